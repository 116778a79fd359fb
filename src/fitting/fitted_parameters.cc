#include "fitting/fitted_parameters.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "base/input_error.h"
#include "base/number_text.h"
#include "solver/interval.h"
#include "solver/resample.h"

namespace mixity {
namespace {

ShownInterval shown(const Interval& interval, const FreeParameter& parameter) {
  ShownInterval result{"profile", interval.confidence, {}, {}, interval.low_status, interval.high_status};
  if (interval.low_status != EndStatus::open) result.low = parameter.shown(interval.low);
  if (interval.high_status != EndStatus::open) result.high = parameter.shown(interval.high);
  return result;
}

/// A profile over twice the interval on each side, or over the whole bounded range if another minimum fits as well.
DrawnProfile profile_of(const Problem& cost, const Verdict& verdict, std::size_t j, const Interval& interval,
                        double allowance, std::size_t points) {
  const FreeParameter& parameter = cost.parameters()[j];
  const double x = verdict.best.x[j];
  const bool whole = verdict.status == FitStatus::multimodal && !parameter.start;
  const auto end = [&](double found, EndStatus status, double bound) {
    if (whole || status != EndStatus::found) return bound;
    return parameter.clamped(x + 2 * (found - x));
  };
  DrawnProfile drawn = draw_profile(cost, verdict.best, j, end(interval.low, interval.low_status, parameter.lower),
                                    end(interval.high, interval.high_status, parameter.upper), points, allowance,
                                    residual_variance(cost, verdict.best.sum_of_squares));
  for (auto& point : drawn.points) point.first = parameter.shown(point.first);
  return drawn;
}

/// The parameters of a fit that are not held, in the order of the solver's.
std::vector<FittedParameter*> free_parameters(FitResult& fit) {
  std::vector<FittedParameter*> free;
  for (FittedParameter& parameter : fit.parameters)
    if (!parameter.held) free.push_back(&parameter);
  return free;
}

}  // namespace

std::vector<double> add_parameters(const Problem& cost, const Verdict& verdict, const FitOptions& options,
                                   const Progress& progress, FitResult& fit) {
  std::vector<double> deeper;
  fit.free_parameters = cost.parameters().size();
  fit.sum_of_squares = verdict.best.sum_of_squares;
  fit.correlations = verdict.correlations;
  const bool known = cost.known_errors();
  const std::size_t n = cost.residual_count(), p = cost.parameters().size();
  double freedom = std::numeric_limits<double>::infinity();
  if (fit.errors && fit.errors->runs.any()) freedom = fit.errors->runs.freedom;
  // Student's likelihood has known errors, except for its scale and degrees of freedom.
  if (fit.loss_freedom > 0 && !fit.known_errors && n > p + 1)
    freedom = std::min(freedom, static_cast<double>(n - p - 1));
  const double allowance =
      n > p ? cost_allowance(options.confidence, verdict.best.sum_of_squares, n, p, known, freedom) : 0;
  const bool judged = verdict.status != FitStatus::not_converged && n > p && allowance > 0;
  const std::vector<FittedParameter*> fitted = free_parameters(fit);
  std::vector<Interval> intervals;
  if (options.intervals && judged)
    intervals = profile_intervals(cost, verdict.best, options.confidence, allowance, verdict.standard_errors,
                                  stretch(progress, 0, options.profile_points > 0 ? 0.2 : 1));
  for (std::size_t j = 0; j < fitted.size(); ++j) {
    const FreeParameter& parameter = cost.parameters()[j];
    const double x = verdict.best.x[j];
    const std::optional<double> error = verdict.standard_errors[j];
    fitted[j]->value = parameter.shown(x);
    fitted[j]->at_bound = verdict.at_bound[j];
    fitted[j]->stderr_.reset();
    fitted[j]->interval.reset();
    if (error) fitted[j]->stderr_ = *error * parameter.shown_slope(x);
    if (intervals.empty()) continue;
    const Interval& interval = intervals[j];
    fitted[j]->interval = shown(interval, parameter);
    if (!interval.deeper.empty()) {
      deeper = interval.deeper;
      fit.status = FitStatus::not_converged;
      fit.message = "the cost is lower at " + parameter.name + " = " + rounded(parameter.shown(deeper[j]), 4) +
                    " than at the minimum found";
    }
    if (options.profile_points == 0) continue;
    if (progress) progress(0.2 + 0.8 * static_cast<double>(j) / static_cast<double>(fitted.size()));
    fitted[j]->profile = profile_of(cost, verdict, j, interval, allowance, options.profile_points);
  }
  return deeper;
}

void add_resampled(const Problem& cost, const Verdict& verdict, const Dataset& data, const FitOptions& options,
                   const Progress& progress, FitResult& fit) {
  if (verdict.status == FitStatus::not_converged || !(options.bootstrap.replicates > 0 || options.influence)) return;
  std::vector<std::size_t> runs;
  for (const std::size_t i : fit.used) runs.push_back(data.points[i].curve);
  if (options.bootstrap.replicates > 0) {
    if (options.bootstrap.resample == Resample::curves && std::set(runs.begin(), runs.end()).size() < 2)
      throw InputError(data.path, "a bootstrap of curves draws whole runs, of which this file has one");
    fit.bootstrap = bootstrap(cost, verdict.best.x, runs, options.bootstrap, options.confidence,
                              stretch(progress, 0, options.influence ? 0.5 : 1));
    const std::vector<FittedParameter*> fitted = free_parameters(fit);
    for (std::size_t j = 0; j < fit.bootstrap->parameters.size(); ++j)
      fitted[j]->bootstrap = fit.bootstrap->parameters[j];
  }
  if (!options.influence) return;
  fit.influence = influence(cost, verdict.best.x, runs, options.bootstrap.threads,
                            stretch(progress, options.bootstrap.replicates > 0 ? 0.5 : 0, 1));
  for (std::size_t run = 0; run < data.curves.size(); ++run)
    if (std::find(runs.begin(), runs.end(), run) != runs.end()) fit.run_names.push_back(data.curves[run]);
}

}  // namespace mixity
