// One model fitted to one data set, with its goodness of fit: what `mixity fit` reports.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dataset/dataset.h"
#include "fitting/interval.h"
#include "fitting/minimise.h"
#include "fitting/resample.h"
#include "fitting/robust.h"
#include "fitting/standard_errors.h"
#include "fitting/toughness_objective.h"
#include "fitting/trial.h"

namespace mixity {

/// A parameter held during the fit: at `value`, or without one at what the data set's metadata say of it
/// (r = toughness_II/toughness).
struct HeldParameter {
  std::string name;
  std::optional<double> value;
};

/// "r" or "lambda=0.3". Null if the text is neither.
std::optional<HeldParameter> parse_held(std::string_view text);

/// toughness: Gc/GIc against psi. area: A against T. curve: distance from the curve in the plane of T and A.
enum class Objective { toughness, area, curve };
std::string_view to_string(Objective objective);
std::optional<Objective> parse_objective(std::string_view text);

struct FitOptions {
  Objective objective = Objective::toughness;
  Scale scale = Scale::log;           // of toughness
  bool weighted = false;              // toughness: by each point's standard error, which the others always use
  std::vector<HeldParameter> hold{};  // names a model does not have are ignored for that model
  std::vector<Correction> free{};     // constants of the experiment that are fitted, too
  Corrections corrections{};          // of those that are not
  std::optional<StatedError> sigma_T{}, sigma_A{};
  Loss loss = Loss::none;
  std::optional<double> loss_scale{};  // in standard errors; null: the loss's usual one
  bool intervals = true;
  double confidence = 0.95;
  BootstrapOptions bootstrap{};    // with replicates = 0: none
  bool influence = false;          // of each point and run: jackknife, leverage, Cook's distance
  std::size_t profile_points = 0;  // of each free parameter's drawn profile; 0: none
  Progress progress{};             // of bootstrap and influence
  std::vector<double> near{};  // of a refit: where the minimum is looked for, in the solver's numbers; empty: anywhere
};

/// For refits whose value alone is wanted: no intervals, bootstrap or influence.
FitOptions value_only(FitOptions options);

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
  bool known_errors = false;             // the residuals are in units of known standard errors
  std::optional<StandardErrors> errors;  // of the points, where the objective uses them
  std::vector<double> correlations;      // [p x p] of the free parameters in order; empty for one
  std::size_t free_parameters = 0;
  std::vector<double> solution;  // of the free parameters, as the solver counts: what FitOptions::near takes
  double sum_of_squares = 0;     // of the (weighted) residuals, or of the robust loss
  std::optional<BootstrapResult> bootstrap;
  std::optional<Influence> influence;  // changes in the reader's units; points as in `used`
  std::vector<std::string> run_names;  // of Influence::runs
  double loss_scale = 0;               // in units of the residuals; 0 without a robust loss

  bool has_values() const { return status != FitStatus::not_identifiable; }
};

/// Keys of all models: {"a", "b", "c", "bk"}.
std::vector<std::string> model_keys();

/// True if one of these models has a parameter of this name.
bool has_parameter(const std::vector<std::string>& models, std::string_view name);

/// `model` must be one of model_keys(). `points`: indices of the points to fit, all if null. Throws InputError if a
/// parameter is to be held at a value that is out of range or that the data set does not state, if the objective needs
/// loads and the data set has none, or if a point lacks a standard error.
FitResult fit_model(const Dataset& data, std::string_view model, const FitOptions& options = {},
                    const std::vector<std::size_t>* points = nullptr);

}  // namespace mixity
