// Exports that need a word of the reader, or that are refused, say what they were taken for.
#include <numbers>

#include "dataset/table/exports.h"

namespace mixity {
namespace exports_of_doubt_test {

using namespace exports;

TEST(Exports, WithoutTheNamesAreReadByAMapping) {
  const auto mixed = [](const Row& row) { return std::vector<double>{row[2], row[0], 1e-3 * row[1]}; };
  expect_the_experiment("Kanal 1 (mm²);Kanal 3 (mN);Kanal 4 (N)\n" + lines({';', kComma, mixed}),
                        {{"columns", "P=Kanal 3 (mN),T=Kanal 4 (N),A=Kanal 1"}});
  expect_the_experiment(lines({','}), {{"columns", "P=1 (mN),T=2 (mN),A=3 (mm^2)"}});
  const TemporaryFolder folder;
  const std::string names = folder.write(
      "lab.toml", "[P]\nnames = [\"Kanal 3\"]\n[T]\nnames = [\"Kanal 4\"]\n[A]\nsymbols = [\"Kanal 1\"]\n");
  expect_the_experiment("Kanal 1 (mm²);Kanal 3 (mN);Kanal 4 (N)\n" + lines({';', kComma, mixed}),
                        {{"headings", names}});
}

TEST(Exports, WithAMappingByNumberAreTheTableThatIsThereWithoutIt) {
  const Overrides by_number{{"columns", "P=1,T=2,A=3"}}, with_units{{"columns", "P=1 (mN),T=2 (mN),A=3 (mm^2)"}};
  for (const Overrides& mapping : {by_number, with_units}) {
    expect_the_experiment("Kanal;Kraft quer;Fleck\nmN;mN;mm^2\n" + german(), mapping);
    expect_the_experiment("mN;mN;mm^2\nKanal;Kraft quer;Fleck\n" + german(), mapping);
    expect_the_experiment("Kanal;Kraft quer;Fleck\n[mN];[mN];[mm²]\n" + german(), mapping);
    expect_the_experiment("mN;mN;mm^2\n" + german(), mapping);
    expect_the_experiment("# Kanal Kraft Fleck\n# mN mN mm^2\n" + lines({' '}), mapping);
    expect_the_experiment("Normalkraft;Reibkraft;Kontaktfläche\nmN;mN;mm^2\n" + german(), mapping);
  }
  expect_the_experiment("Kanal;Kraft quer;Fleck\n" + german(), with_units);
  expect_the_experiment(german(), with_units);
}

TEST(Exports, WithARowOfUnitsThatLookLikeSymbolsHaveTheirHeadingsAbove) {
  // N is a symbol of P, s one of standard errors
  expect_the_experiment("Normal force\tShear force\tPatch\nmN\tmN\tmm^2\n" + lines({'\t'}), {{"columns", "A=Patch"}});
  const auto in_N = [](const Row& row) { return std::vector<double>{1e-3 * row[0], 1e-3 * row[1], row[2]}; };
  const std::string rows = lines({'\t', Form{}.field, in_N});
  expect_the_experiment("Axial Load\tShear Force\tPatch\nN\tN\tmm^2\n" + rows, {{"columns", "A=Patch"}});
  expect_the_experiment("Cell 1\tShear Force\tPatch\nN\tN\tmm^2\n" + rows, {{"columns", "P=1,A=3"}});
}

TEST(Exports, WithErrorsInTheFieldsOfTheirValuesHaveBoth) {
  const auto errors = [](const std::string& text, const Overrides& constants = {}) {
    const TemporaryFolder folder;
    return load_dataset(folder.write("a.csv", text), constants);
  };
  for (const char* text : {"G_I [J/m^2],G_II [J/m^2]\n0.61+/-0.05,0.3\n0.42+/-0.07,0.31+/-0.04\n",
                           "G_I [J/m^2];G_II [J/m^2]\n0,61 \xC2\xB1 0,05;0,3\n0,42(7);0,31(4)\n",
                           "G_I [J/m^2]\tG_II [J/m^2]\n0.61(5)\t0.3\n0.42(7)\t0.31(4)\n"}) {
    const Dataset data = errors(text, {{"toughness", "1 J/m^2"}});
    ASSERT_EQ(data.energies.size(), 2u) << text;
    EXPECT_EQ(data.energies[0].G_I, 0.61) << text;
    EXPECT_DOUBLE_EQ(data.energies[0].sigma_GI, 0.05) << text;
    EXPECT_EQ(data.energies[0].sigma_GII, kNotStated) << text;
    EXPECT_DOUBLE_EQ(data.energies[1].sigma_GII, 0.04) << text;
    EXPECT_DOUBLE_EQ(data.errors[1].ratio, std::hypot(0.07, 0.04)) << text;
    EXPECT_EQ(texts_of(data.notes).at(0), "standard errors: stated in the fields of the values") << text;
  }
  const Dataset data = errors("P,T,A\n1,0,19\n1,1 +/- 0.5,18 +/- 10%\n");
  ASSERT_EQ(data.errors.size(), 2u);
  EXPECT_EQ(data.errors[0].T, kNotStated);
  EXPECT_EQ(data.errors[1].T, 0.5);
  EXPECT_DOUBLE_EQ(data.errors[1].A, 1.8);
  for (const char* refused : {"P,T,A\n1 +/- 0.1,0,19\n1,1,18\n", "P,T,A,sigma_T\n1,0 +/- 1,19,1\n1,1,18,1\n"})
    EXPECT_NE(input_error([&] { errors(refused); }).find("states a standard error where none is read"),
              std::string::npos);
}

TEST(Exports, WithWordsBelowOrBesideTheirNumbersAreReadWithoutThem) {
  const std::string rows = lines({'\t'});
  const std::string last = rows.substr(0, rows.rfind('\n', rows.size() - 2) + 1);  // without the last row
  const std::string remark = rows.substr(last.size(), rows.size() - last.size() - 1) + "\tslides, at last\n";
  const std::string header = "P [mN]\tT [mN]\tA [mm^2]";
  expect_the_experiment(header + "\tComment\n" + last + remark);
  expect_the_experiment(header + "\n" + last + remark);
  expect_the_experiment(header + "\n" + rows + "End of data\n");
  expect_the_experiment(header + "\n" + rows + "exported by AB\ton a Monday\nEnd\n\n");
  const auto error = [&](const std::string& text) {
    const TemporaryFolder folder;
    return input_error([&] { load_dataset(folder.write("a.csv", text), kConstants); });
  };
  EXPECT_NE(error(header + "\n" + last + "End of data\n" + rows).find("the row has 1 fields"), std::string::npos);
  EXPECT_NE(error(header + "\n" + rows + "4\t5\n").find("the row has 2 fields"), std::string::npos);  // cut off
  EXPECT_NE(error(header + "\n" + rows + "4\t5\t0.3\t7\n").find("more fields"), std::string::npos);
}

TEST(Exports, WithoutALoadTakeItFromTheirNameOrAFlag) {
  const TemporaryFolder folder;
  const std::string text = "T [mN],A [mm^2]\n0,0.3\n1,0.29\n";
  const auto load_of = [&](const std::string& name, const Overrides& more) {
    const Dataset data = load_dataset(folder.write(name, text), with(more));
    return data.points.at(1).P * data.contact.value().force_unit();
  };
  EXPECT_DOUBLE_EQ(load_of("a.csv", {{"load", "4.68 mN"}}), 4.68e-3);
  EXPECT_DOUBLE_EQ(load_of("a.csv", {{"load", "-0.2 mN"}}), -0.2e-3);
  EXPECT_DOUBLE_EQ(load_of("run_4.68mN.csv", {{"load_from", "run_{P}mN"}}), 4.68e-3);
  EXPECT_DOUBLE_EQ(load_of("b_-0,2mN_3.csv", {{"load_from", "b_{P}mN"}}), -0.2e-3);
  EXPECT_DOUBLE_EQ(load_of("12uN-7.csv", {{"load_from", "{P}uN"}}), 12e-6);
  EXPECT_DOUBLE_EQ(load_of("load 1.2 mN.csv", {{"load_from", "load {P} mN"}}), 1.2e-3);
  EXPECT_DOUBLE_EQ(load_of("load_1.2_mN.csv", {{"load_from", "load_{P}_mN"}}), 1.2e-3);
  EXPECT_DOUBLE_EQ(load_of("run_2mN.csv", {{"load_from", "run_{P}mN"}, {"load", "3 mN"}}), 3e-3);  // said last
  const auto refused = [&](const std::string& name, const Overrides& more) {
    return input_error([&] { load_of(name, more); });
  };
  EXPECT_NE(refused("run_7,250mN.csv", {{"load_from", "run_{P}mN"}}).find("may be a thousand or a decimal"),
            std::string::npos);
  EXPECT_NE(refused("run-7mN.csv", {{"load_from", "run{P}mN"}}).find("may be a sign or a separator"),
            std::string::npos);
  EXPECT_NE(refused("a.csv", {{"load", "3 mN +/- 1 mN"}}).find("its error belongs in load_offset"), std::string::npos);
  EXPECT_NE(refused("a.csv", {{"pixel", "1.7 um +/- 5%"}}).find("its error belongs in area_scale"), std::string::npos);
  EXPECT_EQ(folder.left_out_of(input_error([&] {
    load_of("run7.csv", {{"load_from", "run_{P}mN"}});
  })),
            "run7.csv: the file's name states no load (load_from is \"run_{P}mN\")");
}

TEST(Exports, ThatCanBeReadInTwoWaysAreRefusedWithBoth) {
  const auto error = [](const std::string& text) {
    return file_error("a.csv", text, [](const std::string& path) { load_dataset(path, kConstants); });
  };
  EXPECT_EQ(
      error("P [mN],T [mN],A [mm^2]\n\"1,234\",\"2,345\",\"3,456\"\n\"1,235\",\"2,346\",\"3,457\"\n"),
      "a.csv:2:1: '1,234' may be 1.234 (decimal comma) or 1234 (comma between thousands); say which: --decimal=\",\" "
      "or --decimal=\".\"");
  EXPECT_EQ(error("P [mN],T [mN] (N),A [mm^2]\n1,2,3\n2,3,4\n"),
            "a.csv:1:8: column 'T [mN] (N)' states two units, mN and N");
  EXPECT_EQ(error("Normal force (mN),Load (mN),Friction force (mN),Contact area (mm^2)\n1,2,3,4\n2,2,3,4\n"),
            "a.csv:1:19: 'Normal force (mN)' and 'Load (mN)' may both be P; say which: "
            "--columns=\"P=Normal force (mN)\" or --columns=\"P=Load (mN)\"");
  EXPECT_EQ(error("P [mN],T [mN],A [px]\n1,2,3\n2,3,4\n"),
            "a.csv:1:15: column 'A' is in pixels; state the side of one: --pixel=\"1.7 um\", or the key pixel");
  // integers in groups of three, or three decimals: none of them can be told
  EXPECT_EQ(error("P [uN];T [uN];A [um^2]\n7.732;0;457.831\n7.732;854;456.212\n"),
            "a.csv:2:1: '7.732' may be 7732 (decimal comma) or 7.732 (decimal point); say which: --decimal=\",\" or "
            "--decimal=\".\"");
  EXPECT_NE(error("P [uN];T [uN];A [um^2]\n7,732;0;457,831\n7,732;854;456,212\n").find("say which: --decimal"),
            std::string::npos);
  EXPECT_EQ(error("P [mN],T [mN],A [mm^2]\nN,mN,mm^2\n1,2,3\n2,2,3\n"),
            "a.csv:2:1: the row of units has 'N' for column 'P [mN]', which itself says mN");
  EXPECT_EQ(error("P,T,A\nkg,mN,mm^2\n1,2,3\n2,2,3\n"),
            "a.csv:2:1: the row of units has 'kg' for column 'P', which is a mass; if a weight is meant: "
            "--columns=\"P=P (kgf)\"");
  EXPECT_EQ(error("PK\x03\x04..."),
            "a.csv: is a workbook or an archive that is damaged or incomplete; save or copy it again");
}

TEST(Exports, WithAMappingThatCannotBeAreRefused) {
  const auto error = [](const std::string& text, const std::string& columns) {
    return file_error("a.csv", text, [&](const std::string& path) {
      load_dataset(path, with({{"columns", columns}}));
    });
  };
  const std::string twice = "Force (mN),Force (mN),A (mm^2)\n1,2,3\n2,2,3\n";
  EXPECT_EQ(error(twice, "P=1,T=1"), "a.csv:1:1: column 1 is mapped to T and to P");
  EXPECT_EQ(error(twice, "P=Force (mN),T=2"),
            "a.csv:1:12: columns 1 and 2 are both named 'Force (mN)', which is mapped to P; choose one by its number: "
            "--columns=\"P=2\"");
  // what is mapped stands over what is understood
  const TemporaryFolder folder;
  const Dataset data = load_dataset(
      folder.write("b.csv", "P [mN],T [mN],area [mm^2],r [mm]\n4,0,25,0.3\n4,1,25,0.29\n"), with({{"columns", "a=r"}}));
  EXPECT_NEAR(data.points.at(0).A * data.contact.value().area_unit(), std::numbers::pi * 0.09e-6, 1e-18);
}

TEST(Exports, WithLossesOfAreaDoNotTakeThemForErrors) {
  const TemporaryFolder folder;
  const Dataset data = load_dataset(folder.write("a.csv",
                                                 "P [mN],T [mN],A [mm^2],\xCE\x94"
                                                 "A [mm^2],dT [mN]\n4,0,0.3,0,1\n4,1,0.29,0.01,1\n"),
                                    kConstants);
  EXPECT_TRUE(data.errors.empty());
  EXPECT_EQ(data.points.size(), 2u);
}

TEST(Exports, AreSaidHowTheyWereRead) {
  const TemporaryFolder folder;
  const Dataset data = load_dataset(
      folder.write("a.csv",
                   encoded("Versuch 7\nNormalkraft;Reibkraft;Kontaktfläche\nmN;mN;mm²\n" + german(), "UTF-16")),
      kConstants);
  EXPECT_EQ(data.reading, "UTF-16LE, semicolons, decimal commas, units in line 3, headings in line 2");
  EXPECT_EQ(data.taken,
            (std::vector<std::string>{"P from 'Normalkraft'", "T from 'Reibkraft'", "A from 'Kontaktfläche'"}));
}

TEST(Exports, ThatAreLogsSaySo) {
  const TemporaryFolder folder;
  const std::string path =
      folder.write("a.csv", "Zeit (s);P [mN];T [mN];A [mm^2]\n0;1;0;\n1;1;0;0,2\n2;1;0;\n3;1;1;\n4;1;1;0,19\n");
  EXPECT_NE(texts_of(load_dataset(path, kConstants).notes).at(0).find("mixity runs makes loading runs of it"),
            std::string::npos);
}

TEST(Exports, WithStretchedContactsSaySo) {
  const TemporaryFolder folder;
  const Dataset data = load_dataset(
      folder.write("a.csv", "P [mN],T [mN],a_par [mm],a_perp [mm]\n4,0,0.3,0.3\n4,2,0.27,0.324\n"), kConstants);
  EXPECT_EQ(
      texts_of(data.notes).at(0),
      "areas are those of ellipses, axes as 1.2 to 1 (eccentricity 0.553) at most, in line 3, the longer one "
      "across the shear; the models are of a circle, and around such an edge the energy release rate varies by about "
      "20%");
}

}  // namespace exports_of_doubt_test
}  // namespace mixity
