// Standard errors evaluated at a fitted curve, and the quantities of the residuals that follow from them.
#pragma once

#include <memory>
#include <vector>

#include "fitting/error_model.h"

namespace mixity {

/// Sets place_T and place_A of `errors` for the points of the fit.
void keep_places(const Dataset& data, const PointIndices& used, NearestPlaces&& nearest, StandardErrors& errors);

/// Evaluates the errors of fitted points at their places on the fitted curve, those of other points at the readings.
/// Returns the largest relative change among the fitted points.
double evaluate_errors(const Dataset& data, const PointIndices& used, NearestPlaces&& nearest, StandardErrors& errors);

/// The variance of a point's residual divided by that of proportional errors of `errors.scatter` at its readings; 1
/// where errors are not estimated.
double variance_ratio(const Dataset& data, const StandardErrors& errors, std::size_t point);

/// The elements of `all` at these points; empty if `all` is.
std::vector<double> of_points(const std::vector<double>& all, const PointIndices& used);

/// Computes FitResult::log_variances.
double log_variances(const Dataset& data, const PointIndices& used, const StandardErrors& errors);

/// The same of the axes: their variances relative to those of the areas' share before the fit (variance_ratio).
double log_variances_of_axes(const Dataset& data, const PointIndices& used, const StandardErrors& errors);

/// What is subtracted from the residuals before decorrelation: the expected distances, and the changes due to the runs'
/// own constants, about which they are linearised. Empty: nothing.
std::vector<double> taken_off(const Dataset& data, const PointIndices& used, const StandardErrors& errors);

/// Decorrelates the residuals of these points; null where neighbours do not correlate.
std::optional<Decorrelation> neighbours_of(const Dataset& data, const PointIndices& used, const StandardErrors& errors);

}  // namespace mixity
