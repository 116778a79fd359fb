#include <gtest/gtest.h>

#include "cli/run_program.h"
#include "dataset/table/workbook_files.h"

namespace mixity::cli {
namespace workbook_test {

/// The lines of a shipped CSV as cells.
std::vector<std::vector<std::string>> shipped(const std::string& name) {
  std::vector<std::vector<std::string>> rows;
  for (const std::string& line : lines_of(content_of(MIXITY_ROOT "/data/" + name)))
    if (!line.starts_with('#')) rows.push_back(fields_of(line));
  return rows;
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
}

}  // namespace workbook_test
using namespace workbook_test;

TEST(Workbook, IsFittedAsItsCsv) {
  const TemporaryFolder folder;
  folder.write("run.toml", content_of(MIXITY_ROOT "/data/mergel2018.toml"));
  const Words options{"--models=c", "--format=json"};
  const auto fitted = [&](const std::string& name) {
    Words words{"fit", folder.path(name)};
    words.insert(words.end(), options.begin(), options.end());
    ProgramResult result = run_program(words);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.out;
  };
  folder.write("run.csv", content_of(MIXITY_ROOT "/data/mergel2018.csv"));
  folder.write("run.xlsx",
               zipped(workbook_parts({{"Notes", rows_xml({{"ours"}})}, {"Run", rows_xml(shipped("mergel2018.csv"))}})));
  std::string csv = fitted("run.csv"), sheet = fitted("run.xlsx");
  const auto numbers = [](const std::string& json) { return json.substr(json.find("\"fits\"")); };
  ASSERT_NE(csv.find("\"fits\""), std::string::npos);
  EXPECT_EQ(numbers(sheet), numbers(csv));
}

TEST(Workbook, LogsAreCutAsTheirCsv) {
  const TemporaryFolder folder;
  folder.write("log.toml", content_of(MIXITY_ROOT "/data/shear_log.toml"));
  folder.write("log.csv", content_of(MIXITY_ROOT "/data/shear_log.csv"));
  folder.write("log.xlsx", zipped(workbook_parts({{"Log", rows_xml(shipped("shear_log.csv"))}})));
  for (const char* kind : {"csv", "xlsx"}) {
    const ProgramResult result =
        run_program({"runs", folder.path("log." + std::string(kind)), "--out=" + folder.path(kind)});
    EXPECT_EQ(result.exit_code, 0) << result.err;
  }
  for (const char* file : {"/peaks.csv", "/runs.csv", "/cuts.toml"}) {
    std::string csv = content_of(folder.path("csv") + file), sheet = content_of(folder.path("xlsx") + file);
    replace_all(sheet, "log.xlsx", "log.csv");
    EXPECT_FALSE(csv.empty());
    EXPECT_EQ(sheet, csv) << file;
  }
}

TEST(Workbook, SheetChoosesInEveryCommand) {
  const TemporaryFolder folder;
  const auto table = [](const std::string& T) {
    return rows_xml({{"P [mN]", "T [mN]", "A [mm^2]"}, {"5", T, "0.4"}, {"5", "2", "0.3"}});
  };
  const std::string file = folder.write("a.xlsx", zipped(workbook_parts({{"One", table("0")}, {"Two", table("abc")}})));
  const Words constants{"--radius=9mm", "--modulus=2MPa", "--toughness=27mJ/m^2"};
  const auto checked = [&](const std::string& option) {
    Words words{"check", file};
    if (!option.empty()) words.push_back(option);
    words.insert(words.end(), constants.begin(), constants.end());
    return run_program(words);
  };
  EXPECT_NE(checked("").out.find("read as: sheet 'One'"), std::string::npos) << checked("").out << checked("").err;
  EXPECT_NE(checked("").out.find("--sheet=Two"), std::string::npos) << checked("").out;
  for (const char* two : {"--sheet=Two", "--sheet=2"})
    EXPECT_NE(checked(two).err.find("a.xlsx:2:"), std::string::npos) << checked(two).err;
  folder.write("a.toml", "sheet = \"Two\"\n");
  EXPECT_NE(checked("").err.find("'abc' is not a number"), std::string::npos) << checked("").err;
  // and in import
  const std::string plot =
      folder.write("b.xlsx", zipped(workbook_parts({{"A", rows_xml({{"x", "y"}})},
                                                    {"B", rows_xml({{"dry", ""}, {"0", "0.4"}, {"1.234", "0.3"}})}})));
  const ProgramResult imported =
      run_program({"import", plot, "--sheet=B", "--x=T [mN]", "--y=A [mm^2]", "--loads=5mN"});
  EXPECT_EQ(imported.out, "curve,P [mN],T [mN],A [mm^2]\ndry,5,0,0.4\ndry,5,1.2340,0.3\n") << imported.err;
}

TEST(Workbook, IsNamedWhereASheetIsStatedAndTheFileIsNone) {
  const TemporaryFolder folder;
  const std::string data = folder.write("a.csv", "P,T,A\n1,0,19.6\n1,1,19.5\n"),
                    note = "the sheet that is stated, 'Run 2', is not used: the file is no workbook";
  EXPECT_NE(run_program({"check", data, "--sheet=Run 2"}).out.find(note), std::string::npos);
  EXPECT_NE(run_program({"runs", MIXITY_ROOT "/data/shear_log.csv", "--sheet=Run 2"}).out.find(note),
            std::string::npos);
  const std::string plot = folder.write("plot.csv", "run 1,\nX,Y\n0,19.6\n1,19.5\n");
  expect_refused({"import", plot, "--x=T", "--y=A", "--loads=1", "--sheet=2"}, 3,
                 "--sheet: " + plot + " is no workbook");
}

}  // namespace mixity::cli
