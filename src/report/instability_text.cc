#include "report/instability_text.h"

#include <algorithm>
#include <cmath>

#include "base/number_text.h"
#include "base/phrases.h"
#include "report/fields.h"

namespace mixity {
namespace {

using Row = std::vector<std::string>;

std::string number_text(const Derived& number, double scale) {
  if (!number.value) return "-";
  constexpr double kRounding = 1e-12;  // of a value that does not depend on what is fitted
  if (!number.standard_error || *number.standard_error <= kRounding * std::abs(*number.value))
    return rounded(*number.value * scale, 8);
  return with_error(*number.value * scale, *number.standard_error * scale);
}

/// Whether T reaches tau0 A before one of the folds.
bool slides_first(const InstabilityReport& report, const InstabilityReport::AtLoad& at) {
  return report.shear_strength &&
         std::any_of(at.predicted.folds.begin(), at.predicted.folds.end(), [&](const FoldPrediction& fold) {
           return *fold.T.value > *report.shear_strength * *fold.A.value;
         });
}

std::string control_text(const Control& control, const InstabilityUnits& units) {
  std::string text(to_string(control.kind));
  if (control.kind == Control::Kind::stiffness)
    text += " " + rounded(control.stiffness * units.stiffness_scale, 4) + unit_text(units.stiffness);
  return text;
}

/// Adds T, u and A of a fold or a closing.
template <class Place>
void add_place(Json& entry, const Place& place, const InstabilityUnits& units, bool errors) {
  const auto add = [&](const std::string& name, const Derived& number, double scale) {
    entry[name] = *number.value * scale;
    if (errors) entry[name + "_stderr"] = number.standard_error ? Json(*number.standard_error * scale) : Json();
  };
  add("T", place.T, units.force_scale);
  add("u", place.u, units.displacement_scale);
  add("A", place.A, units.area_scale);
}

Json closings_json(const FoldsPrediction& predicted, const InstabilityUnits& units, bool errors) {
  Json closings = Json::array();
  for (const ClosingPrediction& one : predicted.closings) {
    Json entry = {{"control", to_string(one.control.kind)}, {"end", to_string(one.end)}};
    add_place(entry, one, units, errors);
    closings.push_back(entry);
  }
  return closings;
}

Json folds_json(const FoldsPrediction& predicted, const InstabilityUnits& units, bool errors) {
  Json folds = Json::array();
  for (const FoldPrediction& fold : predicted.folds) {
    Json entry = {{"control", to_string(fold.control.kind)}};
    if (fold.control.kind == Control::Kind::stiffness)
      entry["stiffness"] = fold.control.stiffness * units.stiffness_scale;
    entry["met_on"] = fold.on_loading ? "loading" : "reversal";
    add_place(entry, fold, units, errors);
    entry["psi"] = fold.psi;
    entry["jumps_to"] = to_string(fold.jumps_to);
    entry["area_lost"] = (*fold.A.value - fold.area_after) * units.area_scale;
    folds.push_back(entry);
  }
  return folds;
}

}  // namespace

std::string to_text(const InstabilityReport& report) {
  const InstabilityUnits& units = report.units;
  std::string text = "[[Instabilities]] model " + report.model;
  for (const auto& [name, number] : report.parameters) text += ", " + name + " = " + number_text(number, 1);
  if (report.stated.mode_III != ModeIII::unstated) text += ", mode III " + mode_III_text(report.stated);
  text += (report.source.empty() ? "" : ", " + report.source) + (units.force.empty() ? " (dimensionless)\n" : "\n");
  const bool approach = report.stated.control == NormalControl::approach;
  const std::string load = approach ? bracketed("delta", units.held) : bracketed("P", units.force);
  std::vector<Row> rows{{load, "control", "met on", bracketed("T", units.force), bracketed("u", units.displacement),
                         bracketed("A", units.area), "psi [rad]", "jumps to", bracketed("area lost", units.area)}};
  std::string without;
  for (const InstabilityReport::AtLoad& one : report.loads) {
    const FoldsPrediction& predicted = one.predicted;
    for (const ClosingPrediction& one_end : predicted.closings)
      without += "    " + load + " = " + rounded(one.load, 6) + ", " + control_text(one_end.control, units) +
                 ": the edge closes or slips at the ends of " + (one_end.end == EllipseEnd::closes_along ? "a" : "b") +
                 ", where K_I is 0, before any fold: at T = " + number_text(one_end.T, units.force_scale) +
                 unit_text(units.force) + ", u = " + number_text(one_end.u, units.displacement_scale) +
                 unit_text(units.displacement) + ", A = " + number_text(one_end.A, units.area_scale) +
                 unit_text(units.area) + '\n';
    if (predicted.folds.empty() && predicted.closings.empty())
      without += "    " + load + " = " + rounded(one.load, 6) + ": " +
                 (predicted.problem.empty() ? "none" : predicted.problem) + '\n';
    if (slides_first(report, one))
      without += "    " + load + " = " + rounded(one.load, 6) +
                 ": the interface slides first, as T = tau0 A is met before with the stated shear strength\n";
    for (const FoldPrediction& fold : predicted.folds)
      rows.push_back({rounded(one.load, 6), control_text(fold.control, units), fold.on_loading ? "loading" : "reversal",
                      number_text(fold.T, units.force_scale), number_text(fold.u, units.displacement_scale),
                      number_text(fold.A, units.area_scale), rounded(fold.psi, 7),
                      std::string(to_string(fold.jumps_to)),
                      rounded((*fold.A.value - fold.area_after) * units.area_scale, 8)});
  }
  return text + (rows.size() > 1 ? aligned(rows, "    ") : "") + without;
}

std::string to_json(const InstabilityReport& report) {
  const InstabilityUnits& units = report.units;
  const bool fitted = !report.source.empty();
  Json document = {{"model", report.model}}, parameters = Json::object();
  if (fitted) document["source"] = report.source;
  for (const auto& [name, number] : report.parameters) {
    if (!fitted) document[name] = *number.value;
    parameters[name] = {{"value", *number.value}, {"stderr", json_of(number.standard_error)}};
  }
  if (fitted) document["parameters"] = parameters;
  document["mode_III"] = to_string(report.stated.mode_III);
  if (!units.force.empty())
    document["units"] = {{"force", units.force},
                         {"displacement", units.displacement},
                         {"area", units.area},
                         {"stiffness", units.stiffness}};
  if (report.stated.control == NormalControl::approach) {  // what the field load of each entry is
    document["control"] = to_string(report.stated.control);
    if (!units.held.empty()) document["units"]["approach"] = units.held;
  }
  Json loads = Json::array(), sliding = Json::array();
  for (const InstabilityReport::AtLoad& one : report.loads) {
    Json entry = {{"load", one.load}, {"folds", folds_json(one.predicted, units, fitted)}};
    if (!one.predicted.problem.empty()) entry["problem"] = one.predicted.problem;
    if (!one.predicted.closings.empty()) entry["closings"] = closings_json(one.predicted, units, fitted);
    loads.push_back(entry);
    if (slides_first(report, one)) sliding.push_back(one.load);
  }
  if (report.shear_strength) document["slides_first"] = sliding;
  if (fitted)
    document["loads"] = loads;
  else
    document.update(loads.at(0));
  return document.dump(2) + "\n";
}

}  // namespace mixity
