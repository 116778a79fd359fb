#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>

#include "analysis/judgement.h"
#include "analysis/readable.h"
#include "base/number_text.h"
#include "base/phrases.h"
#include "base/text.h"
#include "fitting/consistency.h"
#include "fitting/predicted_curves.h"
#include "fitting/standard_errors.h"
#include "fitting/stated_constants.h"
#include "report/fit_fields.h"
#include "report/fit_table.h"
#include "report/fit_text.h"

namespace mixity {

std::string shown_r2(const std::optional<double>& r2) { return r2 ? r2_text(*r2) : "undefined (the data do not vary)"; }

std::string ends_text(const ShownInterval& interval, double width, const char* open, const char* bound) {
  const auto end = [&](const std::optional<double>& value, EndStatus status) {
    return !value ? std::string(open) : resolved(*value, width) + (status == EndStatus::at_bound ? bound : "");
  };
  return end(interval.low, interval.low_status) + " .. " + end(interval.high, interval.high_status);
}

std::string interval_text(const FittedParameter& parameter) {
  if (!parameter.interval) return {};
  const ShownInterval& interval = *parameter.interval;
  const double width = interval.low && interval.high ? *interval.high - *interval.low : 0;
  // That of the causes of failed tests need not include a value that is not believed.
  const bool apart =
      interval.method == "explanations" && parameter.value &&
      ((interval.low && *parameter.value < *interval.low) || (interval.high && *parameter.value > *interval.high));
  return "   " + rounded(100 * interval.confidence, 4) + "% " + ends_text(interval, width, "?", " (bound)") +
         (apart ? " if a cause is fitted" : "");
}

std::string estimated_errors(const StandardErrors& errors, const DisplayUnits& units) {
  const auto size = [](const char* name, ErrorSource source, const std::optional<ErrorModel>& model, double step,
                       double scale, const std::string& unit) {
    if (StandardErrors::is_known(source) || !model) return std::string();
    const auto shown = [&](double value) { return rounded(value * scale, 2) + (unit.empty() ? "" : " " + unit); };
    std::vector<std::string> parts;
    if (model->constant > 0) parts.push_back(shown(model->constant));
    if (model->share > 0) parts.push_back(rounded(100 * model->share, 2) + " %");
    if (step > 0) parts.push_back("steps of " + shown(step));
    return std::string(name) + " " + (parts.empty() ? "0" : joined(parts, " + "));
  };
  std::vector<std::string> axes{
      size("A", errors.source_A, errors.model_A, errors.step_A, units.area_scale, units.area),
      size("T", errors.source_T, errors.model_T, errors.step_T, units.force_scale, units.force)};
  std::erase(axes, "");
  if (axes.empty()) return {};
  const bool assumed = errors.source_A == ErrorSource::assumed || errors.source_T == ErrorSource::assumed;
  std::vector<std::string> list{joined(axes),
                                assumed ? "assumed: too few neighbouring points to estimate them" : "from scatter"};
  if (!errors.run_factors.empty()) {
    const auto [least, most] = std::minmax_element(errors.run_factors.begin(), errors.run_factors.end());
    list.push_back("times " + rounded(*least, 2) + " to " + rounded(*most, 2) + " in the runs");
  }
  return joined(list);
}

std::string correlation_text(const FitResult& fit) {
  const double r = mean_correlation(fit);
  if (!(r > 0)) return {};
  return "neighbours correlate by " + rounded(r, 2) + ": as good as " +
         rounded(std::round(independent_points(fit)), 6) + " of " + std::to_string(fit.used.size()) + " points";
}

std::vector<std::string> raised_errors(const StandardErrors& errors) {
  std::vector<std::string> texts;
  for (const auto& [raised, quantity] : {std::pair(errors.raised_T, "T"), std::pair(errors.raised_A, "A")})
    if (raised > 0)
      texts.push_back(rounded(100 * kLeastError, 2) + "% of the largest " + quantity + " stands for " +
                      counted(raised, "error") + " of 0");
  return texts;
}

/// The quantities that differ from run to run, and the expected range of the next run.
std::vector<std::string> run_texts(const FitResult& fit, const Dataset& data) {
  std::vector<std::string> texts;
  const RunDifferences& runs = fit.errors->runs;
  for (std::size_t q = 0; q < runs.spreads.size(); ++q) {
    const std::string& name = runs.names[q];
    const ConstantUnit unit = shown_deviation(data, name);
    const auto constant = constant_named(name);
    const auto shown = [&](double size) {
      return constant && is_factor(*constant) ? rounded(100 * size, 2) + "%"
                                              : rounded(size * unit.scale, 2) + unit_text(unit.text);
    };
    std::vector<std::string> deviations;
    for (std::size_t run = 0; run < data.curves.size(); ++run)
      deviations.push_back(data.curves[run] + (runs.deviations[q][run] < 0 ? ": " : ": +") +
                           shown(runs.deviations[q][run]));
    std::string text = name + " differs from run to run by " + shown(runs.spreads[q]) + " (standard deviation); run " +
                       joined(deviations);
    const FittedParameter* const first = find_parameter(fit.parameters, name);
    if (first && first->interval && first->stderr_ && first->interval->low && first->interval->high) {
      const double half = 0.5 * (*first->interval->high - *first->interval->low),
                   next = half * std::hypot(1.0, runs.spreads[q] / *first->stderr_);
      text += "; that of a further run lies within " + resolved(*first->value - next, 2 * next) + " .. " +
              resolved(*first->value + next, 2 * next) + " (" + rounded(100 * first->interval->confidence, 4) + "%)";
    }
    texts.push_back(std::move(text));
  }
  return texts;
}

std::string paper_text(const FitResult& fit) {
  if (!fit.paper) return {};
  std::vector<std::string> parameters;
  for (const FittedParameter& one : fit.paper->parameters)
    parameters.push_back(one.name + (one.value ? " = " + rounded(*one.value, 5) : " not determined"));
  std::string text = "    the paper's fit (ln(Gc/GIc) against psi, unweighted):" + joined(parameters, ", ", " ");
  if (fit.paper->status != FitStatus::ok) text += " (" + in_words(fit.paper->status) + ")";
  if (fit.paper->status == FitStatus::not_identifiable) return text + "\n";
  return text + ", R^2 = " + shown_r2(fit.paper->r2) + ", " + std::to_string(fit.paper->points) + " points\n";
}

namespace {

std::string factor_text(double factor) { return "times " + rounded(factor, 3) + ", from scatter"; }

}  // namespace

std::string errors_text(const FitResult& fit, const Dataset& data, Wording words) {
  std::ostringstream out;
  if (!fit.errors && fit.sigma_factor)
    out << "    errors: from the file, " << factor_text(*fit.sigma_factor) << '\n';
  else if (!fit.errors && !fit.known_errors && !data.errors.empty() && fit.objective == Objective::toughness)
    out << "    errors: every point has the same weight; " << words(Remedy::set("weighted", "true"))
        << (data.has_loads ? " or " + words(Remedy::set("objective", "curve")) : "")
        << " uses the file's standard errors\n";
  if (fit.errors) {
    out << "    errors: ";
    const auto source = [&](ErrorSource of) -> std::string {
      return of == ErrorSource::exact ? "0 (none given; if T has errors, state " + words(Remedy::set("sigma_T")) + ")"
             : of == ErrorSource::columns ? "from the file"
                                          : "as stated";
    };
    const auto stated = [&](const char* name, ErrorSource of) {
      return StandardErrors::is_known(of) ? name + (" " + source(of)) : std::string();
    };
    std::vector<std::string> parts{stated("sigma_A", fit.errors->source_A), stated("sigma_T", fit.errors->source_T)};
    if (fit.sigma_factor) parts.push_back("both " + factor_text(*fit.sigma_factor));
    parts.push_back(estimated_errors(*fit.errors, data.display));
    if (fit.axes > 0)
      parts.push_back(data.holds_approach()
                          ? "P " + rounded(mean_error_of_loads(data, fit), 3) + unit_text(data.display.force)
                      : data.axes[fit.used[0]].sigma_q > 0
                          ? "of the axes as in the columns"
                          : "ln(a/b) " + rounded(fit.errors->axes_factor, 3) + " times the relative error of A");
    std::erase(parts, "");
    out << joined(parts);
    for (const std::string& raised : raised_errors(*fit.errors)) out << "; " << raised;
    if (const std::string text = correlation_text(fit); !text.empty()) out << "\n    " << text;
    for (const std::string& text : run_texts(fit, data)) out << "\n    " << text;
    out << '\n';
    if (fit.errors->absolute() && fit.rmse && fit.freedom() > 0 && fit.loss_scale == 0) {
      const double freedom = static_cast<double>(fit.freedom());
      constexpr double kFew = 10;  // with fewer points a small chi^2 says little
      const double part = fit.sum_of_squares / freedom;
      const std::string shown = chi_squared_text(part);
      out << "    chi^2 per degree of freedom = " << shown;
      if (shown == "0")
        out << ": the points lie on the curve; the interval uses the stated errors";
      else if (part > 2)
        out << ": the scatter is larger than these errors; intervals are too narrow";
      else if (part < 0.5 && freedom > kFew)
        out << ": these errors are " << rounded(1 / std::sqrt(part), 2)
            << " times as large as the scatter of the points; the interval uses the stated errors";
      out << '\n';
    }
  }
  if (fit.loss_freedom > 0)
    out << "    robust loss: Student's t with " << rounded(fit.loss_freedom, 3) << " degrees of freedom and a scale of "
        << rounded(fit.loss_scale / std::sqrt(fit.loss_freedom), 4) << " of the residuals' unit\n";
  else if (fit.loss_scale > 0)
    out << "    robust loss, bends at " << rounded(fit.loss_scale, 4) << " of the residuals' unit\n";
  for (const auto& [names, c] : correlations(fit))
    if (std::abs(c) > 0.5)
      out << "    correlation of " << names[0] << " and " << names[1] << ": " << rounded(c, 3)
          << (std::abs(c) > 0.99 ? ": they act alike on these data; hold one of them\n" : "\n");
  return out.str();
}

std::string resampling_text(const FitResult& fit, const Dataset& data) {
  std::ostringstream out;
  if (fit.bootstrap) {
    out << "    bootstrap of " << fit.bootstrap->replicates
        << (!fit.bootstrap->of_runs ? " resampled point sets" : " resampled sets of runs");
    if (fit.bootstrap->failed > 0) out << " (" << fit.bootstrap->failed << " without a minimum, left out)";
    out << (fit.bootstrap->parameters.empty() ? ": too few of them fit\n" : "\n");
    for (const FittedParameter& fitted : fit.parameters) {
      const FittedParameter parameter = readable(fitted);
      if (!parameter.bootstrap) continue;
      const Bootstrapped& found = *parameter.bootstrap;
      out << "        " << parameter.name << ": " << resolved(found.low, found.high - found.low) << " .. "
          << resolved(found.high, found.high - found.low) << ", standard deviation "
          << rounded(found.standard_deviation, 2) << ", bias " << rounded(found.bias, 2) << '\n';
    }
  }
  if (!fit.influence || fit.influence->points.empty()) return out.str();
  std::vector<std::size_t> order(fit.influence->points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const std::size_t shown = std::min<std::size_t>(5, order.size());
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(shown), order.end(),
                    [&](std::size_t i, std::size_t j) {
                      return fit.influence->points[i].cooks_distance > fit.influence->points[j].cooks_distance;
                    });
  const FittedParameter* const leading = leading_parameter(fit);
  const std::string name = leading ? leading->name : "";
  const auto change = [&](const std::vector<double>& values) {
    return values.empty() ? std::string("no fit without it")
                          : name + (values[0] < 0 ? " " : " +") + rounded(values[0], 2);
  };
  out << "    most influential points (Cook's distance, change if left out):\n";
  for (std::size_t i = 0; i < shown; ++i) {
    const PointInfluence& point = fit.influence->points[order[i]];
    out << "        " << data.line_text(data.points[fit.used[order[i]]].line) << ": "
        << rounded(point.cooks_distance, 2) << ", " << change(point.change) << '\n';
  }
  std::vector<std::string> runs;
  for (std::size_t i = 0; i < fit.influence->runs.size(); ++i)
    runs.push_back(fit.run_names[i] + ' ' + change(fit.influence->runs[i]));
  if (runs.size() > 1) out << joined(runs, ", ", "    change if a run is left out: ") << '\n';
  return out.str();
}

std::string area_error_text(double error, const Dataset& data) {
  return rounded_difference(error, largest_value(data, &Point::A) * data.display.area_scale, 3);
}

std::string comparison_text(const Analysis& result) {
  if (result.comparison.empty()) return {};
  std::ostringstream out;
  std::vector<ComparedModel> sorted = result.comparison;
  const auto key = [](const ComparedModel& m) {
    return std::pair{m.left_out ? m.left_out->rmse_area : std::numeric_limits<double>::infinity(),
                     m.aicc.value_or(std::numeric_limits<double>::infinity())};
  };
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](const ComparedModel& one, const ComparedModel& other) { return key(one) < key(other); });
  const bool left_out = std::any_of(sorted.begin(), sorted.end(), [](const auto& m) { return m.left_out.has_value(); });
  out << "[[Comparison]]\n    model   " << (left_out ? padded("error in A on loads left out", 31) : "")
      << "AICc weight   "
      << "probability by the evidence\n";
  for (const ComparedModel& m : sorted) {
    out << "    " << padded(m.model, 8);
    if (left_out) {
      std::string text = "-";
      if (m.left_out) {
        text = area_error_text(m.left_out->rmse_area, result.data) + unit_text(result.data.display.area);
        if (m.left_out->beyond_fold > 0) text += ", " + std::to_string(m.left_out->beyond_fold) + " past the fold";
      }
      out << padded(text, 31);
    }
    out << padded(m.weight ? weight_text(*m.weight) : "-", 14) << (m.probability ? weight_text(*m.probability) : "-")
        << '\n';
  }
  if (const std::string text = no_best_model(result); !text.empty()) out << "    " << text << '\n';
  return out.str();
}

std::string per_curve_text(const Analysis& result) {
  std::ostringstream out;
  for (const PerCurve& per_curve : result.per_curve) {
    out << "[[Each run]] model " << per_curve.model << '\n';
    for (const CurveFit& one : per_curve.curves) {
      out << "    " << padded(one.curve, 10);
      if (result.data.has_loads)
        out << padded(result.data.held_name() + (" = " + rounded(one.P * result.data.held_scale(), 4)) +
                          unit_text(result.data.held_unit()),
                      18);
      for (const FittedParameter& parameter : one.fit.parameters) {
        if (parameter.held) continue;
        out << parameter.name << " = " << (parameter.value ? rounded(*parameter.value, 5) : "not determined");
        if (parameter.stderr_) out << " +/- " << rounded(*parameter.stderr_, 2);
        out << interval_text(parameter);
        if (&parameter != &one.fit.parameters.back()) out << "  ";
      }
      if (one.fit.status != FitStatus::ok) out << "  " << to_string(one.fit.status);
      out << '\n';
    }
    if (!per_curve.test) {
      out << "    no test of one value for all runs: " << per_curve.untested << '\n';
      continue;
    }
    const PerCurve::Test& test = *per_curve.test;
    out << "    one value for all runs against one for each: " << (test.chi_squared ? "chi^2(" : "F(")
        << rounded(test.freedom, 4) << (test.chi_squared ? "" : ", " + rounded(test.residual_freedom, 6))
        << ") = " << (test.chi_squared ? chi_squared_text(test.statistic, 4) : rounded(test.statistic, 4))
        << ", p = " << rounded(test.p_value, 2);
    if (test.aicc_pooled && test.aicc_separate)
      out << ", AICc " << rounded(*test.aicc_pooled, 5) << " against " << rounded(*test.aicc_separate, 5);
    out << "\n    "
        << (test.p_value < 0.05 ? "the runs do not share one value" : "the runs are consistent with one value") << '\n';
  }
  return out.str();
}

}  // namespace mixity
