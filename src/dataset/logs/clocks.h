// Brings forces and areas that have clocks of their own to one clock.
#pragma once

#include <optional>

#include "dataset/logs/frames.h"

namespace mixity {

struct FrameOptions {
  std::optional<double> lag{};  // s; null: from events
  double longest_lag = 30;      // s: the search goes from minus to plus this
};

/// make_frames with the lag between the two clocks. If it is not stated, it is estimated: to a few tenths of a second
/// by the correlation of area and load, and then by the shift at which sudden changes of T coincide best with drops of
/// the area, or at which the area leaves its course when T shows the onset of sliding. Throws InputError if the data do
/// not determine the lag, or two shifts fit nearly equally well.
Frames on_one_clock(const Recording& forces, const Recording& areas, const FrameOptions& options);

}  // namespace mixity
