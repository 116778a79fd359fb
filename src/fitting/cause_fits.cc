#include "fitting/cause_fits.h"

#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <utility>

#include "base/number_text.h"
#include "base/units.h"
#include "fitting/options.h"
#include "fitting/plausible_size.h"
#include "fitting/predicted_area.h"
#include "fitting/stated_constants.h"

namespace mixity {
namespace {

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

Cause fitted(const Case& of, Cause::Kind kind, std::string name, Message remedy, FitOptions options,
             const Points& points) {
  options.explanation_only = true;
  FitResult fit = of.refit(of.data, options, points, &of.fit.parameters);
  return {kind, std::move(name), {}, {}, std::move(remedy), points, std::move(fit), 0};
}

constexpr std::string_view kStiffness = "normal_stiffness";

}  // namespace

std::string hysteresis_text(double value) {
  return std::string("the toughness without shear is ") + (value > 0 ? "larger by " : "smaller by ") +
         percent(std::abs(value));
}

Cause with_free(const Case& of, Constant constant, const Points& points) {
  FitOptions options = of.options;
  options.free.push_back(constant);
  return fitted(of, Cause::Kind::constant, std::string(kConstantNames[constant]), remedy_of(constant),
                std::move(options), points);
}

Cause by_run(const Case& of, const std::string& quantity, const Points& points) {
  FitOptions options = of.options;
  options.by_run.push_back(quantity);
  return fitted(of, Cause::Kind::runs, quantity, Remedy::set("by_run", quantity), std::move(options), points);
}

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

bool is_explanation(const Case& of, const FitResult& with) {
  if (!is_found(with) || !explains(of.data, with)) return false;
  const FittedParameter *const before = find_parameter(of.fit.parameters, of.fit.budget->parameter),
                               *const after = find_parameter(with.parameters, of.fit.budget->parameter);
  return !(before && after && after->at_bound && !before->at_bound);
}

}  // namespace mixity
