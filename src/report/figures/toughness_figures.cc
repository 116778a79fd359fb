#include <algorithm>
#include <cmath>

#include "analysis/readable.h"
#include "base/number_text.h"
#include "dataset/display_units.h"
#include "fitting/predicted_curves.h"
#include "report/figures/data_figures.h"

namespace mixity {
std::vector<Figure> toughness_figures(const ReportedData& reported) {
  const Analysis& result = reported.result;
  const Dataset& data = result.data;
  const ToughnessRange& range = reported.figured.toughness;
  Series points{"data", Look::circles, color(7), {}};
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < data.points.size(); ++i)
    if (data.toughness(i)) all.push_back(i);
  if (all.empty()) return {};
  bool errors = false;
  for (const std::size_t i : all) errors |= data.errors_of(i).ratio > 0;
  for (const std::size_t i : shown_points(all)) {
    const double psi = data.toughness(i)->psi(), ratio = data.toughness(i)->ratio, error = data.errors_of(i).ratio;
    points.points.emplace_back(psi, ratio);
    points.hover.push_back(point_hover(data, i));
    if (errors) points.bars.push_back({psi, psi, std::max(ratio - error, 0.5 * range.least), ratio + error});
  }
  Figure figure{reported.stem + "_toughness",
                "Toughness ratio against phase angle",
                {"ψ [rad]", 0.0, range.last_psi},
                {"f = G_c/G_{Ic}", range.logarithmic ? 0.8 * range.least : std::max(0.0, 0.9 * range.least), range.most,
                 range.logarithmic},
                {}};
  bool bands = false;
  for (const ModelCurves& model : reported.figured.models) {
    const std::string& key = model.fit->model;
    if (model.toughness_band) {  // one polygon
      Series band{"", Look::band, model_color(key), model.toughness_band->first};
      const auto& back = model.toughness_band->second;
      band.points.insert(band.points.end(), back.rbegin(), back.rend());
      figure.series.insert(figure.series.begin(), std::move(band));
      bands = true;
    }
    const FittedParameter* leading = leading_parameter(*model.fit);
    figure.series.push_back(
        {"model " + key + (leading ? ", " + parameter_symbol(leading->name) + " = " + rounded(*leading->value, 4) : ""),
         model_line(key), model_color(key), model.toughness});
  }
  figure.series.push_back(std::move(points));
  figure.key_place = KeyPlace::top_left;
  figure.caption = std::to_string(all.size()) + " points and the fitted models" +
                   (bands ? "; bands span the intervals of the parameters" : "") +
                   (data.has_loads ? ". Both axes are computed from the same area, so that almost any model looks good "
                                     "here: judge by the areas."
                                   : ".") +
                   shown_note(shown_points(all).size(), all.size());
  if (!result.request.options.free.empty())
    figure.caption += " Points are computed with the stated constants, not with those that were fitted.";
  return {figure};
}

}  // namespace mixity
