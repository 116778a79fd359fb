#include "fitting/consistency.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "fitting/circularity.h"
#include "fitting/course.h"
#include "fitting/fitted_errors.h"
#include "fitting/limited_residuals.h"
#include "fitting/pinned.h"
#include "fitting/pull_off_course.h"
#include "fitting/run_differences.h"
#include "solver/robust.h"
#include "statistics/distributions.h"

namespace mixity {
namespace {

/// z of the number of sequences of one sign (Wald & Wolfowitz); 0 where nearly all signs agree.
double runs_of_one_sign(const std::vector<double>& r) {
  double plus = 0, runs = 1;
  for (std::size_t i = 0; i < r.size(); ++i) {
    plus += r[i] >= 0;
    if (i > 0) runs += (r[i] >= 0) != (r[i - 1] >= 0);
  }
  const double n = static_cast<double>(r.size()), both = 2 * plus * (n - plus);
  const double variance = both * (both - n) / (n * n * (n - 1));
  return variance > 0 ? (runs - both / n - 1) / std::sqrt(variance) : 0;
}

/// z of the slope of r against t, for residuals of different variances.
double trend_of(const std::vector<double>& t, const std::vector<double>& r) {
  double mean = 0, sum = 0, squares = 0;
  for (const double value : t) mean += value / static_cast<double>(t.size());
  for (std::size_t i = 0; i < t.size(); ++i) {
    sum += (t[i] - mean) * r[i];
    squares += std::pow((t[i] - mean) * r[i], 2);
  }
  return squares > 0 ? sum / std::sqrt(squares) : 0;
}

/// Products of neighbouring residuals: their sum, and the sum of their squares.
std::pair<double, double> neighbour_products(const std::vector<double>& r) {
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i + 1 < r.size(); ++i) {
    sum += r[i] * r[i + 1];
    squares += std::pow(r[i] * r[i + 1], 2);
  }
  return {sum, squares};
}

/// Compares residuals at the ends of the runs with those before.
class EndsTest {
 public:
  /// A run with its loads T. `repeats`: whether a reading in steps is that of the point before, and tells nothing new.
  void add(const std::vector<double>& T, const std::vector<double>& r, const std::vector<bool>& repeats) {
    constexpr double kBeside = 0.3;  // share of a run, from its end
    std::vector<std::size_t> order(r.size());
    std::iota(order.rbegin(), order.rend(), std::size_t{0});
    // A run that was recorded as it was sheared ends where the file does: points that have slid may lie at lower shear.
    const double last_T = std::abs(T.back());
    if (!(std::abs(T.front()) < last_T &&
          std::all_of(T.begin(), T.end(), [&](double one) { return std::abs(one) < 2 * last_T; })))
      std::stable_sort(order.begin(), order.end(),
                       [&](std::size_t one, std::size_t other) { return std::abs(T[one]) > std::abs(T[other]); });
    const auto size = static_cast<double>(r.size());
    const auto last = std::max<std::size_t>(1, static_cast<std::size_t>(ResidualTests::kEnd * size)),
               beside = static_cast<std::size_t>(kBeside * size);
    for (std::size_t i = 0; i < last; ++i) at_end_.add(r[order[i]], repeats[order[i]]);
    for (std::size_t i = last; i < beside; ++i) beside_.add(r[order[i]], repeats[order[i]]);
  }

  void add(const EndsTest& run) {
    at_end_.add(run.at_end_);
    beside_.add(run.beside_);
  }

  void finish(const FitResult& fit, ResidualTests& tests) const {
    constexpr double kEnough = 10;  // informative points beside the ends
    if (!(at_end_.told > 0)) return;
    // Where errors have unknown size, the scatter beside the ends measures it, since it may grow with T.
    const bool enough = beside_.told >= kEnough, measured = !fit.known_errors && enough && beside_.squares > 0;
    const double unit = measured ? std::sqrt(beside_.squares / beside_.points) : residual_unit(fit);
    // A fit that is attracted by the ends departs from the points beside them.
    const double mean_beside = enough ? beside_.sum / beside_.points : 0;
    const double variance = 1 / at_end_.told + (enough ? 1 / beside_.told : 0);
    tests.ends = (at_end_.sum / at_end_.points - mean_beside) / std::sqrt(variance) / unit;
    tests.ends_p = measured ? student_p_value(tests.ends, beside_.told) : 2 * normal_below(-std::abs(tests.ends));
  }

 private:
  struct Part {
    void add(double r, bool repeat) {
      sum += r;
      squares += r * r;
      ++points;
      told += repeat ? 0 : 1;
    }
    void add(const Part& other) {
      sum += other.sum;
      squares += other.squares;
      points += other.points;
      told += other.told;
    }
    double sum = 0, squares = 0, points = 0, told = 0;  // told: number of points that do not repeat
  };
  Part at_end_, beside_;
};

/// Residuals minus the part expected from noise.
double unexpected(const FitResult& fit, std::size_t i) {
  const bool some = fit.errors && !fit.errors->expected.empty();
  return some ? fit.residuals[i] - fit.errors->expected[fit.used[i]] : fit.residuals[i];
}
std::vector<double> unexpected(const FitResult& fit) {
  std::vector<double> r(fit.residuals.size());
  for (std::size_t i = 0; i < r.size(); ++i) r[i] = unexpected(fit, i);
  return r;
}

/// T of each residual, at the fitted curve where that is known: the noise of a reading of T is in its residual, too, so
/// that residuals would depend on the reading.
class Shears {
 public:
  Shears(const Dataset& data, const FitResult& fit)
      : data_(data), fit_(fit), known_(fit.errors && !fit.errors->place_T.empty()) {}
  double operator()(std::size_t k) const {
    const std::size_t i = fit_.used[k];
    return known_ ? std::copysign(fit_.errors->place_T[i], data_.points[i].T) : data_.points[i].T;
  }

 private:
  const Dataset& data_;
  const FitResult& fit_;
  bool known_;
};

ResidualTests test_residuals(const Dataset& data, const FitResult& fit) {
  constexpr std::size_t kFarthest = 6;  // lag; a wrong model bends residuals over more points than a filter averages
  ResidualTests tests;
  const Shears T(data, fit);
  const auto of_noise = [&](std::size_t i) { return unexpected(fit, i); };
  if (const auto course = data.has_loads ? test_course(data, fit.used, T, of_noise) : std::nullopt) {
    tests.course = course->F;
    tests.course_p = course->exceeds_noise(fit.used.size(), residual_unit(fit)) ? course->p_value : 1;
    // With few runs, noise with a memory is hardly distinguished from a wrong model: less evidence is enough against
    // it.
    constexpr std::size_t kFewRuns = 5;
    constexpr double kLess = 1e-2;
    const bool few = data.curves.size() < kFewRuns && fit.errors && fit.errors->correlations.any();
    tests.shares_course = tests.course_p < (few ? kLess : kChance);
  }
  // With one or two runs, correlated noise cannot be distinguished from a wrong model.
  const bool independent = tests.course && fit.innovations.size() == fit.residuals.size();
  std::vector<double> changed;  // of millions of points no list is copied
  if (!independent || fit.loss_scale > 0) changed = independent ? fit.innovations : unexpected(fit);
  const std::vector<double>& whole = changed.empty() ? fit.innovations : std::as_const(changed);
  if (fit.loss_scale == 0 && !fit.used.empty() && whole.size() == fit.used.size() && whole.size() < kManyPoints)
    if (const LimitedResiduals limited(data, fit.used, whole); limited.any()) {
      std::vector<double> single(whole.size());
      for (std::size_t i = 0; i < whole.size(); ++i) single[i] = limited[i];
      changed = std::move(single);
    }
  if (fit.loss_scale > 0)  // limit outliers as the fit does, to where the loss bends
    for (double& r : changed) r = std::clamp(r, -fit.loss_scale, fit.loss_scale);
  const std::vector<double>& residuals = changed.empty() ? fit.innovations : changed;
  const PointsByRun runs(data, fit.used);
  struct OfRun {
    double square = 0, product = 0, of_products = 0, farther = 0;
    ResidualTests::Run run{};
    EndsTest ends{};
  };
  std::vector<OfRun> of_runs(runs.runs());
  runs.for_each_run([&](std::size_t g) {
    if (runs.size(g) < ResidualTests::kLeastRun) return;
    const std::size_t c = runs.run(g);
    OfRun& here = of_runs[g];
    std::vector<double> r, t;
    std::vector<bool> repeats;
    r.reserve(runs.size(g));
    t.reserve(runs.size(g));
    std::optional<std::size_t> before;
    for (std::size_t k = 0; k < runs.size(g); ++k) {
      const std::size_t i = runs.at(g, k), point = fit.used[i];
      repeats.push_back(before && fit.errors && fit.errors->coarse(point) &&
                        data.points[point].A == data.points[*before].A);
      before = point;
      r.push_back(residuals[i]);
      t.push_back(data.has_loads ? T(i) : std::asin(data.converted[point].mixity.sin));
      here.square += r.back() * r.back();
    }
    if (data.has_loads) here.ends.add(t, r, repeats);
    std::tie(here.product, here.of_products) = neighbour_products(r);
    for (std::size_t lag = 2; lag <= std::min(kFarthest, r.size() / 4); ++lag)
      here.farther += std::inner_product(r.begin() + static_cast<std::ptrdiff_t>(lag), r.end(), r.begin(), 0.0);
    here.run = {c < data.curves.size() ? data.curves[c] : std::string(), r.size(), runs_of_one_sign(r),
                here.square > 0 ? here.product / here.square : 0, trend_of(t, r)};
  });
  double z = 0, trend = 0, squares = 0, product = 0, of_products = 0, farther = 0;
  EndsTest ends;
  for (const OfRun& one : of_runs) {
    if (one.run.points == 0) continue;
    ends.add(one.ends);
    z += one.run.runs;
    trend += one.run.trend * one.run.trend;
    squares += one.square;
    product += one.product;
    of_products += one.of_products;
    farther += one.farther;
    tests.runs.push_back(one.run);
  }
  if (tests.runs.empty()) return tests;
  const auto m = static_cast<double>(tests.runs.size());
  tests.runs_p = normal_below(z / std::sqrt(m));
  tests.trend_p = chi_squared_p_value(trend, m);
  ends.finish(fit, tests);
  if (squares > 0) {
    tests.correlation = product / squares;
    tests.widening = std::sqrt(std::max(1 + 2 * (product + farther) / squares, 0.0));
  }
  if (of_products > 0) tests.correlation_p = normal_below(-product / std::sqrt(of_products));
  return tests;
}

/// Root mean square of residuals over that of their second differences in each run, by T; null for too few points.
std::optional<double> over_neighbours(const Dataset& data, const FitResult& fit) {
  constexpr std::size_t kEnough = 8;
  if (!data.has_loads) return std::nullopt;
  double squares = 0, differences = 0, triples = 0;
  const Shears T(data, fit);
  const std::vector<double>& r = fit.innovations.empty() ? fit.residuals : fit.innovations;
  const PointsByRun in_runs(data, fit.used);
  struct Sums {
    double squares = 0, differences = 0, triples = 0;
  };
  std::vector<Sums> of_runs(in_runs.runs());
  in_runs.for_each_run([&](std::size_t g) {
    std::vector<std::uint32_t> run(in_runs.size(g));
    for (std::size_t k = 0; k < run.size(); ++k) run[k] = static_cast<std::uint32_t>(in_runs.at(g, k));
    std::stable_sort(run.begin(), run.end(),
                     [&](std::size_t one, std::size_t other) { return std::abs(T(one)) < std::abs(T(other)); });
    Sums sums;
    for (std::size_t i = 1; i + 1 < run.size(); ++i) {
      const double before = r[run[i - 1]], here = r[run[i]], behind = r[run[i + 1]];
      sums.squares += (before * before + 4 * here * here + behind * behind) / 6;  // weighted like the differences
      sums.differences += std::pow(before - 2 * here + behind, 2) / 6;
      ++sums.triples;
    }
    of_runs[g] = sums;
  });
  for (const Sums& one : of_runs) {
    squares += one.squares;
    differences += one.differences;
    triples += one.triples;
  }
  if (triples < kEnough || !(differences > 0)) return std::nullopt;
  return std::sqrt(squares / differences);
}

/// Root mean square residual in units of the scatter of neighbouring points.
double over_scatter(const Dataset& data, const FitResult& fit) {
  double squares = 0;
  for (std::size_t i = 0; i < fit.residuals.size(); ++i)
    squares += std::pow(unexpected(fit, i), 2) * variance_ratio(data, *fit.errors, fit.used[i]);
  return fit.freedom() > 0 ? std::sqrt(squares / static_cast<double>(fit.freedom())) : 0;
}

/// Runs with points for which the fitted model has no area, and the first of these.
std::vector<BeyondEquilibrium> beyond_equilibrium(const Dataset& data, const FitResult& fit) {
  std::vector<BeyondEquilibrium> list;
  if (!fit.area || fit.area->areas.size() != fit.used.size()) return list;
  for (std::size_t i = 0; i < fit.used.size(); ++i) {
    if (fit.area->predicts(i)) continue;
    const std::string& curve = data.curves[data.points[fit.used[i]].curve];
    auto of_run = std::find_if(list.begin(), list.end(), [&](const auto& one) { return one.curve == curve; });
    if (of_run == list.end()) of_run = list.insert(list.end(), {curve, 0, fit.used[i]});
    ++of_run->points;
  }
  return list;
}

}  // namespace

Consistency consistency_of(const Dataset& data, const FitResult& fit) {
  return fit.consistency ? *fit.consistency : test_consistency(data, fit);
}

Consistency test_consistency(const Dataset& data, const FitResult& fit) {
  Consistency result;
  if (fit.known_errors && fit.freedom() > 0) {
    // Beside a robust loss by the median, which is worth so many of the points, and which few outliers do not move.
    constexpr double kWorth = 0.37;
    const bool robust = fit.loss_scale > 0;
    const double freedom = static_cast<double>(fit.freedom()), n = static_cast<double>(fit.used.size());
    const double square = robust ? n * std::pow(spread(fit.innovations), 2) : fit.sum_of_squares;
    result.chi2_per_freedom = square / freedom;
    const double counted = robust ? kWorth * freedom : freedom;
    result.chi2_p = chi_squared_p_value(square / freedom * counted, counted);
  }
  result.residuals = test_residuals(data, fit);
  // The errors come from the scatter of neighbours, independent of the fit; residuals are in units of these.
  if (!fit.known_errors && fit.objective == Objective::curve && fit.errors && fit.loss_scale == 0 &&
      fit.errors->source_A == ErrorSource::scatter && fit.errors->source_T == ErrorSource::scatter)
    result.residuals.over_scatter = over_scatter(data, fit);
  result.residuals.over_neighbours = over_neighbours(data, fit);
  if (fit.errors && !fit.used.empty()) {
    const auto coarse =
        std::count_if(fit.used.begin(), fit.used.end(), [&](std::size_t i) { return fit.errors->coarse(i); });
    result.residuals.coarse = 2 * static_cast<std::size_t>(coarse) > fit.used.size();
  }
  constexpr double kFew = 3;
  std::set<std::size_t> runs;
  for (const std::size_t i : fit.used) runs.insert(data.points[i].curve);
  result.residuals.together =
      mean_correlation(fit) > 0 && independent_points(fit) < kFew * static_cast<double>(runs.size());
  result.beyond = beyond_equilibrium(data, fit);
  result.circle = test_axes(data, fit);
  result.pull_off = test_pull_off(data, fit);
  // pull-off loads determine the parameters of a contact whose areas hardly change
  result.pinned =
      data.has_loads && fit.pull_off == 0 && is_pinned(data, fit, [&](std::size_t i) { return unexpected(fit, i); });
  return result;
}

}  // namespace mixity
