#include "explorer/experiment.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

#include "analysis/judgement.h"
#include "analysis/model_curves.h"
#include "analysis/readable.h"
#include "analysis/readers_units.h"
#include "base/number_text.h"
#include "base/units.h"
#include "explorer/drawing.h"
#include "explorer/field_words.h"
#include "fitting/predicted_curves.h"
#include "fitting/prediction.h"
#include "mechanics/contact_model.h"

namespace mixity::explorer {
namespace {

constexpr std::size_t kMostExcluded = 20;  // listed on a page

Json runs_of(const Dataset& data) {
  Json runs = Json::array();
  const auto by_run = points_by_curve(data);
  for (std::size_t run = 0; run < by_run.size(); ++run) {
    runs.push_back(
        {{"name", data.curves[run]},
         {"P", data.curve_loads[run] * data.held_scale()},
         {"lines", list_of(by_run[run], [&](std::size_t i) { return data.points[i].line; })},
         {"T", list_of(by_run[run], [&](std::size_t i) { return data.points[i].T * data.display.force_scale; })},
         {"A", list_of(by_run[run], [&](std::size_t i) { return data.points[i].A * data.display.area_scale; })}});
    if (!data.axes.empty())
      runs.back()["axes"] = list_of(by_run[run], [&](std::size_t i) { return std::exp(data.axes[i].q); });
  }
  return runs;
}

/// The page draws pull-off loads over what the first of them holds.
HeldShear held_shear(const Dataset& data) { return data.pull_off.front().held; }

double shear_scale(const Dataset& data) {
  return held_shear(data) == HeldShear::load ? data.display.force_scale : data.display.length_scale;
}

Json pull_off_of(const Dataset& data) {
  Json points = Json::array();
  for (const PullOffReading& one : data.pull_off)
    if (one.held == held_shear(data))
      points.push_back({std::abs(one.shear) * shear_scale(data), one.P * data.display.force_scale, one.line});
  const bool by_load = held_shear(data) == HeldShear::load;
  return {
      {"points", points}, {"held", by_load ? "T" : "u"}, {"unit", by_load ? data.display.force : data.display.length}};
}

Json pull_off_curve(const Analysis& result, const FitResult& fit) {
  const Dataset& data = result.data;
  double most = 0;
  for (const PullOffReading& one : data.pull_off) most = std::max(most, std::abs(one.shear));
  Json curve = Json::array();
  for (const auto& [shear, P] : drawn_pull_off(data, result.request.options, fit, held_shear(data), 1.05 * most))
    curve.push_back({shear * shear_scale(data), P * data.display.force_scale});
  return curve;
}

/// Residuals against T, or against psi where there are no loads.
Json residuals_of(const Dataset& data, const FitResult& fit) {
  Json residuals = Json::array();
  for (std::size_t k = 0; k < std::min(fit.residuals.size(), fit.used.size()); ++k) {
    const std::size_t i = fit.used[k];
    const Point& point = data.points[i];
    const double x = data.has_loads ? point.shear() * data.display.force_scale : data.converted[i].psi();
    residuals.push_back({point.curve, x, fit.residuals[k], point.line});
  }
  return residuals;
}

/// The model's areas at the load of a run up to a tangential load, with a band of one standard error.
Json band_of(const Analysis& result, const FitResult& fit, std::size_t run, double T_most) {
  constexpr int kSteps = 40;
  const double sign = result.data.sign_of_shear(run);
  std::vector<double> P(kSteps + 1, result.data.curve_loads[run]), T;
  for (int i = 0; i <= kSteps; ++i) T.push_back(sign * T_most * i / kSteps);
  Json band = Json::array();
  const DisplayUnits& units = result.data.display;
  const auto areas = predict_areas_of(result.data, fit, result.request.options, P, T);
  for (std::size_t i = 0; i < areas.size(); ++i)
    if (areas[i].standard_error)
      band.push_back({sign * T[i] * units.force_scale, (areas[i].A - *areas[i].standard_error) * units.area_scale,
                      (areas[i].A + *areas[i].standard_error) * units.area_scale});
  return band;
}

Json model_of(const Analysis& result, const FitResult& fit) {
  const Dataset& data = result.data;
  const bool errors = fit.known_errors || fit.objective == Objective::curve;
  Json drawn{{"model", fit.model},
             {"residuals", residuals_of(data, fit)},
             {"residual_unit", errors                    ? "standard errors"
                               : fit.scale == Scale::log ? "ln(Gc/GIc)"
                                                         : "Gc/GIc"}};
  drawn["toughness"] = drawn_toughness(data, fit, 0.5 * pi<double>(), 1e4, 120);
  if (fit.pull_off > 0) drawn["pull_off"] = pull_off_curve(result, fit);
  if (!data.has_loads) {
    // what makes a measured ratio one over the toughness that was fitted
    const std::vector<double> of_runs = over_fitted_toughness(data, fit);
    drawn["over"] = list_of(data.points, [&](const Point& point) { return of_runs[point.curve]; });
    return drawn;
  }
  const auto by_run = points_by_curve(data);
  Json runs = Json::array();
  for (std::size_t run = 0; run < by_run.size(); ++run) {
    double largest = 0;
    for (const std::size_t i : by_run[run]) largest = std::max(largest, data.points[i].shear());
    const DrawnCurve curve = drawn_curve(result.data, result.request.options, fit, data.curve_loads[run], 1.4 * largest,
                                         data.sign_of_shear(run));
    Json stable = Json::array(), unstable = Json::array(), folds = Json::array();
    for (const DrawnPoint& q : curve.points) (q.stable && unstable.empty() ? stable : unstable).push_back({q.T, q.A});
    for (const DrawnFold& fold : curve.folds)
      if (fold.control == Control::Kind::load) folds.push_back({fold.T, fold.A});
    runs.push_back({{"P", data.curve_loads[run] * data.held_scale()},
                    {"curve", stable},
                    {"unstable", unstable},
                    {"band", band_of(result, fit, run, 1.4 * largest)},
                    {"folds", folds}});
    if (is_elliptic(fit.model)) {
      Json& axes = runs.back()["axes"] = Json::array();
      for (const auto& [T, ratio] : drawn_axes(data, result.request.options, fit, run))
        axes.push_back({T * data.display.force_scale, ratio});
    }
  }
  drawn["runs"] = std::move(runs);
  return drawn;
}

/// "λ_II = 0.0203 ± 0.0005", in a unit that suits the value.
std::string parameter_text(const FittedParameter& fitted) {
  const FittedParameter one = readable(fitted);
  const std::string name = parameter_in_text(one.name) + " = ", unit = unit_text(one.unit);
  if (!one.value) return name + "not determined";
  if (!one.stderr_) return name + rounded(*one.value, 5) + unit + (one.held ? " (held)" : "");
  const auto [value, error] = rounded_to_error(*one.value, *one.stderr_);
  return name + value + " ± " + error + unit;
}

/// "2.133 MPa +/- 0.1 MPa": short, for a field of a form.
std::string as_typed(double value, double error, const std::string& unit) {
  const ReadableUnit shown = unit == "N" ? ReadableUnit{1e3, "mN"} : readable_unit(value, unit);
  const auto text = [&](double one, int digits) { return rounded(one * shown.factor, digits) + " " + shown.unit; };
  return text(value, 10) + (error > 0 ? " +/- " + text(error, 4) : "");
}

}  // namespace

Json as_read(const Dataset& data) {
  Json told{
      {"reading", data.reading},
      {"taken", data.taken},
      {"ignored", data.ignored_columns},
      {"notes", list_of(data.notes, [](const Message& note) { return note.text(in_fields); })},
      {"points", data.points.size()},
      {"rows", data.rows},
      {"units", {{"force", data.display.force}, {"area", data.display.area}}},
      {"held",
       {{"approach", data.holds_approach()}, {"name", data.holds_approach() ? "δ" : "P"}, {"unit", data.held_unit()}}},
      {"notice", data.metadata.provenance == Provenance::reconstructed ? kReconstructedNotice : ""}};
  Json constants = Json::object();
  const std::span<const Excluded> listed(data.excluded.data(), std::min(data.excluded.size(), kMostExcluded));
  const Metadata& stated = data.metadata;
  for (const auto& [name, text] : constants_as_stated(stated)) constants[name] = {{"exact", text}, {"shown", text}};
  for (const auto& [name, value, unit] :
       {std::tuple("radius", stated.radius, "m"), std::tuple("modulus", stated.modulus, "Pa"),
        std::tuple("toughness", stated.toughness, "J/m^2"), std::tuple("shear_strength", stated.shear_strength, "Pa"),
        std::tuple("load_offset", stated.load_offset, "N"), std::tuple("shear_offset", stated.shear_offset, "N"),
        std::tuple("approach_offset", stated.approach_offset, "m"),
        std::tuple("normal_stiffness", stated.normal_stiffness, "N/m")})
    if (value) constants[name]["shown"] = as_typed(*value, stated.standard_error(name), unit);
  told["excluded"] = list_of(listed, [&](const Excluded& one) {
    return Json{{"where", data.line_text(one.line)}, {"reason", one.reason}};
  });
  told["files"] = list_of(data.files, [](const SourceFile& file) {
    return Json{{"name", file.path.substr(file.path.find_last_of('/') + 1)}, {"first_line", file.first_line}};
  });
  told["excluded_count"] = data.excluded.size();
  told["constants"] = constants;
  if (!data.pull_off.empty()) told["pull_off"] = pull_off_of(data);
  if (data.has_loads) {
    told["runs"] = runs_of(data);
    return told;
  }
  told["energies"] = {{"lines", list_of(data.points, &Point::line)},
                      {"psi", list_of(data.converted, &ToughnessPoint::psi)},
                      {"f", list_of(data.converted, &ToughnessPoint::ratio)}};
  return told;
}

Json as_told(const Answer& answer, const Dataset& data) {
  return {{"result", answer.result},        {"model", answer.model},   {"interval", answer.interval},
          {"doubt", answer.doubt},          {"budget", answer.budget}, {"jumps", jump_table(answer, data)},
          {"cannot_say", answer.cannot_say}};
}

Json as_advised(const Analysis& result) {
  Json advice = Json::array();
  for (const std::size_t i : by_merit(result)) {
    const FitResult& fit = result.fits[i];
    if (const Json buttons = buttons_of(fit.message); !buttons.empty())
      advice.push_back({{"model", fit.model}, {"text", fit.message.text(in_fields)}, {"buttons", buttons}});
  }
  return advice;
}

Json as_listed(const Analysis& result) {
  const auto shown = in_readers_units(result);
  Json listed = Json::object();
  for (const FitResult& fit : (shown ? *shown : result).fits)
    listed[fit.model] = list_of(fit.parameters, parameter_text);
  return listed;
}

Json as_drawn(const Analysis& result) {
  Json models = Json::array();
  for (const std::size_t i : by_merit(result))
    if (has_all_values(result.fits[i])) models.push_back(model_of(result, result.fits[i]));
  Json drawn{{"models", models}};
  if (const auto& contact = result.data.contact)
    drawn["contact"] = {{"radius", contact->radius},
                        {"modulus", contact->modulus},
                        {"toughness", contact->toughness},
                        {"mN", 1e3 * contact->force_unit() / result.data.display.force_scale},
                        {"mm2", 1e6 * contact->area_unit() / result.data.display.area_scale}};
  return drawn;
}

}  // namespace mixity::explorer
