// Models chosen by their key at run time: areas and other states of arrays of loads, folds, regimes, curves. All
// dimensionless (contact.h); what another layer, a program or another language calls where the model is a name.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mechanics/equilibrium.h"
#include "mechanics/folds.h"
#include "mechanics/regimes.h"

namespace mixity {

/// Values of an array, or one for all: value i lies i steps behind the first.
struct Values {
  const double* first = nullptr;
  std::ptrdiff_t step = 0;
  double operator[](std::size_t i) const { return first[static_cast<std::ptrdiff_t>(i) * step]; }
};

/// "lambda", or "r" and "m". Empty if no model has this key.
std::vector<std::string> parameter_names(std::string_view model);

/// Least and largest value of each.
std::vector<std::pair<double, double>> parameter_bounds(std::string_view model);

/// Why these are no model with its parameters: no such key, another number of values, one out of its range, no law
/// with a unique equilibrium. Empty if they are.
std::string parameters_problem(std::string_view model, std::span<const double> parameters);

/// A[i] = pi a^2 and status[i] at the loads P[i] and T[i] (|T|: equilibrium depends on T^2), as LoadedContact::at has
/// them within 4e-15. A[i] is NaN exactly where status[i] is not ok: no_equilibrium beyond the last one, or below
/// pull-off; invalid for parameters out of range and for loads that are no numbers. Neighbours with the same P and
/// parameters are found together. `model` is a key; one of Values for each of its parameters.
void areas(std::string_view model, std::span<const Values> parameters, Values P, Values T, std::span<double> A,
           std::span<EquilibriumStatus> status);

/// Derivatives of these areas: slopes[k][i] = dA[i]/d parameter k = -F_k/F_A of the equilibrium's gradient
/// (sensitivity.h), each of A's length. NaN where A[i] is; not finite on a fold, where dA/dT is not either.
void area_slopes(std::string_view model, std::span<const Values> parameters, Values P, Values T,
                 std::span<const double> A, std::span<const std::span<double>> slopes);

/// f = G_c/G_Ic at phase angles psi [rad], 0..pi/2; NaN outside, and for parameters out of range. May be infinite at
/// pi/2.
void toughness_ratios(std::string_view model, std::span<const Values> parameters, Values psi, std::span<double> f);

/// T >= 0 at which an equilibrium of the load P[i] has the area A[i], stable or not: the inverse of `areas` on its
/// stable branch. NaN where there is none: an area above that of JKR, at or below that of Hertz, or
/// one that no finite T leaves.
void tangential_loads(std::string_view model, std::span<const Values> parameters, Values P, Values A,
                      std::span<double> T);

/// Folds of the curve at the load P in the order in which they are met (find_folds), or why there is no curve.
struct FoldsOrProblem {
  std::vector<Fold> folds{};
  std::string problem{};
};
FoldsOrProblem folds_of(std::string_view model, std::span<const double> parameters, double P, Control control);

/// What becomes of the contact (classify), or why there is none.
struct RegimeOrProblem {
  std::optional<RegimeReport> regime{};
  std::string problem{};
};
RegimeOrProblem regime_of(std::string_view model, std::span<const double> parameters, double P,
                          std::optional<double> tau0 = {});

/// The load below which the contact jumps (critical_load); null where parameters_problem says something.
std::optional<double> critical_load_of(std::string_view model, std::span<const double> parameters);

/// So many points (two at least) along the whole curve, evenly in the angle of the circle, through every fold; or why
/// there is none.
struct CurveOrProblem {
  std::vector<CurvePoint> points{};
  std::string problem{};
};
CurveOrProblem curve_of(std::string_view model, std::span<const double> parameters, double P, std::size_t points);

}  // namespace mixity
