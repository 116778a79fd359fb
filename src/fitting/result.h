// What a fit says, as plain numbers in a reader's units.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dataset/dataset.h"
#include "fitting/options.h"
#include "fitting/standard_errors.h"
#include "solver/results.h"

namespace mixity {

/// An interval as a reader sees it. A missing end is open.
struct ShownInterval {
  std::string method;  // profile
  double confidence;
  std::optional<double> low, high;
  EndStatus low_status, high_status;
};

struct FittedParameter {
  std::string name;
  std::optional<double> value;    // null if not identifiable
  std::optional<double> stderr_;  // null if held, at a bound, not identifiable
  double lower, upper;
  bool at_bound = false, held = false;
  std::optional<ShownInterval> interval{};
  std::optional<Bootstrapped> bootstrap{};  // in the reader's unit
  std::string unit{};                       // empty if dimensionless
  std::optional<DrawnProfile> profile{};    // x in the reader's unit; if asked for
};

/// How well the fitted model predicts the area at the points' loads, in the units of the file.
struct AreaGoodness {
  std::optional<double> r2;  // null if fewer than two points are predicted or all areas are equal
  double rmse = 0, max_abs_residual = 0;
  std::size_t predicted = 0;
  std::size_t unpredicted = 0;               // points beyond the last equilibrium of the fitted model
  std::vector<std::optional<double>> areas;  // per used point, dimensionless; null where unpredicted
  std::string_view obstacle{};               // why the law defines no area with these parameters; else empty
};

/// The paper's fit of the same data: ln(Gc/GIc) against psi, every point with the same weight.
struct PaperFit {
  FitStatus status = FitStatus::not_converged;
  std::vector<FittedParameter> parameters;
  std::optional<double> r2;
  std::size_t points = 0;

  /// Null where the fit has none: a constant of the experiment, not identifiable.
  std::optional<double> value_of(std::string_view parameter) const {
    for (const FittedParameter& one : parameters)
      if (one.name == parameter) return one.value;
    return std::nullopt;
  }
};

struct FitResult {
  std::string model, model_name, formula;
  Objective objective = Objective::toughness;
  Scale scale = Scale::log;
  FitStatus status = FitStatus::not_converged;
  std::string message;
  std::vector<FittedParameter> parameters;
  std::vector<std::size_t> used;   // indices into Dataset::points
  std::vector<Excluded> excluded;  // usable points that this model cannot describe
  std::optional<double> r2;        // in the fitted space; null without scatter or without a fit
  std::optional<double> rmse, max_abs_residual;
  std::vector<double> residuals;         // per used point, model minus data; empty without a fit
  std::optional<AreaGoodness> area;      // null without loads or without a fit
  std::optional<PaperFit> paper;         // beside the objective curve of loads
  bool known_errors = false;             // the residuals are in units of known standard errors
  std::optional<StandardErrors> errors;  // of the points, where the objective uses them
  std::vector<double> correlations;      // [p x p] of the free parameters in order; empty for one
  std::size_t free_parameters = 0;
  double sum_of_squares = 0;  // of the (weighted) residuals, or of the robust loss
  std::optional<BootstrapResult> bootstrap;
  std::optional<Influence> influence;  // changes in the reader's units; points as in `used`
  std::vector<std::string> run_names;  // of Influence::runs
  double loss_scale = 0;               // in units of the residuals; 0 without a robust loss

  bool has_values() const { return status != FitStatus::not_identifiable; }
};

/// Whether each of the parameters has a value.
inline bool has_all_values(const FitResult& fit) {
  for (const FittedParameter& parameter : fit.parameters)
    if (!parameter.value) return false;
  return true;
}

}  // namespace mixity
