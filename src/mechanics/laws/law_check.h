// What is checked of a law that was defined at run time before it is used.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mechanics/laws/law.h"

namespace mixity {

struct LawCheck {
  std::optional<std::string> error{};   // why it is no law over the ranges of its parameters
  std::vector<std::string> warnings{};  // where its equilibrium is not unique, how many digits its form loses
};

/// Over the ranges of its parameters, at some of their values.
LawCheck check_law(const ExpressionLaw& law);

}  // namespace mixity
