// The sign of the load in a log.
#pragma once

#include "dataset/logs/recording.h"

namespace mixity {

/// Whether compression is negative in the log: P is lower in contact than out of it, and the contact area grows as P
/// falls. False if the data do not show it, as when the load hardly changes in contact. `lag`: of the clock of the
/// areas.
bool compression_is_negative(const Recording& forces, const Recording& areas, double lag);

}  // namespace mixity
