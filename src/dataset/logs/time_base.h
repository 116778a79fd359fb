// The times of a log whose clock is coarser than its rows.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace mixity {

/// What a clock that is coarser than the rows led to.
struct TimeBase {
  double stamp = 0;          // s, the typical step of the clock; 0: each row has a time of its own
  std::size_t shared = 0;    // rows that share their stamp with another one, and were spread evenly
  std::size_t repeated = 0;  // rows that repeat the row before in all columns, and were left out
};

/// Why times tell nothing, and at which row.
struct ClockFault {
  std::size_t row = 0;
  std::string reason;  // empty: there is none
};

/// Gives rows that share a stamp times of their own. A stamp says when its interval begins, so its first row keeps it
/// and the others follow evenly up to the next stamp; the first stamp, whose rows may be cut off, is filled from its
/// end. Times that all differ stay as they are. A fault if the rows of the stamps do not come at one rate. `time`:
/// finite, from row to row equal or rising.
ClockFault spread_times(std::vector<double>& time, TimeBase& base);

}  // namespace mixity
