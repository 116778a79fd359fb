#include "solver/verdict.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "solver/covariance.h"
#include "solver/descent.h"
#include "solver/interval.h"
#include "solver/multistart.h"

namespace mixity {
namespace {

constexpr double kChiSquare95 = 3.841458820694124;  // of one degree of freedom

std::string digits(double value, int count) {
  char text[48];
  return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::general, count).ptr};
}

std::string value_text(const FreeParameter& parameter, double x) {
  return digits(parameter.shown(x), 4) + (parameter.unit.empty() ? "" : " " + parameter.unit);
}

std::string values_text(const Problem& problem, const std::vector<double>& x) {
  std::string text;
  for (std::size_t k = 0; k < x.size(); ++k)
    text += (k ? ", " : "") + problem.parameters()[k].name + " = " + value_text(problem.parameters()[k], x[k]);
  return text;
}

bool lower(const Minimum& one, const Minimum& other) { return one.sum_of_squares < other.sum_of_squares; }

/// The minima that descents ended at, each once.
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
  /// Whether a minimum of no higher cost is known.
  bool has_below(double cost) const {
    return std::any_of(list.begin(), list.end(),
                       [&](const Minimum& minimum) { return minimum.stationary && minimum.sum_of_squares <= cost; });
  }
  /// Whether a minimum is known in the basin of this start.
  bool has_one_of(const Start& start) const {
    return !start.low.empty() && std::any_of(list.begin(), list.end(), [&](const Minimum& minimum) {
      for (std::size_t k = 0; k < minimum.x.size(); ++k)
        if (!(minimum.x[k] >= start.low[k] && minimum.x[k] <= start.high[k])) return false;
      return minimum.stationary;
    });
  }
  /// At a bound the slope may vanish by symmetry where the cost is highest: those are no minima.
  void drop_peaks() {
    if (list.size() > 1) std::erase_if(list, [&](const Minimum& minimum) { return is_peak_at_bound(minimum); });
  }

  std::vector<Minimum> list;

 private:
  bool are_one(const Minimum& one, const Minimum& other) const {
    for (std::size_t k = 0; k < one.x.size(); ++k) {
      const double scale = std::max(std::abs(one.x[k]), problem_.parameters()[k].least_size());
      if (std::abs(one.x[k] - other.x[k]) > options_.same_minimum * scale) return false;
    }
    return true;
  }

  bool is_peak_at_bound(const Minimum& minimum) const {
    for (std::size_t k = 0; k < minimum.x.size(); ++k) {
      const FreeParameter& parameter = problem_.parameters()[k];
      const double x = minimum.x[k], inwards = x <= parameter.lower ? 1 : x >= parameter.upper ? -1 : 0;
      if (inwards == 0) continue;
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

/// What the tests of a verdict look at. Each test says why the fit is not ok, or nothing.
struct Judgement {
  const Problem& problem;
  const SolverOptions& options;
  const Starts& starts;
  Verdict& verdict;
  Covariance covariance;
  double least;  // the lowest cost met

  std::optional<double> cost_at(const std::vector<double>& x) const {
    std::vector<double> residuals(problem.residual_count());
    return sum_of_squares(problem, x, residuals);
  }
  bool fits_as_well(double cost) const {
    return cost <= least + fit_tolerance(problem, least) || std::sqrt(cost) <= residual_rounding(problem);
  }
};

using Finding = std::optional<std::pair<FitStatus, std::string>>;

/// Within rounding, or within what the scatter allows, every value looked at fits as well as the best: the first that
/// does not says otherwise. Some standard errors from the best there mostly is one.
Finding every_value_fits(const Judgement& judgement) {
  if (judgement.starts.dearest.empty()) return {};
  const Minimum& best = judgement.verdict.best;
  for (std::size_t k = 0; k < best.x.size(); ++k) {
    const FreeParameter& parameter = judgement.problem.parameters()[k];
    const std::optional<double>& error = judgement.covariance.standard_errors[k];
    if (parameter.start || !error) continue;
    for (const double errors : {-4.0, 4.0}) {
      std::vector<double> x = best.x;
      x[k] += errors * *error;
      if (x[k] < parameter.lower || x[k] > parameter.upper) continue;
      if (const auto cost = judgement.cost_at(x); cost && !judgement.fits_as_well(*cost)) return {};
    }
  }
  for (const auto& x : judgement.starts.dearest)
    if (const auto cost = judgement.cost_at(x); cost && !judgement.fits_as_well(*cost)) return {};
  std::string names;
  for (const FreeParameter& parameter : judgement.problem.parameters())
    names += (names.empty() ? "" : ", ") + parameter.name;
  return {{FitStatus::not_identifiable, "the data do not constrain " + names + ": every value in the range fits"}};
}

Finding nothing_found(const Judgement& judgement) {
  if (!judgement.verdict.best.x.empty()) return {};
  return {{FitStatus::not_converged, "no start led to a minimum"}};
}

Finding unconstrained(const Judgement& judgement) {
  Verdict& verdict = judgement.verdict;
  const Covariance& found = judgement.covariance;
  if (!found.unconstrained.empty())
    return {{FitStatus::not_identifiable, "the data do not constrain " + found.unconstrained}};
  verdict.standard_errors = found.standard_errors;
  verdict.correlations = found.correlations;
  return {};
}

/// Where a little further down the slope the model is not defined, the only parameter is as good as at a bound.
Finding stopped_on_a_slope(const Judgement& judgement) {
  const Minimum& best = judgement.verdict.best;
  if (best.stationary) return {};
  for (std::size_t k = 0; k < best.x.size(); ++k)
    for (const double direction : {-1.0, 1.0}) {
      std::vector<double> beyond = best.x;
      beyond[k] += direction * 1e-6 * std::max(std::abs(best.x[k]), judgement.problem.parameters()[k].least_size());
      const FreeParameter& parameter = judgement.problem.parameters()[k];
      if (beyond[k] < parameter.lower || beyond[k] > parameter.upper || judgement.cost_at(beyond)) continue;
      judgement.verdict.standard_errors.assign(best.x.size(), std::nullopt);
      const std::string where = "beyond " + values_text(judgement.problem, best.x) + " the model is not defined here";
      return {{best.x.size() == 1 ? FitStatus::at_bound : FitStatus::not_converged, where}};
    }
  return {{FitStatus::not_converged,
           "the solver stopped where the gradient is not zero (relative size " + digits(best.stationarity, 2) + ")"}};
}

Finding above_a_start(const Judgement& judgement) {
  const double best = judgement.verdict.best.sum_of_squares, least = judgement.least;
  const bool higher = best > least * (1 + judgement.options.lower_cost) &&
                      std::sqrt(best) > std::sqrt(least) + residual_rounding(judgement.problem);
  if (!higher) return {};
  return {{FitStatus::not_converged, "the solver ended above the lowest cost of its starts"}};
}

Finding at_a_bound(const Judgement& judgement) {
  std::string bounds;
  for (std::size_t k = 0; k < judgement.verdict.best.x.size(); ++k) {
    if (!judgement.verdict.at_bound[k]) continue;
    const FreeParameter& parameter = judgement.problem.parameters()[k];
    const double x = judgement.verdict.best.x[k];
    bounds += (bounds.empty() ? "" : ", ") + parameter.name + " is at its " +
              (x <= parameter.lower ? "lower bound " : "upper bound ") + value_text(parameter, x);
  }
  if (bounds.empty()) return {};
  return {{FitStatus::at_bound, bounds}};
}

Finding another_fits_as_well(const Judgement& judgement) {
  const auto& others = judgement.verdict.others;
  const double best = judgement.verdict.best.sum_of_squares;
  const auto other = std::find_if(others.begin(), others.end(), [&](const Minimum& minimum) {
    return minimum.sum_of_squares <= best + fit_tolerance(judgement.problem, best);
  });
  if (other == others.end()) return {};
  return {{FitStatus::multimodal, std::string("another minimum fits as well within the ") +
                                      (judgement.problem.known_errors() ? "standard errors: " : "scatter: ") +
                                      values_text(judgement.problem, other->x)}};
}

/// In this order: the first that has something to say decides.
constexpr Finding (*kTests[])(const Judgement&) = {every_value_fits,    nothing_found, unconstrained,
                                                   stopped_on_a_slope,  above_a_start, at_a_bound,
                                                   another_fits_as_well};

}  // namespace

std::string_view to_string(FitStatus status) {
  switch (status) {
    case FitStatus::ok:
      return "ok";
    case FitStatus::at_bound:
      return "at_bound";
    case FitStatus::not_identifiable:
      return "not_identifiable";
    case FitStatus::multimodal:
      return "multimodal";
    case FitStatus::not_converged:
      break;
  }
  return "not_converged";
}

std::string too_few_points(std::size_t distinct, std::size_t points, std::size_t parameters) {
  return std::to_string(distinct) + " usable point" + (distinct == 1 ? "" : "s") +
         (distinct < points ? ", repeated in " + std::to_string(points) + " rows," : "") + " cannot determine " +
         std::to_string(parameters) + " parameter" + (parameters == 1 ? "" : "s") + " and their errors";
}

double fit_tolerance(const Problem& problem, double least) {
  const auto freedom = static_cast<double>(problem.residual_count() - problem.parameters().size());
  return kChiSquare95 * (problem.known_errors() ? 1 : least / freedom);
}

Verdict solve(const Problem& problem, const StartingPoints& starting, const SolverOptions& options) {
  const std::size_t n = problem.residual_count(), p = problem.parameters().size();
  Verdict verdict{FitStatus::ok, {}, {}, std::vector<bool>(p), std::vector<std::optional<double>>(p), {}, {}};
  const auto end = [&](FitStatus status, const std::string& message) {
    verdict.status = status;
    verdict.message = message;
    if (status == FitStatus::not_converged) verdict.correlations.clear();
    if (status == FitStatus::not_identifiable || status == FitStatus::not_converged)
      verdict.standard_errors.assign(p, std::nullopt);
    return verdict;
  };
  if (n <= p) return end(FitStatus::not_identifiable, too_few_points(n, n, p));

  Starts starts;
  if (starting.near.empty()) starts = find_starts(problem, options);
  std::vector<Start> list;  // what is guessed lies nearest, mostly
  if (!starting.near.empty()) list.push_back({starting.near});
  for (const auto& guess : starting.guesses) list.push_back({guess});
  list.insert(list.end(), starts.list.begin(), starts.list.end());
  if (list.empty())
    return end(FitStatus::not_converged, "the model is not finite at these points for any parameter value");

  Minima minima(problem, options);
  double least = std::numeric_limits<double>::infinity();
  SolverOptions exploring = options;
  if (p > 1) {
    exploring.most_iterations = options.most_iterations_of_a_start;
    exploring.kernel_stationary_of_several = options.stationary;
  }
  Kernel kernel(problem, exploring);
  std::vector<double> residuals(n);
  for (const Start& start : list) {
    if (minima.has_one_of(start)) continue;
    std::optional<Minimum> minimum = kernel.explore(start);
    if (minimum)
      least = std::min(least, kernel.first_cost());
    else if (const auto cost = sum_of_squares(problem, start.x, residuals))  // finite, where the slope is not
      least = std::min(least, *cost);
    // the only start of several parameters is worth both engines: one may end in a valley, or where nothing is felt
    const bool lost = !minimum || (!minimum->stationary && !minima.has_below(minimum->sum_of_squares));
    if (lost || (list.size() == 1 && p > 1 && options.engine == Engine::ceres))
      if (const auto other = descend(problem, start.x, options)) {
        minima.keep(*other);
        if (minimum && other->stationary && !lower(*minimum, *other)) continue;
      }
    if (minimum && (minimum->stationary || lost)) minima.keep(*minimum);
  }
  minima.drop_peaks();
  std::sort(minima.list.begin(), minima.list.end(), lower);
  // the kernel found it; what is shown is the work of the engine that was asked for, to the last digits
  if (!minima.list.empty() && (p > 1 || options.engine != Engine::kernel))
    if (const auto minimum = descend(problem, minima.list.front().x, options);
        minimum && (minimum->stationary || lower(*minimum, minima.list.front())))
      minima.list.front() = *minimum;
  if (!minima.list.empty()) {
    verdict.best = minima.list.front();
    verdict.others.assign(minima.list.begin() + 1, minima.list.end());
    least = std::min(least, verdict.best.sum_of_squares);
    for (std::size_t k = 0; k < p; ++k)
      verdict.at_bound[k] =
          verdict.best.x[k] <= problem.parameters()[k].lower || verdict.best.x[k] >= problem.parameters()[k].upper;
  }
  const bool found = !minima.list.empty();
  const Judgement judgement{problem,
                            options,
                            starts,
                            verdict,
                            found ? covariance(problem, verdict.best, verdict.at_bound, options) : Covariance{},
                            least};
  for (const auto test : kTests)
    if (const Finding finding = test(judgement)) return end(finding->first, finding->second);
  return verdict;
}

}  // namespace mixity
