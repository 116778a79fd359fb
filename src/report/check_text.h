// What `mixity check` prints.
#pragma once

#include <string>

#include "dataset/dataset.h"

namespace mixity {

std::string check_text(const Dataset& data);

}  // namespace mixity
