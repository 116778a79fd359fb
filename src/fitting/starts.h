// Where a fit starts, beside the places of its scan.
#pragma once

#include <algorithm>

#include "fitting/minimise.h"
#include "fitting/prepared_fit.h"

namespace mixity {

/// Where the constants start: at the JKR curve through the points without shear (T up to 1 % of the largest).
template <class Model>
std::vector<double> jkr_start(const Dataset& data, const FitOptions& options, const PreparedFit<Model>& prepared) {
  std::vector<double> start(options.free.size(), 0.0);
  double largest = 0, pull = 0;
  for (const std::size_t i : prepared.used) {
    largest = std::max(largest, data.points[i].T);
    pull = std::max(pull, -data.points[i].P);
  }
  // with a toughness at which every load keeps the contact closed, if the stated one is not: at 0.85 of pull-off
  for (std::size_t k = 0; k < start.size(); ++k)
    if (options.free[k] == kToughness && above_pull_off(-pull) < 0) start[k] = std::log(pull / 4);
  PreparedFit<Model> unsheared = prepared;
  unsheared.held.fill(true);
  std::erase_if(unsheared.used, [&](std::size_t i) { return data.points[i].T > 0.01 * largest; });
  if (unsheared.used.size() < options.free.size()) return start;
  FitOptions area = options;
  area.objective = Objective::area;
  const auto minimum = descend(*make_problem<Model>(data, area, unsheared), start);
  return minimum && minimum->stationary ? minimum->x : start;
}

/// Solutions of fits of toughness, which cost no search for an equilibrium: the basins of areas and curves may be far
/// narrower than the steps of a scan. Points beyond the fold, the last of their run, are outliers there: fits without
/// the last part of each run, too. `parameters`: how many are free.
std::vector<std::vector<double>> toughness_guesses(const Dataset& data, std::string_view model,
                                                   const FitOptions& options, const std::vector<std::size_t>& used,
                                                   std::size_t parameters);

}  // namespace mixity
