// Whether measured axes are those of the fitted circles or ellipses.
#pragma once

#include <optional>

#include "dataset/dataset.h"
#include "fitting/result.h"

namespace mixity {

/// A line of ln(a/b), or of what the fit of an ellipse leaves of it, over (T over the largest T of its run)^2, by least
/// squares with an offset, which is the camera's aspect ratio. Null with fewer than eight measured axes. Where the
/// errors of axes come from the residuals, these are large under a wrong tie, and no other test would see it.
std::optional<CircleTest> test_axes(const Dataset& data, const FitResult& fit);

/// Whether the ratio of the axes changes beyond chance, and by more than half a percent.
bool axes_leave_fit(const FitResult& fit);

}  // namespace mixity
