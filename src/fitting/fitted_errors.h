// Standard errors at a fitted curve, and what follows from them for the residuals.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "fitting/error_model.h"

namespace mixity {

/// Sets StandardErrors::place_T and place_A of the points of the fit.
void keep_places(const Dataset& data, std::span<const std::size_t> used, const NearestPlaces& nearest,
                 StandardErrors& errors);

/// Evaluates the errors at the places of a fitted curve, for the points of the fit, and at the readings for the others.
/// Returns the largest relative change for the points of the fit.
double evaluate_errors(const Dataset& data, std::span<const std::size_t> used, const NearestPlaces& nearest,
                       StandardErrors& errors);

/// For each of these points the variance of its residual over that which proportional errors of `errors.scatter`, taken
/// at the readings, would give it; 1 where errors are not estimated.
std::vector<double> variance_ratios(const Dataset& data, std::span<const std::size_t> used,
                                    const StandardErrors& errors);

/// Those of these points; none if there are none of all.
std::vector<double> of_points(const std::vector<double>& all, std::span<const std::size_t> used);

/// FitResult::log_variances.
double log_variances(const Dataset& data, std::span<const std::size_t> used, const StandardErrors& errors);

/// What is taken off the residuals before they are made independent: the expected distances, and what the runs' own
/// constants change, about which they are linearised. Empty: nothing.
std::vector<double> taken_off(const Dataset& data, std::span<const std::size_t> used, const StandardErrors& errors);

/// What makes the residuals of these points independent; null where their neighbours do not correlate.
std::optional<Decorrelation> neighbours_of(const Dataset& data, std::span<const std::size_t> used,
                                           const StandardErrors& errors);

}  // namespace mixity
