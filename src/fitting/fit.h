// One model fitted to one data set, with its goodness of fit: what `mixity fit` reports.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dataset/dataset.h"
#include "fitting/minimise.h"
#include "fitting/toughness_objective.h"

namespace mixity {

/// A parameter held during the fit: at `value`, or without one at what the data set's metadata say of it
/// (r = toughness_II/toughness).
struct HeldParameter {
  std::string name;
  std::optional<double> value;
};

/// "r" or "lambda=0.3". Null if the text is neither.
std::optional<HeldParameter> parse_held(std::string_view text);

struct FitOptions {
  Scale scale = Scale::log;
  std::vector<HeldParameter> hold;  // names a model does not have are ignored for that model
};

struct FittedParameter {
  std::string name;
  std::optional<double> value;    // null if not identifiable
  std::optional<double> stderr_;  // null if held, at a bound, not identifiable
  double lower, upper;
  bool at_bound = false, held = false;
};

/// How well the fitted model predicts the area at the points' loads, in the units of the file.
struct AreaGoodness {
  std::optional<double> r2;  // null if fewer than two points are predicted or all areas are equal
  double rmse = 0, max_abs_residual = 0;
  std::size_t predicted = 0;
  std::size_t unpredicted = 0;               // points beyond the last equilibrium of the fitted model
  std::vector<std::optional<double>> areas;  // per used point, dimensionless; null where unpredicted
};

struct FitResult {
  std::string model, model_name, formula;
  Scale scale = Scale::log;
  FitStatus status = FitStatus::not_converged;
  std::string message;
  std::vector<FittedParameter> parameters;
  std::vector<std::size_t> used;   // indices into Dataset::points
  std::vector<Excluded> excluded;  // usable points that this model cannot describe
  std::optional<double> r2;        // in the fitted space; null without scatter or without a fit
  std::optional<double> rmse, max_abs_residual;
  std::vector<double> residuals;     // per used point, model minus data; empty without a fit
  std::optional<AreaGoodness> area;  // null without loads or without a fit

  bool has_values() const { return status != FitStatus::not_identifiable; }
};

/// Keys of all models: {"a", "b", "c", "bk"}.
std::vector<std::string> model_keys();

/// True if one of these models has a parameter of this name.
bool has_parameter(const std::vector<std::string>& models, std::string_view name);

/// Fits objective `toughness`. `model` must be one of model_keys(). Throws InputError if a parameter is to be held at
/// a value that is out of range or that the data set does not state.
FitResult fit_toughness(const Dataset& data, std::string_view model, const FitOptions& options = {});

}  // namespace mixity
