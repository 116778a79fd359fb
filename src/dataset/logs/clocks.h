// Brings forces and areas that were recorded with two clocks to one clock.
#pragma once

#include <optional>

#include "dataset/logs/frames.h"

namespace mixity {

/// make_frames with the lag between the two clocks in s. If it is not stated, it is estimated: to a few tenths of a
/// second by the records as a whole (coarse_lag.h), then by the events that both show (lag_events.h). Its error is the
/// standard deviation of the product of what the events tell, or covers what contacts and falls tell where these
/// disagree. Throws InputError if the data do not determine the lag.
Frames on_one_clock(const Recording& forces, const Recording& areas, std::optional<double> lag);

}  // namespace mixity
