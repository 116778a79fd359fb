// Where the constants of the experiment start.
#pragma once

#include <algorithm>

#include "fitting/minimise.h"
#include "fitting/prepared_fit.h"

namespace mixity {

/// Where the constants start: at the JKR curve through the points without shear (T up to 1 % of the largest).
template <class Model>
std::vector<double> jkr_start(const Dataset& data, const FitOptions& options, const PreparedFit<Model>& prepared) {
  std::vector<double> start(options.free.size(), 0.0);
  double largest = 0;
  for (const std::size_t i : prepared.used) largest = std::max(largest, data.points[i].T);
  PreparedFit<Model> unsheared = prepared;
  unsheared.held.fill(true);
  std::erase_if(unsheared.used, [&](std::size_t i) { return data.points[i].T > 0.01 * largest; });
  if (unsheared.used.size() < options.free.size()) return start;
  FitOptions area = options;
  area.objective = Objective::area;
  const auto minimum = descend(*make_problem<Model>(data, area, unsheared), start);
  return minimum && minimum->stationary ? minimum->x : start;
}

}  // namespace mixity
