// Events that forces and areas both show, and the lag between their clocks that each implies.
#pragma once

#include <string>
#include <vector>

#include "dataset/logs/frames.h"
#include "statistics/break_times.h"

namespace mixity {

/// An event: its time in the forces, by their clock, and in the areas, by theirs.
struct LagEvent {
  enum class Kind { made, lost, fall } kind;
  TimeDensity in_forces, in_areas;
};

inline std::string to_string(LagEvent::Kind kind) {
  using enum LagEvent::Kind;
  return kind == made ? "contacts made" : kind == lost ? "contacts lost" : "falls of T";
}

/// The range of lags to try, s.
struct LagRange {
  double first, last;
};

/// The probability density of the lag from one event; what lies outside the range is lost from its sum. `interval`:
/// between frames, s.
TimeDensity lag_by(const LagEvent& event, LagRange range, double interval);

/// Contacts made and lost: P leaves or returns to its zero when the area does. `rough`: frames with a lag known to some
/// tenths of a second.
std::vector<LagEvent> contact_events(const Recording& forces, const Frames& rough, LagRange range);

/// Falls of T and onsets of sliding: the area departs from its trend when T begins to fall, whether it then drops,
/// regrows or stays constant, and however long T falls.
std::vector<LagEvent> fall_events(const Frames& rough, LagRange range);

}  // namespace mixity
