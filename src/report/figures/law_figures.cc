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
  Series measured{"each run", Look::circles, color(0), {}},
      model{"model " + reported.sahli_model, model_line(reported.sahli_model), color(2), {}};
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
  Figure figure{reported.stem + "_alpha_A0",
                "Reduction parameter alpha of A = A0 - alpha T^2 against initial area A0",
                {units.area_unit.empty() ? "A_0 ξ^2/R^2" : "A_0 [" + units.area_unit + "]", first, last, true},
                {"α" + unit, {}, {}, true},
                {line(-1.25, "exponent -5/4", Look::dashed), line(-1.5, "exponent -3/2", Look::dotted)}};
  figure.series.push_back(std::move(measured));
  figure.series.push_back(std::move(model));
  figure.caption =
      "Parabolas fitted to the first half of each run. The grey lines pass through the mean of the points; "
      "fracture mechanics predicts -5/4 for large areas, Sahli et al. (2018) found -3/2.";
  if (reported.sahli->power_law) {
    figure.caption += " Here the exponent is " + rounded(reported.sahli->power_law->exponent, 3);
    if (reported.sahli->power_law->exponent_stderr)
      figure.caption += " +/- " + rounded(*reported.sahli->power_law->exponent_stderr, 2);
    figure.caption += ".";
  }
  return {figure};
}

std::vector<Figure> peak_figures(const PeakForces& forces, const std::string& stem,
                                 const std::vector<PredictedPeaks>& predicted) {
  // the first cycle of each load, which a fold can foretell, apart from what follows
  Series peak{"first maximum", Look::triangles, color(1), {}},
      minimum{"following minimum", Look::circles, color(2), {}},
      later_peak{"maxima of later cycles", Look::triangles, color(7), {}},
      later_minimum{"their minima", Look::circles, color(7), {}};
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
  Figure figure{stem + "_peaks",
                "Mean shear stress over the area of Hertz against normal load",
                {bare ? "P/(R G_{Ic})" : "P [" + forces.force_unit + "]", 0.0, {}},
                {bare ? "T/A_{Hertz} ξ/E^*" : "T/A_{Hertz}  [" + forces.stress_unit + "]", 0.0, {}},
                {}};
  const auto spread = [](const Series& series) {
    double low = 1e300, high = 0;
    for (const auto& [x, y] : series.points) {
      low = std::min(low, y);
      high = std::max(high, y);
    }
    return rounded(high / low, 3);
  };
  figure.caption = "A stress that does not depend on the load is a strength.";
  for (const Series* series : {&peak, &minimum})
    if (series->points.size() > 1)
      figure.caption += " At the " + series->label + " of each load it varies by a factor of " + spread(*series) + ".";
  for (const PredictedPeaks& model : predicted) {
    Series band{"", Look::band, model_color(model.model), {}},
        line{"jump of model " + model.model, model_line(model.model), model_color(model.model), {}};
    for (const PredictedPeak& load : model.loads) {
      line.points.emplace_back(load.P, load.stress);
      band.points.emplace_back(load.P, load.low);
    }
    for (auto load = model.loads.rbegin(); load != model.loads.rend(); ++load)
      band.points.emplace_back(load->P, load->high);
    figure.series.push_back(std::move(band));
    figure.series.push_back(std::move(line));
    if (model.ratio)
      figure.caption += " First maxima are " + rounded(*model.ratio, 3) + " +/- " + rounded(*model.ratio_error, 2) +
                        " of the jump that model " + model.model + " predicts.";
  }
  for (Series* series : {&later_peak, &later_minimum, &peak, &minimum})
    if (!series->points.empty()) figure.series.push_back(std::move(*series));
  return {figure};
}

}  // namespace mixity
