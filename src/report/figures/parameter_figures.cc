#include <algorithm>
#include <cmath>

#include "analysis/readable.h"
#include "base/files.h"
#include "base/number_text.h"
#include "dataset/display_units.h"
#include "fitting/predicted_curves.h"
#include "report/figures/data_figures.h"

namespace mixity {
namespace {

Figure profile_figure(const std::string& stem, const FitResult& fit, const FittedParameter& parameter) {
  const auto& [points, level] = *parameter.profile;
  const double first = points.front().first, last = points.back().first;
  double highest = level;
  for (const auto& [x, rise] : points) highest = std::max(highest, rise);
  const std::string suffix = parameter.name == "lambda" ? "" : "_" + plain_file_name(parameter.name);
  Figure figure{
      .name = stem + "_profile_" + fit.model + suffix,
      .title = "Profile of the cost along " + parameter.name + ", model " + fit.model,
      .x = {bracketed(parameter_symbol(parameter.name), parameter.unit), first, last},
      .y = {"rise of the cost/variance", 0.0, 1.05 * std::min(highest, 6 * level)},
      .series = {{"profile", model_line(fit.model), model_color(fit.model), points}},
      .caption = "How fast the fit worsens away from the best " + parameter.name +
                 "; circles are the ends of the interval. Where the profile leaves the parabola, the standard error "
                 "says less than the interval."};
  if (parameter.stderr_ && *parameter.stderr_ > 0) {
    Series parabola{"parabola of the standard error", Look::dotted, color(7)};
    for (const auto& [x, rise] : points)
      parabola.points.emplace_back(x, std::pow((x - *parameter.value) / *parameter.stderr_, 2));
    figure.series.push_back(std::move(parabola));
  }
  if (!parameter.interval) return figure;
  const std::string percent = rounded(100 * parameter.interval->confidence, 4) + " %";
  figure.series.push_back({percent, Look::dashed, color(5), {{first, level}, {last, level}}});
  Series ends{"", Look::circles, color(1)};
  for (const auto& end : {parameter.interval->low, parameter.interval->high})
    if (end) ends.points.emplace_back(*end, level);
  figure.series.push_back(std::move(ends));
  return figure;
}

/// Null if no run determines the parameter.
std::optional<Figure> run_figure(const ReportedData& reported, const PerCurve& per_curve, const FitResult& fit,
                                 const FittedParameter& pooled) {
  const DrawnUnits units(reported.result.data);
  Series runs{"each run", model_symbol(fit.model), model_color(fit.model)};
  double first = 1e300, last = -1e300;
  for (const CurveFit& one : per_curve.curves) {
    const FittedParameter* own = leading_parameter(one.fit);
    if (!own || !own->value) continue;
    const double P = one.P * units.held, value = *own->value;
    const double low = own->interval ? own->interval->low.value_or(value) : value;
    const double high = own->interval ? own->interval->high.value_or(value) : value;
    runs.points.emplace_back(P, value);
    runs.bars.push_back({P, P, low, high});
    runs.hover.push_back("run " + one.curve + ": " + own->name + " = " + rounded(value, 4) + " (" + rounded(low, 3) +
                         " .. " + rounded(high, 3) + "), " + std::to_string(one.fit.used.size()) + " points, " +
                         std::string(to_string(one.fit.status)));
    first = std::min(first, P);
    last = std::max(last, P);
  }
  if (runs.points.empty()) return std::nullopt;
  const double margin = last > first ? 0.05 * (last - first) : 1;
  first -= margin;
  last += margin;
  Figure figure{
      .name = reported.stem + "_runs_" + fit.model,
      .title = "Each run by itself: " + pooled.name + " against normal load, model " + fit.model,
      .x = {units.P(), first, last},
      .y = {bracketed(parameter_symbol(pooled.name), pooled.unit)},
      .caption = "Bars are the intervals of single runs, the line and its band the value for all runs together."};
  if (pooled.interval && pooled.interval->low && pooled.interval->high) {
    const double low = *pooled.interval->low, high = *pooled.interval->high;
    figure.series.push_back(band("", color(5), {{first, low}, {last, low}}, {{first, high}, {last, high}}));
  }
  figure.series.push_back({"all runs", Look::solid, color(5), {{first, *pooled.value}, {last, *pooled.value}}});
  figure.series.push_back(std::move(runs));
  if (per_curve.test)
    figure.caption += std::string(per_curve.test->p_value < 0.05 ? " The runs do not share one value"
                                                                 : " The runs are consistent with one value") +
                      " (p = " + rounded(per_curve.test->p_value, 2) + ").";
  return figure;
}

}  // namespace

std::vector<Figure> profile_figures(const ReportedData& reported) {
  std::vector<Figure> figures;
  for (const FitResult& fit : reported.result.fits)
    for (const FittedParameter& parameter : fit.parameters)
      if (parameter.profile && parameter.profile->points.size() > 2)
        figures.push_back(profile_figure(reported.stem, fit, readable(parameter)));
  return figures;
}

std::vector<Figure> run_figures(const ReportedData& reported) {
  std::vector<Figure> figures;
  if (!reported.result.data.has_loads) return figures;
  for (const PerCurve& per_curve : reported.result.per_curve)
    for (const FitResult& fit : reported.result.fits) {
      const FittedParameter* pooled = leading_parameter(fit);
      if (fit.model != per_curve.model || !pooled || !pooled->value) continue;
      if (auto figure = run_figure(reported, per_curve, fit, *pooled)) figures.push_back(std::move(*figure));
    }
  return figures;
}

std::vector<Figure> left_out_figures(const ReportedData& reported) {
  const Dataset& data = reported.result.data;
  const DrawnUnits units(data);
  Figure figure{.name = reported.stem + "_left_out",
                .title = "Error in the area at loads left out of the fit",
                .x = {units.P()},
                .y = {"RMS error in " + units.A(), {}, {}, true},
                .caption = "Each load is predicted by a fit of the others: the model that is lowest predicts best."};
  for (const ComparedModel& model : reported.result.comparison) {
    if (!model.left_out) continue;
    Series series{"model " + model.model, model_symbol(model.model), model_color(model.model)};
    for (const LeftOut::Run& run : model.left_out->runs) {
      if (!(run.rmse_area > 0)) continue;
      series.points.emplace_back(run.P * units.held, run.rmse_area);
      series.hover.push_back("model " + model.model + " without run " + run.curve + ": RMS error " +
                             with_unit(run.rmse_area, 3, units.area_unit) + " over " + std::to_string(run.points) +
                             " points, " + std::to_string(run.beyond_fold) + " past the fold");
    }
    figure.series.push_back(std::move(series));
  }
  return figure.series.empty() ? std::vector<Figure>() : std::vector<Figure>{std::move(figure)};
}

}  // namespace mixity
