// Where a fit starts, beside the places of its scan.
#pragma once

#include <algorithm>

#include "fitting/fit.h"
#include "fitting/prepared_fit.h"
#include "fitting/scan.h"

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
/// the last part of each run, too, if only as many points as free parameters are left. `parameters`: how many are free.
template <class Model>
std::vector<std::vector<double>> toughness_guesses(const Dataset& data, const FitOptions& options,
                                                   const std::vector<std::size_t>& used, std::size_t parameters) {
  constexpr std::size_t kEnough = 1000;  // points, evenly chosen
  const std::size_t every = used.size() / kEnough + 1;
  std::vector<std::vector<std::size_t>> runs(data.curves.size());
  for (std::size_t i = 0; i < used.size(); i += every)
    if (data.toughness(used[i])) runs[data.points[used[i]].curve].push_back(used[i]);
  for (auto& run : runs)
    std::sort(run.begin(), run.end(),
              [&](std::size_t one, std::size_t other) { return data.points[one].T < data.points[other].T; });
  FitOptions toughness = value_only(options);
  toughness.objective = Objective::toughness;
  toughness.scale = Scale::log;
  toughness.weighted = false;
  toughness.loss = Loss::none;
  toughness.loss_scale.reset();
  std::vector<std::vector<double>> guesses;
  std::size_t last_count = 0;
  for (const double part : {1.0, 0.95, 0.9, 0.8, 0.65}) {
    std::vector<std::size_t> points;
    for (const auto& run : runs)
      points.insert(points.end(), run.begin(),
                    run.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(run.size())));
    if (points.size() == last_count || points.size() < parameters) continue;
    last_count = points.size();
    PreparedFit<Model> prepared = prepare<Model>(data, toughness, &points);
    if (!options.free.empty()) prepared.start = jkr_start<Model>(data, toughness, prepared);
    const auto problem = make_problem<Model>(data, toughness, prepared);
    std::optional<Minimum> lowest;
    for (const Start& start : scan(*problem).minima)
      if (auto found = descend(*problem, start.x); found && (!lowest || found->sum_of_squares < lowest->sum_of_squares))
        lowest = std::move(found);
    if (lowest) guesses.push_back(lowest->x);
    // of one parameter neither a robust loss, whose scan is the dearest of all, nor weights have anything to add
    if (part < 1 || parameters == 1) continue;
    const auto guess = [&](const FitOptions& other) {
      const FitResult fit = fit_model(data, Model::info.key, other, &points);
      if (!fit.solution.empty()) guesses.push_back(fit.solution);
    };
    FitOptions other = toughness;
    other.loss = Loss::cauchy;
    guess(other);
    // each point by its standard error, as areas and curves see it: at low shear its toughness is hardly known
    if (!lowest || !options.free.empty() || options.corrections != Corrections{}) continue;
    other.weighted = true;
    other.near = lowest->x;
    guess(other);
    other.loss = Loss::none;
    guess(other);
  }
  return guesses;
}

}  // namespace mixity
