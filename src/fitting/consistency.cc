#include "fitting/consistency.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/number_text.h"
#include "statistics/distributions.h"

namespace mixity {
namespace {

/// z of the number of runs of one sign (Wald and Wolfowitz); 0 where one sign is all but alone.
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

struct Sums {
  double product = 0, squares = 0;  // of neighbours; squares of these products
};
Sums neighbours(const std::vector<double>& r) {
  Sums sums;
  for (std::size_t i = 0; i + 1 < r.size(); ++i) {
    sums.product += r[i] * r[i + 1];
    sums.squares += std::pow(r[i] * r[i + 1], 2);
  }
  return sums;
}

/// z of the slope of r against t, whatever the variance of each.
double trend_of(const std::vector<double>& t, const std::vector<double>& r) {
  double mean = 0, sum = 0, squares = 0;
  for (const double value : t) mean += value / static_cast<double>(t.size());
  for (std::size_t i = 0; i < t.size(); ++i) {
    sum += (t[i] - mean) * r[i];
    squares += std::pow((t[i] - mean) * r[i], 2);
  }
  return squares > 0 ? sum / std::sqrt(squares) : 0;
}

double largest_size(const std::vector<double>& t) {
  double most = 0;
  for (const double one : t) most = std::max(most, std::abs(one));
  return most;
}

constexpr double kBesideEnd = 0.3;    // of a run, from its end on
constexpr double kEnoughBeside = 10;  // points

ResidualTests test_residuals(const Dataset& data, const FitResult& fit) {
  ResidualTests tests;
  std::vector<std::vector<std::size_t>> runs(std::max<std::size_t>(data.curves.size(), 1));  // indices into `used`
  for (std::size_t i = 0; i < fit.used.size(); ++i) {
    const std::size_t curve = data.points[fit.used[i]].curve;
    if (curve < runs.size()) runs[curve].push_back(i);
  }
  double z = 0, trend = 0, squares = 0, product = 0, of_products = 0, ends = 0, at_ends = 0, near = 0, near_ends = 0,
         of_near = 0;
  for (std::size_t c = 0; c < runs.size(); ++c) {
    if (runs[c].size() < ResidualTests::kLeastRun) continue;
    std::vector<double> r, t;
    double square = 0;
    for (const std::size_t i : runs[c]) {
      const std::size_t point = fit.used[i];
      r.push_back(fit.residuals[i]);
      t.push_back(data.has_loads ? data.points[point].T : std::asin(data.converted[point].mixity.sin));
      square += r.back() * r.back();
    }
    if (data.has_loads) {
      std::vector<std::size_t> order(r.size());
      std::iota(order.rbegin(), order.rend(), std::size_t{0});
      // A run that was read as it was sheared ends where the file does: what has slid may lie at lower shear.
      if (!(std::abs(t.front()) < std::abs(t.back()) && 2 * std::abs(t.back()) > largest_size(t)))
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t one, std::size_t other) { return std::abs(t[one]) > std::abs(t[other]); });
      const auto last =
          std::max<std::size_t>(1, static_cast<std::size_t>(ResidualTests::kEnd * static_cast<double>(r.size())));
      for (std::size_t i = 0; i < last; ++i) ends += r[order[i]];
      at_ends += static_cast<double>(last);
      const auto beside = static_cast<std::size_t>(kBesideEnd * static_cast<double>(r.size()));
      for (std::size_t i = last; i < beside; ++i) {
        near += r[order[i]];
        of_near += r[order[i]] * r[order[i]];
      }
      near_ends += static_cast<double>(std::max(beside, last) - last);
    }
    const Sums sums = neighbours(r);
    const ResidualTests::Run run{c < data.curves.size() ? data.curves[c] : std::string(), r.size(), runs_of_one_sign(r),
                                 square > 0 ? sums.product / square : 0, trend_of(t, r)};
    z += run.runs;
    trend += run.trend * run.trend;
    squares += square;
    product += sums.product;
    of_products += sums.squares;
    tests.runs.push_back(run);
  }
  if (tests.runs.empty()) return tests;
  const auto m = static_cast<double>(tests.runs.size());
  tests.runs_p = normal_below(z / std::sqrt(m));
  tests.trend_p = chi_squared_p_value(trend, m);
  if (at_ends > 0) {
    // what scatters more at large T than elsewhere is measured by what lies beside it
    const bool measured = !fit.known_errors && near_ends >= kEnoughBeside && of_near > 0;
    const double unit = measured ? std::sqrt(of_near / near_ends) : residual_unit(fit);
    // A fit that is drawn to the ends is drawn away from what lies beside them.
    const double beside = near_ends >= kEnoughBeside ? near / near_ends : 0;
    const double variance = 1 / at_ends + (near_ends >= kEnoughBeside ? 1 / near_ends : 0);
    tests.ends = (ends / at_ends - beside) / std::sqrt(variance) / unit;
    tests.ends_p = measured ? student_p_value(tests.ends, near_ends) : 2 * normal_below(-std::abs(tests.ends));
  }
  if (squares > 0) tests.correlation = product / squares;
  if (of_products > 0) tests.correlation_p = normal_below(-product / std::sqrt(of_products));
  return tests;
}

/// Root mean square of residuals over that of their second differences in each run, by T; null of too few.
std::optional<double> over_neighbours(const Dataset& data, const FitResult& fit) {
  constexpr std::size_t kEnough = 8;
  if (!data.has_loads) return std::nullopt;
  std::vector<std::vector<std::size_t>> runs(data.curves.size());
  for (std::size_t i = 0; i < fit.used.size(); ++i) runs[data.points[fit.used[i]].curve].push_back(i);
  double squares = 0, differences = 0, triples = 0;
  for (auto& run : runs) {
    std::stable_sort(run.begin(), run.end(), [&](std::size_t one, std::size_t other) {
      return data.points[fit.used[one]].shear() < data.points[fit.used[other]].shear();
    });
    for (std::size_t i = 1; i + 1 < run.size(); ++i) {
      const double before = fit.residuals[run[i - 1]], here = fit.residuals[run[i]], behind = fit.residuals[run[i + 1]];
      squares += (before * before + 4 * here * here + behind * behind) / 6;  // weighs as the differences do
      differences += std::pow(before - 2 * here + behind, 2) / 6;
      ++triples;
    }
  }
  if (triples < kEnough || !(differences > 0)) return std::nullopt;
  return std::sqrt(squares / differences);
}

/// Runs with points that the fitted model gives no area, and the first of them.
std::vector<BeyondEquilibrium> beyond_equilibrium(const Dataset& data, const FitResult& fit) {
  std::vector<BeyondEquilibrium> list;
  if (!fit.area || fit.area->areas.size() != fit.used.size()) return list;
  for (std::size_t i = 0; i < fit.used.size(); ++i) {
    if (fit.area->areas[i]) continue;
    const std::string& curve = data.curves[data.points[fit.used[i]].curve];
    if (list.empty() || list.back().curve != curve) list.push_back({curve, 0, fit.used[i]});
    ++list.back().points;
  }
  return list;
}

}  // namespace

double residual_unit(const FitResult& fit) {
  if (fit.known_errors || fit.used.size() <= fit.free_parameters) return 1;
  return std::sqrt(fit.sum_of_squares / static_cast<double>(fit.used.size() - fit.free_parameters));
}

Consistency test_consistency(const Dataset& data, const FitResult& fit) {
  Consistency result;
  if (fit.known_errors && fit.loss_scale == 0 && fit.used.size() > fit.free_parameters) {
    const auto freedom = static_cast<double>(fit.used.size() - fit.free_parameters);
    result.chi2_per_freedom = fit.sum_of_squares / freedom;
    result.chi2_p = chi_squared_p_value(fit.sum_of_squares, freedom);
  }
  result.residuals = test_residuals(data, fit);
  // Errors of neighbours know nothing of the fit: residuals are in units of these.
  if (!fit.known_errors && fit.objective == Objective::curve && fit.errors && fit.loss_scale == 0 &&
      fit.errors->source_A == ErrorSource::scatter && fit.errors->source_T == ErrorSource::scatter)
    result.residuals.over_scatter = residual_unit(fit);
  result.residuals.over_neighbours = over_neighbours(data, fit);
  result.beyond = beyond_equilibrium(data, fit);
  return result;
}

const ExactConstant* wrong_constant(const FitResult& fit) {
  if (!fit.budget) return nullptr;
  const ExactConstant* worst = nullptr;
  for (const ExactConstant& one : fit.budget->exact)
    if (one.score && (!worst || one.score->p_value < worst->score->p_value)) worst = &one;
  if (!worst || !(worst->score->p_value * fit.budget->independent < kChance)) return nullptr;
  // Where the stated errors are too small for any constant, all of chi^2 counts less.
  const bool too_small = fit.known_errors && fit.consistency && fit.consistency->chi2_p.value_or(1) < kChance;
  if (too_small &&
      chi_squared_p_value(worst->score->fall / *fit.consistency->chi2_per_freedom, 1) * fit.budget->independent >=
          kChance)
    return nullptr;
  return worst;
}

bool slides(const FitResult& fit) {
  constexpr double kFarOff = 4;    // standard errors of a residual
  constexpr std::size_t kFew = 2;  // points that noise may have put there
  if (!fit.area || fit.area->areas.size() != fit.used.size()) return false;
  std::size_t beyond = 0;
  for (std::size_t i = 0; i < fit.used.size(); ++i)
    beyond += !fit.area->areas[i] && std::abs(fit.residuals[i]) > kFarOff * residual_unit(fit);
  return beyond > kFew;
}

/// Of points too few for tests along the runs: far from the curve, and not by noise of other proportions than are taken
/// for granted, which residuals of neighbours show as well. A wrong model of six points a run makes it 4 to 8.
bool is_far(const ResidualTests& tests) {
  constexpr double kFarOff = 2.5, kFarFromNeighbours = 1.5;
  return tests.over_scatter.value_or(0) > kFarOff && tests.over_neighbours.value_or(0) > kFarFromNeighbours;
}

Message failed_test(const FitResult& fit) {
  constexpr double kFarFromStated = 4;  // standard errors of a prior
  if (fit.budget)
    for (const BudgetPart& part : fit.budget->parts)
      if (std::abs(part.pull) > kFarFromStated)
        return part.constant + " lies " + rounded(std::abs(part.pull), 2) + " of its standard errors " +
               (part.pull < 0 ? "below" : "above") + " what was stated: check it";
  if (slides(fit)) return "points lie beyond the last equilibrium: cut the runs at the onset of sliding";
  if (const ExactConstant* wrong = wrong_constant(fit))
    return wrong->constant + " looks wrong: check it, state its standard error, or " +
           Remedy::set("free", wrong->constant);
  if (!fit.consistency) return {};
  const Consistency& tests = *fit.consistency;
  if (tests.chi2_p && *tests.chi2_p < kChance)
    return "the scatter is larger than the stated errors (chi^2 per degree of freedom " +
           rounded(*tests.chi2_per_freedom, 3) + "): check sigma_T and sigma_A";
  if (is_far(tests.residuals))
    return "the points lie " + rounded(*tests.residuals.over_scatter, 2) +
           " times as far from the curve as neighbours scatter: the model or a constant is wrong";
  if (tests.residuals.ends_p < kChance)
    return "the ends of the runs lie off the curve (z = " + rounded(tests.residuals.ends, 2) +
           "): points past the onset of sliding?";
  if (tests.residuals.runs_p < kChance || tests.residuals.correlation_p < kChance)
    return "residuals of neighbouring points resemble each other (correlation " +
           rounded(tests.residuals.correlation, 2) +
           "): the model or a constant is wrong, or the points are not independent (" + Remedy::set("bootstrap") +
           " with " + Remedy::set("resample", "curves") + ")";
  if (tests.residuals.trend_p < kChance)
    return "residuals follow a trend along the runs: the model or a constant is wrong";
  return {};
}

}  // namespace mixity
