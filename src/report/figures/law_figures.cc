#include <algorithm>
#include <cmath>

#include "analysis/predicted_peaks.h"
#include "base/number_text.h"
#include "dataset/display_units.h"
#include "report/figures/data_figures.h"

namespace mixity {

std::vector<Figure> sahli_figures(const ReportedData& reported) {
  if (!reported.sahli) return {};
  const Dataset& data = reported.result.data;
  const DrawnUnits units(data);
  const double alpha_scale = units.area / (units.force * units.force);
  Series measured{"each run", Look::circles, color(0)},
      model{"model " + reported.sahli_model, model_line(reported.sahli_model), model_color(reported.sahli_model)};
  double log_A = 0, log_alpha = 0;
  for (const SahliRun& run : reported.sahli->runs) {
    if (!(run.alpha > 0 && run.A0 > 0)) continue;
    const double A0 = run.A0 * units.area, alpha = run.alpha * alpha_scale;
    const double dA = run.A0_stderr.value_or(0) * units.area, d = run.alpha_stderr.value_or(0) * alpha_scale;
    measured.points.emplace_back(A0, alpha);
    measured.bars.push_back({A0 - dA, A0 + dA, std::max(alpha - d, 0.1 * alpha), alpha + d});
    measured.hover.push_back("run " + run.curve + ": A0 = " + with_unit(A0, 4, units.area_unit) +
                             ", alpha = " + rounded(alpha, 4) + ", " + std::to_string(run.points) + " points");
    log_A += std::log(A0);
    log_alpha += std::log(alpha);
    if (run.alpha_predicted && *run.alpha_predicted > 0)
      model.points.emplace_back(A0, *run.alpha_predicted * alpha_scale);
  }
  if (measured.points.size() < 2) return {};
  std::sort(model.points.begin(), model.points.end());
  const auto n = static_cast<double>(measured.points.size());
  const auto [least, most] = std::minmax_element(measured.points.begin(), measured.points.end());
  const double first = 0.8 * least->first, last = 1.25 * most->first;
  const auto line = [&](double exponent, const char* label, Look look) {
    const auto at = [&](double A0) { return std::exp(log_alpha / n + exponent * (std::log(A0) - log_A / n)); };
    return Series{label, look, color(7), {{first, at(first)}, {last, at(last)}}};
  };
  const std::string unit = units.area_unit.empty() ? "" : " [" + units.area_unit + "/" + units.force_unit + "^2]";
  std::string exponent;
  if (const auto& law = reported.sahli->power_law)
    exponent = " Here the exponent is " + rounded(law->exponent, 3) +
               (law->exponent_stderr ? " +/- " + rounded(*law->exponent_stderr, 2) : "") + ".";
  return {{.name = reported.stem + "_alpha_A0",
           .title = "Reduction parameter alpha of A = A0 - alpha T^2 against initial area A0",
           .x = {units.area_unit.empty() ? "A_0 ξ^2/R^2" : "A_0 [" + units.area_unit + "]", first, last, true},
           .y = {"α" + unit, {}, {}, true},
           .series = {line(-1.25, "exponent -5/4", Look::dashed), line(-1.5, "exponent -3/2", Look::dotted), measured,
                      model},
           .caption = "Parabolas fitted to the first half of each run. The grey lines pass through the mean of the "
                      "points; fracture mechanics predicts -5/4 for large areas, Sahli et al. (2018) found -3/2." +
                      exponent}};
}

std::vector<Figure> peak_figures(const ReportedData& reported) {
  if (!reported.peaks) return {};
  const PeakForces& forces = *reported.peaks;
  // the first cycle of each load, which a fold can predict, separate from later cycles
  Series peak{"first maximum", Look::triangles, color(1)}, minimum{"following minimum", Look::circles, color(2)},
      later_peak{"maxima of later cycles", Look::triangles, color(7)},
      later_minimum{"their minima", Look::circles, color(7)};
  const auto add = [&](Series& first, Series& later, std::optional<double> PeakForce::*stress) {
    const auto firsts = first_of_loads(forces, stress);
    for (const PeakForce& row : forces.rows) {
      if (!(row.*stress)) continue;
      Series& series = std::find(firsts.begin(), firsts.end(), &row) == firsts.end() ? later : first;
      series.points.emplace_back(row.P, *(row.*stress));
      series.hover.push_back("line " + std::to_string(row.line) + ": P = " + with_unit(row.P, 5, forces.force_unit) +
                             ", " + series.label + " T/A_Hertz = " + with_unit(*(row.*stress), 4, forces.stress_unit));
    }
  };
  add(peak, later_peak, &PeakForce::peak);
  add(minimum, later_minimum, &PeakForce::minimum);
  if (peak.points.empty() && minimum.points.empty()) return {};
  const bool bare = forces.force_unit.empty();
  Figure figure{.name = reported.stem + "_peaks",
                .title = "Mean shear stress over the area of Hertz against normal load",
                .x = {bare ? "P/(R G_{Ic})" : "P [" + forces.force_unit + "]", 0.0, {}},
                .y = {bare ? "T/A_{Hertz} ξ/E^*" : "T/A_{Hertz}  [" + forces.stress_unit + "]", 0.0, {}},
                .caption = "If this stress does not depend on the load, it is the shear strength of the interface."};
  for (const Series* series : {&peak, &minimum}) {
    if (series->points.size() < 2) continue;
    const auto [low, high] = std::minmax_element(series->points.begin(), series->points.end(),
                                                 [](const auto& a, const auto& b) { return a.second < b.second; });
    figure.caption += " At the " + series->label + " of each load it varies by a factor of " +
                      rounded(high->second / low->second, 3) + ".";
  }
  for (const PredictedPeaks& model : reported.predicted_peaks) {
    if (model.loads.size() < 2) continue;  // no line
    Points jump, lower, upper;
    for (const PredictedPeak& load : model.loads) {
      jump.emplace_back(load.P, load.stress);
      lower.emplace_back(load.P, load.low);
      upper.emplace_back(load.P, load.high);
    }
    figure.series.push_back(band("", model_color(model.model), lower, upper));
    figure.series.push_back({"jump of model " + model.model, model_line(model.model), model_color(model.model), jump});
    if (model.ratio)
      figure.caption += " First maxima are " + rounded(*model.ratio, 3) + " +/- " + rounded(*model.ratio_error, 2) +
                        " of the jump that model " + model.model + " predicts.";
  }
  for (Series* series : {&later_peak, &later_minimum, &peak, &minimum})
    if (!series->points.empty()) figure.series.push_back(std::move(*series));
  return {figure};
}

}  // namespace mixity
