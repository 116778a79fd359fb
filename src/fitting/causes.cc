#include "fitting/causes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "fitting/cause_fits.h"
#include "fitting/constants.h"
#include "fitting/expected_fall.h"
#include "fitting/options.h"
#include "statistics/distributions.h"

namespace mixity {
namespace {

constexpr std::size_t kMostConstants = 5;
constexpr double kNear = 20;  // the misfit beyond that of another model up to which a cause is of interest

bool lie_together(const FitResult& fit) { return fit.consistency && fit.consistency->residuals.together; }

bool has_course(const FitResult& fit) { return fit.consistency && fit.consistency->residuals.course_p < kChance; }

/// Exact constants that the tests suggest to free, and uncertain ones far from their stated values.
std::vector<Constant> suspected_constants(const FitResult& fit) {
  constexpr double kFar = 3;  // standard errors of a prior
  std::vector<std::pair<double, Constant>> list;
  if (!fit.budget) return {};
  for (const ExactConstant& one : fit.budget->exact)
    if (one.score && asks_to_be_free(*one.score, fit.budget->independent))
      list.emplace_back(-one.score->fall, constant_named(one.constant).value());
  for (const BudgetPart& part : fit.budget->parts)
    if (std::abs(part.pull) > kFar) list.emplace_back(-part.pull * part.pull, constant_named(part.constant).value());
  std::stable_sort(list.begin(), list.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
  const auto add_exact = [&](Constant constant) {
    if (std::any_of(fit.budget->exact.begin(), fit.budget->exact.end(),
                    [&](const ExactConstant& one) { return one.constant == kConstantNames[constant]; }))
      list.emplace_back(0, constant);
  };
  // A memory as long as the runs hides what differs between them.
  if (lie_together(fit)) {
    add_exact(kModulusDrift);
    add_exact(kToughnessDrift);
  }
  // A few areas without shear that are off look like a course, and their score test has few points.
  if (has_course(fit)) add_exact(kHysteresis);
  std::vector<Constant> constants;
  const auto has = [&](Constant c) { return std::find(constants.begin(), constants.end(), c) != constants.end(); };
  for (const auto& [fall, constant] : list) {
    const Constant alike = constant == kAreaScale ? kModulus : constant;  // they act alike; only the modulus is named
    const bool known = std::any_of(list.begin(), list.end(), [&](const auto& one) { return one.second == alike; });
    if (constants.size() < kMostConstants && !has(known ? alike : constant))
      constants.push_back(known ? alike : constant);
  }
  return constants;
}

/// Tests of quantities that differ between the runs; modulus is left out, as area_scale acts like it.
std::vector<RunTest> differing_quantities(const FitResult& fit) {
  std::vector<RunTest> list;
  const double tests = static_cast<double>(fit.run_tests.size());
  for (const RunTest& test : fit.run_tests) {
    const double p = std::min({test.all.p_value, test.odd.p_value, test.drift.p_value});
    const bool differs = p * tests < kChance || lie_together(fit);
    if (differs && test.quantity != kConstantNames[kModulus]) list.push_back(test);
  }
  return list;
}

/// A cause to try.
struct PossibleCause {
  ExpectedFall expected;
  bool by_run;
  std::function<Cause(const Case&, const Points&)> fit;
};

/// The best cause so far.
struct Reached {
  double fall = 0, expected_fall = 0;  // of the misfit
  bool by_run = false;
};

/// Whether a cause will not come within `range` of the best one so far. In 900 simulated experiments (tools/noise,
/// tools/laboratories) the expected fall of causes that did was too small by less than 10, or by no more than that of
/// the best. An exception are two quantities that differ by run where errors are unknown: correlated neighbours take up
/// what the wrong one leaves.
bool falls_short(const FitResult& fit, const PossibleCause& one, const Reached& best, double range) {
  constexpr double kLeast = 6, kPart = 0.03, kPartByRun = 0.5;
  const double part = !fit.known_errors && one.by_run && best.by_run ? kPartByRun : kPart,
               of_best = std::isfinite(best.expected_fall) ? std::abs(best.fall - best.expected_fall) : 0;
  return one.expected.misfit + range + std::max({kLeast, part * best.fall, of_best}) < best.fall;
}

/// All that the tests suspect; those with the largest expected fall of the misfit come first.
std::vector<PossibleCause> possible_causes(const Case& of, const Points& points) {
  constexpr double kAtMost = 3;  // far from its minimum the linearised fall is too small, but not by this factor
  const FitResult& fit = of.fit;
  std::vector<PossibleCause> list;
  for (const Constant constant : suspected_constants(fit)) {
    if (of.to_beat &&
        misfit(fit) - expected_fall(fit, constant, fit.used.size(), kAtMost).misfit >= *of.to_beat + kNear)
      continue;
    const bool drift = constant == kModulusDrift || constant == kToughnessDrift;
    const bool hidden = (drift && lie_together(fit)) || (constant == kHysteresis && has_course(fit));
    list.push_back({hidden ? kUnknownFall : expected_fall(fit, constant, points.size()), false,
                    [=](const Case& with, const Points& which) { return with_free(with, constant, which); }});
  }
  if (of.to_beat) return list;
  if (of.data.holds_approach()) list.push_back({kUnknownFall, false, with_stiffness});
  // A course common to all runs is not a difference between them.
  if (!has_course(fit) && fit.rows() == fit.used.size())  // by_run knows areas alone
    for (const RunTest& test : differing_quantities(fit))
      list.push_back({expected_fall(fit, test, points.size()), true,
                      [=](const Case& with, const Points& which) { return by_run(with, test.quantity, which); }});
  std::stable_sort(list.begin(), list.end(), [](const PossibleCause& x, const PossibleCause& y) {
    return x.expected.misfit > y.expected.misfit;
  });
  return list;
}

/// Whether a fit fails clearly, whatever the proportions of the errors.
bool is_hopeless(const Dataset& data, const FitResult& fit) {
  constexpr double kSurely = 1e-6;
  if (!is_found(fit) || (fit.residuals.empty() && fit.pull_off_residuals.empty())) return true;
  const ResidualTests tests = consistency_of(data, fit).residuals;
  return is_far(tests) || tests.course_p < kSurely;
}

}  // namespace

double misfit(double squares, double log_variances, std::size_t points, bool known_errors) {
  const auto n = static_cast<double>(points);
  return (known_errors ? squares : n * std::log(squares / n)) + log_variances;
}

double misfit(const FitResult& fit) {
  return misfit(fit.sum_of_squares, fit.log_variances, fit.rows(), fit.known_errors);
}

std::vector<Cause> causes(const Case& of, const Points& points, double before, double range) {
  const Points some = thinned(points, kTriedFirst);
  const bool many = worth_a_sample(points);
  const auto differs = [](const Cause& one) {
    return one.kind != Cause::Kind::runs ||
           (one.fit.errors && one.fit.errors->runs.any() && one.fit.errors->runs.spreads.back() > 0);
  };
  std::vector<Cause> list;
  Reached best;
  const auto consider = [&](const Case& with, const Case& with_all, const PossibleCause& possible) {
    // Few points may show no difference between the runs where all of them do.
    if (many && !is_explanation(of, possible.fit(with, some).fit)) return;
    Cause one = possible.fit(with_all, points);
    if (!differs(one) || !is_explanation(of, one.fit)) return;
    one.misfit = is_of_one_run(one) ? one.fit.one_run->misfit : misfit(one.fit);
    if (before - one.misfit > best.fall) best = {before - one.misfit, possible.expected.misfit, possible.by_run};
    list.push_back(std::move(one));
  };
  // If another model has won, errors need not be estimated for each cause, and differing runs explain nothing.
  FitOptions bare = of.options;
  bare.fitted_errors = false;
  const Case by_readings{of.data, of.fit, bare, of.refit, of.to_beat};
  FitOptions near = bare;
  if (of.to_beat && points.size() == of.fit.used.size()) near.most_misfit = *of.to_beat + kNear;
  const Case near_the_other{of.data, of.fit, near, of.refit, of.to_beat};
  for (const PossibleCause& one : possible_causes(of, points)) {
    if (falls_short(of.fit, one, best, range) || stays_too_large(of.fit, one.expected, points.size())) continue;
    if (of.to_beat)
      consider(by_readings, near_the_other, one);
    else if (one.by_run || (of.fit.known_errors && !many) || !is_hopeless(of.data, one.fit(by_readings, some).fit))
      consider(of, of, one);  // with known errors it is given up as soon as that shows
  }
  std::stable_sort(list.begin(), list.end(), [](const Cause& x, const Cause& y) { return x.misfit < y.misfit; });
  std::erase_if(
      list, [&, best = list.empty() ? 0 : list.front().misfit](const Cause& one) { return one.misfit > best + range; });
  std::stable_sort(list.begin(), list.end(), [&](const Cause& x, const Cause& y) {
    return x.misfit + implausibility(of, x) < y.misfit + implausibility(of, y);
  });
  for (Cause& one : list) describe(of, one);
  return list;
}

std::vector<Cause> beside_the_fit(const Case& of) {
  std::vector<Cause> list;
  const FitResult& fit = of.fit;
  const ExactConstant* const nearly = nearly_wrong_constant(fit);
  if (!nearly || fit.loss_scale > 0 || !is_found(fit)) return list;
  const FittedParameter* const first = find_parameter(fit.parameters, fit.budget->parameter);
  if (!first || !first->value || !first->stderr_ || !first->interval) return list;
  constexpr double kMatters = 0.5;  // standard errors beyond an end, an eighth of an interval of 95 %
  const bool by_itself = !is_nearly_wrong(*nearly, fit.budget->independent);
  const double quantile = std::sqrt(chi_squared_quantile(first->interval->confidence, 1));
  for (const double side : {-1.0, 1.0}) {
    const auto& end = side < 0 ? first->interval->low : first->interval->high;
    if (!end) continue;
    // Only what lies outermost, according to the linearised fit, is fitted.
    std::vector<std::pair<double, Constant>> beyond;
    for (const ExactConstant& one : fit.budget->exact) {
      if (!one.score || one.score->fall < nearly->score->fall - kAboutAsWell || (by_itself && &one != nearly)) continue;
      const double reach = side * one.score->change + quantile * one.score->widening;
      if (reach > side * (*end - *first->value) / *first->stderr_ + kMatters)
        beyond.emplace_back(-reach, constant_named(one.constant).value());
    }
    std::stable_sort(beyond.begin(), beyond.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
    for (const auto& [reach, constant] : beyond) {
      if (!list.empty() && list.front().name == kConstantNames[constant]) break;
      Cause one = with_free(of, constant, Points(fit.used.begin(), fit.used.end()));
      if (!is_explanation(of, one.fit)) continue;
      one.misfit = misfit(one.fit);
      if (one.misfit + implausibility(of, one) > misfit(fit)) continue;
      list.push_back(std::move(one));
      break;
    }
  }
  for (Cause& one : list) describe(of, one);
  return list;
}

std::optional<Cause> shape_instead_of_memory(const Case& of) {
  const bool correlate = of.fit.errors && of.fit.errors->correlations.any();
  if (!correlate || !of.fit.budget || of.fit.loss_scale > 0 || !is_found(of.fit)) return std::nullopt;
  const bool exact = std::any_of(of.fit.budget->exact.begin(), of.fit.budget->exact.end(),
                                 [](const ExactConstant& one) { return one.constant == kConstantNames[kShape]; });
  constexpr double kTooLarge = 40;  // the expected misfit of a shape; one of 18 was more, but below that of the memory
  const auto& expected = of.fit.shape_instead_of_memory;
  if (!exact || (expected && *expected > misfit(of.fit) + kAboutAsWell + kTooLarge)) return std::nullopt;
  Cause cause = with_free(of, kShape, of.fit.used.list());
  if (!is_explanation(of, cause.fit)) return std::nullopt;
  cause.misfit = misfit(cause.fit);
  const FittedParameter *const before = find_parameter(of.fit.parameters, of.fit.budget->parameter),
                               *const after = find_parameter(cause.fit.parameters, of.fit.budget->parameter);
  if (!before || !after || !before->stderr_ || !after->value) return std::nullopt;
  const double change = (*after->value - *before->value) / *before->stderr_;
  const bool without = !(cause.fit.errors && cause.fit.errors->correlations.any());
  if (!without || cause.misfit > misfit(of.fit) + kAboutAsWell || !moves_or_widens(change, 1)) return std::nullopt;
  describe(of, cause);
  return cause;
}

bool runs_differ(const FitResult& fit, double chance) {
  const double each = chance / static_cast<double>(fit.run_tests.size());
  return std::any_of(fit.run_tests.begin(), fit.run_tests.end(), [&](const RunTest& test) {
    const auto fails = [&](const RunTest::Way& way) { return way.matters() && way.p_value < each; };
    return fails(test.all) || fails(test.odd) || fails(test.drift);
  });
}

}  // namespace mixity
