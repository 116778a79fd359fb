// The resolution (step) with which a camera or a converter reads.
#pragma once

#include <vector>

namespace mixity {

/// The step of which all differences between readings are multiples, to 1/20 as printed, if at least a fifth of the
/// readings equal the one before in their run; else 0. `runs`: readings in file order. Rounding to such a step adds the
/// variance step^2/12.
double common_step(const std::vector<std::vector<double>>& runs);

}  // namespace mixity
