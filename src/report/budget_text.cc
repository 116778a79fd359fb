#include "report/budget_text.h"

#include <algorithm>
#include <cmath>

#include "base/number_text.h"
#include "base/units.h"
#include "fitting/consistency.h"

namespace mixity {
namespace {

std::string percent(double share) { return rounded(100 * share, 2) + "%"; }

std::string chance(double p) { return p < 1e-4 ? "p < 0.0001" : "p = " + rounded(p, 2); }

std::string uncertain(const Budget& budget) {
  constexpr double kFarFromStated = 3;  // standard errors of a prior
  std::string text = "error budget of " + budget.parameter +
                     " (shares of the variance, by the joint covariance): scatter " + percent(*budget.scatter);
  for (const BudgetPart& part : budget.parts) text += ", " + part.constant + " " + percent(part.share);
  std::string separator = "; ";
  for (const BudgetPart& part : budget.parts) {
    if (!(std::abs(part.pull) > kFarFromStated)) continue;
    text += separator + "FAR FROM WHAT WAS STATED: " + part.constant + " by " + rounded(part.pull, 2) +
            " of its standard errors";
    separator = ", ";
  }
  return text;
}

/// In a unit as the parameter itself is shown.
std::string effect_text(double effect, const Budget& budget) {
  const ReadableUnit shown = readable_unit(effect, budget.unit);
  return rounded(effect * shown.factor, 2) + unit_text(shown.unit);
}

std::string exact(const Budget& budget) {
  std::string text, separator = "taken as exact; " + budget.parameter + " would move by ";
  for (const ExactConstant& one : budget.exact) {
    if (!one.effect) continue;
    const bool offset = one.constant.ends_with("_offset");
    text += separator + (*one.effect < 0 ? "" : "+") + effect_text(*one.effect, budget) + " (" + one.constant + " +" +
            (offset ? rounded(one.step, 2) + unit_text(one.unit) : "5%") + ")";
    separator = ", ";
  }
  return text;
}

/// Constants that the data ask to be free, those that chi^2 would gain most from first.
std::string score_tests(const FitResult& fit) {
  constexpr std::size_t kMost = 3;
  if (!fit.budget) return {};
  std::vector<const ExactConstant*> list;
  for (const ExactConstant& one : fit.budget->exact)
    if (one.score && one.score->p_value * fit.budget->independent < kChance) list.push_back(&one);
  std::stable_sort(list.begin(), list.end(), [](const ExactConstant* one, const ExactConstant* other) {
    return one->score->fall > other->score->fall;
  });
  std::string text, separator = fit.known_errors
                                    ? "score tests: chi^2 would fall by "
                                    : "score tests: chi^2, in units of the scatter about the fit, would fall by ";
  for (std::size_t i = 0; i < std::min(kMost, list.size()); ++i) {
    const ExactConstant& one = *list[i];
    const ReadableUnit shown = readable_unit(one.score->value, one.unit);
    text += separator + rounded(one.score->fall, 3) + " with " + one.constant + " near " +
            rounded(one.score->value * shown.factor, 4) + unit_text(shown.unit) + " (" + chance(one.score->p_value) +
            ")";
    separator = ", by ";
  }
  return text;
}

}  // namespace

std::vector<std::string> budget_lines(const FitResult& fit) {
  std::vector<std::string> lines;
  if (!fit.budget) return lines;
  if (!fit.budget->parts.empty() && fit.budget->scatter) lines.push_back(uncertain(*fit.budget));
  if (std::string text = exact(*fit.budget); !text.empty()) lines.push_back(std::move(text));
  return lines;
}

std::string prior_text(const FittedParameter& parameter, const std::optional<Budget>& budget) {
  const RoundedToError stated = rounded_to_error(parameter.prior->mean, parameter.prior->standard_error);
  std::string text = "stated " + stated.value + " +/- " + stated.error;
  for (const BudgetPart& part : budget ? budget->parts : std::vector<BudgetPart>{})
    if (part.constant == parameter.name)
      text += ", moved by " + std::string(part.pull < 0 ? "" : "+") + rounded(part.pull, 2) + " of that error";
  return text;
}

std::vector<std::string> budget_and_consistency(const FitResult& fit, const Analysis& result) {
  std::vector<std::string> lines;
  if (fit.status == FitStatus::suspect) lines.push_back("SUSPECT: " + fit.message.text(result.request.words));
  if (!fit.outdone_by.empty()) return lines;  // what its errors are made of is of no interest
  if (std::string text = posterior_line(fit); !text.empty()) lines.push_back(std::move(text));
  for (const FittedParameter& parameter : fit.parameters) {
    if (!parameter.prior || !parameter.value || !parameter.stderr_) continue;
    const RoundedToError shown = rounded_to_error(*parameter.value, *parameter.stderr_);
    lines.push_back(parameter.name + " = " + shown.value + " +/- " + shown.error + unit_text(parameter.unit) + ", " +
                    prior_text(parameter, fit.budget));
  }
  for (const auto& more : {budget_lines(fit), consistency_lines(fit, result.data)})
    lines.insert(lines.end(), more.begin(), more.end());
  return lines;
}

std::string posterior_line(const FitResult& fit) {
  if (!fit.evidence) return {};
  const Evidence& evidence = fit.evidence->evidence;
  const RoundedToError shown = rounded_to_error(evidence.mean, evidence.standard_deviation);
  const double width = evidence.high - evidence.low;
  return "posterior: " + fit.evidence->parameter + " = " + shown.value + " +/- " + shown.error + ", " +
         rounded(100 * fit.evidence->confidence, 4) + "% credible " + resolved(evidence.low, width) + " .. " +
         resolved(evidence.high, width) + " (" +
         (fit.evidence->prior == RangePrior::uniform ? "uniform" : "log-uniform") + " prior), ln evidence " +
         rounded(evidence.log_evidence, 6);
}

std::string unsheared_sentence(const UnshearedTest& test) {
  const std::string counted = std::to_string(test.points) + (test.points == 1 ? " point" : " points");
  std::string text = "areas without shear (" + counted + ") " +
                     (test.p_value < kChance ? "do not agree with JKR" : "agree with JKR") +
                     " and the constants as stated: chi^2 " + rounded(test.chi2, 3);
  std::string separator = "; they imply ";
  for (const UnshearedTest::Implied& one : test.implied) {
    const ReadableUnit unit = readable_unit(one.value, one.unit);
    const RoundedToError shown = rounded_to_error(one.value * unit.factor, one.standard_error * unit.factor);
    text += separator + one.constant + " " + shown.value + " +/- " + shown.error + unit_text(unit.unit) + " (chi^2 " +
            rounded(one.chi2, 3) + ")";
    separator = " or ";
  }
  return text;
}

std::vector<std::string> consistency_lines(const FitResult& fit, const Dataset& data) {
  std::vector<std::string> lines;
  if (!fit.consistency) return lines;
  const Consistency& tests = *fit.consistency;
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "residuals: " : ", ") + part; };
  if (tests.chi2_per_freedom)
    add("chi^2 per degree of freedom " + rounded(*tests.chi2_per_freedom, 3) + " (" + chance(*tests.chi2_p) + ")");
  if (!tests.residuals.runs.empty()) {
    add("runs of one sign " + chance(tests.residuals.runs_p));
    add("correlation of neighbours " + rounded(tests.residuals.correlation, 2) + " (" +
        chance(tests.residuals.correlation_p) + ")");
    add("trends " + chance(tests.residuals.trend_p));
    if (fit.area) add("ends of runs " + chance(tests.residuals.ends_p));
  }
  if (!text.empty()) lines.push_back(text);
  if (std::string scores = score_tests(fit); !scores.empty()) lines.push_back(std::move(scores));
  std::string separator = "beyond the last equilibrium: ";
  text.clear();
  for (const BeyondEquilibrium& run : tests.beyond) {
    const Point& first = data.points[run.first];
    text += separator + std::to_string(run.points) + (run.points == 1 ? " point" : " points") + " of run " + run.curve +
            " from T = " + rounded(first.T * data.display.force_scale, 4) + unit_text(data.display.force) + " (" +
            data.line_text(first.line) + ")";
    separator = ", ";
  }
  if (!text.empty()) lines.push_back(text);
  return lines;
}

}  // namespace mixity
