// What a fit says of areas, and of jumps, at any loads, with what it does not know (propagation.h).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fitting/propagation.h"
#include "fitting/result.h"
#include "mechanics/equilibrium.h"
#include "mechanics/folds.h"

namespace mixity {

/// An area as it would be measured, and its standard error from those of the fitted parameters and constants; null
/// where these are not known (a parameter at a bound, not identifiable), and so close to a jump that a standard error
/// of a parameter takes the contact beyond it. Dimensionless, as Point has them.
struct AreaPrediction {
  EquilibriumStatus status;  // no_equilibrium: beyond the last one, or below pull-off; then A is 0
  double A = 0;
  std::optional<double> standard_error{};
};

/// At loads as they are read (offsets that were fitted are added to them); `options` are those of the fit. Empty if the
/// fit has no values. Throws std::invalid_argument for a model that is none.
std::vector<AreaPrediction> predict_areas_of(const Dataset& data, const FitResult& fit, const FitOptions& options,
                                             std::span<const double> P, std::span<const double> T);

/// A fold as it would be measured, with standard errors; dimensionless.
struct FoldPrediction {
  Control control;
  bool on_loading;  // else on reversal
  Derived T, u, A;
  double psi;  // [rad], at the fit itself
  Jump jumps_to;
  double area_after;  // 0 off contact
};

/// Folds at a load as it is read, under each of the controls, in the order in which they are met (find_folds). The
/// stiffness of a control is in units of xi^2 G_Ic of the data set's own constants.
struct FoldsPrediction {
  std::vector<FoldPrediction> folds{};
  std::string problem{};  // why there is no curve: no value, no contact, no law
};
FoldsPrediction predict_folds_of(const Dataset& data, const FitResult& fit, const FitOptions& options, double P,
                                 const std::vector<Control>& controls);

/// The first of them that is met on loading under load control: where the contact jumps. Null if it does not.
std::optional<FoldPrediction> predict_jump_of(const Dataset& data, const FitResult& fit, const FitOptions& options,
                                              double P);

}  // namespace mixity
