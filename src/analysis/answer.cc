#include "analysis/answer.h"

#include <algorithm>
#include <cmath>

#include "analysis/judgement.h"
#include "analysis/readable.h"
#include "base/number_text.h"
#include "fitting/predicted_curves.h"

namespace mixity {
namespace {

std::string with_error(const Derived& number) {
  if (!number.value) return "-";
  if (!number.standard_error || !(*number.standard_error > 0)) return rounded(*number.value, 4);
  const RoundedToError shown = rounded_to_error(*number.value, *number.standard_error);
  return shown.value + " ± " + shown.error;
}

/// Writes λ, ψ and ² for lambda, psi and ^2.
std::string with_greek(std::string text) {
  for (const auto& [name, letter] : {std::pair("lambda", "λ"), std::pair("psi", "ψ"), std::pair("^2", "²")})
    for (std::size_t at = 0; (at = text.find(name, at)) != std::string::npos;)
      text.replace(at, std::string(name).size(), letter);
  return text;
}

/// The jumps at the loads of all runs.
std::vector<PredictedJump> jumps(const Analysis& result, const FitResult& fit) {
  const Dataset& data = result.data;
  const DisplayUnits& units = data.display;
  std::vector<double> largest(data.curves.size());
  for (const Point& point : data.points) largest[point.curve] = std::max(largest[point.curve], point.shear());
  std::vector<std::size_t> runs;
  for (std::size_t run = 0; run < data.curve_loads.size(); ++run) {
    const auto same = std::find_if(runs.begin(), runs.end(),
                                   [&](std::size_t other) { return data.curve_loads[other] == data.curve_loads[run]; });
    if (same == runs.end())
      runs.push_back(run);
    else
      largest[*same] = std::max(largest[*same], largest[run]);
  }
  std::stable_sort(runs.begin(), runs.end(),
                   [&](std::size_t i, std::size_t j) { return data.curve_loads[i] > data.curve_loads[j]; });
  std::vector<PredictedJump> list;
  const auto scaled = [](Derived number, double scale) {
    if (number.value) *number.value *= scale;
    if (number.standard_error) *number.standard_error *= scale;
    return number;
  };
  for (const std::size_t run : runs)
    if (const auto jump = predict_jump_of(data, fit, result.request.options, data.curve_loads[run]))
      list.push_back({data.curve_loads[run] * data.held_scale(), data.holds_approach(),
                      scaled(jump->T, units.force_scale), scaled(jump->A, units.area_scale),
                      largest[run] * units.force_scale});
  return list;
}

/// Warns if the jumps are extrapolated.
std::string reach(const std::vector<PredictedJump>& jumps) {
  double farthest = 0;
  for (const PredictedJump& jump : jumps)
    if (jump.largest_T > 0) farthest = std::max(farthest, *jump.T.value / jump.largest_T);
  if (farthest <= 1.05) return {};
  return "The jumps are extrapolated: they lie at up to " + rounded(farthest, 3) +
         " times the largest T that was measured at their load.";
}

/// Loads at which the interface slides before the contact jumps.
std::string sliding(const Dataset& data, const std::vector<PredictedJump>& jumps) {
  const auto strength = stated_strength(data);
  if (!strength) return {};
  const DisplayUnits& units = data.display;
  std::string loads;
  for (const PredictedJump& jump : jumps)
    if (*jump.T.value / units.force_scale > *strength * *jump.A.value / units.area_scale)
      loads += (loads.empty() ? "" : ", ") + rounded(jump.P, 4);
  if (loads.empty()) return {};
  return "The jumps ignore the stated shear strength: the interface reaches T = τ0 A before, and slides first, "
         "at " +
         std::string(data.held_name()) + " = " + loads + unit_text(data.held_unit()) + ".";
}

/// Constants without a standard error that would move the result by more than its standard error if they were 5 % off.
std::string exact_constants(const FitResult& fit) {
  const FittedParameter* const parameter = leading_parameter(fit);
  if (!fit.budget || !parameter || !parameter->stderr_) return {};
  std::string names;
  const ExactConstant* worst = nullptr;
  for (const ExactConstant& one : fit.budget->exact) {
    if (!one.effect || one.constant.ends_with("_offset") || is_change(one.constant) ||
        !(std::abs(*one.effect) > *parameter->stderr_))
      continue;
    names += (names.empty() ? "" : ", ") + one.constant;
    if (!worst || std::abs(*one.effect) > std::abs(*worst->effect)) worst = &one;
  }
  if (!worst) return {};
  return "The error does not include errors of " + names + ", taken as exact: a 5 % larger " + worst->constant +
         " would shift " + parameter_in_text(parameter->name) + " by " +
         rounded(std::abs(*worst->effect) / *parameter->stderr_, 2) +
         " of its standard errors. State their standard errors, as in " + worst->constant + " = \"VALUE +/- ERROR\".";
}

std::string rivals(const Analysis& result) {
  if (const std::string text = no_best_model(result); !text.empty()) return "Which model is right: " + text + ".";
  std::string text;
  for (const ComparedModel& one : result.comparison)
    if (one.weight.value_or(0) > 0.05)
      text += (text.empty() ? "" : ", ") + one.model + " " + rounded(100 * *one.weight, 2) + " %";
  return text.find(',') == std::string::npos ? "" : "Which model is right: the AICc weights are " + text + ".";
}

/// True if the interval covers the whole range.
bool is_unknown(const FittedParameter& one) {
  constexpr double kWhole = 0.99;
  if (one.stderr_ || !one.interval) return false;
  const double low = one.interval->low.value_or(one.lower), high = one.interval->high.value_or(one.upper);
  return high - low > kWhole * (one.upper - one.lower);
}

}  // namespace

Answer answer_of(const Analysis& result) {
  Answer answer;
  const std::vector<std::size_t> order = by_merit(result);
  if (order.empty() || !has_all_values(result.fits[order.front()])) return answer;
  const FitResult& fit = result.fits[order.front()];
  answer.fit = &fit;
  answer.model = "model " + fit.model + ", " + fit.model_name + ": " + with_greek(fit.formula);
  for (const FittedParameter& fitted : fit.parameters) {
    if (fitted.prior || (fitted.held && !answer.result.empty())) continue;
    const FittedParameter one = readable(fitted);
    answer.result += (answer.result.empty() ? "" : ", ") + parameter_in_text(one.name) + " = " +
                     with_error({one.value, one.stderr_}) + unit_text(one.unit);
    if (!one.interval || !one.interval->low || !one.interval->high) continue;
    const double width = *one.interval->high - *one.interval->low;
    answer.interval +=
        (answer.interval.empty() ? rounded(100 * one.interval->confidence, 4) + " % interval of " : ", of ") +
        parameter_in_text(one.name) + " " + resolved(*one.interval->low, width) + " .. " +
        resolved(*one.interval->high, width) + unit_text(one.unit);
  }
  const FittedParameter* const leading = leading_parameter(fit);
  if (leading && is_unknown(*leading))
    answer.result = parameter_in_text(leading->name) + " is not determined by these data";
  if (fit.status != FitStatus::ok)
    answer.doubt = in_words(fit.status) + (fit.message.empty() ? "" : ": " + fit.message.text(result.request.words));
  if (fit.budget && fit.budget->scatter && !fit.budget->parts.empty()) {
    answer.budget.emplace_back("scatter", *fit.budget->scatter);
    for (const BudgetPart& part : fit.budget->parts) answer.budget.emplace_back(part.constant, part.share);
  }
  if (result.data.has_loads) answer.jumps = jumps(result, fit);
  for (std::string sentence :
       {rivals(result), exact_constants(fit), reach(answer.jumps), sliding(result.data, answer.jumps)})
    if (!sentence.empty()) answer.cannot_say.push_back(std::move(sentence));
  return answer;
}

std::vector<std::vector<std::string>> jump_table(const Answer& answer, const Dataset& data) {
  std::vector<std::vector<std::string>> rows;
  if (answer.jumps.empty()) return rows;
  const DisplayUnits& units = data.display;
  rows.push_back({bracketed(data.held_name(), data.held_unit()), "jumps at " + bracketed("T", units.force),
                  "with " + bracketed("A", units.area), "measured up to " + bracketed("T", units.force)});
  for (const PredictedJump& jump : answer.jumps)
    rows.push_back({rounded(jump.P, 4), with_error(jump.T), with_error(jump.A), rounded(jump.largest_T, 4)});
  return rows;
}

}  // namespace mixity
