// The constants of an experiment as they were stated, with their standard errors.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "dataset/dataset.h"

namespace mixity {

/// Name and value of each that is stated, in a reader's unit: {"modulus E*", "2.13 +/- 0.11 MPa"}.
std::vector<std::pair<std::string, std::string>> stated_constants_text(const Dataset& data);

}  // namespace mixity
