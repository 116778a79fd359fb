// Where the minima of a one-parameter cost lie: the whole range, as finely as the cost bends.
#pragma once

#include <vector>

#include "fitting/single_cost.h"

namespace mixity {

/// Holds one minimum, at least. The slope points inwards at both ends, but for low = high: a bound the cost falls to.
struct Basin {
  double low, high;
  double start;  // a bound only if low = high
  double cost;   // the lower one of the ends'
};

/// False if the cost is lower just inside this bound. A slope of zero does not show it where the cost is stationary by
/// symmetry, as model b's is at lambda = 2.
bool lowest_at_bound(SingleCost& cost, const FreeParameter& parameter, double bound);

struct SingleScan {
  std::vector<Basin> basins;  // lowest first
  double lowest, highest;     // finite costs met; lowest infinite if there was none
};

/// From places spaced by factors towards a lower bound of 0 and evenly above, halved until value, slope and curvature
/// at both ends of each interval agree on the cost between them; where the curvature is not exact, at fixed places.
SingleScan scan_basins(SingleCost& cost, const FreeParameter& parameter);

}  // namespace mixity
