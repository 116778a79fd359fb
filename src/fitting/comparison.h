// Compares models (comparison.cc), and one set of parameters for all runs with one set for each (per_curve.cc).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fitting/fit.h"

namespace mixity {

/// Information criteria.
struct Information {
  double aic, bic;
  std::optional<double> aicc;  // needs n > K + 1
};
/// For n points. K counts the parameters, and the error variance where it is not known.
Information information(double sum_of_squares, std::size_t n, std::size_t parameters, bool known_errors);
/// Null without values, for a perfect fit, and for a robust loss in units of the scatter, which differs between fits.
std::optional<Information> information(const FitResult& fit);
/// The same with the constant free that explains the failed tests; null if there is none.
std::optional<Information> information_explained(const FitResult& fit);

/// The points of each run, as indices into Dataset::points. Runs without points are left out.
std::vector<std::vector<std::size_t>> runs_with_points(const Dataset& data);

/// Errors of the predicted areas of loading runs that were left out of the fit, in the file's units. Beyond the last
/// equilibrium, the area at the fold is the prediction.
struct LeftOut {
  double rmse_area;
  std::size_t beyond_fold;  // number of points
  struct Run {
    std::string curve;
    double P;  // dimensionless
    double rmse_area;
    std::size_t points, beyond_fold;
  };
  std::vector<Run> runs;
};
/// Null without loads, with fewer than two runs or more than 200 (each needs a fit to all others), or if a fit without
/// one of them has no value or no equilibrium.
std::optional<LeftOut> leave_one_load_out(const Dataset& data, const FitResult& whole, const FitOptions& options);

/// Model probabilities from the evidence, with equal prior probabilities. Null for fits that have no evidence or fewer
/// points than others; all are null if only one of several fits has evidence, or if one without it may be the best.
std::vector<std::optional<double>> probabilities(const std::vector<FitResult>& fits);

struct ComparedModel {
  std::string model;
  std::optional<double> aicc, bic, weight;  // null where the fit used other points than the rest or has no value
  std::optional<LeftOut> left_out;
  std::optional<double> probability{};  // see probabilities
};

/// Compares all fits of one data set. Akaike weights exp(-d/2)/sum are over the models whose AICc is comparable.
std::vector<ComparedModel> compare_models(const Dataset& data, const std::vector<FitResult>& fits,
                                          const FitOptions& options);

/// The model that each criterion prefers, or several that tie (weights, probabilities or errors equal to 1e-3); empty
/// where it has nothing to compare.
struct Preferences {
  std::vector<std::string> aicc, evidence, left_out;
  bool agree() const;  // the criteria that prefer a model share one, ties included
};
Preferences preferences(const std::vector<ComparedModel>& compared);

/// The fit of one run alone.
struct CurveFit {
  std::string curve;
  double P;  // dimensionless
  FitResult fit;
};

/// Tests one set of parameters for all runs against one set for each: F = ((S_1 - S_m)/(p (m - 1)))/(S_m/(n - p m)), or
/// chi^2 = S_1 - S_m where the errors are known.
struct PerCurve {
  std::string model;
  std::vector<CurveFit> curves;
  std::size_t fitted = 0;  // m, the runs whose own fit has a value; only these are tested
  struct Test {
    bool chi_squared;
    double statistic, freedom, residual_freedom, p_value;
    std::optional<double> aicc_pooled, aicc_separate;
  };
  std::optional<Test> test;
  std::string untested;  // why there is no test; else empty
};

/// The data set must have runs (loads, or a column `curve`).
PerCurve fit_per_curve(const Dataset& data, std::string_view model, const FitOptions& options);

}  // namespace mixity
