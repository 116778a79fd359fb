// The sign of the load of a log.
#pragma once

#include "dataset/logs/recording.h"

namespace mixity {

/// Whether the log has compression as negative: P lies lower in contact than out of it, and areas of the contact grow
/// as P falls. False where neither shows, as where the load hardly changes in contact. `lag`: of the areas' clock.
bool compression_is_negative(const Recording& forces, const Recording& areas, double lag);

}  // namespace mixity
