// Quantities whose spread between the runs is found with the fit.
#include <algorithm>
#include <cmath>

#include "fitting/curve_objective.h"
#include "fitting/fitted_errors.h"
#include "fitting/fitter.h"
#include "fitting/run_differences.h"

namespace mixity {

/// Finds the spreads, takes the runs' deviations off the residuals, and what they explain off the shares of noise.
/// False where they are not determined. The residuals are linearised at the deviations so far (Lindstrom & Bates 1990,
/// Biometrics 46, 673).
bool Fitter::find_run_differences(const std::vector<double>& x, NearestPlaces& nearest, std::vector<double>& leverage,
                                  double& change) {
  RunDifferences& differences = prepared_.errors->runs;
  const RunDifferences before = differences;
  const std::vector<double> at_deviations = nearest.residuals;
  const std::vector<std::string>& names = options_.by_run;
  auto rows = run_rows(data_, options_, prepared_, x, nearest.residuals, names, 1);
  if (!rows) return false;
  const UsedRuns in_runs = used_runs(data_, prepared_.used);
  const Groups& groups = in_runs.groups;
  const std::vector<std::size_t>& runs = in_runs.runs;
  for (std::size_t q = 0; q < before.names.size(); ++q)
    for (std::size_t g = 0; g < groups.size() && constant_named(names[q]); ++g)
      for (const std::size_t i : groups[g]) {
        const auto row = static_cast<Eigen::Index>(i), column = static_cast<Eigen::Index>(q);
        nearest.residuals[i] -= rows->Z(row, column) * before.deviations[q][runs[g]];
        rows->r[row] -= rows->Zw(row, column) * before.deviations[q][runs[g]];
      }
  const GroupedRows grouped = grouped_rows(rows->J, rows->r, rows->Zw, groups);
  const auto found = restricted_spreads(grouped);
  if (!found) return false;
  const auto deviation = most_probable(grouped, found->spread, Fixed::yes);
  differences = {names, {}, {}, {}, found->freedom};
  for (std::size_t q = 0; q < names.size(); ++q) {
    const auto column = static_cast<Eigen::Index>(q);
    differences.spreads.push_back(found->spread[column]);
    differences.columns.emplace_back(data_.points.size());
    std::vector<double>& deviations = differences.deviations.emplace_back(data_.curves.size());
    for (std::size_t g = 0; g < groups.size(); ++g) deviations[runs[g]] = deviation[g][column];
  }
  shorten_steps(x, before, at_deviations);
  for (std::size_t q = 0; q < names.size(); ++q)
    for (std::size_t g = 0; g < groups.size(); ++g)
      for (const std::size_t i : groups[g])
        nearest.residuals[i] +=
            rows->Z(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(q)) * differences.deviations[q][runs[g]];
  for (std::size_t q = 0; q < names.size(); ++q) {
    const double unit = std::max(differences.spreads[q], 1e-6);
    change = std::max(change, before.any() ? std::abs(differences.spreads[q] - before.spreads[q]) / unit : 1);
    for (std::size_t run = 0; before.any() && run < data_.curves.size(); ++run)
      change = std::max(change, std::abs(differences.deviations[q][run] - before.deviations[q][run]) / unit);
  }
  const Eigen::VectorXd shares = shares_of_noise(rows->J, rows->Zw, groups, found->spread);
  for (std::size_t i = 0; i < leverage.size(); ++i) leverage[i] = 1 - shares[static_cast<Eigen::Index>(i)];
  return true;
}

/// The columns at the errors and deviations that were found. False where they are not finite.
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

/// Halves the step of a run's deviations until it lowers the squares of its residuals and of its deviations.
void Fitter::shorten_steps(const std::vector<double>& x, const RunDifferences& before,
                           const std::vector<double>& residuals) {
  constexpr int kMost = 5;
  RunDifferences& to = prepared_.errors->runs;
  const RunDifferences wanted = to;
  const auto old = [&](std::size_t q, std::size_t run) { return before.any() ? before.deviations[q][run] : 0.0; };
  const UsedRuns in_runs = used_runs(data_, prepared_.used);
  const Groups& groups = in_runs.groups;
  const std::vector<std::size_t>& runs = in_runs.runs;
  const auto cost = [&](std::size_t g, const std::vector<double>& r, const auto& deviation) {
    double sum = 0;
    for (const std::size_t i : groups[g]) sum += r[i] * r[i];
    for (std::size_t q = 0; q < to.names.size(); ++q)
      if (to.spreads[q] > 0) sum += std::pow(deviation(q, runs[g]) / to.spreads[q], 2);
    return sum;
  };
  std::vector<double> expected = of_points(prepared_.errors->expected, prepared_.used), now = residuals;
  std::vector<double> least;
  for (std::size_t g = 0; g < groups.size(); ++g) least.push_back(cost(g, now, old));
  std::vector<double> step(groups.size(), 1.0);
  for (int halving = 0; halving < kMost; ++halving) {
    const auto nearest = static_cast<const CurveObjective&>(*make_problem(data_, options_, prepared_)).nearest(x);
    if (!nearest) return;
    for (std::size_t i = 0; i < now.size(); ++i) now[i] = nearest->residuals[i] - (expected.empty() ? 0 : expected[i]);
    bool all = true;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const auto here = [&](std::size_t q, std::size_t run) { return to.deviations[q][run]; };
      if (step[g] == 0 || cost(g, now, here) <= least[g] * (1 + 1e-9)) continue;
      all = false;
      step[g] = halving + 2 == kMost ? 0 : step[g] / 2;
      for (std::size_t q = 0; q < to.names.size(); ++q)
        if (constant_named(to.names[q]))
          to.deviations[q][runs[g]] = old(q, runs[g]) + step[g] * (wanted.deviations[q][runs[g]] - old(q, runs[g]));
    }
    if (all) return;
  }
}

}  // namespace mixity
