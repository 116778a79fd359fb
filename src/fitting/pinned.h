// Contacts whose areas stay constant, so that the runs do not determine the parameters.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "dataset/dataset.h"
#include "fitting/point_indices.h"
#include "fitting/result.h"

namespace mixity {

/// Whether the areas of each run are constant within their scatter. A common fall with T^2 must lower the sum of
/// squares by less than 6 times the variance about a line in T^2 for each run, and these lines must lower it by no more
/// than chance. The variance counts more where neighbours correlate. `sigma_A`: per point of the data set, as far as
/// known; empty: proportional errors. False if there are too few points.
bool areas_stay(const Dataset& data, const PointIndices& used, std::span<const double> sigma_A);

/// Whether the areas stay constant within their scatter, and the fitted curves describe them no better than one area
/// per run. `residual`: of the i-th used point, without the part expected from noise.
bool is_pinned(const Dataset& data, const FitResult& fit, const std::function<double(std::size_t)>& residual);

}  // namespace mixity
