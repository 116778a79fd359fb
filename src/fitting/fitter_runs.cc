// Quantities whose spread between the runs is fitted, too.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "fitting/curve_objective.h"
#include "fitting/fitted_errors.h"
#include "fitting/fitter.h"
#include "fitting/run_differences.h"

namespace mixity {

/// Finds the spreads and a step of x and of the runs' deviations together, linearised at the present ones (Lindstrom &
/// Bates 1990, Biometrics 46, 673). `nearest` becomes that at the end of the step; the part that the deviations explain
/// is removed from the shares of noise. False where they are not determined.
bool Fitter::find_run_differences(std::vector<double>& x, NearestPlaces& nearest, std::vector<double>& leverage,
                                  double& change) {
  RunDifferences& differences = prepared_.errors->runs;
  const RunDifferences before = differences;
  const std::vector<std::string>& names = options_.by_run;
  auto rows = run_rows(data_, options_, prepared_, x, nearest.residuals, names, 1);
  if (!rows) return false;
  const UsedRuns in_runs = used_runs(data_, prepared_.used);
  const Groups& groups = in_runs.groups;
  const std::vector<std::size_t>& runs = in_runs.runs;
  for (std::size_t q = 0; q < before.names.size(); ++q)
    for (std::size_t g = 0; g < groups.size(); ++g)
      for (const std::size_t i : groups[g]) {
        const auto row = static_cast<Eigen::Index>(i), column = static_cast<Eigen::Index>(q);
        rows->r[row] -= rows->Zw(row, column) * before.deviations[q][runs[g]];
      }
  const GroupedRows grouped = grouped_rows(rows->J, rows->r, rows->Zw, groups);
  const auto found = restricted_spreads(grouped);
  const auto step = found ? most_probable(grouped, found->spread) : std::nullopt;
  if (!step) return false;
  RunDifferences start{names, {}, {}, {}, 0};  // the runs as they are, beside the parameters after the step
  differences = {names, {}, {}, {}, found->freedom};
  const auto& parameters = problem_->parameters();
  std::vector<double> moved(x.size());
  for (std::size_t k = 0; k < x.size(); ++k)
    moved[k] = parameters[k].clamped(x[k] + step->step[static_cast<Eigen::Index>(k)]) - x[k];
  for (std::size_t q = 0; q < names.size(); ++q) {
    const auto column = static_cast<Eigen::Index>(q);
    const auto same = std::find_if(parameters.begin(), parameters.end(),
                                   [&](const FreeParameter& one) { return one.name == names[q]; });
    const double shift = same == parameters.end() ? 0 : moved[static_cast<std::size_t>(same - parameters.begin())];
    start.deviations.emplace_back(data_.curves.size());
    differences.spreads.push_back(found->spread[column]);
    differences.columns.emplace_back(data_.points.size());
    std::vector<double>& deviations = differences.deviations.emplace_back(data_.curves.size());
    for (std::size_t g = 0; g < groups.size(); ++g) {
      deviations[runs[g]] = step->deviations[g][column];
      start.deviations[q][runs[g]] = (before.any() ? before.deviations[q][runs[g]] : 0) - shift;
    }
  }
  for (std::size_t k = 0; k < x.size(); ++k) x[k] += moved[k];
  if (!shorten_steps(x, start, nearest)) return false;
  change = std::max(change, before.any() ? step->length : 1);
  for (std::size_t q = 0; before.any() && q < names.size(); ++q) {
    const double unit = std::max(differences.spreads[q], 1e-6);
    change = std::max(change, std::abs(differences.spreads[q] - before.spreads[q]) / unit);
    for (std::size_t run = 0; run < data_.curves.size(); ++run)
      change = std::max(change, std::abs(differences.deviations[q][run] - before.deviations[q][run]) / unit);
  }
  const Eigen::VectorXd shares = shares_of_noise(rows->J, rows->Zw, groups, found->spread);
  for (std::size_t i = 0; i < leverage.size(); ++i) leverage[i] = 1 - shares[static_cast<Eigen::Index>(i)];
  return true;
}

/// Recomputes the columns at the errors and deviations found. False where they are not finite.
bool Fitter::refresh_columns(const std::vector<double>& x) {
  const auto rows = run_rows(data_, options_, prepared_, x, std::vector<double>(prepared_.used.size()),
                             prepared_.errors->runs.names, 1);
  if (!rows) return false;
  for (std::size_t q = 0; q < prepared_.errors->runs.names.size(); ++q)
    for (std::size_t i = 0; i < prepared_.used.size(); ++i)
      prepared_.errors->runs.columns[q][prepared_.used[i]] =
          rows->Z(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(q));
  return true;
}

/// Halves the step of a run's deviations until it lowers the squares of its residuals and deviations. `nearest`: at the
/// start on entry, at the end on return. Runs whose step is found are not evaluated again. False where that is not
/// finite.
bool Fitter::shorten_steps(const std::vector<double>& x, const RunDifferences& start, NearestPlaces& nearest) {
  constexpr int kMost = 5;
  constexpr double kRise = 1e-3;  // a common parameter that moves may raise the squares of some runs by as much
  RunDifferences& to = prepared_.errors->runs;
  const RunDifferences wanted = to;
  const UsedRuns in_runs = used_runs(data_, prepared_.used);
  const Groups& groups = in_runs.groups;
  const std::vector<std::size_t>& runs = in_runs.runs;
  const auto cost = [&](std::size_t g, const std::vector<double>& r, const RunDifferences& at) {
    double sum = 0;
    for (const std::size_t i : groups[g]) sum += r[i] * r[i];
    for (std::size_t q = 0; q < to.names.size(); ++q)
      if (const double d = at.deviations[q][runs[g]]; d != 0) sum += std::pow(d / to.spreads[q], 2);
    return sum;
  };
  const std::vector<double> expected = of_points(prepared_.errors->expected, prepared_.used);
  std::vector<double> least;
  for (std::size_t g = 0; g < groups.size(); ++g) least.push_back(cost(g, nearest.residuals, start));
  std::vector<double> step(groups.size(), 1.0);
  std::vector<std::size_t> open(groups.size());
  std::iota(open.begin(), open.end(), std::size_t{0});
  const bool apart = nearest.axes.empty() && nearest.pull_off.empty();  // else all runs are evaluated together
  for (int halving = 0; !open.empty(); ++halving) {
    std::vector<std::size_t> rows;
    for (std::size_t g = 0; g < groups.size(); ++g)
      if (!apart || std::binary_search(open.begin(), open.end(), g))
        rows.insert(rows.end(), groups[g].begin(), groups[g].end());
    std::sort(rows.begin(), rows.end());
    PreparedFit some = prepared_;
    some.used = {};
    for (const std::size_t i : rows) some.used.push_back(prepared_.used[i]);
    auto now = static_cast<const CurveObjective&>(*make_problem(data_, options_, some)).nearest(x);
    if (!now) return false;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const std::size_t i = rows[k];
      nearest.residuals[i] = now->residuals[k] - (expected.empty() ? 0 : expected[i]);
      nearest.T[i] = now->T[k];
      nearest.A[i] = now->A[k];
      nearest.load_T[i] = now->load_T[k];
      nearest.load_A[i] = now->load_A[k];
    }
    nearest.axes = std::move(now->axes);
    nearest.pull_off = std::move(now->pull_off);
    std::erase_if(open, [&](std::size_t g) {
      if (step[g] == 0 || cost(g, nearest.residuals, to) <= least[g] * (1 + kRise)) return true;
      step[g] = halving + 1 == kMost ? 0 : step[g] / 2;
      for (std::size_t q = 0; q < to.names.size(); ++q) {
        const double from = start.deviations[q][runs[g]];
        to.deviations[q][runs[g]] = from + step[g] * (wanted.deviations[q][runs[g]] - from);
      }
      return false;
    });
  }
  return true;
}

}  // namespace mixity
