// Finds the basins of a one-parameter cost with exact curvature over the whole range.
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

/// A value in a basin, and ends at which the cost falls inwards; low = high: the cost falls to this bound.
struct Basin {
  double cost, x, low, high;
};

struct Basins {
  std::vector<Basin> list;      // lowest first
  std::vector<double> dearest;  // all finite values tried, highest cost first
};

/// Starts from intervals that shrink by factors towards the bounds, and halves each one until value, slope and
/// curvature at its ends agree on the cost between them.
Basins find_basins(const std::function<CostSample(double)>& look, double lower, double upper);

}  // namespace mixity
