// The basins of a cost of one parameter whose curvature is known exactly: the whole range, as finely as the cost bends.
#pragma once

#include <functional>
#include <vector>

namespace mixity {

/// Half the cost, S/2, at one value of the parameter, with its derivatives.
struct CostSample {
  double x;
  bool finite;
  double value, slope, curvature;
  double slope_size;  // |J|, for the scale-free test of the slope
};

/// A value in a basin, and ends at which the cost falls inwards; low = high: at a bound that the cost falls to.
struct Basin {
  double cost, x, low, high;
};

struct Basins {
  std::vector<Basin> list;      // lowest first
  std::vector<double> dearest;  // all values looked at where the cost is finite, dearest first
};

/// From values spaced by factors towards the lower bound and evenly above, halved until value, slope and curvature at
/// both ends of each interval agree on the cost between them.
Basins find_basins(const std::function<CostSample(double)>& look, double lower, double upper);

}  // namespace mixity
