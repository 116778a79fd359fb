// Brings forces and areas that were recorded with two clocks to one clock.
#pragma once

#include <optional>

#include "dataset/logs/frames.h"

namespace mixity {

/// make_frames with the lag between the two clocks in s. If it is not stated, it is estimated: to a few tenths of a
/// second by the correlation of area and load, and then by the shift at which sudden changes of T coincide best with
/// drops of the area, or at which the area drops from its course when T shows the onset of sliding. Shifts of up to 30
/// s are tried. Throws InputError if the data do not determine the lag, or two shifts fit nearly equally well.
Frames on_one_clock(const Recording& forces, const Recording& areas, std::optional<double> lag);

}  // namespace mixity
