// The statistics of fits in JSON.
#include <gtest/gtest.h>

#include <algorithm>

#include "fitting/synthetic_runs.h"
#include "report/fit_json.h"

namespace mixity {
namespace fit_statistics_json_test {

/// Keys of an object, sorted.
std::vector<std::string> keys(const Json& object) {
  std::vector<std::string> names;
  for (const auto& [name, value] : object.items()) names.push_back(name);
  std::sort(names.begin(), names.end());
  return names;
}

using Names = std::vector<std::string>;

/// What `mixity fit --objective=curve --free=toughness --per=curve --models=a,c` computes.
Analysis whole_request() {
  Analysis result;
  SeededNoise noise(2, 0.005);
  result.data = synthetic_runs("c", {0.2}, {1, 5, 20}, 10, 0.8, noise);
  result.data.display = {"mN", "mm^2", "", 0.25, 0.01};
  result.request.models = {"a", "c"};
  result.request.options.objective = Objective::curve;
  result.request.options.free = {kToughness};
  for (const std::string& model : result.request.models) {
    result.fits.push_back(fit_model(result.data, model, result.request.options));
    result.per_curve.push_back(fit_per_curve(result.data, model, result.request.options));
  }
  result.comparison = compare_models(result.data, result.fits, result.request.options);
  return result;
}

TEST(FitStatisticsJson, OutliersHaveTheirLineRunAndSize) {
  Analysis result = whole_request();
  result.fits[0].outliers = {{12, -5.25}};
  EXPECT_EQ(Json::parse(to_json({result}))["datasets"][0]["fits"][0]["outliers"],
            Json::parse(R"([{"line": 14, "curve": "run 2", "size": -5.25}])"));
  result.data.files = {{"one.csv", 0}, {"two.csv", 10}};
  EXPECT_EQ(Json::parse(to_json({result}))["datasets"][0]["fits"][0]["outliers"],
            Json::parse(R"([{"line": 4, "file": "two.csv", "curve": "run 2", "size": -5.25}])"));
}

TEST(FitStatisticsJson, HasTheKeysOfItsSchema) {
  const Json data = Json::parse(to_json({whole_request()}))["datasets"][0];
  ASSERT_EQ(data["fits"].size(), 2);
  for (const Json& fit : data["fits"]) {
    EXPECT_EQ(keys(fit["errors"]), (Names{"by_run", "constant_A", "constant_T", "correlation_A", "correlation_T",
                                          "raised_A", "raised_T", "relative_scatter", "run_factors", "share_A",
                                          "share_T", "sigma_A", "sigma_T", "step_A", "step_T"}));
    EXPECT_EQ(fit["errors"]["sigma_A"], "scatter");
    EXPECT_TRUE(fit["errors"]["relative_scatter"].is_number());
    EXPECT_EQ(fit["errors"]["raised_A"], 0);
    EXPECT_EQ(keys(fit["paper"]), (Names{"parameters", "points", "r2", "status"}));
    EXPECT_EQ(keys(fit["paper"]["parameters"]), Names{"lambda"});  // the paper frees no constants
    EXPECT_EQ(fit["paper"]["points"], 30);
    EXPECT_TRUE(fit["loss_scale"].is_null());
    ASSERT_EQ(fit["correlations"].size(), 1);
    EXPECT_EQ(fit["correlations"][0]["parameters"], Json({"lambda", "toughness"}));
    EXPECT_TRUE(fit["correlations"][0]["value"].is_number());
    for (const char* name : {"lambda", "toughness"}) {
      const Json& interval = fit["parameters"][name]["interval"];
      EXPECT_EQ(keys(interval), (Names{"confidence", "high", "high_status", "low", "low_status", "method"}));
      EXPECT_EQ(interval["method"], "profile");
      EXPECT_EQ(interval["confidence"], 0.95);
      EXPECT_LT(interval["low"], interval["high"]);
      EXPECT_EQ(interval["low_status"], "found");
    }
  }
  ASSERT_EQ(data["comparison"].size(), 2);
  for (const Json& entry : data["comparison"])
    EXPECT_EQ(keys(entry), (Names{"aicc", "bic", "loo_beyond_fold", "loo_curves", "loo_rmse_area", "model",
                                  "probability", "weight"}));
  ASSERT_EQ(data["per_curve"].size(), 2);
  for (const Json& entry : data["per_curve"]) {
    EXPECT_EQ(keys(entry), (Names{"curves", "fitted", "model", "test", "untested"}));
    EXPECT_EQ(entry["fitted"], 3);
    EXPECT_EQ(keys(entry["test"]),
              (Names{"aicc_pooled", "aicc_separate", "freedom", "kind", "p_value", "residual_freedom", "statistic"}));
    EXPECT_EQ(entry["test"]["kind"], "F");
    ASSERT_EQ(entry["curves"].size(), 3);
    for (const Json& curve : entry["curves"]) {
      EXPECT_EQ(keys(curve), (Names{"curve", "load", "load_dimensionless", "parameters", "points", "status"}));
      EXPECT_EQ(keys(curve["parameters"]["lambda"]), (Names{"interval", "stderr", "value"}));
    }
    EXPECT_EQ(entry["curves"][1]["load_dimensionless"], 5);
    EXPECT_EQ(entry["curves"][1]["load"], 1.25);  // 0.25 mN each
    EXPECT_EQ(entry["curves"][1]["points"], 10);
  }
}

TEST(FitStatisticsJson, WritesWhatIsMissingAsNull) {
  Analysis result;
  result.fits.resize(2);
  result.fits[1].parameters = {{"lambda", 2, {}, 0, 2, true}};
  result.fits[1].parameters[0].interval = {"profile", 0.9, {}, 2.0, EndStatus::open, EndStatus::at_bound};
  const Json fits = Json::parse(to_json({result}))["datasets"][0]["fits"];
  EXPECT_TRUE(fits[0]["errors"].is_null());
  EXPECT_EQ(fits[0]["correlations"], Json::array());
  const Json open = fits[1]["parameters"]["lambda"]["interval"];
  EXPECT_TRUE(open["low"].is_null());
  EXPECT_EQ(open["low_status"], "open");
  EXPECT_EQ(open["high"], 2.0);
  EXPECT_EQ(open["high_status"], "at_bound");
  result.fits[1].parameters[0].interval.reset();
  EXPECT_TRUE(Json::parse(to_json({result}))["datasets"][0]["fits"][1]["parameters"]["lambda"]["interval"].is_null());

  result.comparison = {{"a", {}, {}, {}, {}}};
  result.per_curve.resize(1);
  result.per_curve[0].curves.push_back({"all", 0, {}});
  result.per_curve[0].untested = "too few points";
  const Json data = Json::parse(to_json({result}))["datasets"][0];
  const Json compared = data["comparison"][0];
  for (const char* key : {"aicc", "bic", "weight", "loo_rmse_area", "loo_beyond_fold"})
    EXPECT_TRUE(compared[key].is_null()) << key;
  const Json per_curve = data["per_curve"][0];
  EXPECT_TRUE(per_curve["test"].is_null());
  EXPECT_EQ(per_curve["untested"], "too few points");
  EXPECT_TRUE(per_curve["curves"][0]["load"].is_null());  // (psi, Gc) data have none
}

TEST(FitStatisticsJson, LeavesOutHeldParametersFromCorrelations) {
  Analysis result;
  result.fits.resize(1);
  result.fits[0].parameters = {{"r", 2, {}, 0, 10, false, true}, {"eta", 2, 0.1, 0, 10}, {"modulus", 1, 0.1, 0, 10}};
  result.fits[0].correlations = {1, -0.25, -0.25, 1};
  EXPECT_EQ(Json::parse(to_json({result}))["datasets"][0]["fits"][0]["correlations"],
            Json::parse(R"([{"parameters": ["eta", "modulus"], "value": -0.25}])"));
}

}  // namespace fit_statistics_json_test
}  // namespace mixity
