// Several files are one data set: the same points as one file that holds all of them.
#include "dataset/pooled.h"

#include <gtest/gtest.h>

#include "dataset/exclusion.h"
#include "dataset/temporary_folder.h"

namespace mixity {
namespace pooled_test {

const std::string kConstants = "radius = \"9.42 mm\"\nmodulus = \"2.133 MPa\"\ntoughness = \"27 mJ/m^2\"\n";

TEST(Pooled, WhereTheNamesOfFilesStateTheLoadTheKeyForItIsRecommended) {
  const TemporaryFolder folder;
  const auto advice = [&](const std::string& name) -> std::string {
    try {
      load_dataset(folder.write(name, "T [mN],A [mm^2]\n0,0.35\n2,0.34\n"));
    } catch (const InputError& error) {
      const auto remedies = error.message().remedies();
      return remedies.empty() ? "" : remedies[0].choices[0].option + " = " + remedies[0].choices[0].value;
    }
    return "";
  };
  for (const auto& [name, place] : {std::pair("pad_12mN.txt", "{P}mN"), std::pair("2024_run_1,5 mN.csv", "{P} mN"),
                                    std::pair("glass-7.73mN_b.csv", "-{P}mN"), std::pair("R2_P0.8_mN.csv", "{P}_mN")}) {
    EXPECT_EQ(advice(name), "load_from = " + std::string(place)) << name;
    const Dataset read = load_dataset(
        folder.path(name),
        {{"load_from", place}, {"radius", "9.42 mm"}, {"modulus", "2.133 MPa"}, {"toughness", "27 mJ/m^2"}});
    EXPECT_EQ(read.points.size(), 2u) << name;
  }
  // no load, two, or a number that may begin before
  for (const char* name : {"run_3.csv", "run3.mN.csv", "2mN_to_5mN.csv", "pad_0p5mN.csv", "pad_0_5mN.csv", "5mm.csv"})
    EXPECT_EQ(advice(name), "load = 5 mN") << name;
}

TEST(Pooled, FilesAreTheRunsOfOneDataSet) {
  const TemporaryFolder folder;
  folder.write("run_4mN.csv", "T [mN],A [mm^2]\n0,0.35\n2,0.34\n");
  folder.write("run_4mN.toml", kConstants);
  folder.write("run_12mN.csv", "T [mN];A [mm^2]\n0;0,45\n3;0,44\n5;0,43\n");
  const Dataset whole = load_dataset(
      folder.write("all.csv", "P [mN],T [mN],A [mm^2]\n4,0,0.35\n4,2,0.34\n12,0,0.45\n12,3,0.44\n12,5,0.43\n"),
      {{"radius", "9.42 mm"}, {"modulus", "2.133 MPa"}, {"toughness", "27 mJ/m^2"}});
  std::vector<RunFile> files;
  for (const std::string& path : files_of(folder.path("run_*.csv"))) files.push_back({path});
  ASSERT_EQ(files.size(), 2u);
  const Dataset pooled = load_pooled(files, {{"load_from", "run_{P}mN"}});
  EXPECT_EQ(pooled.curves, (std::vector<std::string>{"run_4mN", "run_12mN"}));  // by number, not by letter
  EXPECT_EQ(pooled.name, "run");
  ASSERT_EQ(pooled.points.size(), whole.points.size());
  for (std::size_t i = 0; i < whole.points.size(); ++i) {
    EXPECT_EQ(pooled.points[i].P, whole.points[i].P);
    EXPECT_EQ(pooled.points[i].T, whole.points[i].T);
    EXPECT_EQ(pooled.points[i].A, whole.points[i].A);
    EXPECT_EQ(pooled.points[i].curve, whole.points[i].curve);
  }
  EXPECT_EQ(pooled.line_text(pooled.points[1].line), "run_4mN.csv line 3");
  EXPECT_EQ(pooled.line_text(pooled.points[2].line), "run_12mN.csv line 2");
  EXPECT_EQ(pooled.line_in_file(pooled.points[4].line), 4u);
}

TEST(Pooled, ARunMayBeNamedAndLoadedByItsEntry) {
  const TemporaryFolder folder;
  const std::string one = folder.write("a.csv", "T [mN],A [mm^2]\n0,0.35\n2,0.34\n"),
                    other = folder.write("b.csv", "T [mN],A [mm^2]\n0,0.45\n");
  folder.write("a.toml", kConstants);
  const Dataset data = load_pooled({{one, "first", "4 mN"}, {other, "second", "12 mN"}});
  EXPECT_EQ(data.curves, (std::vector<std::string>{"first", "second"}));
  EXPECT_DOUBLE_EQ(data.curve_loads[1], 3 * data.curve_loads[0]);
}

TEST(Pooled, ARunOnAnotherSphereIsTheSameContactAtOtherScale) {
  const TemporaryFolder folder;
  // on an eighth of the radius: forces 1/8, areas (1/8)^(4/3) = 1/16
  const std::string one = folder.write("a.csv", "P [mN],T [mN],A [mm^2],sigma_A [mm^2]\n8,4,0.32,0.016\n"),
                    other = folder.write("b.csv", "P [mN],T [mN],A [mm^2],sigma_A [mm^2]\n1,0.5,0.02,0.001\n");
  folder.write("a.toml", "radius = \"8 mm +/- 2%\"\nmodulus = \"2.133 MPa\"\ntoughness = \"27 mJ/m^2\"\n");
  const Dataset data = load_pooled({{one}, {other, "", "", "1 mm"}});
  ASSERT_EQ(data.points.size(), 2u);
  // cbrt and a division round
  EXPECT_NEAR(data.points[1].P, data.points[0].P, 1e-14 * data.points[0].P);
  EXPECT_NEAR(data.points[1].T, data.points[0].T, 1e-14 * data.points[0].T);
  EXPECT_NEAR(data.points[1].A, data.points[0].A, 1e-13 * data.points[0].A);
  EXPECT_NEAR(data.errors[1].A, data.errors[0].A, 1e-13 * data.errors[0].A);
  EXPECT_TRUE(data.several_spheres);
  ASSERT_EQ(data.notes.size(), 1u);
  EXPECT_EQ(texts_of(data.notes)[0],
            "b: on a sphere of 1 mm; shown as the equivalent contact on 8 mm, with 8 times the load and shear and "
            "16 times the area");
  // the share of the radius that is uncertain is that of every sphere, the first as well
  const Dataset turned = load_pooled({{other, "", "", "1 mm"}, {one}});
  EXPECT_DOUBLE_EQ(turned.metadata.standard_error("radius"), 0.02e-3);
  EXPECT_NE(input_error([&] {
              load_pooled({{one}, {other, "", "", "1 mm"}}, {{"shear_offset", "0 +/- 0.1 mN"}});
            }).find("on several spheres: offsets"),
            std::string::npos);
}

TEST(Pooled, PointsOfAFileCanBeLeftOutByItsName) {
  const TemporaryFolder folder;
  std::vector<RunFile> files;
  for (const char* name : {"a.csv", "b.csv"})
    files.push_back({folder.write(name, "P,T,A\n1,0,19.6\n1,1,19.5\n1,2,19.4\n")});
  Dataset data = load_pooled(files);
  Exclusion which;
  which.lines.push_back(parse_lines("b.csv:3-4").value());
  exclude(data, which);
  EXPECT_EQ(data.points.size(), 4u);
  EXPECT_EQ(data.line_text(data.excluded.at(0).line), "b.csv line 3");
  which.lines = {parse_lines("3").value()};
  EXPECT_NE(input_error([&] { exclude(data, which); }).find("lines to exclude need the name of theirs"),
            std::string::npos);
}

TEST(DistinctNames, AreTheWantedOnesAsFarAsTheyAreFree) {
  DistinctNames names;
  std::vector<std::string> given;
  for (const char* wanted : {"a", "a", "a (2)", "a", "b", "a (3)"}) {
    given.push_back(names.free_name(wanted));
    EXPECT_EQ(names.free_name(wanted), given.back()) << "a name that is not taken stays free";
    names.take(given.back());
  }
  EXPECT_EQ(given, (std::vector<std::string>{"a", "a (2)", "a (2) (2)", "a (3)", "b", "a (3) (2)"}));
}

/// What was read is listed once, for all files together: tools/growth shows that time and memory grow with their
/// number.
TEST(Pooled, WhatWasReadIsListedOnce) {
  const TemporaryFolder folder;
  std::vector<RunFile> files;
  for (int i = 0; i < 3; ++i)
    files.push_back({folder.write("run" + std::to_string(i) + ".csv", "P,T,A\n1,0,20\n1,3,19\n")});
  Inputs inputs;
  EXPECT_TRUE(load_part(files[0].path, {}, {}, inputs).inputs.empty());
  EXPECT_EQ(load_pooled(files).inputs.size(), files.size());
}

TEST(Pooled, AFileThatIsNamedTwiceIsRefused) {
  const TemporaryFolder folder;
  const std::string path = folder.write("run_1.csv", "P,T,A\n1,0,2\n1,1,1.9\n");
  EXPECT_EQ(folder.left_out_of(input_error([&] {
    load_pooled({{path}, {path}}, {});
  })),
            "run_1.csv: is named twice: its points would count twice");
}

TEST(Pooled, FilesThatContradictEachOtherAreRefused) {
  const TemporaryFolder folder;
  const auto error = [&](const std::string& toml, const std::string& csv) {
    const std::string one = folder.write("a.csv", "P [mN],T [mN],A [mm^2]\n1,0,0.2\n"),
                      other = folder.write("b.csv", csv);
    folder.write("a.toml", kConstants);
    folder.write("b.toml", toml);
    return folder.left_out_of(input_error([&] { load_pooled({{one}, {other}}); }));
  };
  EXPECT_EQ(error("radius = \"9.43 mm\"\n", "P [mN],T [mN],A [mm^2]\n1,0,0.2\n"),
            "b.toml: states another radius than a file before it; constants are those of the whole experiment");
  EXPECT_EQ(error("", "psi,Gc_over_GIc\n0.1,1\n"),
            "b.csv: holds no loads; only runs with P, T and A make one data set");
  EXPECT_NE(error("", "P,T,A\n1,0,19.6\n").find("b.csv:1:3: the columns have no units"), std::string::npos);
  EXPECT_EQ(error("", "P [mN],T [mN],A [mm^2]\n1,0,x\n"), "b.csv:2:5: column 'A': 'x' is not a number");
  EXPECT_EQ(folder.left_out_of(input_error([&] { files_of(folder.path("nothing_*.csv")); })),
            "nothing_*.csv: no file has such a name");
}

}  // namespace pooled_test
}  // namespace mixity
