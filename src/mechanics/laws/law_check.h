// The checks of a law that is defined at run time, before it is used.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mechanics/laws/user_law.h"

namespace mixity {

struct LawCheck {
  std::optional<std::string> error{};   // why the law cannot be used over the ranges of its parameters
  std::vector<std::string> warnings{};  // where equilibrium is not unique; how many digits are lost
};

/// At some values over the ranges of the law's parameters.
LawCheck check_law(const UserLaw& law);

}  // namespace mixity
