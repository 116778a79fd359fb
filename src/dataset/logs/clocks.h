// Forces and areas with clocks of their own, on one.
#pragma once

#include <optional>

#include "dataset/logs/frames.h"

namespace mixity {

struct FrameOptions {
  std::optional<double> lag{};  // s; null: from events
  double longest_lag = 30;      // s, that is looked for
};

/// make_frames with the lag between the two clocks. Where it is not stated, the area follows the load to within some
/// tenths of a second, and there the lag is the shift at which sudden changes of T coincide best with falls of the
/// area, or the area breaks where T says that sliding begins. Throws InputError if nothing tells it, or two shifts do
/// nearly as well.
Frames on_one_clock(const Recording& forces, const Recording& areas, const FrameOptions& options);

}  // namespace mixity
