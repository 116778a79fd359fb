// Forces and areas of one experiment on one clock: a row for each picture of the contact.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dataset/series/recording.h"

namespace mixity {

/// In SI. Forces are means over the time of a frame, centred on it.
struct Frames {
  double interval = 0;       // s, from frame to frame
  std::vector<double> time;  // s, of the clock of the areas
  std::vector<double> P, T, A;
  double samples = 1;      // of the force in a frame, as a rule
  double lag_error = 0;    // s, standard error
  double lag = 0;          // s: the clock of the forces reads time - lag when that of the areas reads time
  std::string lag_source;  // "one clock", "stated", "from 5 sudden changes of T"
};

struct FrameOptions {
  std::optional<double> lag{};  // s; null: from events
  double longest_lag = 30;      // s, that is looked for
};

/// Brings forces to the frames of the areas. `areas` may be the same recording. Frames without force are left out.
/// Where the clocks differ the lag is the shift at which sudden changes of T coincide best with falls of the area.
/// Throws InputError if the two share no time, or nothing tells the lag.
Frames make_frames(const Recording& forces, const Recording& areas, const FrameOptions& options);

}  // namespace mixity
