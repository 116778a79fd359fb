// The steps in which a camera or a converter reads.
#pragma once

#include <vector>

namespace mixity {

/// The step of which the differences between readings are multiples, to a twentieth of it as they are printed, if a
/// fifth of the readings or more are equal to the one before in their run; else 0. `runs`: readings in the order of the
/// file. Rounding to such a step has the variance step^2/12.
double common_step(const std::vector<std::vector<double>>& runs);

}  // namespace mixity
