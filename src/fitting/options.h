// Options of a fit.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fitting/constants.h"
#include "fitting/standard_errors.h"
#include "solver/options.h"

namespace mixity {

/// toughness: ln(Gc/GIc) against psi, as in the paper. curve: orthogonal distance from the equilibrium curve in the
/// plane of T and A, or from the law in the plane of the two energies.
enum class Objective { toughness, curve };
std::string_view to_string(Objective objective);
std::optional<Objective> parse_objective(std::string_view text);
/// The message for the objective `area` of earlier versions.
inline constexpr std::string_view kNoAreaObjective =
    "objective area was removed: it took T as exact, and its 95 % intervals covered only 57 to 97 %; use curve";

/// For objective toughness: fits ln(Gc/GIc) or Gc/GIc.
enum class Scale { log, linear };
constexpr std::string_view to_string(Scale scale) { return scale == Scale::log ? "log" : "linear"; }

/// A parameter held during the fit: at `value`, or if null at the value in the data set's metadata (r =
/// toughness_II/toughness).
struct HeldParameter {
  std::string name;
  std::optional<double> value;
};
/// "r" or "lambda=0.3". Null if the text is neither.
std::optional<HeldParameter> parse_held(std::string_view text);

struct FitOptions {
  std::optional<Objective> objective{};  // null: curve where the data allow it, see default_objective
  std::optional<Scale> scale{};          // for objective toughness; null: log
  bool weighted = false;                 // toughness: weight points by their standard errors, as curve always does
  std::vector<HeldParameter> hold{};     // names a model does not have are ignored for that model
  std::vector<Constant> free{};          // constants of the experiment that are fitted without a prior
  /// Names of what differs from run to run by chance: the model's first parameter, or constants.
  std::vector<std::string> by_run{};
  /// Values of constants that are not free, taken as exact. Null: as the data set states them; those that it states
  /// with a standard error are fitted with a prior.
  std::optional<Constants> constants{};
  std::optional<StatedError> sigma_T{}, sigma_A{};
  bool free_sigma_factor = false;  // all stated errors are right up to one common factor, estimated from the scatter
  /// True: errors are functions of the fitted value, estimated with the fit where not stated; neighbours may correlate;
  /// the distance expected from noise is subtracted. False: errors are taken at the readings and independent, with one
  /// relative error where none is stated: plain orthogonal distances, as ODRPACK minimises them.
  bool fitted_errors = true;
  /// Errors of all points from an earlier fit of these data; null: from sigma_T, sigma_A, columns or the scatter.
  std::shared_ptr<const StandardErrors> errors{};
  /// Where the data are a part of others: the errors of these, whose scatter and resolution are known better.
  std::shared_ptr<const StandardErrors> of_whole{};
  /// A refit is given up where the least squares without priors have a misfit (causes.h) above this. Null: never.
  std::optional<double> most_misfit{};
  /// A refit that is of interest only if it passes the tests is given up where it will not.
  bool explanation_only = false;
  Loss loss = Loss::none;
  std::optional<double> loss_scale{};  // in standard errors; null: the default of the loss
  bool intervals = true;
  double confidence = 0.95;
  bool checks = true;  // tests of consistency, and evidence; without them no fit is suspect
  /// The prior of the model's first parameter, for evidence and credible interval; where a log-uniform one begins.
  RangePrior lambda_prior = RangePrior::uniform;
  std::optional<double> lambda_prior_from{};
  BootstrapOptions bootstrap{};    // replicates = 0: no bootstrap
  bool influence = false;          // of each point and run: jackknife, leverage, Cook's distance
  std::size_t profile_points = 0;  // per free parameter's drawn profile; 0: no profile
  Progress progress{};             // of one call; may decrease when a fit restarts
};

/// curve if there are loads or errors of both energies; else toughness.
Objective default_objective(const Dataset& data);

/// The scale in which toughness is fitted.
constexpr Scale scale_of(const FitOptions& options) { return options.scale.value_or(Scale::log); }

/// For refits: values only, no intervals, checks, bootstrap or influence.
FitOptions value_only(FitOptions options);

/// Keys of all models: "a", "b", "c", "bk", and of user laws (laws/user_law.h).
std::vector<std::string> model_keys();

/// True if one of these models has a parameter of this name.
bool has_parameter(const std::vector<std::string>& models, std::string_view name);

}  // namespace mixity
