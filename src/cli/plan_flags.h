// Flags that describe an experiment that is to be done.
#pragma once

#include <string_view>
#include <vector>

#include "studies/plan.h"

namespace mixity::cli {

/// Of --model, --lambda or --parameters, the constants, --loads, --points, --reach, --sigma_T and --sigma_A. Loads may
/// be missing if the command finds some itself. Throws UsageError.
Plan plan_from_flags(bool needs_loads);

/// These flags and those of a plan.
std::vector<std::string_view> with_plan_flags(std::vector<std::string_view> flags);

/// A number of things from a flag that is one: "500". Throws UsageError for less than `least`.
std::size_t count_from(const std::string& flag, std::size_t least);

}  // namespace mixity::cli
