// JSON and CSV of a real fit: names, numbers and what must never appear.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/fit_definition.h"
#include "analysis/run.h"
#include "dataset/temporary_folder.h"
#include "report/fit_csv.h"
#include "report/fit_json.h"

namespace mixity {
namespace fit_tables_test {

const Analysis& mergel() {
  static const Analysis result = run(read_fit_definition(MIXITY_ROOT "/fits/mergel2018.toml"));
  return result;
}

TEST(FitJson, HoldsWhatTheContractNames) {
  const auto json = nlohmann::json::parse(to_json({mergel()}));
  EXPECT_EQ(json.at("schema"), "mixity-fit-1");
  const auto& data = json.at("datasets").at(0);
  for (const char* key : {"path", "provenance", "points", "used", "excluded", "fits"})
    EXPECT_TRUE(data.contains(key)) << key;
  const auto& fit = data.at("fits").at(0);
  for (const char* key : {"model", "objective", "status", "message", "parameters", "r2", "rmse", "max_abs_residual",
                          "area", "paper", "published"})
    EXPECT_TRUE(fit.contains(key)) << key;
  const auto& lambda = fit.at("parameters").at("lambda");
  for (const char* key : {"value", "stderr", "lower", "upper", "at_bound"}) EXPECT_TRUE(lambda.contains(key)) << key;
  for (const char* key : {"r2", "rmse", "unpredicted"}) EXPECT_TRUE(fit.at("area").contains(key)) << key;
  EXPECT_EQ(fit.at("published").at("lambda").at("agrees"), true);
}

TEST(FitJson, ValuesReadBackToTheLastBit) {
  const auto json = nlohmann::json::parse(to_json({mergel()}));
  const auto& fit = json.at("datasets").at(0).at("fits").at(0);
  EXPECT_EQ(fit.at("parameters").at("lambda").at("value").get<double>(), *mergel().fits[0].parameters[0].value);
  EXPECT_EQ(fit.at("r2").get<double>(), *mergel().fits[0].r2);
}

TEST(FitJson, ReconstructedDataSayWhatTheyAre) {
  const auto json = nlohmann::json::parse(to_json({mergel()}));
  if (mergel().data.metadata.provenance == Provenance::reconstructed) {
    EXPECT_EQ(json.at("datasets").at(0).at("notice").get<std::string>(), kReconstructedNotice);
  }
}

std::vector<std::vector<std::string>> read_table(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> row(1);
  bool quoted = false;
  for (const char c : text) {
    if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      row.emplace_back();
    else if (c == '\n' && !quoted)
      rows.push_back(row), row.assign(1, "");
    else
      row.back() += c;
  }
  return rows;
}

void expect_rectangular_without_nan(const std::string& text) {
  const auto rows = read_table(text);
  ASSERT_GT(rows.size(), 1u);
  for (const auto& row : rows) {
    EXPECT_EQ(row.size(), rows[0].size());
    for (const std::string& field : row) {
      EXPECT_NE(field, "nan");
      EXPECT_NE(field, "-nan");
      EXPECT_NE(field, "inf");
    }
  }
}

TEST(FitCsv, TablesAreRectangularAndFreeOfNan) {
  expect_rectangular_without_nan(fits_csv({mergel()}));
  expect_rectangular_without_nan(residuals_csv(mergel()));
  expect_rectangular_without_nan(curves_csv(mergel()));
}

TEST(FitCsv, ResidualsAreModelMinusDataForEveryUsedPoint) {
  const auto rows = read_table(residuals_csv(mergel()));
  ASSERT_EQ(rows.size(), 1 + 3 * mergel().data.points.size());
  EXPECT_EQ(rows[0][6], "residual");
  EXPECT_EQ(rows[0][8], "T [mN]");
  EXPECT_EQ(rows[0][9], "A [mm^2]");
  double squares = 0;
  for (std::size_t i = 1; i <= mergel().data.points.size(); ++i) squares += std::pow(std::stod(rows[i][6]), 2);
  const double n = static_cast<double>(mergel().data.points.size());
  EXPECT_NEAR(std::sqrt(squares / n), *mergel().fits[0].rmse, 1e-15);
}

/// The last area lies below the 55.9 of Hertz: it has no phase angle. Its two fields are empty, its residual is not.
TEST(FitCsv, APointWithoutAPhaseAngleKeepsItsResidual) {
  const TemporaryFolder folder;
  FitRequest request;
  request.data_path = folder.write("a.csv", "P,T,A\n100,0,74.4\n100,20,73\n100,40,67.4\n100,46,55\n");
  request.models = {"c"};
  request.options.objective = Objective::curve;
  const auto rows = read_table(residuals_csv(run(request)));
  ASSERT_EQ(rows.size(), 5u);
  EXPECT_NE(rows[3][4], "");
  EXPECT_EQ(rows[4][4] + rows[4][5], "");
  EXPECT_TRUE(std::isfinite(std::stod(rows[4][6])));
}

/// The paper's fit beside the distance from the curve is the fit that the paper's objective makes.
TEST(FitCsv, HoldsThePapersFitBesideThatOfTheCurve) {
  FitRequest request = read_fit_definition(MIXITY_ROOT "/fits/mergel2018.toml");
  request.options.objective = Objective::curve;
  request.compare = false;
  const auto rows = read_table(fits_csv({run(request)})), of_toughness = read_table(fits_csv({mergel()}));
  const auto column = [&](const std::string& name) {
    return static_cast<std::size_t>(std::find(rows[0].begin(), rows[0].end(), name) - rows[0].begin());
  };
  ASSERT_EQ(rows.size(), 4u);
  ASSERT_LT(column("paper_value"), rows[0].size());
  for (std::size_t i = 1; i < rows.size(); ++i) {
    // 1e-7: beside the curve the kernel makes it, by itself Ceres; both end where the gradient is 1e-8 of its terms
    const double value = std::stod(of_toughness[i][column("value")]);
    EXPECT_NEAR(std::stod(rows[i][column("paper_value")]), value, 1e-7 * value);
    EXPECT_NEAR(std::stod(rows[i][column("paper_r2")]), std::stod(of_toughness[i][column("r2")]), 1e-12);
    EXPECT_EQ(rows[i][column("paper_status")], "ok");
    EXPECT_NE(rows[i][column("value")], of_toughness[i][column("value")]);
    for (const char* name : {"paper_value", "paper_status", "paper_r2"}) EXPECT_EQ(of_toughness[i][column(name)], "");
  }
}

/// Predicted curves are read back by the program's own reader and fulfil the model they were drawn from.
TEST(FitCsv, CurvesEndAtTheInstabilityOfModelC) {
  const auto rows = read_table(curves_csv(mergel()));
  const double lambda = *mergel().fits[0].parameters[0].value, pi_ = pi<double>();
  double T_last = 0;
  for (const auto& row : rows)
    if (row[1] == "c" && row[2] == mergel().data.curves[0]) T_last = std::stod(row[4]);
  const double P = mergel().data.curve_loads[0];
  const double expected = std::sqrt(3 * pi_ * (3 * pi_ + 2 * P) / lambda) * mergel().data.display.force_scale;
  EXPECT_NEAR(T_last, expected, 1e-9 * expected);  // the last point is the fold itself, printed to all digits
}

}  // namespace fit_tables_test
}  // namespace mixity
