#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>

#include "cli/run_program.h"
#include "dataset/temporary_folder.h"
#include "report/without_programs.h"

namespace mixity::cli {
namespace command_report_test {

const std::string kDefinition = MIXITY_ROOT "/fits/as4_peek_mmb.toml";

/// Names that a shell or gnuplot would run as a command, or take for an option.
TEST(Report, AFileNameIsNeverACommand) {
  const TemporaryFolder folder;
  const std::string touched = folder.path("touched"), text = content_of(MIXITY_ROOT "/data/mergel2018.csv"),
                    constants = content_of(MIXITY_ROOT "/data/mergel2018.toml");
  ::setenv("MIXITY_TOUCHED", touched.c_str(), 1);
  for (const std::string name :
       {"`touch $MIXITY_TOUCHED`", "<touch $MIXITY_TOUCHED;", "|touch $MIXITY_TOUCHED;", "-k", "$a", "a\nb"}) {
    const std::string data = folder.write(name + ".csv", text);
    folder.write(name + ".toml", constants);
    const ProgramResult result =
        run_program({"report", data, "--models=c", "--formats=pdf,gnuplot", "--out", folder.path("out")});
    EXPECT_EQ(result.exit_code, 0) << name;
    EXPECT_EQ(result.err, "") << name;
    EXPECT_FALSE(std::filesystem::exists(touched)) << name;
  }
  ::unsetenv("MIXITY_TOUCHED");
}

TEST(Report, NamesItsPageAndRepeatsItsCommand) {
  const TemporaryFolder folder;
  const std::string out = folder.path("new folder/report");
  const ProgramResult result = run_program({"report", kDefinition, "--out", out, "--confidence=0.9"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  const std::vector<std::string> lines = lines_of(result.out);
  ASSERT_GT(lines.size(), 4u);
  EXPECT_EQ(lines[0], out + "/report.html");
  EXPECT_EQ(lines[2], "as4_peek_mmb (measured)");
  EXPECT_TRUE(lines[3].starts_with("Model ")) << lines[3];
  const std::string page = content_of(out + "/report.html");
  EXPECT_NE(page.find("mixity report " + kDefinition + " --out '" + out + "' --confidence=0.9"), std::string::npos);
  EXPECT_NE(page.find("(90 % interval)"), std::string::npos);
}

TEST(Report, PutsContactsFirstAndReconstructedDataLast) {
  const TemporaryFolder folder;
  const std::string fits = MIXITY_ROOT "/fits/";
  folder.write("dry.csv", "P,T,A\n1,0,9.3\n1,2,9.2\n1,4,9\n1,6,8.6\n");
  const ProgramResult result = run_program({"report", fits + "waters_guduru2010.toml", fits + "mergel2018.toml",
                                            kDefinition, folder.path("dry.csv"), "--out", folder.path("out")});
  std::string order;
  for (const std::string& line : lines_of(result.out))
    for (const char* name : {"dry", "as4_peek_mmb", "mergel2018", "waters_guduru2010"})
      if (line.starts_with(name + std::string(" ("))) order += name + std::string(" ");
  EXPECT_EQ(order, "dry as4_peek_mmb mergel2018 waters_guduru2010 ") << result.out << result.err;
}

TEST(Report, OfTheSameDataTwiceKeepsBoth) {
  const TemporaryFolder folder;
  const ProgramResult result = run_program({"report", kDefinition, kDefinition, "--out", folder.path("out")});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(folder.path("out/figures/as4_peek_mmb_toughness.svg")));
  EXPECT_TRUE(std::filesystem::exists(folder.path("out/figures/as4_peek_mmb-2_toughness.svg")));
}

/// Tables of several data sets tell their rows by this name.
TEST(Report, OfTwoDataSetsOfOneNameTellsThemApart) {
  const TemporaryFolder folder;
  for (const char* day : {"monday", "friday"}) {
    std::filesystem::create_directory(folder.path(day));
    folder.write(std::string(day) + "/run.csv", "P,T,A\n1,0,19.6\n1,1,19.5\n1,3,18.7\n1,5,17.5\n");
  }
  const std::string out = folder.path("out");
  run_program({"fit", folder.path("monday/run.csv"), folder.path("friday/run.csv"), "--models=c", "--out", out});
  const std::string fits = content_of(out + "/fits.csv");
  for (const char* name : {"\nmonday/run,", "\nfriday/run,"}) EXPECT_NE(fits.find(name), std::string::npos) << fits;
  for (const char* file : {"/monday_run_curves.csv", "/friday_run_curves.csv"})
    EXPECT_TRUE(std::filesystem::exists(out + file)) << file;
}

TEST(Report, OfAFitThatDoesNotEndOkIsWrittenAndEndsWithOne) {
  const TemporaryFolder folder;
  const std::string data = folder.write("still.csv", "P,T,A\n1,0,10\n2,0,11\n3,0,12\n");
  const ProgramResult result = run_program({"report", data, "--models=c", "--out", folder.path("out")});
  EXPECT_EQ(result.exit_code, 1) << result.err;
  EXPECT_NE(content_of(folder.path("out/report.html")).find("not identifiable"), std::string::npos);
}

TEST(Report, DrawsPeakForcesThatTheDefinitionNames) {
  const TemporaryFolder folder;
  folder.write("run.csv", "P,T,A\n3,0,21.87\n3,5,21.4\n3,10,20\n3,15,17.5\n");
  folder.write("peaks.csv", "P,T_peak,T_min\n2,7,5\n-1,3,2\n4,9,8\n#5,9,8\n6,-1,8\n");
  const std::string definition =
      folder.write("fit.toml", "data = \"run.csv\"\nmodels = [\"c\"]\npeaks = \"peaks.csv\"\n");
  const ProgramResult result = run_program({"report", definition, "--out", folder.path("out")});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(std::filesystem::exists(folder.path("out/figures/run_peaks.svg")));
  for (const char* line : {"\"line\": 3", "\"line\": 5", "\"line\": 6"})
    EXPECT_NE(content_of(folder.path("out/results.json")).find(line), std::string::npos) << line;
  folder.write("peaks.csv", "P,T_peak\n2,x\n");
  const ProgramResult refused = run_program({"report", definition, "--out", folder.path("out")});
  EXPECT_EQ(refused.exit_code, 3);
  EXPECT_EQ(refused.complaint(), "mixity: " + folder.path("peaks.csv") + ":2:3: column 'T_peak': 'x' is not a number");
}

TEST(Report, HasItsAnglesAndAreasWhereAPointHasNoPhaseAngle) {
  const TemporaryFolder folder;
  const std::string data = folder.write(
      "run.csv", "P,T,A\n1,-0.01,19.6\n1,5,19.2\n1,7,18.9\n1,10,18\n1,25,2.59\n5,0,23.9\n5,8,23\n5,12,22\n");
  run_program({"report", data, "--models=a,c", "--objective=toughness", "--out", folder.path("out")});
  for (const char* figure : {"toughness", "residuals_psi", "residuals_T", "area_models"})
    EXPECT_TRUE(std::filesystem::exists(folder.path("out/figures/run_" + std::string(figure) + ".svg"))) << figure;
  const std::string page = content_of(folder.path("out/report.html"));
  for (const char* words : {"8 data rows, 8 used, 0 excluded", "line 6, models c, a: y &lt;= 0"})
    EXPECT_NE(page.find(words), std::string::npos) << words;
}

TEST(Report, OfEnergiesShowsTheirToughness) {
  const TemporaryFolder folder;
  const std::string data =
      folder.write("mmb.csv",
                   "G_I [N/mm],G_II [N/mm],sigma_GI [%],sigma_GII [%]\n0.25,-0.01,5,5\n0.2,0.06,5,5\n"
                   "0.15,0.14,5,5\n0.1,0.3,5,5\n");
  const ProgramResult result =
      run_program({"report", data, "--models=c", "--toughness=0.25 N/mm", "--out", folder.path("out")});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(std::filesystem::exists(folder.path("out/figures/mmb_toughness.svg")));
  const std::string page = content_of(folder.path("out/report.html"));
  EXPECT_NE(page.find("the data are (G<sub>I</sub>, G<sub>II</sub>): they have no loads and areas"), std::string::npos);
}

/// Endings of the files of one figure.
std::set<std::string> endings(const std::string& figures) {
  std::set<std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(figures))
    if (entry.path().stem() == "as4_peek_mmb_toughness") found.insert(entry.path().extension());
  return found;
}

TEST(Report, HasFiguresInTheFormatsThatAreAskedFor) {
  const TemporaryFolder folder;
  const auto made = [&](const std::string& name, const Words& more) {
    Words words{"report", kDefinition, "--out", folder.path(name)};
    words.insert(words.end(), more.begin(), more.end());
    const ProgramResult result = run_program(words);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return endings(folder.path(name + "/figures"));
  };
  EXPECT_EQ(made("all", {"--formats=pdf,png,gnuplot"}), (std::set<std::string>{".svg", ".pdf", ".png", ".gp", ".dat"}));
  EXPECT_EQ(made("png", {"--formats=png"}), (std::set<std::string>{".svg", ".png"}));
  expect_refused({"report", kDefinition, "--out", folder.path("none"), "--formats=eps"}, 2,
                 "flag '--formats' names the unknown format 'eps' (known: pdf, png, gnuplot, none)");
  const WithoutPrograms nothing;
  EXPECT_EQ(made("svg", {}), std::set<std::string>{".svg"});
  EXPECT_EQ(made("script", {"--formats=gnuplot"}), (std::set<std::string>{".svg", ".gp", ".dat"}));
}

TEST(Report, WithoutGnuplotLeavesTablesScriptsAndALineOnWhatIsMissing) {
  const TemporaryFolder folder;
  const WithoutPrograms nothing;
  const ProgramResult result =
      run_program({"report", kDefinition, "--formats=pdf,gnuplot", "--out", folder.path("out")});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.complaint().find("gnuplot"), std::string::npos) << result.complaint();
  EXPECT_TRUE(std::filesystem::exists(folder.path("out/results.json")));
  EXPECT_EQ(endings(folder.path("out/figures")), (std::set<std::string>{".svg", ".gp", ".dat"}));
}

TEST(Report, WithoutDataOrAPlaceToGoIsBadUsage) {
  expect_refused({"report"}, 2, "report needs a data CSV or a fit definition (see mixity help report)");
  expect_refused({"report", kDefinition}, 2, "report needs --out=DIR");
}

TEST(Report, InAFolderThatCannotBeWrittenEndsWithFour) {
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "");
  EXPECT_EQ(run_program({"report", kDefinition, "--out", file + "/below"}).exit_code, 4);
}

}  // namespace command_report_test
}  // namespace mixity::cli
