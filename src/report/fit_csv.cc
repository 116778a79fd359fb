#include "report/fit_csv.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <tuple>

#include "base/rounding.h"
#include "dataset/table/csv.h"
#include "fitting/predicted_curves.h"

namespace mixity {
namespace {

constexpr std::size_t kCurvePoints = 101;

std::string number(const std::optional<double>& value) { return value ? shortest(*value) : std::string(); }

std::string notice(const Dataset& data) {
  return data.metadata.provenance == Provenance::reconstructed ? std::string(kReconstructedNotice) : std::string();
}

/// What a row has around it in a table of several data sets: their names, their units, and empty fields where this data
/// set has no loads.
struct Frame {
  std::string before, blanks, after;
};

Frame table_frame(const Dataset& data) {
  return {csv_field(data.name) + ',', data.has_loads ? "" : ",,,,",
          ',' + csv_field(data.display.force) + ',' + csv_field(data.display.area)};
}

void write_area_curve(std::ostringstream& out, const Analysis& result, const FitResult& fit, std::size_t curve,
                      const Frame& frame) {
  const Dataset& data = result.data;
  for (const StableState& state : stable_states(data, result.request.options, fit, curve, kCurvePoints))
    out << frame.before << to_string(data.metadata.provenance) << ',' << fit.model << ','
        << csv_field(data.curves[curve]) << ',' << shortest(data.curve_loads[curve] * data.display.force_scale) << ','
        << shortest(state.T * data.display.force_scale) << ',' << shortest(state.A * data.display.area_scale) << ','
        << shortest(state.psi) << ',' << shortest(state.f) << frame.after << '\n';
}

void write_toughness_curve(std::ostringstream& out, const Dataset& data, const FitResult& fit, const Frame& frame) {
  const double finite = std::numeric_limits<double>::max();
  for (const auto& [psi, f] : drawn_toughness(data, fit, 0.5 * pi<double>(), finite, kCurvePoints - 1))
    out << frame.before << to_string(data.metadata.provenance) << ',' << fit.model << frame.blanks << ','
        << shortest(psi) << ',' << shortest(f) << frame.after << '\n';
}

void write_residuals(std::ostringstream& out, const Analysis& result, const Frame& frame) {
  const Dataset& data = result.data;
  const DisplayUnits& units = data.display;
  for (const FitResult& fit : result.fits)
    for (std::size_t i = 0; i < fit.residuals.size(); ++i) {
      const Point& point = data.points[fit.used[i]];
      const auto toughness = data.toughness(fit.used[i]);
      out << frame.before << to_string(data.metadata.provenance) << ',' << fit.model << ','
          << data.line_in_file(point.line) << ',' << csv_field(data.curves[point.curve]) << ','
          << (toughness ? shortest(toughness->psi()) + ',' + shortest(toughness->ratio) : ",") << ','
          << shortest(fit.residuals[i]);
      if (data.has_loads) {
        out << ',' << shortest(point.P * units.force_scale) << ',' << shortest(point.T * units.force_scale) << ','
            << shortest(point.A * units.area_scale) << ',';
        if (fit.area && fit.area->areas[i]) out << shortest(*fit.area->areas[i] * units.area_scale);
      }
      out << frame.blanks << frame.after << '\n';
    }
}

void write_curves(std::ostringstream& out, const Analysis& result, const Frame& frame) {
  for (const FitResult& fit : result.fits) {
    if (!has_all_values(fit)) continue;
    if (!result.data.has_loads) {
      write_toughness_curve(out, result.data, fit, frame);
      continue;
    }
    for (std::size_t curve = 0; curve < result.data.curves.size(); ++curve)
      write_area_curve(out, result, fit, curve, frame);
  }
}

/// What was known of a constant, and its part in the budget; of the parameter that has the budget, the scatter's part.
std::string budget_fields(const FitResult& fit, const FittedParameter& parameter) {
  std::optional<double> share, pull;
  if (fit.budget && fit.budget->parameter == parameter.name) share = fit.budget->scatter;
  for (const BudgetPart& part : fit.budget ? fit.budget->parts : std::vector<BudgetPart>{})
    if (part.constant == parameter.name) std::tie(share, pull) = std::tuple(part.share, part.pull);
  const bool known = parameter.prior.has_value();
  return (known ? shortest(parameter.prior->mean) : "") + ',' +
         (known ? shortest(parameter.prior->standard_error) : "") + ',' + number(share) + ',' + number(pull);
}

std::string evidence_fields(const FitResult& fit, const FittedParameter& parameter) {
  if (!fit.evidence || fit.evidence->parameter != parameter.name) return ",,,,";
  const Evidence& evidence = fit.evidence->evidence;
  return shortest(evidence.log_evidence) + ',' + shortest(evidence.mean) + ',' + shortest(evidence.standard_deviation) +
         ',' + shortest(evidence.low) + ',' + shortest(evidence.high);
}

}  // namespace

std::string fits_csv(const std::vector<Analysis>& results) {
  std::ostringstream out;
  out << "dataset,provenance,model,objective,scale,status,parameter,value,stderr,lower,upper,at_bound,r2,rmse,"
         "max_abs_residual,area_r2,area_rmse,area_unit,area_unpredicted,notice,unit,low,high,low_status,high_status,"
         "paper_value,paper_status,paper_r2,prior_mean,prior_standard_error,variance_share,pull,"
         "log_evidence,posterior_mean,posterior_standard_deviation,credible_low,credible_high\n";
  for (const Analysis& result : results)
    for (const FitResult& fit : result.fits)
      for (const FittedParameter& parameter : fit.parameters) {
        out << csv_field(result.data.name) << ',' << to_string(result.data.metadata.provenance) << ',' << fit.model
            << ',' << to_string(fit.objective) << ',' << to_string(fit.scale) << ',' << to_string(fit.status) << ','
            << parameter.name << ',' << number(parameter.value) << ',' << number(parameter.stderr_) << ','
            << shortest(parameter.lower) << ',' << shortest(parameter.upper) << ',' << (parameter.at_bound ? 1 : 0)
            << ',' << number(fit.r2) << ',' << number(fit.rmse) << ',' << number(fit.max_abs_residual) << ',';
        if (fit.area && fit.area->predicted > 0)
          out << number(fit.area->r2) << ',' << shortest(fit.area->rmse) << ',';
        else
          out << ",,";
        out << csv_field(result.data.display.area) << ',' << (fit.area ? std::to_string(fit.area->unpredicted) : "")
            << ',' << csv_field(notice(result.data)) << ',' << parameter.unit << ',';
        if (parameter.interval)
          out << number(parameter.interval->low) << ',' << number(parameter.interval->high) << ','
              << to_string(parameter.interval->low_status) << ',' << to_string(parameter.interval->high_status);
        else
          out << ",,,";
        out << ',' << number(fit.paper ? fit.paper->value_of(parameter.name) : std::nullopt) << ','
            << (fit.paper ? to_string(fit.paper->status) : "") << ','
            << number(fit.paper ? fit.paper->r2 : std::nullopt) << ',' << budget_fields(fit, parameter) << ','
            << evidence_fields(fit, parameter) << '\n';
      }
  return out.str();
}

std::string residuals_csv(const Analysis& result) {
  const Dataset& data = result.data;
  const DisplayUnits& units = data.display;
  std::ostringstream out;
  out << "provenance,model,line,curve,psi [rad],Gc_over_GIc,residual";
  if (data.has_loads)
    out << ',' << bracketed("P", units.force) << ',' << bracketed("T", units.force) << ',' << bracketed("A", units.area)
        << ',' << bracketed("A_predicted", units.area);
  out << '\n';
  write_residuals(out, result, {});
  return out.str();
}

std::string curves_csv(const Analysis& result) {
  const DisplayUnits& units = result.data.display;
  std::ostringstream out;
  if (result.data.has_loads)
    out << "provenance,model,curve," << bracketed("P", units.force) << ',' << bracketed("T", units.force) << ','
        << bracketed("A", units.area) << ",psi [rad],f\n";
  else
    out << "provenance,model,psi [rad],f\n";
  write_curves(out, result, {});
  return out.str();
}

std::string residuals_table(const std::vector<Analysis>& results) {
  std::ostringstream out;
  out << "dataset,provenance,model,line,curve,psi [rad],Gc_over_GIc,residual,P,T,A,A_predicted,force_unit,area_unit\n";
  for (const Analysis& result : results) write_residuals(out, result, table_frame(result.data));
  return out.str();
}

std::string curves_table(const std::vector<Analysis>& results) {
  std::ostringstream out;
  out << "dataset,provenance,model,curve,P,T,A,psi [rad],f,force_unit,area_unit\n";
  for (const Analysis& result : results) write_curves(out, result, table_frame(result.data));
  return out.str();
}

}  // namespace mixity
