// Flags of a planned experiment.
#pragma once

#include <string_view>
#include <vector>

#include "studies/simulate.h"

namespace mixity::cli {

/// From --model, --lambda or --parameters, the constants, --loads, --points, --reach, --sigma_T and --sigma_A. Throws
/// UsageError, also for missing loads if the plan needs them.
Plan plan_from_flags(bool needs_loads);

/// Adds the flags of a plan.
std::vector<std::string_view> with_plan_flags(std::vector<std::string_view> flags);

/// A whole number, `least` or more. Throws UsageError.
std::size_t count_from(const std::string& flag, std::size_t least);

}  // namespace mixity::cli
