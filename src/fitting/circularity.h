// Whether contacts whose axes were measured are circles.
#pragma once

#include <optional>

#include "dataset/dataset.h"
#include "fitting/result.h"

namespace mixity {

/// A line of ln(a/b) over (T over the largest T of its run)^2, by least squares with an offset, which is the camera's
/// aspect ratio. Null with fewer than eight measured axes, and for models of elliptic contacts, which describe them.
std::optional<CircleTest> test_circle(const Dataset& data, const FitResult& fit);

/// Whether the ratio of the axes changes beyond chance, and by more than half a percent.
bool is_no_circle(const FitResult& fit);

}  // namespace mixity
