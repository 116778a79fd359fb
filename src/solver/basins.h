// The basins of a cost of one parameter with an exact curvature, found over the whole range.
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

/// A value in a basin, and the ends at which the cost falls inwards; low = high: a bound that the cost falls to.
struct Basin {
  double cost, x, low, high;
};

struct Basins {
  std::vector<Basin> list;      // lowest first
  std::vector<double> dearest;  // all values tried where the cost is finite, highest cost first
};

/// Starts from intervals that shrink by factors towards the bounds, and halves each until value, slope and curvature at
/// its ends agree on the cost between them.
Basins find_basins(const std::function<CostSample(double)>& look, double lower, double upper);

}  // namespace mixity
