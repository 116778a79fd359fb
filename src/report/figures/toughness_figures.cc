#include <algorithm>
#include <cmath>

#include "analysis/readable.h"
#include "base/number_text.h"
#include "dataset/display_units.h"
#include "fitting/predicted_curves.h"
#include "report/figures/data_figures.h"

namespace mixity {
namespace {

Points in_degrees(Points curve) {
  for (auto& point : curve) point.first = degrees(point.first);
  return curve;
}

}  // namespace

std::vector<Figure> toughness_figures(const ReportedData& reported) {
  const Analysis& result = reported.result;
  const Dataset& data = result.data;
  const ToughnessRange& range = reported.figured.toughness;
  std::vector<std::size_t> all;
  bool errors = false;
  for (std::size_t i = 0; i < data.points.size(); ++i)
    if (data.toughness(i)) {
      all.push_back(i);
      errors |= data.errors_of(i).ratio > 0;
    }
  if (all.empty()) return {};
  const std::vector<std::size_t> shown = shown_points(all);
  Series points{"data", Look::circles, color(7)};
  const auto& models = reported.figured.models;
  const std::vector<double> over =
      models.empty() ? std::vector<double>(data.curves.size(), 1) : over_fitted_toughness(data, *models.front().fit);
  const bool rescaled = std::any_of(over.begin(), over.end(), [](double one) { return one != 1; });
  for (const std::size_t i : shown) {
    const double factor = over[data.points[i].curve], psi = degrees(data.toughness(i)->psi()),
                 ratio = factor * data.toughness(i)->ratio, error = factor * data.errors_of(i).ratio;
    points.points.emplace_back(psi, ratio);
    points.hover.push_back(point_hover(data, i));
    if (errors) points.bars.push_back({psi, psi, std::max(ratio - error, 0.5 * range.least), ratio + error});
  }
  std::vector<Series> bands, lines;
  for (const ModelCurves& model : reported.figured.models) {
    const std::string& key = model.fit->model;
    if (const auto& ends = model.toughness_band)
      bands.insert(bands.begin(), band("", model_color(key), in_degrees(ends->first), in_degrees(ends->second)));
    if (std::none_of(model.toughness.begin(), model.toughness.end(),
                     [](const auto& q) { return std::isfinite(q.second); }))
      continue;  // of ellipses, which have two phase angles
    const FittedParameter* leading = leading_parameter(*model.fit);
    lines.push_back(
        {"model " + key + (leading ? ", " + parameter_symbol(leading->name) + " = " + rounded(*leading->value, 4) : ""),
         model_line(key), model_color(key), in_degrees(model.toughness)});
  }
  if (lines.empty() && !reported.figured.models.empty()) return {};
  const double least = range.logarithmic ? 0.8 * range.least : std::max(0.0, 0.9 * range.least);
  Figure figure{
      .name = reported.stem + "_toughness",
      .title = "Toughness ratio against phase angle",
      .x = {"ψ [°]", 0.0, range.last_psi > 0 ? degrees(range.last_psi) : 90},
      .y = {"f = G_c/G_{Ic}", least, range.most, range.logarithmic},
      .series = bands,
      .key_place = KeyPlace::top_left,
      .caption = std::to_string(all.size()) + " points and the fitted models" +
                 (bands.empty() ? "" : "; bands span the intervals of the parameters") +
                 (data.has_loads ? ". Both axes are computed from the same area, so that almost any model looks good "
                                   "here: judge by the areas."
                                 : ".") +
                 shown_note(shown.size(), all.size()) +
                 (rescaled ? " Points are over the toughness that model " + models.front().fit->model + " found."
                  : result.request.options.free.empty()
                      ? ""
                      : " Points are computed with the stated constants, not with those that were fitted.")};
  figure.series.insert(figure.series.end(), lines.begin(), lines.end());
  figure.series.push_back(std::move(points));
  return {figure};
}

}  // namespace mixity
