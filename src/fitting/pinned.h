// Contacts whose areas stay as they are: the runs do not determine the parameters.
#pragma once

#include <span>

#include "dataset/dataset.h"
#include "fitting/result.h"

namespace mixity {

/// Whether the areas of each run are one area within their scatter, by themselves: a fall with T^2
/// that all runs share lowers their squares by less than 6 times the variance about a line in T^2 for each run, and
/// these lines lower them by no more than chance. Where neighbours correlate, the variance counts accordingly more.
/// `sigma_A`: of each point of the data set, as far as is known; empty: proportional errors. False of too few points.
bool areas_stay(const Dataset& data, std::span<const std::size_t> used, std::span<const double> sigma_A);

/// Whether the areas stay within their scatter and the fitted curves describe them no better than one area for each run
/// does. `residuals`: less what noise leads one to expect.
bool is_pinned(const Dataset& data, const FitResult& fit, std::span<const double> residuals);

}  // namespace mixity
