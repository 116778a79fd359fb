// Flags of a planned experiment.
#pragma once

#include "studies/simulate.h"

namespace mixity::cli {

/// What a command takes for each point, and how many it accepts.
struct PointCost {
  double bytes;
  std::size_t most;
};

/// From --model, --lambda or --parameters, the constants, --loads, --points, --reach, --sigma_T and --sigma_A. Throws
/// UsageError, also for missing loads if the plan needs them and for more points than `cost` accepts.
Plan plan_from_flags(bool needs_loads, const PointCost& cost);

}  // namespace mixity::cli
