// Times of a log whose clock is coarser than its rows.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace mixity {

/// The effects of a clock that is coarser than the rows.
struct TimeBase {
  double stamp = 0;          // s, the typical step of the clock; 0: all rows have different times
  std::size_t shared = 0;    // rows that shared their time stamp with others and were spread evenly
  std::size_t repeated = 0;  // rows equal to the row before in all columns, which were left out
};

/// Why times are unusable, and at which row.
struct ClockFault {
  std::size_t row = 0;
  std::string reason;  // empty: there is none
};

/// Gives rows that share a time stamp distinct times. A stamp marks the beginning of its interval: its first row keeps
/// it, and the others follow evenly up to the next stamp. The first stamp, some of whose rows may be missing, is filled
/// from its end. Distinct times are unchanged. Reports a fault if the rows do not come at a constant rate.
/// `time`: finite, not decreasing.
ClockFault spread_times(std::vector<double>& time, TimeBase& base);

}  // namespace mixity
