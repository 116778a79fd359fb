// Flags of a planned experiment.
#pragma once

#include "studies/simulate.h"

namespace mixity::cli {

/// From --model, --lambda or --parameters, the constants, --loads, --points, --reach, --sigma_T and --sigma_A. Throws
/// UsageError, also for missing loads if the plan needs them.
Plan plan_from_flags(bool needs_loads);

}  // namespace mixity::cli
