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

/// toughness: ln(Gc/GIc) against psi, the paper's. curve: orthogonal distance from the equilibrium curve in the plane
/// of T and A, or from the law in the plane of the two energies.
enum class Objective { toughness, curve };
std::string_view to_string(Objective objective);
std::optional<Objective> parse_objective(std::string_view text);
/// The message for an objective of earlier versions.
inline constexpr std::string_view kNoAreaObjective =
    "the objective area took T as exact and covered 57 to 97 % of a nominal 95 %: use curve";

/// Of objective toughness: ln(Gc/GIc) or Gc/GIc.
enum class Scale { log, linear };
constexpr std::string_view to_string(Scale scale) { return scale == Scale::log ? "log" : "linear"; }

/// A parameter held during the fit: at `value`, else at the value in the data set's metadata (r =
/// toughness_II/toughness).
struct HeldParameter {
  std::string name;
  std::optional<double> value;
};
/// "r" or "lambda=0.3". Null if the text is neither.
std::optional<HeldParameter> parse_held(std::string_view text);

struct FitOptions {
  std::optional<Objective> objective{};  // null: curve where the data allow it, see default_objective
  std::optional<Scale> scale{};          // of toughness; null: log
  bool weighted = false;                 // toughness: by each point's standard error, which curve always uses
  std::vector<HeldParameter> hold{};     // names a model does not have are ignored for that model
  std::vector<Constant> free{};          // constants of the experiment that are fitted without a prior
  /// What differs from run to run by chance: the model's first parameter, or constants, by name.
  std::vector<std::string> by_run{};
  /// Constants that are not free, taken as exact. Null: as the data set states them; those that it states with a
  /// standard error are fitted with a prior.
  std::optional<Constants> constants{};
  std::optional<StatedError> sigma_T{}, sigma_A{};
  /// Errors are functions of the fitted value, estimated with the fit where they are not stated; neighbours may
  /// correlate; the distance that noise leads one to expect is taken off. False: taken at the readings, independent,
  /// one relative error where none is stated: bare orthogonal distances, as ODRPACK minimises them.
  bool fitted_errors = true;
  /// Of all points, as a fit of the same data has found them; null: from sigma_T, sigma_A, columns or the scatter.
  std::shared_ptr<const StandardErrors> errors{};
  Loss loss = Loss::none;
  std::optional<double> loss_scale{};  // in standard errors; null: the loss's usual one
  bool intervals = true;
  double confidence = 0.95;
  bool checks = true;  // the tests of consistency and the evidence; without them nothing is suspect
  /// For evidence and credible interval, of the model's first parameter.
  RangePrior lambda_prior = RangePrior::uniform;
  BootstrapOptions bootstrap{};    // with replicates = 0: none
  bool influence = false;          // of each point and run: jackknife, leverage, Cook's distance
  std::size_t profile_points = 0;  // of each free parameter's drawn profile; 0: none
  Progress progress{};             // of one call; may decrease when a fit starts again
};

/// curve where there are loads, or errors of both energies; else toughness.
Objective default_objective(const Dataset& data);

/// The scale that toughness is fitted in.
constexpr Scale scale_of(const FitOptions& options) { return options.scale.value_or(Scale::log); }

/// For refits: values only, no intervals, checks, bootstrap or influence.
FitOptions value_only(FitOptions options);

/// Keys of all models: "a", "b", "c", "bk", and of the laws that were defined (laws/user_law.h).
std::vector<std::string> model_keys();

/// True if one of these models has a parameter of this name.
bool has_parameter(const std::vector<std::string>& models, std::string_view name);

}  // namespace mixity
