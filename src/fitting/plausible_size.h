// How plausible the size of a possible cause is, before the data are asked.
#pragma once

#include <string>

#include "dataset/dataset.h"

namespace mixity {

/// The square of a deviation over its usual size, which laboratories differ by; of a constant or of the first
/// parameter, in the solver's numbers. `value`: of that parameter.
double implausibility(const Dataset& data, const std::string& quantity, double deviation, double value);

}  // namespace mixity
