// The prior plausibility of the size of a possible cause.
#pragma once

#include <string>

#include "dataset/dataset.h"

namespace mixity {

/// (deviation/usual)^2, where `usual` is how much laboratories typically differ. `deviation`: of a constant or of the
/// first parameter, in the solver's numbers; `value`: of the first parameter.
double implausibility(const Dataset& data, const std::string& quantity, double deviation, double value);

}  // namespace mixity
