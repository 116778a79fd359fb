// Points whose stated standard errors are so far below those of the others that they carry most of the weight of a fit.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "dataset/dataset.h"
#include "fitting/result.h"

namespace mixity {

/// Null if there are none, or if the fit uses no errors from the file. `along_A` returns NearestPlaces::load_A of each
/// used point; it is called only for data with loads in which some error is far below the others.
std::optional<HeavyPoints> heavy_points(const Dataset& data, const FitResult& fit,
                                        const std::function<std::vector<double>()>& along_A);

/// The lines of the points in their files.
std::vector<std::size_t> lines_of(const HeavyPoints& heavy, const Dataset& data);
/// "line 5 carries 94 % of the weight (its sigma_A is 1/420 of the median)".
std::string text_of(const HeavyPoints& heavy, const Dataset& data);

}  // namespace mixity
