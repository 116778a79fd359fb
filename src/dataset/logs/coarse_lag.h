// The lag between two clocks to some tenths of a second, from whole records.
#pragma once

#include <optional>

#include "dataset/logs/frames.h"

namespace mixity {

inline constexpr double kLongestLag = 30;  // s, in either direction

/// The shift at which the area correlates best with P^(2/3), also for negative compression. Accurate to a few tenths of
/// a second, as contact begins and ends with the load. Null if the correlation is weak.
struct LagByLoad {
  double lag, correlation;
};
std::optional<LagByLoad> lag_by_load(const Recording& forces, const Pictures& shown, bool negative = false);

/// The shift, within kLongestLag either way, at which sudden changes of T coincide best with drops of the area. Null if
/// the drops do not exceed noise, or another shift fits nearly as well.
std::optional<double> lag_by_drops(const Recording& forces, const Recording& areas, const Pictures& shown);

}  // namespace mixity
