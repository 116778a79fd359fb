// Checks of a law that is defined at run time, made before its first use.
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

/// Evaluates the law at some values over the ranges of its parameters.
LawCheck check_law(const UserLaw& law);

}  // namespace mixity
