// Events that forces and areas both show, and the lag between their clocks that each tells.
#pragma once

#include <string>
#include <vector>

#include "dataset/logs/frames.h"
#include "statistics/break_times.h"

namespace mixity {

/// When the forces show an event, on their clock, and when the areas do, on theirs.
struct LagEvent {
  enum class Kind { made, lost, fall } kind;
  TimeDensity in_forces, in_areas;
};

inline std::string to_string(LagEvent::Kind kind) {
  using enum LagEvent::Kind;
  return kind == made ? "contacts made" : kind == lost ? "contacts lost" : "falls of T";
}

/// The lags that are tried: from `first` to `last`, s.
struct LagRange {
  double first, last;
};

/// How probable each lag is by one event, with some probability that forces and areas do not show the same one.
/// `interval`: of the frames, s.
TimeDensity lag_by(const LagEvent& event, LagRange range, double interval);

/// Contacts made and lost: P leaves its zero, or returns to it, when the area does. `rough`: frames with a lag that is
/// known to some tenths of a second.
std::vector<LagEvent> contact_events(const Recording& forces, const Frames& rough, LagRange range);

/// Falls of T and onsets of sliding: the area leaves its course when T begins to fall, whether it drops, regrows or
/// stays as it is, and however long T falls.
std::vector<LagEvent> fall_events(const Frames& rough, LagRange range);

}  // namespace mixity
