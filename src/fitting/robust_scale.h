// Where a robust loss bends when the size of errors is not known: by the spread of the residuals.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "fitting/least_squares.h"

namespace mixity {

/// Standard error of residuals whose size is not known beforehand: 1.4826 times the median of their sizes.
inline double spread(const LeastSquares& problem, const std::vector<double>& x) {
  std::vector<double> residuals(problem.residual_count());
  if (residuals.empty() || !problem.evaluate(x, residuals, {})) return 0;
  for (double& r : residuals) r = std::abs(r);
  const auto middle = residuals.begin() + static_cast<std::ptrdiff_t>(residuals.size() / 2);
  std::nth_element(residuals.begin(), middle, residuals.end());
  return 1.4826 * *middle;
}

/// Where a single parameter leaves the least spread: outliers may hide every minimum of the squares.
inline std::vector<double> place_of_least_spread(const LeastSquares& problem) {
  if (problem.parameters().size() != 1) return {};
  const FreeParameter& parameter = problem.parameters()[0];
  const double width = parameter.upper - parameter.lower;
  std::vector<double> best;
  double least = std::numeric_limits<double>::infinity();
  constexpr int kPlaces = 100;
  for (int i = 1; i < kPlaces; ++i)
    for (const double share : {i / double{kPlaces}, std::pow(10.0, -8.0 * i / kPlaces)}) {
      const std::vector<double> x{parameter.lower + share * width};
      const double here = spread(problem, x);
      if (!(here > 0 && here < least)) continue;
      least = here;
      best = x;
    }
  return best;
}

}  // namespace mixity
