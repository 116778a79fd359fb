#include <algorithm>
#include <cmath>

#include "analysis/readable.h"
#include "base/number_text.h"
#include "base/phrases.h"
#include "base/units.h"
#include "dataset/constants.h"
#include "fitting/consistency.h"
#include "fitting/heavy_points.h"
#include "report/fit_text.h"

namespace mixity {
namespace {

using Texts = std::vector<std::string>;

std::string percent(double share) { return rounded(100 * share, 2) + "%"; }

std::string chance(double p) { return p < 1e-4 ? "p < 0.0001" : "p = " + rounded(p, 2); }

std::string variance_shares(const Budget& budget) {
  constexpr double kFarFromStated = 3;  // standard errors of a prior
  std::string text = "error budget of " + budget.parameter +
                     " (shares of the variance, by the joint covariance): scatter " + percent(*budget.scatter);
  Texts far;
  for (const BudgetPart& part : budget.parts) {
    text += ", " + part.constant + " " + percent(part.share);
    if (std::abs(part.pull) > kFarFromStated)
      far.push_back("FAR FROM ITS STATED VALUE: " + part.constant + ", by " + rounded(part.pull, 2) +
                    " of its standard errors");
  }
  return text + joined(far, ", ", "; ");
}

/// How the parameter would move with the constants taken as exact, each change in a suitable unit.
std::string effects_of_exact_constants(const Budget& budget, double standard_error) {
  constexpr double kHardly = 0.1;  // of a standard error: smaller changes are not listed
  Texts effects;
  for (const ExactConstant& one : budget.exact) {
    if (!one.effect || (is_change(one.constant) && std::abs(*one.effect) < kHardly * standard_error)) continue;
    const ReadableUnit shown = readable_unit(*one.effect, budget.unit);
    const std::string step = one.constant.ends_with("_offset") ? rounded(one.step, 2) + unit_text(one.unit)
                             : is_change(one.constant)         ? std::string("1%")
                                                               : std::string("5%");
    effects.push_back((*one.effect < 0 ? "" : "+") + rounded(*one.effect * shown.factor, 2) + unit_text(shown.unit) +
                      " (" + one.constant + " +" + step + ")");
  }
  return joined(effects, ", ", "constants taken as exact; an error in them would shift " + budget.parameter + " by ");
}

/// Constants that the data suggest to free, the largest fall of chi^2 first.
std::string score_tests(const FitResult& fit) {
  constexpr std::size_t kMost = 3;
  if (!fit.budget) return {};
  std::vector<const ExactConstant*> list;
  for (const ExactConstant& one : fit.budget->exact)
    if (one.score && one.score->p_value * fit.budget->independent < kChance) list.push_back(&one);
  std::stable_sort(list.begin(), list.end(), [](const ExactConstant* one, const ExactConstant* other) {
    return one->score->fall > other->score->fall;
  });
  Texts falls;
  for (std::size_t i = 0; i < std::min(kMost, list.size()); ++i) {
    const ExactConstant::Score& score = *list[i]->score;
    const ReadableUnit shown = readable_unit(score.value, list[i]->unit);
    falls.push_back(rounded(score.fall, 3) + " with " + list[i]->constant + " near " +
                    rounded(score.value * shown.factor, 4) + unit_text(shown.unit) + " (" + chance(score.p_value) +
                    ")");
  }
  return joined(falls, ", by ",
                fit.known_errors ? "score tests: chi^2 would fall by "
                                 : "score tests: chi^2, in units of the scatter about the fit, would fall by ");
}

std::string residual_tests(const FitResult& fit) {
  const Consistency& tests = *fit.consistency;
  const ResidualTests& residuals = tests.residuals;
  Texts parts;
  if (tests.chi2_per_freedom)
    parts.push_back("chi^2 per degree of freedom " + chi_squared_text(*tests.chi2_per_freedom) + " (" +
                    chance(*tests.chi2_p) + ")");
  if (!residuals.runs.empty()) {
    parts.push_back("runs of one sign " + chance(residuals.runs_p));
    parts.push_back("correlation of neighbours " + rounded_difference(residuals.correlation, 1, 2) + " (" +
                    chance(residuals.correlation_p) + ")");
    parts.push_back("trends " + chance(residuals.trend_p));
    if (fit.area) parts.push_back("ends of runs " + chance(residuals.ends_p));
  }
  return joined(parts, ", ", "residuals: ");
}

std::string points_beyond(const FitResult& fit, const Dataset& data) {
  Texts runs;
  for (const BeyondEquilibrium& run : fit.consistency->beyond) {
    const Point& first = data.points[run.first];
    runs.push_back(counted(run.points, "point") + " of run " + run.curve +
                   " from T = " + rounded(first.T * data.display.force_scale, 4) + unit_text(data.display.force) +
                   " (" + data.line_text(first.line) + ")");
  }
  return joined(runs, ", ", "beyond the last equilibrium: ");
}

std::string heavy_text(const FitResult& fit, const Dataset& data) {
  return fit.consistency->heavy ? text_of(*fit.consistency->heavy, data) : std::string();
}

/// Outliers, the farthest first.
std::string outliers_text(const FitResult& fit, const Dataset& data) {
  constexpr std::size_t kMost = 5;
  std::vector<Outlier> list = fit.outliers;
  std::stable_sort(list.begin(), list.end(),
                   [](const Outlier& one, const Outlier& other) { return std::abs(one.size) > std::abs(other.size); });
  Texts points;
  for (std::size_t i = 0; i < std::min(kMost, list.size()); ++i) {
    const Point& point = data.points[list[i].point];
    const std::string& run = data.curves[point.curve];
    points.push_back(data.line_text(point.line) + (run.empty() ? "" : " of run " + run) + " (" +
                     rounded(std::abs(list[i].size), 2) + (i == 0 ? " standard errors off)" : ")"));
  }
  if (list.empty()) return {};
  if (list.size() > kMost) points.push_back(std::to_string(list.size() - kMost) + " more");
  const bool weighted = fit.known_errors || fit.objective == Objective::curve;
  return counted(list.size(), "outlier") + ": " + joined(points) + "; 1 % of fits to clean data have any" +
         (weighted ? "" : " where all points scatter alike");
}

Texts without_empty(Texts lines) {
  std::erase(lines, "");
  return lines;
}

}  // namespace

std::vector<std::string> budget_lines(const FitResult& fit) {
  if (!fit.budget) return {};
  const bool has_shares = !fit.budget->parts.empty() && fit.budget->scatter;
  const FittedParameter* const first = find_parameter(fit.parameters, fit.budget->parameter);
  const double error = first && first->stderr_ ? *first->stderr_ : 0;
  return without_empty(
      {has_shares ? variance_shares(*fit.budget) : std::string(), effects_of_exact_constants(*fit.budget, error)});
}

std::string prior_text(const FittedParameter& parameter, const std::optional<Budget>& budget) {
  std::string text = "stated " + with_error(parameter.prior->mean, parameter.prior->standard_error);
  for (const BudgetPart& part : budget ? budget->parts : std::vector<BudgetPart>{})
    if (part.constant == parameter.name)
      text += ", moved by " + std::string(part.pull < 0 ? "" : "+") + rounded(part.pull, 2) + " of that error";
  return text;
}

std::vector<std::string> budget_and_consistency(const FitResult& fit, const Analysis& result) {
  Texts lines;
  if (fit.status == FitStatus::suspect) lines.push_back("SUSPECT: " + fit.message.text(result.request.words));
  if (!fit.outdone_by.empty()) return lines;  // the error budget of a rejected model is of no interest
  lines.push_back(posterior_line(fit));
  for (const FittedParameter& fitted : fit.parameters)
    if (const FittedParameter parameter = readable(fitted); parameter.prior && parameter.value && parameter.stderr_)
      lines.push_back(parameter.name + " = " + with_error(*parameter.value, *parameter.stderr_) +
                      unit_text(parameter.unit) + ", " + prior_text(parameter, fit.budget));
  for (const auto& more : {budget_lines(fit), consistency_lines(fit, result.data)})
    lines.insert(lines.end(), more.begin(), more.end());
  return without_empty(std::move(lines));
}

std::string posterior_line(const FitResult& fit) {
  if (!fit.evidence) return {};
  const Evidence& evidence = fit.evidence->evidence;
  const double width = evidence.high - evidence.low;
  return "posterior: " + fit.evidence->parameter + " = " + with_error(evidence.mean, evidence.standard_deviation) +
         ", " + rounded(100 * fit.evidence->confidence, 4) + "% credible " + resolved(evidence.low, width) + " .. " +
         resolved(evidence.high, width) + " (" +
         (fit.evidence->prior_from ? "log-uniform prior from " + rounded(*fit.evidence->prior_from, 3)
                                   : "uniform prior") +
         "), ln evidence " + rounded(evidence.log_evidence, 6);
}

std::string unsheared_sentence(const UnshearedTest& test) {
  Texts implied;
  for (const UnshearedTest::Implied& one : test.implied) {
    const ReadableUnit unit = readable_unit(one.value, one.unit);
    implied.push_back(one.constant + " " + with_error(one.value * unit.factor, one.standard_error * unit.factor) +
                      unit_text(unit.unit) + " (chi^2 " + chi_squared_text(one.chi2) + ")");
  }
  return "areas without shear (" + counted(test.points, "point") + ") " +
         (test.p_value < kChance ? "do not agree with JKR" : "agree with JKR") +
         " and the constants as stated: chi^2 " + chi_squared_text(test.chi2) +
         joined(implied, " or ", "; they imply ");
}

std::vector<std::string> consistency_lines(const FitResult& fit, const Dataset& data) {
  if (!fit.consistency) return {};
  return without_empty({residual_tests(fit), score_tests(fit), points_beyond(fit, data), heavy_text(fit, data),
                        outliers_text(fit, data)});
}

}  // namespace mixity
