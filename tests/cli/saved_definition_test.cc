// check and runs with --save: one file explains how others of its kind are read.
#include <gtest/gtest.h>

#include "base/number_text.h"
#include "cli/run_program.h"

namespace mixity::cli {
namespace saved_definition_test {

const std::string kLog = MIXITY_ROOT "/data/shear_log.csv";

/// What `check` or `runs` prints without lines that name the file or the definition.
std::string reading(const ProgramResult& result, const std::string& file) {
  std::string text;
  for (const std::string& line : lines_of(result.out))
    if (line.find(file) == std::string::npos && !line.starts_with("Written to")) text += line + "\n";
  return text;
}

/// Two tables with unusual headings; the second has other numbers.
std::string table(double scale) {
  std::string text = "Versuch 7\nWeg (mm);Kanal 3;Kanal 4 (N);7\n;mN;;mm^2\n";
  for (const double load : {1.0, 4.0})
    for (int i = 0; i < 5; ++i)
      text += std::to_string(i) + ";" + shortest(load * scale) + ";" + shortest(1e-3 * i * scale) + ";" +
              shortest(0.3 * scale - 0.001 * i) + "\n";
  return text;
}

const Words kFlags{"--columns=P=Kanal 3,T=Kanal 4,A=4 (mm^2)",
                   "--radius=9.42 mm +/- 1%",
                   "--modulus=2.1 MPa",
                   "--toughness=27 mJ/m^2",
                   "--shear_offset=0 +/- 0.1 mN",
                   "--provenance=measured"};

Words with_flags(Words words) {
  words.insert(words.end(), kFlags.begin(), kFlags.end());
  return words;
}

TEST(SavedDefinition, OfCheckReadsAnotherFileAsTheFlagsDo) {
  const TemporaryFolder folder;
  const std::string first = folder.write("first.csv", table(1)), second = folder.write("second.csv", table(1.25)),
                    saved = folder.path("lab.toml");
  const ProgramResult made = run_program(with_flags({"check", first, "--save=" + saved}));
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_NE(made.out.find("Written to " + saved), std::string::npos) << made.out;
  const ProgramResult explicitly = run_program(with_flags({"check", second})),
                      by_definition = run_program({"check", second, "--definition=" + saved});
  ASSERT_EQ(explicitly.exit_code, 0) << explicitly.err;
  EXPECT_EQ(reading(by_definition, "second"), reading(explicitly, "second")) << content_of(saved);
  EXPECT_NE(run_program({"check", second}).exit_code, 0);  // it needs one of them
  const Words fit{"--models=c", "--format=csv"};
  Words one = with_flags({"fit", second}), other{"fit", second, "--definition=" + saved};
  one.insert(one.end(), fit.begin(), fit.end());
  other.insert(other.end(), fit.begin(), fit.end());
  EXPECT_EQ(run_program(other).out, run_program(one).out);
  // beside the file, with its name, it needs no flag
  folder.write("second.toml", content_of(saved));
  EXPECT_EQ(reading(run_program({"check", second}), "second"), reading(explicitly, "second"));
}

TEST(SavedDefinition, IsWrittenWhileConstantsAreMissing) {
  const TemporaryFolder folder;
  const std::string first = folder.write("first.csv", table(1)), second = folder.write("second.csv", table(1.25)),
                    saved = folder.path("lab.toml");
  const ProgramResult made = run_program({"check", first, kFlags[0], "--toughness=27 mJ/m^2", "--save=" + saved});
  EXPECT_EQ(made.exit_code, 0) << made.err;
  const std::string text = content_of(saved);
  EXPECT_NE(text.find("toughness = "), std::string::npos) << text;
  EXPECT_NE(text.find("# radius = \"...\" is needed\n# modulus = \"...\" is needed"), std::string::npos) << text;
  const ProgramResult with =
      run_program({"check", second, "--definition=" + saved, "--radius=9.42 mm", "--modulus=2.1 MPa"});
  EXPECT_EQ(with.exit_code, 0) << with.err;
}

TEST(SavedDefinition, OfALogHasItsRateAndItsTable) {
  const TemporaryFolder folder;
  const auto log = [&](const std::string& name, double scale) {
    std::string text = "remark;count\n1;2\n2;3\n\nSignal 1 (mN);Signal 2 (mN);Kontakt (mm^2)\n";
    const auto lines = lines_of(content_of(kLog));
    for (const std::string& line : lines) {
      const auto fields = fields_of(line);
      if (fields.size() < 4 || fields[0].find_first_not_of("0123456789.-") != std::string::npos) continue;
      text += shortest(std::stod(fields[1]) * scale) + ";" + shortest(std::stod(fields[2]) * scale) + ";" + fields[3] +
              "\n";
    }
    return folder.write(name, text);
  };
  const std::string first = log("first.csv", 1), second = log("second.csv", 1.01), saved = folder.path("lab.toml");
  const Words flags{"--columns=P=Signal 1,T=Signal 2,A=Kontakt", "--rate=400 Hz", "--table=2"};
  const auto runs = [&](Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return run_program(words);
  };
  const ProgramResult made = runs({"runs", first, "--save=" + saved}, flags);
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const std::string text = content_of(saved);
  EXPECT_NE(text.find("rate = '400 Hz'"), std::string::npos) << text;
  EXPECT_NE(text.find("table = '2'"), std::string::npos) << text;
  const ProgramResult explicitly = runs({"runs", second}, flags),
                      by_definition = run_program({"runs", second, "--definition=" + saved});
  ASSERT_EQ(explicitly.exit_code, 0) << explicitly.err;
  EXPECT_EQ(reading(by_definition, "second"), reading(explicitly, "second")) << by_definition.err;
}

TEST(SavedDefinition, OfAPairOfLogsReadsAnotherPair) {
  const TemporaryFolder folder;
  const auto pair = [&](const std::string& name, double scale) {
    std::string forces = "Zeit (s);Kanal 1 (mN);Kanal 2 (mN)\n", areas = "t (s);Spur 3 (mm^2)\n";
    for (const std::string& line : lines_of(content_of(kLog))) {
      const auto fields = fields_of(line);
      if (fields.size() < 4 || fields[0].find_first_not_of("0123456789.-") != std::string::npos) continue;
      forces += fields[0] + ";" + shortest(std::stod(fields[1]) * scale) + ";" + fields[2] + "\n";
      if (!fields[3].empty()) areas += fields[0] + ";" + fields[3] + "\n";
    }
    return std::pair(folder.write(name + "_forces.csv", forces), folder.write(name + "_areas.csv", areas));
  };
  const auto [forces, areas] = pair("first", 1);
  const auto [other_forces, other_areas] = pair("second", 1.01);
  const std::string saved = folder.path("lab.toml"), columns = "--columns=P=Kanal 1,T=Kanal 2,A=Spur 3";
  const ProgramResult made = run_program({"runs", forces, areas, columns, "--lag=0 s", "--save=" + saved});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const ProgramResult explicitly = run_program({"runs", other_forces, other_areas, columns, "--lag=0 s"}),
                      by_definition =
                          run_program({"runs", other_forces, other_areas, "--definition=" + saved, "--lag=0 s"});
  ASSERT_EQ(explicitly.exit_code, 0) << explicitly.err;
  EXPECT_EQ(reading(by_definition, "second"), reading(explicitly, "second")) << by_definition.err << content_of(saved);
  for (const char* name : {"second_forces.toml", "second_areas.toml"}) folder.write(name, content_of(saved));
  const ProgramResult beside = run_program({"runs", other_forces, other_areas, "--lag=0 s"});
  EXPECT_EQ(reading(beside, "second"), reading(explicitly, "second")) << beside.err;
}

TEST(SavedDefinition, ReplacesNoFileOfAUser) {
  const TemporaryFolder folder;
  const std::string data = folder.write("first.csv", table(1)), mine = folder.write("lab.toml", "radius = \"1 mm\"\n");
  const ProgramResult refused = run_program(with_flags({"check", data, "--save=" + mine}));
  EXPECT_EQ(refused.exit_code, 4);
  EXPECT_NE(refused.complaint().find("was not written by mixity"), std::string::npos) << refused.err;
  EXPECT_EQ(content_of(mine), "radius = \"1 mm\"\n");
  EXPECT_EQ(run_program(with_flags({"check", data, "--save=" + mine, "--force"})).exit_code, 0);
  EXPECT_NE(content_of(mine).find("[columns]"), std::string::npos);
  // what is beside the data is an input
  const std::string beside = folder.write("first.toml", "radius = \"9 mm\"\n");
  EXPECT_EQ(run_program(with_flags({"check", data, "--save=" + beside, "--force"})).exit_code, 4);
  EXPECT_EQ(run_program(with_flags({"check", data, "--save=lab.txt"})).exit_code, 2);
}

TEST(SavedDefinition, OfSeveralFilesHasWhatTheyShare) {
  const TemporaryFolder folder;
  const std::string one = folder.write("one.csv", "P [mN],T [mN],A [mm^2]\n1,0,0.3\n1,1,0.29\n"),
                    two = folder.write("two.csv", "P [mN],Friction [mN],A [mm^2]\n1,0,0.3\n1,1,0.29\n"),
                    saved = folder.path("lab.toml");
  folder.write("one.toml", "radius = \"9 mm\"\nmodulus = \"2 MPa\"\ntoughness = \"27 mJ/m^2\"\nnote = \"left\"\n");
  folder.write("two.toml", "radius = \"8 mm\"\nmodulus = \"2 MPa\"\ntoughness = \"27 mJ/m^2\"\n");
  ASSERT_EQ(run_program({"check", one, two, "--save=" + saved}).exit_code, 0);
  const std::string text = content_of(saved);
  EXPECT_NE(text.find("# radius = '9 mm' in one file, '8 mm' in two.csv"), std::string::npos) << text;
  EXPECT_NE(text.find("# T = 'T [mN]' in one file, 'Friction [mN]' in two.csv"), std::string::npos) << text;
  EXPECT_NE(text.find("\nP = 'P [mN]'"), std::string::npos) << text;
  EXPECT_EQ(text.find("left"), std::string::npos) << text;
}

TEST(SavedDefinition, LeavesTheLoadOfOneFileToEach) {
  const TemporaryFolder folder;
  const std::string one = folder.write("one.csv", "T [mN],A [mm^2]\n0,0.3\n1,0.29\n"), saved = folder.path("lab.toml");
  const Words constants{"--radius=9 mm", "--modulus=2 MPa", "--toughness=27 mJ/m^2"};
  Words words{"check", one, "--load=4.68 mN", "--save=" + saved};
  words.insert(words.end(), constants.begin(), constants.end());
  ASSERT_EQ(run_program(words).exit_code, 0);
  EXPECT_NE(content_of(saved).find("# load = '4.68 mN' of one.csv alone"), std::string::npos) << content_of(saved);
  const ProgramResult without = run_program({"check", one, "--definition=" + saved});
  EXPECT_EQ(without.exit_code, 3);
  EXPECT_NE(without.complaint().find("'P' is missing"), std::string::npos) << without.err;
}

TEST(SavedDefinition, YieldsToTheTomlBesideTheDataAndToFlags) {
  const TemporaryFolder folder;
  const std::string data = folder.write("a.csv", "P [mN],T [mN],A [mm^2]\n1,0,0.3\n1,1,0.29\n"),
                    lab = folder.write("lab.toml",
                                       "radius = \"9 mm\"\nyoungs_modulus = \"1.5 MPa\"\npoisson_ratio = 0.5\n"
                                       "toughness = \"27 mJ/m^2\"\n");
  folder.write("a.toml", "radius = \"8 mm\"\nmodulus = \"3 MPa\"\n");
  const ProgramResult check = run_program({"check", data, "--definition=" + lab, "--toughness=20 mJ/m^2"});
  ASSERT_EQ(check.exit_code, 0) << check.err;
  for (const char* words : {"8 mm", "3 MPa", "20 mJ/m^2"})
    EXPECT_NE(check.out.find(words), std::string::npos) << words << check.out;
  folder.write("a.toml", "radius = \"8 mm\"\ndefinition = \"lab.toml\"\n");  // a path from its own folder
  const ProgramResult key = run_program({"check", data});
  ASSERT_EQ(key.exit_code, 0) << key.err;
  for (const char* words : {"8 mm", "2 MPa", "27 mJ/m^2"})
    EXPECT_NE(key.out.find(words), std::string::npos) << words << key.out;
}

TEST(SavedDefinition, IsNamedInFitDefinitionsByItsPathFromTheirFolder) {
  const TemporaryFolder folder;
  const std::string data = folder.write("a.csv", "P [mN],T [mN],A [mm^2]\n1,0,0.3\n1,1,0.29\n1,2,0.28\n1,3,0.27\n"),
                    lab =
                        folder.write("lab.toml", "radius = \"9 mm\"\nmodulus = \"2 MPa\"\ntoughness = \"27 mJ/m^2\"\n");
  const Words fit{"fit",        data,           "--definition=" + lab,
                  "--models=c", "--format=csv", "--save=" + folder.path("sub/fit.toml")};
  const ProgramResult made = run_program(fit);
  EXPECT_NE(content_of(folder.path("sub/fit.toml")).find("definition = '../lab.toml'"), std::string::npos)
      << content_of(folder.path("sub/fit.toml")) << made.err;
  const ProgramResult again = run_program({"fit", folder.path("sub/fit.toml"), "--format=csv"});
  EXPECT_EQ(again.exit_code, made.exit_code) << again.err;
  EXPECT_EQ(again.out, made.out);
  const ProgramResult itself = run_program({"fit", lab});
  EXPECT_EQ(itself.exit_code, 3);
  EXPECT_NE(itself.complaint().find("states how data are read, and no data: --definition=\"" + lab + "\""),
            std::string::npos)
      << itself.err;
}

TEST(SavedDefinition, ThatIsMissingOrNamesAnotherIsRefused) {
  const TemporaryFolder folder;
  const std::string data = folder.write("a.csv", "P,T,A\n1,0,19.6\n1,1,19.5\n");
  expect_refused({"check", data, "--definition=" + folder.path("none.toml")}, 3,
                 folder.path("none.toml") + ": cannot be opened: No such file or directory");
  const std::string chain = folder.write("chain.toml", "definition = \"lab.toml\"\n");
  expect_refused({"check", data, "--definition=" + chain}, 3, chain + ": names another definition; one is read");
}

TEST(SavedDefinition, HasTheConstantsOfAContactWithoutData) {
  const TemporaryFolder folder;
  const std::string lab = "--definition=" + folder.write("lab.toml",
                                                         "radius = \"9 mm\"\nmodulus = \"2 MPa\"\n"
                                                         "toughness = \"27 mJ/m^2\"\n");
  const Words constants{"--radius=9 mm", "--modulus=2 MPa", "--toughness=27 mJ/m^2"};
  for (const Words& words : {Words{"predict", "--model=c", "--lambda=0.1", "--load=3 mN", "--shear=0,5 mN"},
                             Words{"design", "--model=c", "--lambda=0.1", "--loads=1,4 mN", "--format=csv"}}) {
    Words by_flags = words, by_definition = words;
    by_flags.insert(by_flags.end(), constants.begin(), constants.end());
    by_definition.push_back(lab);
    const ProgramResult expected = run_program(by_flags), found = run_program(by_definition);
    ASSERT_EQ(expected.exit_code, 0) << expected.err;
    EXPECT_EQ(found.out, expected.out) << joined(words) << found.err;
  }
}

}  // namespace saved_definition_test
}  // namespace mixity::cli
