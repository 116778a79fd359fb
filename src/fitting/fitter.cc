#include "fitting/fitter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>
#include <utility>

#include "fitting/causes.h"
#include "fitting/consistency.h"
#include "fitting/explanations.h"
#include "fitting/fitted_errors.h"
#include "fitting/fitted_parameters.h"
#include "fitting/pull_off_rows.h"
#include "solver/descent.h"
#include "solver/linear_algebra.h"
#include "solver/refit.h"
#include "solver/verdict.h"

namespace mixity {
namespace {

constexpr int kMostRestarts = 3;
/// The gradient at which refits stop: their values are off by as much of a standard error, times the root of the number
/// of points.
constexpr double kNearEnough = 1e-8;

/// The number of distinct points, counted up to `enough`: repeated rows carry no information about errors.
std::size_t distinct_points(const Dataset& data, const PointIndices& used, std::size_t enough) {
  std::set<std::tuple<double, double, double>> distinct;
  for (const PullOffReading& one : data.pull_off) distinct.insert({one.P, std::abs(one.shear), -1.0});
  for (const std::size_t i : used) {
    if (distinct.size() == enough) break;
    if (data.has_loads)
      distinct.insert({data.points[i].P, data.points[i].shear(), data.points[i].A});
    else
      distinct.insert({data.converted[i].mixity.sin, data.converted[i].mixity.cos, data.converted[i].ratio});
  }
  return distinct.size();
}

}  // namespace

SolverOptions options_of_refits() {
  SolverOptions quick;
  quick.engine = Engine::kernel;
  quick.last_digits = false;
  quick.most_iterations_shown = quick.most_iterations;
  return quick;
}

Fitter::Fitter(const Dataset& data, const ContactModel& model, const FitOptions& options, Purpose purpose,
               const std::vector<std::size_t>* points, const std::vector<FittedParameter>* near)
    : data_(data),
      options_(options),
      purpose_(purpose),
      prepared_(prepare(data, model, options, options.objective.value_or(default_objective(data)), points)),
      points_(points) {
  if (!options_.free.empty() && !near && data.has_loads) prepared_.start = jkr_start(data_, options_, prepared_);
  problem_ = make_problem(data_, options_, prepared_);
  describe();
  if (near) starting_.near = solver_values(*problem_, *near);
  if (purpose_ != Purpose::shown) {
    solver_ = options_of_refits();
    solver_.kernel_stationary = solver_.kernel_stationary_of_several = kNearEnough;
  }
}

FitResult Fitter::run() {
  const bool some = !problem_->parameters().empty();
  if (some && has_too_few_points()) return finished();
  if (options_.most_misfit && is_beyond(*options_.most_misfit)) {
    result_.status = FitStatus::not_converged;
    result_.message = "given up: another model describes the points better";
    return finished();
  }
  const bool as_the_paper = purpose_ == Purpose::shown || (some && starting_.near.empty());
  if (prepared_.objective == Objective::curve && data_.has_loads && as_the_paper && !prepared_.used.empty())
    prepared_.model.is_elliptic() ? start_at_circles() : fit_as_the_paper();
  // rough fractions of the time: until the minimum, and until the resampling
  const double found = options_.profile_points > 0 ? 0.1 : 0.4,
               fitted = options_.bootstrap.replicates > 0 || options_.influence ? 0.1 : 1;
  report_progress(0.25 * found * fitted);
  std::vector<double> x;
  if (!some) {
    result_.status = FitStatus::ok;
    result_.message = "every parameter is held: nothing was fitted";
    finished();
  } else {
    const Verdict verdict = find_parameters(stretch(options_.progress, found * fitted, fitted));
    finished();
    if (!result_.has_values() || verdict.best.x.empty()) return std::move(result_);
    x = verdict.best.x;
    report_progress(fitted);
    add_resampled(*cost_, verdict, data_, options_, stretch(options_.progress, fitted, 1), result_);
  }
  // A refit for its values needs nothing else.
  if (purpose_ == Purpose::values && prepared_.objective == Objective::curve) return std::move(result_);
  add_goodness(x);
  if (!some) {
    result_.known_errors = problem_->known_errors();
    for (const double r : result_.innovations) result_.sum_of_squares += r * r;
    for (const double r : result_.axes_residuals)
      if (std::isfinite(r)) result_.sum_of_squares += r * r;
    for (const double r : result_.pull_off_residuals) result_.sum_of_squares += r * r;
  }
  suspect_wide_errors();
  if (checked()) test_residuals(x);
  // An explanation whose residuals fail is dropped: whether its runs differ is of no interest.
  if (some && purpose_ == Purpose::tried && !result_.residuals.empty()) {
    result_.consistency = test_consistency(data_, result_);
    if (explains(data_, result_)) {
      prepared_.used = result_.used;  // finished() has moved them
      test_runs(x);
    }
  }
  return std::move(result_);
}

/// The result with the data prepared for it, which are moved.
FitResult&& Fitter::finished() {
  result_.used = std::move(prepared_.used);
  return std::move(result_);
}

/// The minimum, its parameters with errors and intervals, and all that follows from the fit there.
Verdict Fitter::find_parameters(const Progress& progress) {
  const FitResult described = result_;
  // The search for an interval may find a lower cost, from which it starts again.
  for (int again = 0;; ++again) {
    result_ = described;
    Verdict verdict = find_minimum();
    result_.status = verdict.status;
    result_.message = verdict.message;
    if (!result_.has_values() || verdict.best.x.empty()) return verdict;
    const std::vector<double>& x = verdict.best.x;
    result_.known_errors = problem_->known_errors();
    const std::vector<double> deeper = add_parameters(*cost_, verdict, options_, progress, result_);
    if (deeper.empty()) widen_by_sizes_of_errors(x);
    result_.free_parameters = unknown();  // the other parameters each have a residual: their prior
    result_.sum_of_squares *= unit_ * unit_;
    const double rest = static_cast<double>(problem_->residual_count()) - static_cast<double>(unknown());
    if (options_.free_sigma_factor && options_.loss == Loss::none && rest > 0)
      result_.sigma_factor = (result_.errors ? result_.errors->factor : 1) * std::sqrt(result_.sum_of_squares / rest);
    if (result_.errors) result_.log_variances = log_variances(data_, prepared_.used, *result_.errors);
    if (const std::size_t n = without_pull_off_error(data_); result_.pull_off > 0 && n > 0)
      result_.log_variances +=
          2 * static_cast<double>(n) * std::log(result_.errors->pull_off / assumed_pull_off_error(data_));
    if (result_.axes > 0) result_.log_variances += log_variances_of_axes(data_, prepared_.used, *result_.errors);
    if (deeper.empty() && purpose_ == Purpose::shown) add_budget(x, verdict);
    if (deeper.empty() && checked()) test_runs(x);
    if (deeper.empty() && checked()) expect_shape(x);
    if (deeper.empty() && checked()) add_evidence(verdict);
    if (deeper.empty() || again == kMostRestarts) return verdict;
    starting_.guesses.push_back(deeper);
  }
}

/// The number of parameters without a prior.
std::size_t Fitter::unknown() const { return problem_->parameters().size() - prior_count(*problem_); }

/// If so, sets status and message.
bool Fitter::has_too_few_points() {
  constexpr std::size_t kOfStudent = 20;  // with 16 points the 95 % intervals of Student's likelihood cover 92 %
  const std::size_t p = unknown(), few = options_.loss == Loss::t ? std::max(kOfStudent, 2 * p + 1) : p + 1;
  const std::size_t distinct = distinct_points(data_, prepared_.used, few);
  if (distinct >= few) return false;
  result_.status = FitStatus::not_identifiable;
  if (distinct <= p)
    result_.message = too_few_points(distinct, prepared_.used.size() + result_.pull_off, p);
  else
    result_.message = "the loss t needs " + std::to_string(few) + " different points, here are " +
                      std::to_string(distinct) + ": " + Remedy::set("loss", "huber");
  return true;
}

void Fitter::report_progress(double fraction) const {
  if (options_.progress) options_.progress(fraction);
}

/// Sets what is known before the fit.
void Fitter::describe() {
  const ModelInfo& model = prepared_.model.info();
  result_.model = model.key;
  result_.model_name = model.name;
  result_.formula = model.formula;
  result_.objective = prepared_.objective;
  result_.scale = scale_of(options_);
  result_.excluded = prepared_.excluded;
  result_.excluded_reason = prepared_.excluded_reason;
  result_.errors = prepared_.errors;
  result_.pull_off = prepared_.objective == Objective::curve ? data_.pull_off.size() : 0;
  result_.axes = problem_->residual_count() - prepared_.used.size() - result_.pull_off;
  for (const ParameterInfo& info : prepared_.model.parameters()) {
    const std::size_t k = result_.parameters.size();
    FittedParameter& shown = result_.parameters.emplace_back(
        FittedParameter{std::string(info.name), {}, {}, info.lower, info.upper, false, prepared_.held[k]});
    if (shown.held) shown.value = prepared_.base[k];
  }
  for (const FreeParameter& constant : problem_->parameters()) {
    if (!constant.start) continue;
    const auto of_model = std::find_if(result_.parameters.begin(), result_.parameters.end(),
                                       [&](const FittedParameter& one) { return one.name == constant.name; });
    FittedParameter& shown =
        of_model != result_.parameters.end()
            ? *of_model
            : result_.parameters.emplace_back(FittedParameter{
                  constant.name, {}, {}, constant.shown(constant.lower), constant.shown(constant.upper)});
    shown.unit = constant.unit;
    if (constant.prior > 0)
      shown.prior = {constant.shown(*constant.start), constant.prior * constant.shown_slope(*constant.start),
                     constant.logarithmic};
  }
}

/// The paper's fit is reported with the result, and is a start for it.
void Fitter::fit_as_the_paper() {
  FitOptions options = value_only({});
  options.objective = Objective::toughness;
  options.hold = options_.hold;
  options.constants = prepared_.constants;
  const FitResult fit = Fitter(data_, prepared_.model, options, Purpose::values, points_, nullptr).run();
  result_.paper = {fit.status, fit.parameters, fit.r2, fit.used.size()};
  if (const std::vector<double> x = solver_values(*problem_, fit.parameters); !x.empty())
    starting_.guesses.push_back(x);
}

/// Starts at couplings above and below that of a circle. Areas alone hardly tell which mode has the larger one.
void Fitter::start_at_circles() {
  constexpr double kRatio = 1.4;
  const ContactModel circle = prepared_.model.circle();
  const std::size_t n = prepared_.model.parameters().size(), half = circle.parameters().size();
  if (n != 2 * half + 1) return;  // both modes share their parameters
  FitOptions options = value_only({});
  options.constants = prepared_.constants;
  options.fitted_errors = false;
  options.sigma_T = options_.sigma_T;
  options.sigma_A = options_.sigma_A;
  const FitResult fit = Fitter(data_, circle, options, Purpose::values, points_, nullptr).run();
  if (!has_minimum(fit)) return;
  const double per_coupling = 1 / (1 - prepared_.base[n - 1]);
  for (const double ratio : {kRatio, 1 / kRatio}) {
    std::vector<FittedParameter> guess;
    for (std::size_t k = 0; k < n; ++k) {
      FittedParameter& one = guess.emplace_back(result_.parameters[k]);
      if (k + 1 == n) {
        one.value = prepared_.base[k];
        continue;
      }
      const double of_circle = *fit.parameters[k % half].value;
      const bool first = k % half == 0;
      one.value = std::clamp(of_circle * (!first   ? 1
                                          : k == 0 ? ratio
                                                   : 1 / (ratio * per_coupling)),
                             one.lower, one.upper);
    }
    if (const std::vector<double> x = solver_values(*problem_, guess); !x.empty()) starting_.guesses.push_back(x);
  }
}

Verdict Fitter::find_minimum() {
  cost_.reset();  // cost_ and robust_ refer to the previous problem
  robust_.reset();
  off_course_.reset();  // from a search that starts again
  off_with_correlations_ = independent_ = false;
  const bool fitted_errors =
      prepared_.objective == Objective::curve && data_.has_loads && options_.fitted_errors && !prepared_.used.empty();
  const bool weighted = prepared_.objective == Objective::toughness && options_.weighted;
  if (weighted && !data_.has_loads)  // weights that are the same whatever the parameters
    problem_ = make_problem(data_, options_, prepared_, toughness_weights(data_, options_, prepared_, prepared_.base));
  Verdict verdict = fitted_errors && !options_.errors ? minimum_with_its_errors() : minimum_of(*problem_);
  if (weighted && data_.has_loads && !settle_weights(verdict)) return verdict;
  if (options_.loss == Loss::none) return verdict;
  return options_.loss == Loss::t ? find_minimum_of_student(std::move(verdict))
                                  : find_robust_minimum(std::move(verdict));
}

/// Where there are loads, the standard errors depend on the model: refits near the last minimum until they no longer
/// change, then one over the whole range. False if they do not settle.
bool Fitter::settle_weights(Verdict& verdict) {
  constexpr int kMost = 50;
  constexpr double kSettled = 1e-12, kEnough = 1e-8;  // relative change of a parameter
  std::vector<double> x = verdict.best.x;
  double change = 0;
  bool near = !x.empty(), judged = false;  // judged: verdict is that of the settled weights
  const auto take = [&](const std::vector<double>& next) {
    const double last = std::exchange(change, 0.0);
    for (std::size_t k = 0; k < x.size(); ++k)
      change = std::max(change, std::abs(next[k] - x[k]) / std::max(std::abs(x[k]), 1e-300));
    x = next;
    return change <= kSettled || (change <= kEnough && change >= last && last > 0);  // rounding is left
  };
  for (int round = 0; round < kMost; ++round) {
    const ParameterValues at = x.empty() ? prepared_.base : problem_->candidate(x).parameters;
    problem_ = make_problem(data_, options_, prepared_, toughness_weights(data_, options_, prepared_, at));
    if (near) {
      const auto minimum = descend(ProblemWithPriors(*problem_), x, solver_);
      near = minimum && !take(minimum->x);
      continue;
    }
    verdict = minimum_of(*problem_);
    if (verdict.best.x.empty()) break;
    if (x.empty()) {
      x = verdict.best.x;
      near = true;
      continue;
    }
    take(verdict.best.x);
    judged = change <= kEnough;
    if (judged) break;
    near = true;  // another minimum is lower
  }
  if (!judged && !verdict.best.x.empty()) {
    verdict = minimum_of(*problem_);
    if (!verdict.best.x.empty()) take(verdict.best.x);
  }
  if (!(change > kEnough && (verdict.status == FitStatus::ok || verdict.status == FitStatus::multimodal))) return true;
  verdict.status = FitStatus::not_converged;
  verdict.message = "the weights, which depend on the parameters, did not settle";
  return false;
}

/// Includes the priors of the constants.
Verdict Fitter::minimum_of(const Problem& data) {
  if (purpose_ == Purpose::values && !starting_.near.empty()) {
    if (auto found = refit_near(data, starting_.near, solver_)) {
      unit_ = found->unit;
      cost_.emplace(data, unit_);
      Verdict verdict(starting_.near.size());
      verdict.status = FitStatus::ok;
      verdict.best = std::move(found->minimum);
      return verdict;
    }
  }
  SolvedWithPriors solved = solve_with_priors(data, starting_, solver_);
  unit_ = solved.unit;
  cost_.emplace(data, unit_);
  return std::move(solved.verdict);
}

}  // namespace mixity
