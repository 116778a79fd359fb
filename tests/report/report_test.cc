// The files of a report and how their numbers agree with those of `fit`.
#include "report/report.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "analysis/run.h"
#include "base/files.h"
#include "dataset/load_text.h"
#include "dataset/temporary_folder.h"
#include "report/example_results.h"
#include "report/fit_json.h"

namespace mixity {
namespace report_test {

using Json = nlohmann::json;

/// Two shipped data sets, with and without loads, reported once for all tests.
class Report : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    results_ = new std::vector<Analysis>{shipped("mergel2018"), shipped("waters_guduru2010")};
    const std::vector<ReportedData> data{reported_data((*results_)[0], "mergel2018"),
                                         reported_data((*results_)[1], "waters_guduru2010")};
    written_ = write_report(*results_, data, folder_->path(), {"mixity report 'a b.toml'", {}});
  }
  static void TearDownTestSuite() {
    delete results_;
    delete folder_;
  }
  static std::string content(const std::string& name) { return read_file(folder_->path(name)); }

  static inline TemporaryFolder* folder_ = nullptr;
  static inline std::vector<Analysis>* results_ = nullptr;
  static inline WrittenReport written_;
};

TEST_F(Report, HasAPageASummaryAndTables) {
  EXPECT_EQ(written_.page, folder_->path("report.html"));
  EXPECT_EQ(written_.missing, "");
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder_->path()))
    names.insert(entry.path().filename().string());
  EXPECT_EQ(names, (std::set<std::string>{".mixity-files", "report.html", "summary.md", "results.json", "fits.csv",
                                          "residuals.csv", "curves.csv", "figures"}));
}

TEST_F(Report, HasTheExplorerBesideItAndALinkWhereThereIsOne) {
  TemporaryFolder folder;
  const std::string shell = folder.write("shell.html", "<script type=\"application/json\" id=\"data\">null</script>");
  const std::vector<ReportedData> data{reported_data((*results_)[0], "x")};
  write_report(*results_, data, folder.path("report"), {"mixity", {}, shell});
  EXPECT_NE(read_file(folder.path("report/explorer.html")).find("mergel2018.csv"), std::string::npos);
  EXPECT_NE(read_file(folder.path("report/report.html")).find("href=\"explorer.html\""), std::string::npos);
  EXPECT_EQ(content("report.html").find("explorer.html"), std::string::npos);
}

TEST_F(Report, JsonHoldsTheFitsAsFitDoes) {
  const Json report = Json::parse(content("results.json"));
  EXPECT_EQ(report["schema"], "mixity-report-1");
  EXPECT_EQ(report["command"], "mixity report 'a b.toml'");
  std::size_t i = 0;
  for (const char* name : {"mergel2018", "waters_guduru2010"}) {
    const Analysis fitted = run(read_fit_definition(MIXITY_ROOT "/fits/" + std::string(name) + ".toml"));
    const Json fit = Json::parse(to_json({fitted}))["datasets"][0];
    for (const char* key : {"path", "name", "provenance", "notice", "points", "excluded", "comparison"})
      EXPECT_EQ(report["datasets"][i][key], fit[key]) << name << ' ' << key;
    // the same fits, the best of them first
    const auto of_model = [](const Json& fits, const std::string& model) {
      for (const Json& one : fits)
        if (one["model"] == model) return one;
      return Json();
    };
    const Json& fits = report["datasets"][i]["fits"];
    ASSERT_EQ(fits.size(), fit["fits"].size());
    EXPECT_EQ(fits[0]["model"], report["datasets"][i]["answer"]["model"]);
    for (const Json& one : fit["fits"]) EXPECT_TRUE(of_model(fits, one["model"]) == one) << name << ' ' << one["model"];
    ++i;
  }
}

TEST_F(Report, JsonNamesEveryFigureAndItsFiles) {
  const Json report = Json::parse(content("results.json"));
  std::set<std::string> listed, there;
  for (const Json& data : report["datasets"])
    for (const Json& figure : data["figures"])
      for (const Json& file : figure["files"]) listed.insert(file.get<std::string>());
  for (const auto& entry : std::filesystem::directory_iterator(folder_->path("figures")))
    there.insert("figures/" + entry.path().filename().string());
  there.erase("figures/.mixity-files");
  EXPECT_EQ(listed, there);
}

TEST_F(Report, ResidualTableHoldsEveryResidualToTheLastBit) {
  std::istringstream table(content("residuals.csv"));
  std::string line;
  std::getline(table, line);
  EXPECT_EQ(
      line,
      "dataset,provenance,model,line,curve,psi [rad],Gc_over_GIc,residual,P,T,A,A_predicted,force_unit,area_unit");
  for (const Analysis& result : *results_)
    for (const FitResult& fit : result.fits)
      for (std::size_t i = 0; i < fit.residuals.size(); ++i) {
        ASSERT_TRUE(std::getline(table, line));
        std::vector<std::string> fields;
        std::istringstream stream(line + ",");
        for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
        ASSERT_EQ(fields.size(), 14u) << line;
        EXPECT_EQ(fields[0], result.data.name);
        EXPECT_EQ(fields[1], "reconstructed");
        EXPECT_EQ(fields[2], fit.model);
        EXPECT_EQ(std::stoul(fields[3]), result.data.points[fit.used[i]].line);
        EXPECT_EQ(std::stod(fields[7]), fit.residuals[i]);
        EXPECT_EQ(fields[8].empty(), !result.data.has_loads);
        EXPECT_EQ(fields[12], result.data.has_loads ? "mN" : "");
      }
  EXPECT_FALSE(std::getline(table, line));
}

TEST_F(Report, CurveTableHasAsManyFieldsForEveryDataSet) {
  std::istringstream table(content("curves.csv"));
  std::set<std::string> sets;
  for (std::string line; std::getline(table, line);) {
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), 10) << line;
    sets.insert(line.substr(0, line.find(',')));
  }
  EXPECT_EQ(sets, (std::set<std::string>{"dataset", "mergel2018", "waters_guduru2010"}));
}

TEST_F(Report, IsTheSameToTheByteWhenMadeAgain) {
  const TemporaryFolder again;
  const std::vector<ReportedData> data{reported_data((*results_)[0], "mergel2018"),
                                       reported_data((*results_)[1], "waters_guduru2010")};
  write_report(*results_, data, again.path(), {"mixity report 'a b.toml'", {}});
  for (const char* name : {"report.html", "summary.md", "results.json", "fits.csv", "residuals.csv", "curves.csv"})
    EXPECT_EQ(read_file(again.path(name)), content(name)) << name;
}

TEST(ReportUnits, OfPagesAreAReadersAndThoseOfTablesTheFiles) {
  FitRequest request;
  request.models = {"c"};
  const std::string csv =
      "P [Newton],T [Newton],A [mm\\+(2)]\n0.0077,0,0.457\n0.0077,0.05,0.444\n0.0077,0.08,0.425\n0.0077,0.1,0.41\n"
      "0.0029,0,0.319\n0.0029,0.05,0.289\n0.0029,0.07,0.262\n0.0029,0.08,0.241\n";
  const std::vector<Analysis> results{run_for_report(
      request, load_text(csv, "radius = \"9.42 mm\"\nmodulus = \"2.133 MPa\"\ntoughness = \"27 mJ/m^2\"\n"))};
  const TemporaryFolder folder;
  write_report(results, {reported_data(results[0], "x")}, folder.path(), {"mixity", {}});
  const std::string page = read_file(folder.path("report.html"));
  EXPECT_NE(page.find("T [mN]"), std::string::npos);
  EXPECT_EQ(page.find("[Newton]"), std::string::npos);
  EXPECT_EQ(page.find("\\+("), std::string::npos);
  const std::string summary = read_file(folder.path("summary.md"));
  EXPECT_NE(summary.find("P [mN]"), std::string::npos);
  EXPECT_NE(summary.find("mm²"), std::string::npos);
  const Json json = Json::parse(read_file(folder.path("results.json")));
  EXPECT_NEAR(json["datasets"][0]["answer"]["jumps"][0]["P"].get<double>(), 0.0077, 1e-12);  // rounding
  const std::string table = read_file(folder.path("residuals.csv"));
  EXPECT_NE(table.find(",Newton,mm^2\n"), std::string::npos) << table;
}

TEST(ReportProgress, RisesToOne) {
  const TemporaryFolder folder;
  const std::vector<Analysis> results{shipped("as4_peek_mmb")};
  double last = 0;
  write_report(results, {reported_data(results[0], "x")}, folder.path(), {"mixity", [&](double fraction) {
                                                                            EXPECT_GE(fraction, last);
                                                                            last = fraction;
                                                                          }});
  EXPECT_EQ(last, 1);
}

TEST(ReportFolder, ThatCannotBeWrittenIsSaid) {
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "");
  const std::vector<Analysis> results{shipped("as4_peek_mmb")};
  EXPECT_THROW(write_report(results, {reported_data(results[0], "x")}, file + "/below", {}), OutputError);
}

}  // namespace report_test
}  // namespace mixity
