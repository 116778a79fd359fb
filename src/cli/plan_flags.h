// Flags of a planned experiment.
#pragma once

#include "studies/simulate.h"

namespace mixity::cli {

/// The cost of a command per point, and the most points it accepts.
struct PointCost {
  double bytes;
  std::size_t most;
};

/// Made from --model, --lambda or --parameters, the constants, --loads, --points, --reach, --sigma_T and --sigma_A.
/// Throws UsageError, also for missing loads if the plan needs them and for more points than `cost` accepts.
Plan plan_from_flags(bool needs_loads, const PointCost& cost);

}  // namespace mixity::cli
