#include "solver/solve.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "solver/descent.h"
#include "solver/interval.h"
#include "solver/kernel.h"
#include "solver/multistart.h"
#include "solver/prior.h"
#include "solver/refit.h"
#include "solver/verdict.h"

namespace mixity {
namespace {

constexpr int kMostRounds = 50;    // between the minimum and the unit of its residuals
constexpr double kSettled = 1e-9;  // relative change of that unit

bool lower(const Minimum& one, const Minimum& other) { return one.sum_of_squares < other.sum_of_squares; }

/// The distinct minima at which descents ended.
class Minima {
 public:
  Minima(const Problem& problem, const SolverOptions& options)
      : problem_(problem), options_(options), rounding_(residual_rounding(problem)) {}

  void keep(const Minimum& minimum) {
    const auto same =
        std::find_if(list.begin(), list.end(), [&](const Minimum& known) { return are_one(known, minimum); });
    if (same == list.end())
      list.push_back(minimum);
    else if (minimum.stationary ? !same->stationary || lower(minimum, *same)
                                : std::sqrt(minimum.sum_of_squares) + rounding_ < std::sqrt(same->sum_of_squares))
      *same = minimum;
  }
  /// Whether a minimum with at most this cost is known.
  bool has_below(double cost) const {
    return std::any_of(list.begin(), list.end(),
                       [&](const Minimum& minimum) { return minimum.stationary && minimum.sum_of_squares <= cost; });
  }
  /// Whether a minimum is known in the box of this start.
  bool has_one_of(const Start& start) const {
    return !start.low.empty() && std::any_of(list.begin(), list.end(), [&](const Minimum& minimum) {
      for (std::size_t k = 0; k < minimum.x.size(); ++k)
        if (!(minimum.x[k] >= start.low[k] && minimum.x[k] <= start.high[k])) return false;
      return minimum.stationary;
    });
  }
  /// Removes peaks: at a bound the slope may vanish by symmetry where the cost is highest.
  void drop_peaks() {
    if (list.size() > 1) std::erase_if(list, [&](const Minimum& minimum) { return is_peak_at_bound(minimum); });
  }

  std::vector<Minimum> list;

 private:
  bool are_one(const Minimum& one, const Minimum& other) const {
    for (std::size_t k = 0; k < one.x.size(); ++k) {
      const FreeParameter& parameter = problem_.parameters()[k];
      // a value near zero is judged by the error that it is stated with
      const double scale = std::max({std::abs(one.x[k]), parameter.least_size(), parameter.prior});
      if (std::abs(one.x[k] - other.x[k]) > options_.same_minimum * scale) return false;
    }
    return true;
  }

  bool is_peak_at_bound(const Minimum& minimum) const {
    for (std::size_t k = 0; k < minimum.x.size(); ++k) {
      const FreeParameter& parameter = problem_.parameters()[k];
      if (!parameter.at_bound(minimum.x[k])) continue;
      const double x = minimum.x[k], inwards = x <= parameter.lower ? 1 : -1;
      if (minimum.x.size() == 1) return !lowest_at_bound(problem_, x);
      Profile profile(problem_, minimum, 1e-3 * options_.lower_cost * minimum.sum_of_squares, options_);
      profile.begin(k);
      for (const double share : {1e-3, 1e-2})
        if (const auto there = profile(x + share * inwards * parameter.width());
            there && there->cost < minimum.sum_of_squares * (1 - options_.lower_cost))
          return true;
    }
    return false;
  }

  const Problem& problem_;
  const SolverOptions& options_;
  double rounding_;
};

/// The lowest minimum within three standard errors, by the scatter of the residuals, of one of a single parameter.
/// Residuals far larger than the errors put bends into the cost where points change the branch of the curve that is
/// next to them. Which side of one Newton's method ends at is chance, and the grid is too wide to show.
Minimum lowest_nearby(const Problem& problem, Minimum best, const SolverOptions& options) {
  constexpr int kSides = 12, kMost = 5;  // samples on each side; times that a lower minimum is looked around
  constexpr double kReach = 3;
  const std::size_t n = problem.residual_count();
  const FreeParameter& parameter = problem.parameters()[0];
  std::vector<double> residuals(n);
  for (int round = 0; round < kMost; ++round) {
    Kernel kernel(problem, options);
    const double slope = kernel.at(best.x).slope_size.norm(),
                 scatter = std::sqrt(best.sum_of_squares / static_cast<double>(n - 1));
    if (!(slope > 0)) break;
    Minimum lowest = best;
    for (int k = -kSides; k <= kSides; ++k) {
      const std::vector<double> x{parameter.clamped(best.x[0] + kReach * scatter / slope * k / kSides)};
      const auto cost = sum_of_squares(problem, x, residuals);
      if (cost && *cost < lowest.sum_of_squares * (1 - options.lower_cost)) lowest = {x, *cost, 1, false};
    }
    if (lowest.x == best.x) break;
    const auto minimum = kernel.explore({lowest.x});
    if (!minimum || !lower(*minimum, lowest)) break;
    best = *minimum;
  }
  return best;
}

FoundMinima find_minima(const Problem& problem, const StartingPoints& starting, const SolverOptions& options) {
  const std::size_t p = problem.parameters().size();
  FoundMinima found;
  std::vector<Start> list;  // guesses first: they are usually the nearest
  if (!starting.near.empty()) list.push_back({starting.near});
  for (const auto& guess : starting.guesses) list.push_back({guess});
  if (starting.near.empty()) {
    Starts starts = find_starts(problem, options);
    list.insert(list.end(), starts.list.begin(), starts.list.end());
    found.dearest = std::move(starts.dearest);
  }
  found.started = !list.empty();

  Minima minima(problem, options);
  // The kernel's minimum is the result of a refit that does not ask for the last digits.
  const bool refit = !starting.near.empty() && options.engine == Engine::kernel && !options.last_digits;
  SolverOptions exploring = options;
  if (p > 1 && !refit) {
    exploring.most_iterations = options.most_iterations_of_a_start;
    exploring.kernel_stationary_of_several = options.stationary;
  }
  std::optional<Kernel> kernel(std::in_place, problem, exploring);
  std::vector<double> residuals;
  for (const Start& start : list) {
    if (minima.has_one_of(start)) continue;
    const std::optional<Minimum> minimum = kernel->explore(start);
    residuals.resize(minimum ? 0 : problem.residual_count());
    if (minimum)
      found.least = std::min(found.least, kernel->first_cost());
    else if (const auto cost = sum_of_squares(problem, start.x, residuals))  // finite, although the slope is not
      found.least = std::min(found.least, *cost);
    // From the only start of several parameters tries both engines: one may end in a valley or on a plateau.
    const bool lost = !minimum || (!minimum->stationary && !minima.has_below(minimum->sum_of_squares));
    if (lost || (list.size() == 1 && p > 1 && options.engine == Engine::ceres))
      if (const auto other = descend(problem, start.x, options)) {
        minima.keep(*other);
        if (minimum && other->stationary && !lower(*minimum, *other)) continue;
      }
    if (minimum && (minimum->stationary || lost)) minima.keep(*minimum);
  }
  kernel.reset();  // its arrays are as long as the data
  minima.drop_peaks();
  found.list = std::move(minima.list);
  if (found.list.empty()) return found;
  std::sort(found.list.begin(), found.list.end(), lower);
  Minimum& best = found.list.front();
  if (p == 1 && best.slow && starting.near.empty()) best = lowest_nearby(problem, best, options);
  // The kernel found it; the engine of the options takes it to the last digits.
  if (!refit && (p > 1 || options.engine != Engine::kernel))
    if (const auto minimum = descend(problem, best.x, options);
        minimum && (minimum->stationary || lower(*minimum, best)))
      best = *minimum;
  found.least = std::min(found.least, best.sum_of_squares);
  return found;
}

}  // namespace

Verdict solve(const Problem& problem, const StartingPoints& starting, const SolverOptions& options) {
  const std::size_t n = problem.residual_count(), p = problem.parameters().size();
  if (n > p) return judge(problem, find_minima(problem, starting, options), options);
  Verdict verdict(p);
  verdict.status = FitStatus::not_identifiable;
  verdict.message = too_few_points(n, n, p);
  return verdict;
}

SolvedWithPriors solve_with_priors(const Problem& data, const StartingPoints& starting, const SolverOptions& options) {
  const std::size_t priors = prior_count(data), n = data.residual_count(), unknown = data.parameters().size() - priors;
  if (priors == 0) return {solve(data, starting, options), 1};
  const Remembering nearby(data);
  const Problem& of_data = starting.near.empty() ? data : static_cast<const Problem&>(nearby);
  const auto at_unit = [&](double unit, const StartingPoints& from, const SolverOptions& with) {
    return SolvedWithPriors{solve(ProblemWithPriors(of_data, unit), from, with), unit};
  };
  if (data.known_errors() || n <= unknown) return at_unit(1, starting, options);
  const auto priors_at = [&](const std::vector<double>& x) {
    double sum = 0;
    for (std::size_t k = 0; k < x.size(); ++k)
      if (const FreeParameter& one = data.parameters()[k]; one.prior > 0)
        sum += std::pow((x[k] - *one.start) / one.prior, 2);
    return sum;
  };
  // The unit at a place whose cost is known in another unit.
  const auto unit_of = [&](double cost, const std::vector<double>& x, double unit) {
    const double square = (cost - priors_at(x)) * unit * unit;
    return square > 0 ? std::sqrt(square / static_cast<double>(n - unknown)) : 0.0;
  };
  // The kernel first finds the unit, without a verdict.
  SolverOptions quick = options;
  quick.engine = Engine::kernel;
  quick.stationary = quick.kernel_stationary_of_several = 1e-6;  // the error of the cost is its square
  quick.kernel_stationary = 1e-8;
  const auto settle = [&](std::vector<double>& x) {
    if (const auto both = refit_near(of_data, x, quick)) {
      x = both->minimum.x;
      return both->unit;
    }
    std::vector<double> residuals(n);
    const auto square = x.empty() ? std::nullopt : sum_of_squares(of_data, x, residuals);
    double unit = square ? std::sqrt(*square / static_cast<double>(n - unknown)) : 0.0;
    for (int i = 0; i < kMostRounds && unit > 0; ++i) {
      const auto minimum = Kernel(ProblemWithPriors(nearby, unit), quick).descend(x);
      if (!minimum || !minimum->stationary) break;
      x = minimum->x;
      const double there = unit_of(minimum->sum_of_squares, x, unit);
      if (!(there > 0) || std::abs(there - unit) <= kSettled * unit) break;
      unit = there;
    }
    return unit;
  };
  std::vector<double> x = !starting.near.empty()      ? starting.near
                          : !starting.guesses.empty() ? starting.guesses.back()
                                                      : at_unit(1, starting, quick).verdict.best.x;
  std::optional<SolvedWithPriors> found;
  for (int i = 0; i < kMostRounds; ++i) {
    const double unit = settle(x);
    if (!(unit > 0)) break;
    found = at_unit(unit, i == 0 && starting.near.empty() ? starting : StartingPoints{x}, options);
    const Minimum& best = found->verdict.best;
    x = best.x;
    if (x.empty() || std::abs(unit_of(best.sum_of_squares, x, unit) - unit) <= kSettled * unit) break;
  }
  return found ? std::move(*found) : at_unit(1, starting, options);
}

}  // namespace mixity
