// Converts forces and areas that were recorded with two clocks to one clock.
#pragma once

#include <optional>

#include "dataset/logs/frames.h"

namespace mixity {

/// make_frames with the lag between the two clocks in s. If not stated, it is estimated: to a few tenths of a second
/// from the whole records (coarse_lag.h), then from the events that both show (lag_events.h). Its error is the standard
/// deviation of the product of the events' densities, or covers the lags from contacts and from falls where these
/// disagree. Throws InputError if the data do not determine the lag.
Frames on_one_clock(const Recording& forces, const Recording& areas, std::optional<double> lag);

}  // namespace mixity
