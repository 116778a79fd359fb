// Areas and jumps that a fit predicts at any loads, with standard errors.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fitting/result.h"
#include "mechanics/ellipse.h"
#include "mechanics/states.h"

namespace mixity {

/// A number derived from a fit, and its standard error from those of all fitted parameters and constants. Null if there
/// is none.
struct Derived {
  std::optional<double> value{}, standard_error{};
};

/// An area as it would be measured, dimensionless like Point. The standard error is null within a standard error of a
/// jump, and where a parameter has none (at a bound, not identifiable).
struct AreaPrediction {
  EquilibriumStatus status;  // no_equilibrium: beyond the last one, or below pull-off; then A is 0
  double A = 0;
  std::optional<double> standard_error{};
  // Of elliptic contacts: the semi-axes along and across the shear, in units of a length whose square is one of A.
  Derived a{}, b{};
};

/// Predicts areas at measured loads (fitted offsets are added); `options` are those of the fit. Empty if the fit has no
/// values. Throws std::invalid_argument for an unknown model.
std::vector<AreaPrediction> predict_areas_of(const Dataset& data, const FitResult& fit, const FitOptions& options,
                                             std::span<const double> P, std::span<const double> T);

/// A fold as it would be measured, with standard errors; dimensionless.
struct FoldPrediction {
  Control control;
  bool on_loading;  // else on reversal of the load
  Derived T, u, A;
  double psi;  // [rad], from the fitted values
  Jump jumps_to;
  double area_after;  // 0 off contact
};

/// A fold computed for given parameters, without standard errors.
inline FoldPrediction as_prediction(const Fold& fold) {
  return {fold.control, fold.place.maximum, {fold.T}, {fold.u}, {fold.A}, fold.psi, fold.jumps_to, fold.area_after};
}

/// Where the edge of an elliptic contact closes before any fold under a control (EllipseEnd), as it would be measured.
struct ClosingPrediction {
  Control control;
  EllipseEnd end;
  Derived T, u, A;
};

/// Folds at a measured load under each of the controls, in the order of find_folds. The stiffness of a control is in
/// units of xi^2 G_Ic of the data set's own constants.
struct FoldsPrediction {
  std::vector<FoldPrediction> folds{};
  std::vector<ClosingPrediction> closings{};
  std::string problem{};  // why there is no curve: fit without values, no contact, or no law
};
FoldsPrediction predict_folds_of(const Dataset& data, const FitResult& fit, const FitOptions& options, double P,
                                 const std::vector<Control>& controls);

/// The first fold on loading under load control, where the contact jumps. Null if it never jumps.
std::optional<FoldPrediction> predict_jump_of(const Dataset& data, const FitResult& fit, const FitOptions& options,
                                              double P);

}  // namespace mixity
