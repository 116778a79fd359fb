// What a fit says of areas at any loads, with what it does not know.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fitting/result.h"
#include "mechanics/equilibrium.h"

namespace mixity {

/// An area as it would be measured, and its standard error from those of the fitted parameters and constants; null
/// where these are not known (a parameter at a bound, not identifiable). Dimensionless, as Point has them.
struct AreaPrediction {
  EquilibriumStatus status;  // no_equilibrium: beyond the last one, or below pull-off; then A is 0
  double A = 0;
  std::optional<double> standard_error{};
};

/// At loads as they are read (offsets that were fitted are added to them); `options` are those of the fit. To first
/// order (delta method): the area's derivatives by central differences, a thousandth of a standard error wide, on the
/// covariance of the fit. Empty if the fit has no values. Throws std::invalid_argument for a model that is none.
std::vector<AreaPrediction> predict_areas_of(const Dataset& data, const FitResult& fit, const FitOptions& options,
                                             std::span<const double> P, std::span<const double> T);

}  // namespace mixity
