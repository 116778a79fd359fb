#include "solver/verdict.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/number_text.h"
#include "base/phrases.h"
#include "solver/covariance.h"

namespace mixity {
namespace {

constexpr double kChiSquare95 = 3.841458820694124;  // of one degree of freedom

std::string value_text(const FreeParameter& parameter, double x) {
  return rounded(parameter.shown(x), 4) + (parameter.unit.empty() ? "" : " " + parameter.unit);
}

std::string values_text(const Problem& problem, const std::vector<double>& x) {
  std::string text;
  for (std::size_t k = 0; k < x.size(); ++k)
    text += (k ? ", " : "") + problem.parameters()[k].name + " = " + value_text(problem.parameters()[k], x[k]);
  return text;
}

/// The input of the tests of a verdict. Each test returns why the fit is not ok, or nothing.
struct Judgement {
  const Problem& problem;
  const SolverOptions& options;
  const FoundMinima& found;
  Verdict& verdict;
  const Covariance& covariance;

  std::optional<double> cost_at(const std::vector<double>& x) const {
    std::vector<double> residuals(problem.residual_count());
    return sum_of_squares(problem, x, residuals);
  }
  bool fits_as_well(double cost) const {
    return cost <= found.least + fit_tolerance(problem, found.least) || std::sqrt(cost) <= residual_rounding(problem);
  }
};

using Finding = std::optional<std::pair<FitStatus, std::string>>;

/// Every value tried fits as well as the best, within the scatter or rounding. The first one that does not ends the
/// test; there usually is one four standard errors from the best.
Finding every_value_fits(const Judgement& judgement) {
  if (judgement.found.dearest.empty()) return {};
  const Minimum& best = judgement.verdict.best;
  for (std::size_t k = 0; k < best.x.size(); ++k) {
    const FreeParameter& parameter = judgement.problem.parameters()[k];
    const std::optional<double>& error = judgement.covariance.standard_errors[k];
    if (parameter.start || !error) continue;
    for (const double errors : {-4.0, 4.0}) {
      std::vector<double> x = best.x;
      x[k] += errors * *error;
      if (x[k] != parameter.clamped(x[k])) continue;
      if (const auto cost = judgement.cost_at(x); cost && !judgement.fits_as_well(*cost)) return {};
    }
  }
  for (const auto& x : judgement.found.dearest)
    if (const auto cost = judgement.cost_at(x); cost && !judgement.fits_as_well(*cost)) return {};
  const std::string names = joined(texts_of(judgement.problem.parameters(), &FreeParameter::name));
  return {{FitStatus::not_identifiable,
           "the data do not constrain " + names + ": no value in the range fits better than another"}};
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

/// The model may not be defined a little further down the slope; for the only parameter this is like a bound.
Finding stopped_on_a_slope(const Judgement& judgement) {
  const Minimum& best = judgement.verdict.best;
  if (best.stationary) return {};
  for (std::size_t k = 0; k < best.x.size(); ++k)
    for (const double direction : {-1.0, 1.0}) {
      const FreeParameter& parameter = judgement.problem.parameters()[k];
      std::vector<double> beyond = best.x;
      beyond[k] += direction * 1e-6 * std::max(std::abs(best.x[k]), parameter.least_size());
      if (beyond[k] != parameter.clamped(beyond[k]) || judgement.cost_at(beyond)) continue;
      judgement.verdict.standard_errors.assign(best.x.size(), std::nullopt);
      const std::string where = "beyond " + values_text(judgement.problem, best.x) + " the model is not defined here";
      return {{best.x.size() == 1 ? FitStatus::at_bound : FitStatus::not_converged, where}};
    }
  return {{FitStatus::not_converged,
           "the solver stopped where the gradient is not zero (relative size " + rounded(best.stationarity, 2) + ")"}};
}

Finding above_a_start(const Judgement& judgement) {
  const double best = judgement.verdict.best.sum_of_squares, least = judgement.found.least;
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

/// In this order; the first finding decides.
constexpr Finding (*kTests[])(const Judgement&) = {every_value_fits,    nothing_found, unconstrained,
                                                   stopped_on_a_slope,  above_a_start, at_a_bound,
                                                   another_fits_as_well};

}  // namespace

std::string too_few_points(std::size_t distinct, std::size_t points, std::size_t parameters) {
  return std::to_string(distinct) + " usable point" + (distinct == 1 ? "" : "s") +
         (distinct < points ? ", repeated in " + std::to_string(points) + " rows," : "") + " cannot determine " +
         std::to_string(parameters) + " parameter" + (parameters == 1 ? "" : "s") + " and their errors";
}

double fit_tolerance(const Problem& problem, double least) { return kChiSquare95 * residual_variance(problem, least); }

Verdict judge(const Problem& problem, const FoundMinima& found, const SolverOptions& options) {
  const std::size_t p = problem.parameters().size();
  Verdict verdict(p);
  if (!found.started) {
    verdict.message = "the model is not finite at these points for any parameter value";
    return verdict;
  }
  Covariance errors;
  if (!found.list.empty()) {
    verdict.best = found.list.front();
    verdict.others.assign(found.list.begin() + 1, found.list.end());
    for (std::size_t k = 0; k < p; ++k) verdict.at_bound[k] = problem.parameters()[k].at_bound(verdict.best.x[k]);
    errors = covariance(problem, verdict.best, verdict.at_bound, options);
  }
  verdict.status = FitStatus::ok;
  const Judgement judgement{problem, options, found, verdict, errors};
  for (const auto test : kTests) {
    const Finding finding = test(judgement);
    if (!finding) continue;
    std::tie(verdict.status, verdict.message) = *finding;
    if (verdict.status == FitStatus::not_converged) verdict.correlations.clear();
    if (verdict.status == FitStatus::not_identifiable || verdict.status == FitStatus::not_converged)
      verdict.standard_errors.assign(p, std::nullopt);
    break;
  }
  return verdict;
}

}  // namespace mixity
