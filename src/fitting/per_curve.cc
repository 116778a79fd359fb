// One set of parameters for all runs against one set for each.
#include <algorithm>

#include "dataset/pull_off.h"
#include "fitting/comparison.h"
#include "fitting/fitted_parameters.h"
#include "fitting/predicted_area.h"
#include "fitting/prepare.h"
#include "solver/joint.h"
#include "solver/prior.h"
#include "solver/robust.h"
#include "solver/solve.h"
#include "statistics/distributions.h"

namespace mixity {
namespace {

constexpr const char* kNoConstants = "the constants that all runs share were not found";

/// Whether runs share fitted constants. For energies each series has its own toughness.
bool share_constants(const Dataset& data, const FitOptions& options) {
  return !data.has_energies && !fitted_constants(data, options).empty();
}

/// The runs that have their own minimum, fitted separately.
struct SeparateFits {
  std::vector<std::vector<std::size_t>> runs{};  // points of each
  std::vector<FitResult> fits{};
  double sum_of_squares = 0;
  std::size_t parameters = 0, points = 0;
  bool known_errors = false;

  void add(const std::vector<std::size_t>& run, const FitResult& fit) {
    runs.push_back(run);
    fits.push_back(fit);
    sum_of_squares += fit.sum_of_squares;
    parameters += fit.free_parameters;
    points += fit.used.size();
    known_errors = fit.known_errors;
  }
  std::vector<std::size_t> all_points() const {
    std::vector<std::size_t> all;
    for (const auto& run : runs) all.insert(all.end(), run.begin(), run.end());
    return all;
  }
};

/// Common constants of the experiment for runs with their own parameters.
struct CommonConstants {
  Constants constants{};  // all of them; those that were fitted with fitted values
  /// Per run: the model's free parameters. Their errors and intervals include those of the constants.
  std::vector<std::vector<FittedParameter>> own{};
  double sum_of_squares = 0;        // of the data and the priors
  std::size_t free_parameters = 0;  // of all runs together, without those with a prior
};

/// Starts from separate fits at constants near the common ones. Finds intervals for up to 40 runs. Null if no minimum
/// is found or the fit does not determine its parameters.
std::optional<CommonConstants> fit_common_constants(const Dataset& data, const FitOptions& options,
                                                    const Constants& near, const SeparateFits& separate) {
  constexpr std::size_t kMostIntervals = 40;  // the time of the joint problem grows with the cube of the number of runs
  const ContactModel model = model_of(data, separate.fits[0]);
  const Objective objective = options.objective.value_or(default_objective(data));
  const std::vector<FittedConstant> constants = fitted_constants(data, options);
  const std::size_t runs = separate.runs.size();
  std::vector<std::unique_ptr<ModelProblem>> problems;
  std::vector<const Problem*> parts;
  std::vector<double> start;
  for (std::size_t i = 0; i < runs; ++i) {
    const FitResult& fit = separate.fits[i];
    const PreparedFit prepared = prepare(data, model, options, objective, &separate.runs[i]);
    std::vector<double> weights;
    if (objective == Objective::toughness && options.weighted)
      weights = toughness_weights(data, options, prepared, fitted_candidate(data, model, fit, options).parameters);
    problems.push_back(make_problem(data, options, prepared, std::move(weights)));
    parts.push_back(problems.back().get());
    for (const FittedParameter& one : fit.parameters)
      if (!one.held && has_parameter({fit.model}, one.name)) start.push_back(*one.value);
  }
  const std::size_t own = start.size() / runs;
  for (const FittedConstant& one : constants) start.push_back(near[one.constant]);
  const JointProblem joint(parts, own);
  std::optional<RobustProblem> robust;
  if (options.loss != Loss::none)
    robust.emplace(joint, options.loss, options.loss_scale.value_or(usual_scale(options.loss)));
  const Problem& of_data = robust ? static_cast<const Problem&>(*robust) : joint;
  const auto [verdict, unit] = solve_with_priors(of_data, {start});
  if (verdict.status == FitStatus::not_converged || verdict.status == FitStatus::not_identifiable) return std::nullopt;
  const ProblemWithPriors cost(of_data, unit);
  FitResult found;
  for (const FreeParameter& one : cost.parameters())
    found.parameters.push_back({one.name, {}, {}, one.lower, one.upper});
  FitOptions asked = options;
  asked.intervals &= runs <= kMostIntervals;
  asked.profile_points = 0;
  if (!add_parameters(cost, verdict, asked, {}, found).empty()) return std::nullopt;
  CommonConstants result{constants_of(data, options)};
  for (std::size_t k = 0; k < constants.size(); ++k)
    result.constants[constants[k].constant] = verdict.best.x[runs * own + k];
  for (std::size_t i = 0; i < runs; ++i) {
    const auto first = found.parameters.begin() + static_cast<std::ptrdiff_t>(i * own);
    result.own.emplace_back(first, first + static_cast<std::ptrdiff_t>(own));
  }
  result.sum_of_squares = verdict.best.sum_of_squares * unit * unit;
  result.free_parameters = cost.parameters().size() - prior_count(cost);
  return result;
}

/// Copies errors and intervals of a run's parameters from the joint fit.
void take_errors(const std::vector<FittedParameter>& joint, FitResult& fit) {
  for (FittedParameter& one : fit.parameters)
    if (const FittedParameter* const same = find_parameter(joint, one.name)) {
      one.stderr_ = same->stderr_;
      one.interval = same->interval;
    }
}

/// Tests one set of parameters for all runs against one set for each.
void test_runs(const FitResult& pooled, const SeparateFits& separate, PerCurve& result) {
  if (!has_minimum(pooled)) {
    result.untested = "no one value for all runs was found";
  } else if (separate.parameters == pooled.free_parameters) {
    result.untested = "every parameter is held";
  } else if (!(separate.sum_of_squares > 0)) {
    result.untested = "the runs have no scatter";
  } else {
    const bool known = pooled.known_errors;
    const double freedom = static_cast<double>(separate.parameters - pooled.free_parameters),
                 rest = static_cast<double>(separate.points - separate.parameters),
                 gain = std::max(pooled.sum_of_squares - separate.sum_of_squares, 0.0),
                 statistic = known ? gain : gain / freedom / (separate.sum_of_squares / rest),
                 p_value = known ? chi_squared_p_value(gain, freedom) : fisher_p_value(statistic, freedom, rest);
    const auto aicc = [&](double sum_of_squares, std::size_t parameters) {
      return information(sum_of_squares, separate.points, parameters, known).aicc;
    };
    result.test = {known,
                   statistic,
                   freedom,
                   rest,
                   p_value,
                   aicc(pooled.sum_of_squares, pooled.free_parameters),
                   aicc(separate.sum_of_squares, separate.parameters)};
  }
}

}  // namespace

PerCurve fit_per_curve(const Dataset& data, std::string_view model, const FitOptions& asked) {
  if (!data.pull_off.empty()) return fit_per_curve(without_pull_off(data), model, asked);  // they belong to no run
  PerCurve result;
  FitOptions options = asked;
  options.fitted_errors = false;  // with one value for differing runs, the differences would be taken for noise
  result.model = model;
  const auto untested = [&](const char* why) {
    result.untested = why;
    return result;
  };
  FitOptions own = value_only(options);
  own.intervals = options.intervals;
  own.checks = options.checks;
  const bool shared = share_constants(data, options);
  if (shared) {
    const FitResult whole = fit_model(data, model, value_only(options));
    if (!has_minimum(whole)) return untested(kNoConstants);
    own.intervals = own.checks = false;  // these need all runs together
    own.free.clear();
    own.constants = constants_of(data, options, whole.parameters);
  }
  SeparateFits separate;
  const auto runs = runs_with_points(data);
  for (const auto& run : runs) {
    const std::size_t c = data.points[run.front()].curve;
    if (options.progress) options.progress(static_cast<double>(c) / static_cast<double>(data.curves.size()));
    result.curves.push_back(
        {data.curves[c], data.has_loads ? data.curve_loads[c] : 0.0, fit_model(data, model, own, &run)});
    if (has_minimum(result.curves.back().fit)) separate.add(run, result.curves.back().fit);
  }
  result.fitted = separate.runs.size();
  if (result.fitted < 2) return untested("fewer than two runs have a value of their own");
  if (separate.points <= separate.parameters) return untested("too few points");
  if (options.loss != Loss::none && !separate.known_errors)
    return untested("a robust loss in units of the scatter is another cost for each run");
  FitOptions of_all = own;
  if (shared) {
    const auto joint = fit_common_constants(data, options, *own.constants, separate);
    if (!joint) return untested(kNoConstants);
    own.constants = joint->constants;
    for (std::size_t c = 0, next = 0; c < runs.size(); ++c) {
      FitResult& fit = result.curves[c].fit;
      const bool is_tested = has_minimum(fit);
      fit = fit_model(data, model, own, &runs[c]);
      if (is_tested) take_errors(joint->own[next++], fit);
    }
    separate.sum_of_squares = joint->sum_of_squares;
    separate.parameters = joint->free_parameters;
    of_all = options;
  }
  const std::vector<std::size_t> tested = separate.all_points();
  test_runs(fit_model(data, model, value_only(of_all), &tested), separate, result);
  return result;
}

}  // namespace mixity
