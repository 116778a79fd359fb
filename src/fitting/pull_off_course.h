// Whether pull-off loads leave the fit along the shear.
#pragma once

#include <optional>

#include "dataset/dataset.h"
#include "fitting/result.h"

namespace mixity {

/// A parabola in the held shear against the residuals of the pull-off loads: F of its offset and its curvature over the
/// scatter about it. An error of the loads that comes from their scatter about the fit absorbs what contradicts the
/// areas; this scatter does not. Null with fewer than six loads.
std::optional<PullOffTest> test_pull_off(const Dataset& data, const FitResult& fit);

/// Whether they leave it beyond chance.
bool pull_off_departs(const FitResult& fit);

}  // namespace mixity
