#include "fitting/causes.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "base/number_text.h"
#include "base/units.h"
#include "fitting/constants.h"
#include "fitting/expected_fall.h"
#include "fitting/options.h"
#include "fitting/plausible_size.h"
#include "fitting/predicted_area.h"
#include "fitting/stated_constants.h"
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

std::string percent(double share) { return rounded(100 * share, 2) + " %"; }

/// The size of a deviation of this quantity, given the solver's number.
std::string size_text(const Dataset& data, const std::string& quantity, double deviation) {
  const auto constant = constant_named(quantity);
  if (!constant) return rounded(deviation, 2);
  if (is_factor(*constant)) return percent(std::expm1(std::abs(deviation)));
  const ConstantUnit unit = unit_of(data, *constant);
  return rounded(std::abs(deviation) * unit.scale, 2) + (unit.text.empty() ? "" : " " + unit.text);
}

/// "27.1 mJ/m^2 (+0.4 %)"
std::string value_text(const Case& of, Constant constant, const FittedParameter& found) {
  if (is_change(constant)) return percent(*found.value);
  const ReadableUnit shown = readable_unit(*found.value, found.unit);
  std::string text = rounded(*found.value * shown.factor, 4) + (found.unit.empty() ? "" : " " + shown.unit);
  if (is_factor(constant)) {
    const double share =
        *found.value / unit_of(of.data, constant).scale / std::exp(constants_of(of.data, of.options)[constant]);
    text += " (" + std::string(share > 1 ? "+" : "") + percent(share - 1) + ")";
  }
  return text;
}

Message of_constant(const Case& of, Constant constant, const FitResult& fit) {
  const FittedParameter& found = *find_parameter(fit.parameters, kConstantNames[constant]);
  const double value = *found.value;
  const auto change = [&](const char* more, const char* less, const char* behind) {
    return std::string(value > 0 ? more : less) + percent(std::abs(value)) + behind;
  };
  if (constant == kModulusDrift)
    return change("modulus grows by ", "modulus falls by ", " from the first run to the last");
  if (constant == kToughnessDrift)
    return change("toughness grows by ", "toughness falls by ", " from the first run to the last");
  if (constant == kShape)
    return change("the contact is no circle: its radius reads ", "the contact is no circle: its radius reads ",
                  value > 0 ? " too large at the largest T" : " too small at the largest T");
  if (constant == kHysteresis) return hysteresis_text(value);
  std::string text = found.name;
  if (constant == kModulus) text += " (or area_scale, which acts like it)";
  if (constant == kAreaScale) text += " (or modulus, which acts like it)";
  return text + " looks wrong: at " + value_text(of, constant, found);
}

Message remedy_of(Constant constant) {
  if (constant == kModulusDrift) return Remedy::set("drift", "modulus");
  if (constant == kToughnessDrift) return Remedy::set("drift", "toughness");
  if (constant == kHysteresis) return Remedy::set("unsheared", "own");
  return Remedy::set("free", std::string(kConstantNames[constant]));
}

Cause with_free(const Case& of, Constant constant, const Points& points) {
  FitOptions options = of.options;
  options.free.push_back(constant);
  options.explanation_only = true;
  return {Cause::Kind::constant,
          std::string(kConstantNames[constant]),
          {},
          {},
          remedy_of(constant),
          points,
          of.refit(of.data, options, points, &of.fit.parameters),
          0};
}

Cause by_run(const Case& of, const std::string& quantity, const Points& points) {
  FitOptions options = of.options;
  options.by_run.push_back(quantity);
  options.explanation_only = true;
  return {Cause::Kind::runs,
          quantity,
          {},
          {},
          Remedy::set("by_run", quantity),
          points,
          of.refit(of.data, options, points, &of.fit.parameters),
          0};
}

constexpr std::string_view kStiffness = "normal_stiffness";

/// Another stiffness of the machine that holds an approach. It is exact in a fit, so that it is searched beside.
Cause with_stiffness(const Case& of, const Points& points) {
  const double kLeast = std::log(1e-3), kMost = std::log(30.0);  // compliances; those of contacts are 0.1 to 1
  constexpr int kSteps = 12, kBits = 12;
  Dataset data = of.data;
  FitOptions bare = of.options;
  bare.fitted_errors = false;  // those of the wrong stiffness would decide which is the best
  const auto fit_at = [&](double log_compliance, const FitOptions& with) {
    data.compliance = std::exp(log_compliance);
    return of.refit(data, with, points, nullptr);
  };
  const auto misfit_at = [&](double log_compliance) {
    const FitResult fit = fit_at(log_compliance, bare);
    return is_found(fit) ? misfit(fit) : HUGE_VAL;
  };
  const double step = (kMost - kLeast) / kSteps;
  double best = kLeast, least = HUGE_VAL;
  for (int k = 0; k <= kSteps; ++k)
    if (const double one = misfit_at(kLeast + k * step); one < least) {
      least = one;
      best = kLeast + k * step;
    }
  if (std::isfinite(least))
    best = boost::math::tools::brent_find_minima(misfit_at, best - step, best + step, kBits).first;
  Cause cause{
      Cause::Kind::constant, std::string(kStiffness), {}, {}, "measure it", points, fit_at(best, of.options), 0};
  const double unit = data.contact ? data.contact->stiffness_unit() : 1;
  cause.value = rounded(unit / data.compliance, 3) + (data.contact ? " N/m" : "");
  cause.size = std::string(kStiffness) + " looks wrong: at " + cause.value;
  return cause;
}

/// Whether a quantity that differs in one run alone explains the points better than one that differs in all.
bool is_of_one_run(const Cause& cause) {
  return cause.kind == Cause::Kind::runs && cause.fit.one_run && cause.fit.one_run->misfit < misfit(cause.fit);
}

void describe(const Case& of, Cause& cause) {
  if (cause.name == kStiffness) return;
  if (cause.kind == Cause::Kind::constant) {
    const Constant constant = constant_named(cause.name).value();
    cause.size = of_constant(of, constant, cause.fit);
    cause.value = value_text(of, constant, *find_parameter(cause.fit.parameters, cause.name));
    return;
  }
  const RunDifferences& runs = cause.fit.errors->runs;
  const std::size_t q = runs.names.size() - 1;
  const std::string alike = cause.name == kConstantNames[kAreaScale] ? " (or modulus, which acts like it)" : "";
  cause.size = cause.name + alike + " differs from run to run by " + size_text(of.data, cause.name, runs.spreads[q]) +
               " (standard deviation)";
  if (!is_of_one_run(cause)) return;
  const OneRun odd = *cause.fit.one_run;
  Points others;
  for (const std::size_t i : cause.points)
    if (of.data.points[i].curve != odd.run) others.push_back(i);
  FitResult without = of.refit(of.data, of.options, others, &of.fit.parameters);
  if (!is_found(without) || !explains(of.data, without)) return;
  const std::string& name = of.data.curves[odd.run];
  cause.kind = Cause::Kind::one_run;
  cause.run = name;
  cause.size = cause.name + alike + " of run " + name + " differs from that of the others by " +
               size_text(of.data, cause.name, odd.deviation);
  cause.remedy = Remedy::set("leave_out", name) + " or " + Remedy::set("by_run", cause.name);
  cause.points = std::move(others);
  cause.fit = std::move(without);
}

double implausibility(const Case& of, const Cause& cause) {
  const FittedParameter& first = cause.fit.parameters.front();
  if (cause.name == kStiffness) return 0;  // it may have been left out
  if (cause.kind == Cause::Kind::runs) {
    const double size = is_of_one_run(cause) ? cause.fit.one_run->deviation : cause.fit.errors->runs.spreads.back();
    return implausibility(of.data, cause.name, size, first.value.value_or(0));
  }
  const Constant constant = constant_named(cause.name).value();
  const double found = constants_of(of.data, of.options, cause.fit.parameters)[constant];
  return implausibility(of.data, cause.name, found - constants_of(of.data, of.options)[constant], 0);
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
  constexpr ExpectedFall kUnknown{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  constexpr double kAtMost = 3;  // far from its minimum the linearised fall is too small, but not by this factor
  const FitResult& fit = of.fit;
  std::vector<PossibleCause> list;
  for (const Constant constant : suspected_constants(fit)) {
    if (of.to_beat &&
        misfit(fit) - expected_fall(fit, constant, fit.used.size(), kAtMost).misfit >= *of.to_beat + kNear)
      continue;
    const bool drift = constant == kModulusDrift || constant == kToughnessDrift;
    const bool hidden = (drift && lie_together(fit)) || (constant == kHysteresis && has_course(fit));
    list.push_back({hidden ? kUnknown : expected_fall(fit, constant, points.size()), false,
                    [=](const Case& with, const Points& which) { return with_free(with, constant, which); }});
  }
  if (of.to_beat) return list;
  if (of.data.holds_approach()) list.push_back({kUnknown, false, with_stiffness});
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

/// Whether a fit explains the points and may end ok: one that moves the first parameter to a bound does not.
bool is_explanation(const Case& of, const FitResult& with) {
  if (!is_found(with) || !explains(of.data, with)) return false;
  const FittedParameter *const before = find_parameter(of.fit.parameters, of.fit.budget->parameter),
                               *const after = find_parameter(with.parameters, of.fit.budget->parameter);
  return !(before && after && after->at_bound && !before->at_bound);
}

/// Whether a fit fails clearly, whatever the proportions of the errors.
bool is_hopeless(const Dataset& data, const FitResult& fit) {
  constexpr double kSurely = 1e-6;
  if (!is_found(fit) || (fit.residuals.empty() && fit.pull_off_residuals.empty())) return true;
  const ResidualTests tests = test_consistency(data, fit).residuals;
  return is_far(tests) || tests.course_p < kSurely;
}

}  // namespace

std::string hysteresis_text(double value) {
  return std::string("the toughness without shear is ") + (value > 0 ? "larger by " : "smaller by ") +
         percent(std::abs(value));
}

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
