#include "dataset/metadata.h"

#include <gtest/gtest.h>

#include <cmath>

#include "dataset/temporary_folder.h"

namespace mixity {
namespace metadata_test {

Metadata metadata_of(std::string_view toml) {
  const TemporaryFolder folder;
  return read_metadata(folder.write("a.toml", toml));
}

std::string error_of(std::string_view toml) {
  return file_error("a.toml", toml, [](const std::string& path) { read_metadata(path); });
}

TEST(Metadata, ConstantsAreHeldInSi) {
  const Metadata metadata = metadata_of(R"(
radius = "9.42 mm"
modulus = "2.133 MPa"
toughness = "27 mJ/m^2"
toughness_II = "1.7 N/mm"
shear_strength = "430 kPa"
provenance = "digitised"
source = "a paper"
note = "a note"
)");
  // 4 ulp (EXPECT_DOUBLE_EQ): the decimal value, the factor and their product are each rounded once.
  EXPECT_DOUBLE_EQ(metadata.radius.value(), 9.42e-3);
  EXPECT_DOUBLE_EQ(metadata.modulus.value(), 2.133e6);
  EXPECT_DOUBLE_EQ(metadata.toughness.value(), 0.027);
  EXPECT_DOUBLE_EQ(metadata.toughness_II.value(), 1700);
  EXPECT_DOUBLE_EQ(metadata.shear_strength.value(), 0.43e6);
  EXPECT_EQ(metadata.provenance, Provenance::digitised);
  EXPECT_EQ(metadata.source, "a paper");
  EXPECT_EQ(metadata.note, "a note");
  EXPECT_EQ(metadata.plane_strain_modulus(), metadata.modulus);
}

TEST(Metadata, AnErrorInPercentOfZeroIsRefusedWithOneThatWorks) {
  EXPECT_NE(error_of("load_offset = \"0 +/- 1%\"")
                .find("a share of 0 is no error; write the error itself, such as \"0 +/- 0.5 mN\""),
            std::string::npos);
  EXPECT_EQ(error_of("load_offset = \"0 +/- 0.5 mN\""), "");
}

TEST(Metadata, AFileThatIsNotThereOrEmptyLeavesAllUnstated) {
  const TemporaryFolder folder;
  for (const std::string& path : {folder.path("none.toml"), folder.write("empty.toml", "")}) {
    const Metadata metadata = read_metadata(path);
    EXPECT_FALSE(metadata.radius || metadata.plane_strain_modulus() || metadata.toughness || metadata.shear_strength);
    EXPECT_EQ(metadata.provenance, Provenance::unstated);
    EXPECT_EQ(metadata.source, "");
  }
}

TEST(Metadata, TheModulusFollowsFromYoungsModulusAndPoissonRatio) {
  // E* = E/(1 - nu^2): 1.6 MPa/0.75 and 1.6 MPa/0.84, by hand
  for (const auto& [nu, modulus] : {std::pair{"0.5", 1.6e6 / 0.75},
                                    {"\"0.5\"", 1.6e6 / 0.75},
                                    {"\"40 %\"", 1.6e6 / 0.84},
                                    {"0", 1.6e6},
                                    {"0.0", 1.6e6}})
    EXPECT_DOUBLE_EQ(  // 4 ulp: a product, a difference and a quotient
        metadata_of("youngs_modulus = \"1.6 MPa\"\npoisson_ratio = " + std::string(nu)).plane_strain_modulus().value(),
        modulus)
        << nu;
  EXPECT_FALSE(metadata_of("poisson_ratio = 0.5").plane_strain_modulus());
}

TEST(Metadata, AStandardErrorStandsBehindItsConstant) {
  Metadata metadata;
  for (const auto& [name, text] :
       {std::pair("radius", "10 +/- 0.1 mm"), std::pair("toughness", "27 mJ/m^2 +/- 10%"),
        std::pair("youngs_modulus", "1.5 +/- 0.03 MPa"), std::pair("poisson_ratio", "0.5 +/- 0.01"),
        std::pair("load_offset", "-1 +/- 0.5 mN"), std::pair("area_scale", "1 +/- 2%")})
    EXPECT_EQ(set_field(metadata, name, text), "") << name;
  EXPECT_DOUBLE_EQ(metadata.standard_error("radius"), 1e-4);
  EXPECT_DOUBLE_EQ(metadata.standard_error("toughness"), 2.7e-3);
  EXPECT_DOUBLE_EQ(*metadata.load_offset, -1e-3);
  EXPECT_DOUBLE_EQ(metadata.standard_error("load_offset"), 5e-4);
  EXPECT_DOUBLE_EQ(metadata.standard_error("area_scale"), 0.02);
  // dE*/E* of E/(1 - nu^2): 2 % of E and 2 nu dnu/(1 - nu^2) = 0.01/0.75
  EXPECT_DOUBLE_EQ(metadata.modulus_error(), std::hypot(0.02, 0.01 / 0.75));
  EXPECT_EQ(set_field(metadata, "toughness", "27 mJ/m^2"), "");  // stated anew, as exact
  EXPECT_EQ(metadata.standard_error("toughness"), 0);
}

TEST(Metadata, ByteOrderMarkAndCrLfAreRead) {
  EXPECT_EQ(metadata_of("\xEF\xBB\xBFradius = \"1 m\"\r\nsource = \"µ\"\r\n").radius, 1.0);
}

TEST(Metadata, SourceAndNoteAreOnePrintableLine) {
  EXPECT_EQ(metadata_of("source = \"\"\"\nA,\tB\nC \"\"\"").source, "A, B C");
  EXPECT_EQ(metadata_of("note = \"a\\u001b[31mb\\u0000c\"").note, "a?[31mb?c");
}

TEST(Metadata, WhatCannotBeUnderstoodIsRefusedWithItsPlace) {
  for (const auto& [toml, error] : std::vector<std::pair<std::string, std::string>>{
           {"radius = \"9.42\"", "1:10: radius is \"9.42\"; it must be a length such as mm, written \"9.42 mm\""},
           {"radius = \"9.42 mN\"", "1:10: radius is \"9.42 mN\"; it must be a length such as mm, written \"9.42 mm\""},
           {"radius = \"9,420 mm\"", "1:10: radius is \"9,420 mm\"; write \"9.420 mm\" or \"9420 mm\""},
           {"modulus = \"2.133 Mpa\"", "1:11: modulus is \"2.133 Mpa\"; the unit \"Mpa\" is not known; \"MPa\" is"},
           {"modulus = \"2 +/- 0.1 mpsi\"",
            "1:11: modulus is \"2 +/- 0.1 mpsi\"; the unit \"mpsi\" is not known; it must be a stress such as MPa"},
           {"radius = \"wide\"", "1:10: radius is \"wide\"; it must be a number with a unit, such as \"9.42 mm\""},
           {"radius = \"\"", "1:10: radius is \"\"; it must be a number with a unit, such as \"9.42 mm\""},
           {"radius = \"9 mm +/- wide\"",
            "1:10: radius is \"9 mm +/- wide\"; it must be a number with a unit, such as \"1 mm +/- 2%\" or \"1 +/- "
            "0.02 mm\""},
           {"radius = \"0 mm\"", "1:10: radius is \"0 mm\"; it must be positive"},
           {"toughness = \"-1 J/m^2\"", "1:13: toughness is \"-1 J/m^2\"; it must be positive"},
           {"# µ\n  radius =  9.42", "2:13: radius must be a string with a number and a unit, such as \"9.42 mm\""},
           {"radius = [1]", "1:10: radius must be a string with a number and a unit, such as \"9.42 mm\""},
           {"poisson_ratio = 0.6", "1:17: poisson_ratio is \"0.6\"; it must lie between 0 and 0.5"},
           {"poisson_ratio = -0.1", "1:17: poisson_ratio is \"-0.1\"; it must lie between 0 and 0.5"},
           {"provenance = \"measuerd\"",
            "1:14: provenance is \"measuerd\"; it must be measured, digitised or reconstructed"},
           {"mode_III = \"round\"", "1:12: mode_III is \"round\"; it must be half or averaged"},
           {"mode_III = \"\"", "1:12: mode_III is \"\"; it must be half or averaged"},
           {"mode_III = 1.5", "1:12: mode_III must be a string"},
           {"\nraduis = \"3 mm\"",
            "2:1: unknown key \"raduis\": did you mean radius? (known: radius, modulus, youngs_modulus, poisson_ratio, "
            "toughness, "
            "toughness_II, "
            "shear_strength, load_offset, shear_offset, area_offset, approach_offset, area_scale, force_gain, "
            "modulus_drift, "
            "toughness_drift, "
            "shape, hysteresis, normal_stiffness, pixel, load, rate, fps, table, mode_III, control, provenance, title, "
            "source, note, columns, "
            "headings, "
            "definition, decimal, "
            "sheet, load_from)"},
       })
    EXPECT_EQ(error_of(toml), "a.toml:" + error) << toml;
}

TEST(Metadata, AnUnknownKeyIsCalledThatWhateverItsValue) {
  for (const char* toml : {"raduis = \"3 mm\"", "raduis = 3", "raduis = true", "[raduis]\nvalue = 3"})
    EXPECT_NE(error_of(toml).find("unknown key \"raduis\""), std::string::npos) << error_of(toml);
}

TEST(Metadata, ASyntaxErrorHasItsPlace) {
  // The sentence is the TOML reader's; line and column are ours to pass on.
  EXPECT_TRUE(error_of("source = \"a\"\nradius = 9.42 mm\n").starts_with("a.toml:2:15: "))
      << error_of("radius = 9.42 mm\n");
  EXPECT_TRUE(error_of("radius = \"9.42 mm\nmodulus").starts_with("a.toml:1:"));
  EXPECT_TRUE(error_of("radius = \"1 mm\"\nradius = \"2 mm\"\n").starts_with("a.toml:2:"));
  EXPECT_TRUE(error_of("source = " + std::string(100000, '[')).starts_with("a.toml:1:"));
}

TEST(Metadata, TwoStatementsOfTheModulusAreRefused) {
  const auto problem = [](const std::string& toml, const Overrides& overrides = {}) -> std::string {
    Metadata metadata = metadata_of(toml);
    try {
      apply_overrides(overrides, metadata);
      require_whole_modulus(metadata, "a.toml", overrides);
    } catch (const InputError& error) {
      return error.text(cli::in_flags);
    }
    return {};
  };
  const std::string E = "youngs_modulus = \"1.6 MPa\"", nu = "poisson_ratio = 0.5", modulus = "modulus = \"2 MPa\"";
  EXPECT_EQ(problem(modulus + '\n' + E + '\n' + nu), "a.toml: states both modulus and youngs_modulus; state one");
  EXPECT_EQ(problem(E), "a.toml: states youngs_modulus without poisson_ratio");
  EXPECT_EQ(problem(nu), "a.toml: states poisson_ratio without youngs_modulus");
  EXPECT_EQ(problem("", {{"youngs_modulus", "1.6 MPa"}}), "--youngs_modulus: needs poisson_ratio, too");
  EXPECT_EQ(problem("", {{"poisson_ratio", "0.5"}}), "--poisson_ratio: needs youngs_modulus, too");
  EXPECT_EQ(problem(modulus, {{"poisson_ratio", "0.5"}}), "");  // beside E*, that of mode III
  for (const std::string& fine : {modulus, E + '\n' + nu, modulus + '\n' + nu}) EXPECT_EQ(problem(fine), "");
  EXPECT_EQ(problem(E, {{"poisson_ratio", "0.5"}}), "");
}

TEST(Metadata, PoissonsRatioMayStandByItselfWhereModeIIIIsAveraged) {
  const auto weighs = [](const std::string& toml, const Overrides& overrides = {}) {
    Metadata metadata = metadata_of(toml);
    apply_overrides(overrides, metadata);
    require_whole_modulus(metadata, "a.toml", overrides);
    return metadata.kappa();
  };
  const std::string averaged = "mode_III = \"averaged\"\n", half = "mode_III = \"half\"\n", nu = "poisson_ratio = 0.25";
  EXPECT_EQ(weighs(""), 1);
  EXPECT_EQ(weighs(half), 1);
  EXPECT_EQ(weighs(averaged), 1.5);
  EXPECT_EQ(weighs(averaged + nu), 1.75 / 1.5);
  EXPECT_EQ(weighs(averaged + "modulus = \"2 MPa\"", {{"poisson_ratio", "0.25"}}), 1.75 / 1.5);
  EXPECT_EQ(weighs(nu, {{"mode_III", "averaged"}}), 1.75 / 1.5);
  EXPECT_EQ(weighs(averaged + nu + "\nyoungs_modulus = \"2 MPa\"", {{"mode_III", "half"}}), 1);
  EXPECT_THROW(weighs(averaged + nu, {{"mode_III", "half"}}), InputError);
  EXPECT_THROW(weighs(averaged + "youngs_modulus = \"2 MPa\""), InputError);
}

TEST(Metadata, TheConventionOfModeIIISaysPoissonsRatio) {
  EXPECT_EQ(mode_III_text(metadata_of("")), "half");
  EXPECT_EQ(mode_III_text(metadata_of("mode_III = \"half\"\npoisson_ratio = 0.3")), "half");
  const std::string averaged = "mode_III = \"averaged\"\n";
  EXPECT_EQ(mode_III_text(metadata_of(averaged)), "averaged (kappa = 1.5 at nu = 0.5, not stated)");
  EXPECT_EQ(mode_III_text(metadata_of(averaged + "poisson_ratio = 0")), "averaged (kappa = 1 at nu = 0)");
  EXPECT_EQ(mode_III_text(metadata_of(averaged + "poisson_ratio = \"0.5 +/- 0.01\"")),
            "averaged (kappa = 1.5 at nu = 0.5, taken as exact)");
}

TEST(Metadata, FilesWithTwoConventionsOfModeIIIAreNoDataSet) {
  Metadata constants = metadata_of("mode_III = \"averaged\"");
  EXPECT_EQ(add_constants(metadata_of("radius = \"1 mm\""), constants), "");
  EXPECT_EQ(constants.mode_III, ModeIII::averaged);
  EXPECT_EQ(add_constants(metadata_of("mode_III = \"half\""), constants),
            "states another mode_III than a file before it; constants are those of the whole experiment");
}

TEST(Metadata, OverridesReplaceWhatTheFileStates) {
  Metadata metadata = metadata_of("radius = \"1 m\"\nmodulus = \"2 Pa\"\nprovenance = \"measured\"");
  apply_overrides({{"radius", "3 m"}, {"toughness", "4 J/m^2"}, {"provenance", "reconstructed"}, {"note", "x"}},
                  metadata);
  EXPECT_EQ(metadata.radius, 3.0);
  EXPECT_EQ(metadata.modulus, 2.0);
  EXPECT_EQ(metadata.toughness, 4.0);
  EXPECT_EQ(metadata.provenance, Provenance::reconstructed);
  EXPECT_EQ(metadata.note, "x");
}

TEST(Metadata, OneStatementOfTheModulusOverridesTheOther) {
  Metadata metadata = metadata_of("modulus = \"2 Pa\"");
  apply_overrides({{"youngs_modulus", "3 Pa"}, {"poisson_ratio", "0.5"}}, metadata);
  EXPECT_EQ(metadata.plane_strain_modulus(), 4.0);
  apply_overrides({{"modulus", "5 Pa"}}, metadata);
  EXPECT_EQ(metadata.plane_strain_modulus(), 5.0);
}

TEST(Metadata, AnOverrideThatCannotBeUsedNamesTheFlag) {
  Metadata metadata;
  EXPECT_EQ(input_error([&] {
              apply_overrides({{"radius", "3"}}, metadata);
            }),
            "--radius: radius is \"3\"; it must be a length such as mm, written \"9.42 mm\"");
  EXPECT_FALSE(metadata.radius);
}

TEST(Metadata, PathsThatCannotBeLookedUpAreInputErrors) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path("folder.toml"));
  EXPECT_EQ(input_error([&] { read_metadata(folder.path("folder.toml")); }),
            folder.path("folder.toml") + ": cannot be read: Is a directory");
  const std::string too_long = folder.path(std::string(300, 'x') + ".toml");
  std::filesystem::create_symlink("loop.toml", folder.path("loop.toml"));
  for (const std::string& path : {too_long, folder.path("loop.toml")}) {
    std::string error = "another exception";
    EXPECT_NO_THROW(error = input_error([&] { read_metadata(path); })) << path;
    EXPECT_TRUE(error.starts_with(path + ": ")) << error;
  }
}

}  // namespace metadata_test
}  // namespace mixity
