#include "report/fit_text.h"

#include <cctype>
#include <cmath>
#include <sstream>

#include "analysis/judgement.h"
#include "analysis/readable.h"
#include "analysis/readers_units.h"
#include "base/number_text.h"
#include "base/phrases.h"
#include "dataset/pull_off.h"
#include "report/data_text.h"

namespace mixity {
namespace {

std::string all_of_them(Wording words) { return "all of them with " + words(Remedy::set("format", "json")); }

std::string capitals(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = c == '_' ? ' ' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

void write_data(std::ostringstream& out, const Dataset& data, Wording words) {
  out << data_heading(data) << "\n    # provenance   = " << to_string(data.metadata.provenance)
      << "\n    # data rows    = " << data.rows << ", used " << usable_rows(data) << ", excluded "
      << data.excluded.size();
  out << runs_of_points(data);
  out << '\n';
  if (!data.metadata.source.empty()) out << "    # source       = " << data.metadata.source << '\n';
  std::vector<std::string> constants;
  for (const auto& [label, value] : shown_constants(data)) constants.push_back(label + " " + value);
  if (!constants.empty()) out << "    # constants    = " << joined(constants) << '\n';
  out << data_notes(data, words) << excluded_text(data, all_of_them(words));
}

void write_parameter(std::ostringstream& out, const FittedParameter& parameter, const std::optional<Budget>& budget) {
  out << "    " << parameter.name << ":" << std::string(parameter.name.size() < 8 ? 8 - parameter.name.size() : 1, ' ');
  if (!parameter.value) {
    out << "not determined";
  } else if (const double value = *parameter.value; parameter.stderr_) {
    out << with_error(value, *parameter.stderr_);
    if (*parameter.stderr_ < std::abs(value))
      out << " (" << rounded(100 * *parameter.stderr_ / std::abs(value), 2) << "%)";
  } else {
    out << rounded(value, 7)
        << (parameter.held       ? " (held)"
            : parameter.at_bound ? " (no standard error: at its bound)"
                                 : " (no standard error)");
  }
  if (!parameter.unit.empty() && parameter.value) out << ' ' << parameter.unit;
  out << interval_text(parameter);
  if (parameter.prior) out << "   " << prior_text(parameter, budget);
  if (!parameter.held && !parameter.prior)
    out << "   range " << rounded(parameter.lower, 4) << ".." << rounded(parameter.upper, 4)
        << (parameter.value ? "" : unit_text(parameter.unit));
  out << '\n';
}

std::string fitted_space(const FitResult& fit) {
  if (fit.objective == Objective::curve)
    return fit.of_pull_off_alone() && !fit.known_errors ? "distance from the curve, in errors of an assumed size"
                                                        : "distance from the curve, in standard errors";
  return std::string(fit.scale == Scale::log ? "ln(Gc/GIc)" : "Gc/GIc") + " against psi";
}

/// How well the pull-off loads are described beside areas; empty without.
std::string pull_off_line(const FitResult& fit, const Dataset& data) {
  if (fit.pull_off_residuals.empty()) return {};
  double squares = 0, largest = 0;
  std::size_t at = 0;
  for (std::size_t i = 0; i < fit.pull_off; ++i) {
    const double r = fit.pull_off_residuals[i];
    squares += r * r;
    if (std::abs(r) <= largest) continue;
    largest = std::abs(r);
    at = i;
  }
  const double n = static_cast<double>(fit.pull_off), unit = fit.errors->pull_off * data.display.force_scale;
  if (fit.of_pull_off_alone() && !fit.known_errors)
    return counted(fit.pull_off, "pull-off load") + ": no errors are stated; scatter about the curve " +
           rounded(unit * std::sqrt(squares / std::max(n - 1, 1.0)), 3) + unit_text(data.display.force) +
           ", the largest distance " + rounded(unit * largest, 3) + unit_text(data.display.force) + " in " +
           data.line_text(data.pull_off[at].line);
  std::string text = counted(fit.pull_off, "pull-off load") + ": RMS " + rounded(std::sqrt(squares / n), 3) +
                     " standard errors, the largest in " + data.line_text(data.pull_off[at].line) + " (" +
                     rounded(fit.pull_off_residuals[at], 3) + ")";
  if (without_pull_off_error(data) > 0)
    text += "; error of the load " + rounded(unit, 3) + unit_text(data.display.force) + ", from scatter";
  return text;
}

void write_fit(std::ostringstream& out, const FitResult& fit, const FitRequest& request, const Dataset& data) {
  out << "[[Model " << fit.model << "]] " << fit.model_name << ": " << fit.formula << '\n';
  out << "    status: " << (fit.status == FitStatus::ok ? "ok" : "*** " + capitals(to_string(fit.status)) + " ***");
  if (!fit.message.empty()) out << ": " << fit.message.text(request.words);
  out << '\n';
  for (const FittedParameter& parameter : fit.parameters) write_parameter(out, readable(parameter), fit.budget);
  const bool kept = fit.outdone_by.empty();  // the error budget of a rejected model is not shown
  const auto write_lines = [&](const std::vector<std::string>& list) {
    for (const std::string& line : list)
      if (kept && !line.empty()) out << "    " << line << '\n';
  };
  write_lines({posterior_line(fit)});
  write_lines(budget_lines(fit));
  out << paper_text(fit);
  const double size = fit.errors ? 1e6 : 1;  // of what residuals are differences: in standard errors, or of logarithms
  if (fit.rmse)
    out << "    R^2 = " << shown_r2(fit.r2) << " in " << fitted_space(fit) << ", RMS "
        << rounded_difference(*fit.rmse, size, 3) << ", largest residual "
        << rounded_difference(*fit.max_abs_residual, size, 3) << ", "
        << (fit.of_pull_off_alone() ? counted(fit.pull_off, "pull-off load") : counted(fit.used.size(), "point"))
        << '\n';
  write_lines({pull_off_line(fit, data)});
  write_lines(consistency_lines(fit, data));
  out << (fit.of_pull_off_alone() ? std::string() : errors_text(fit, data, request.words))
      << resampling_text(fit, data);
  if (fit.area && !fit.used.empty()) {
    out << "    ";
    if (fit.area->predicted > 0)
      out << "R^2 = " << shown_r2(fit.area->r2) << " in predicted A(T), RMS " << area_error_text(fit.area->rmse, data)
          << unit_text(data.display.area) << ", largest residual " << area_error_text(fit.area->max_abs_residual, data);
    else
      out << "no predicted A(T)";
    if (!fit.area->obstacle.empty())
      out << ": " << fit.area->obstacle;
    else if (fit.area->unpredicted > 0)
      out << "; " << counted(fit.area->unpredicted, "point") << " beyond the last equilibrium";
    out << '\n';
  }
  out << first_excluded(data, fit.excluded, "without ", all_of_them(request.words));
  for (const Agreement& agreement : compare(fit, request))
    out << "    published " << agreement.published.name << " = " << shortest(agreement.published.value) << " +- "
        << shortest(agreement.published.tolerance) << ": " << (agreement.agrees ? "agrees" : "*** DOES NOT AGREE ***")
        << '\n';
}

}  // namespace

std::string to_text(const Analysis& result) {
  if (const auto shown = in_readers_units(result)) return to_text(*shown);
  std::ostringstream out;
  write_data(out, result.data, result.request.words);
  if (result.unsheared) out << "    " << unsheared_sentence(*result.unsheared) << '\n';
  for (const FitResult& fit : result.fits) write_fit(out, fit, result.request, result.data);
  out << per_curve_text(result) << comparison_text(result);
  return out.str();
}

}  // namespace mixity
