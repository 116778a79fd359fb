// Evaluates a fit at its minimum: evidence, budget, goodness of fit, tests of the residuals.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "fitting/budget.h"
#include "fitting/consistency.h"
#include "fitting/curve_objective.h"
#include "fitting/fitted_errors.h"
#include "fitting/fitter.h"
#include "fitting/heavy_points.h"
#include "fitting/predicted_area.h"
#include "fitting/pull_off_rows.h"
#include "solver/evidence.h"
#include "statistics/distributions.h"

namespace mixity {
namespace {

/// Points whose residuals have a chance below 1 % of being so large in any of them, so that one good fit in 100 names
/// one. An error estimated from few points by the median is itself uncertain, about like one with half as many degrees
/// of freedom: with the normal distribution every tenth good fit of ten points would name one.
std::vector<Outlier> outliers_of(const FitResult& fit, bool known_errors) {
  constexpr double kChanceOfAny = 0.01, kNever = 2.5;  // 2.5 standard errors: a chance above 1 % even of one point
  std::vector<Outlier> outliers;
  if (fit.freedom() == 0 || !(fit.standard_error > 0)) return outliers;
  const auto points = static_cast<double>(fit.used.size()), freedom = static_cast<double>(fit.freedom());
  for (std::size_t i = 0; i < fit.used.size(); ++i) {
    const double size = fit.innovations[i] / fit.standard_error;
    if (std::abs(size) < kNever) continue;
    const double chance = known_errors ? 2 * normal_below(-std::abs(size)) : student_p_value(size, 0.5 * freedom);
    if (chance * points < kChanceOfAny) outliers.push_back({fit.used[i], size});
  }
  return outliers;
}

}  // namespace

/// Robust losses are not likelihoods and have no evidence.
void Fitter::add_evidence(const Verdict& verdict) {
  result_.evidence.reset();
  const bool wanted = options_.intervals && !robust_;
  const FreeParameter& first = cost_->parameters()[0];
  if (!wanted || first.start || verdict.best.x.empty() || verdict.status == FitStatus::not_converged) return;
  std::optional<double> from;
  if (options_.lambda_prior == RangePrior::log_uniform)
    from = options_.lambda_prior_from.value_or(kLeastOfUpper * first.upper);
  const EvidenceOptions choice{.prior = options_.lambda_prior,
                               .confidence = options_.confidence,
                               .from = from.value_or(0),
                               .unit = problem_->known_errors() ? 0 : unit_};
  if (const auto found = evidence(*cost_, verdict.best, verdict.standard_errors[0], choice)) {
    result_.evidence = {first.name, options_.lambda_prior, from, options_.confidence, *found};
    result_.evidence->evidence.log_evidence -= result_.log_variances / 2;
  }
}

/// The effect of the constants of the experiment on the parameter.
void Fitter::add_budget(const std::vector<double>& x, const Verdict& verdict) {
  const bool scaled = prepared_.objective == Objective::toughness && scale_of(options_) == Scale::linear;
  if (scaled || data_.has_energies || verdict.status == FitStatus::not_converged || verdict.at_bound.size() != x.size())
    return;
  PreparedFit all = prepared_;
  std::vector<double> beside = x;
  std::vector<ConstantStep> exact;
  auto [load, shear] = largest_pull_off(data_);
  double area = 0;
  for (const std::size_t i : prepared_.used) {
    load = std::max(load, std::abs(data_.points[i].P));
    shear = std::max(shear, data_.points[i].shear());
    area = std::max(area, data_.points[i].A);
  }
  // A drift needs three runs, hysteresis needs areas with and without shear.
  bool with = false, without = false;
  if (data_.has_loads) {
    const PointPlaces places(data_);
    for (std::size_t i = 0; i < data_.points.size(); ++i) (places.at(i).unsheared ? without : with) = true;
  }
  const auto acts = [&](Constant c) {
    if (c == kModulusDrift || c == kToughnessDrift) return data_.curves.size() >= 3;
    if (c == kShape && prepared_.model.is_elliptic()) return false;  // the model has the shape
    if (c == kApproachOffset) return data_.holds_approach();
    if (c == kLoadOffset && data_.holds_approach()) return !data_.loads_beside.empty();
    return c != kHysteresis || (with && without);
  };
  for (const Constant c : kAllConstants) {
    const bool fitted = std::any_of(prepared_.fitted.begin(), prepared_.fitted.end(),
                                    [&](const FittedConstant& one) { return one.constant == c; });
    const bool of_areas = c == kAreaScale || c == kAreaOffset;
    if (fitted || (!data_.has_loads && c != kToughness) || !acts(c) || (of_areas && prepared_.used.empty())) continue;
    all.fitted.push_back({c, prepared_.constants[c], 0});
    const double size = c == kLoadOffset || c == kApproachOffset ? load : c == kShearOffset ? shear : area;
    exact.push_back({beside.size(), is_factor(c) ? std::log(1.05) : is_change(c) ? 0.01 : 0.01 * size});
    beside.push_back(prepared_.constants[c]);
  }
  all.start.clear();
  const auto data = make_problem(data_, options_, all, options_.weighted ? problem_->weights() : std::vector<double>{});
  const double freedom = static_cast<double>(data->residual_count()) - static_cast<double>(result_.free_parameters);
  const double unit = cost_->known_errors() ? unit_ : std::sqrt(result_.sum_of_squares / freedom);
  const RobustProblem robust(*data, options_.loss, result_.loss_scale, result_.loss_freedom);
  result_.budget =
      error_budget(robust_ ? static_cast<const Problem&>(robust) : *data, beside, unit, verdict.at_bound, exact);
}

/// Goodness in the fitted space, and for the predicted areas.
void Fitter::add_goodness(const std::vector<double>& x) {
  const bool curve = prepared_.objective == Objective::curve && data_.has_loads;
  result_.innovations.resize(problem_->residual_count());
  const bool some = !result_.innovations.empty();
  const bool finite = some && curve ? static_cast<const CurveObjective&>(*problem_).evaluate_both(
                                          x, result_.innovations, result_.residuals)
                                    : some && problem_->evaluate(x, result_.innovations, {});
  if (!finite) {
    result_.innovations.clear();
    result_.residuals.clear();
    result_.status = FitStatus::not_converged;
    result_.message = "the model is not finite at the used points";
    return;
  }
  if (!curve) result_.residuals = result_.innovations;
  if (result_.axes > 0) {
    const auto& objective = static_cast<const CurveObjective&>(*problem_);
    for (std::size_t i = 0; i < result_.used.size(); ++i) {
      const std::size_t row = objective.row_of_axes(i);
      result_.axes_residuals.push_back(row > 0 ? result_.innovations[row] : std::numeric_limits<double>::quiet_NaN());
    }
  }
  add_pull_off(x);
  result_.innovations.resize(result_.used.size());
  const bool alone = result_.of_pull_off_alone();
  {  // of millions of points each array counts
    std::vector<double> targets = problem_->targets(), weights = problem_->weights();
    for (std::size_t i = 0; alone && i < data_.pull_off.size(); ++i) {
      const MeasuredPullOff one = measured_pull_off(data_.pull_off[i], result_.errors->pull_off, 0);
      weights.push_back(1 / one.sigma_P);
      targets.push_back(one.P / one.sigma_P);
    }
    const Goodness fit = goodness(alone ? result_.pull_off_residuals : result_.residuals, targets, weights);
    result_.r2 = fit.r2;
    result_.rmse = fit.rmse;
    result_.max_abs_residual = fit.max_abs_residual;
  }
  if (purpose_ != Purpose::shown) return;
  result_.standard_error =
      problem_->known_errors() ? 1 : spread(alone ? result_.pull_off_residuals : result_.residuals);
  if (data_.has_loads) result_.area = area_goodness(data_, result_.used, prepared_.model, problem_->candidate(x));
}

/// The residuals of pull-off loads, which are the last, and the model's loads.
void Fitter::add_pull_off(const std::vector<double>& x) {
  if (result_.pull_off == 0) return;
  result_.pull_off_residuals.assign(result_.innovations.end() - static_cast<std::ptrdiff_t>(result_.pull_off),
                                    result_.innovations.end());
  const Candidate at = problem_->candidate(x);
  const ConstantsScale scale(at.constants);
  for (const PullOffReading& one : data_.pull_off) {
    const double shear = std::abs(held_shear(scale, one.held, one.shear));
    PullOff found;
    prepared_.model.pull_off(at.parameters, one.held, {&shear, 1}, {&found, 1}, {});
    result_.pull_off_loads.push_back(scale.measured_load(found.P));
  }
}

/// Tests the assumptions of the fit, unless its residuals are only rounding.
void Fitter::test_residuals(const std::vector<double>& x) {
  const double rounding = 100 * residual_rounding(*problem_);
  const bool judged = result_.status == FitStatus::ok || result_.status == FitStatus::at_bound ||
                      result_.status == FitStatus::multimodal || result_.status == FitStatus::suspect;
  if (!judged || result_.residuals.size() + result_.pull_off == 0 || !(result_.sum_of_squares > rounding * rounding))
    return;
  result_.consistency = test_consistency(data_, result_);
  result_.consistency->heavy = heavy_points(data_, result_, [&] {
    // Of many points those of the last round serve, whose errors moved the fit by next to nothing.
    if (result_.used.size() >= kManyPoints && !result_.errors->load_A.empty())
      return of_points(result_.errors->load_A, result_.used);
    auto nearest = static_cast<const CurveObjective&>(*problem_).nearest(x);
    return nearest ? std::move(nearest->load_A) : std::vector<double>();
  });
  ResidualTests& residuals = result_.consistency->residuals;
  if (off_course_ && off_course_->p_value < residuals.course_p) {
    residuals.course = off_course_->F;
    residuals.course_p = off_course_->p_value;
    residuals.shares_course = true;
  }
  // Where ln f comes from loads and areas, its scatter differs from point to point.
  const bool common_scale = prepared_.objective == Objective::curve || options_.weighted || !data_.has_loads;
  if (common_scale) result_.outliers = outliers_of(result_, problem_->known_errors());
  if (result_.status == FitStatus::ok && !failed_test(data_, result_).empty()) result_.status = FitStatus::suspect;
}

/// A value whose error exceeds its whole range is not a result.
void Fitter::suspect_wide_errors() {
  for (const FittedParameter& one : result_.parameters) {
    if (result_.status != FitStatus::ok || !one.stderr_ || !(*one.stderr_ > one.upper - one.lower)) continue;
    result_.status = FitStatus::suspect;
    result_.message = "the data do not determine " + one.name +
                      ": its standard error exceeds its whole range; check the sizes and units of " +
                      data_.names_of_errors();
  }
}

}  // namespace mixity
