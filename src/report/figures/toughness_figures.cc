#include <algorithm>
#include <cmath>

#include "analysis/readable.h"
#include "base/number_text.h"
#include "dataset/display_units.h"
#include "fitting/predicted_curves.h"
#include "report/figures/data_figures.h"

namespace mixity {
namespace {

/// Both ends of the interval as one polygon.
std::optional<Series> band(const Dataset& data, const FitResult& fit, double last_psi, double most) {
  const auto low = at_interval_end(fit, false), high = at_interval_end(fit, true);
  if (!low || !high) return std::nullopt;
  Series series{"", Look::band, model_color(fit.model), drawn_toughness(data, *low, last_psi, most)};
  const auto back = drawn_toughness(data, *high, last_psi, most);
  series.points.insert(series.points.end(), back.rbegin(), back.rend());
  return series;
}

}  // namespace

std::vector<Figure> toughness_figures(const ReportedData& reported) {
  const Analysis& result = reported.result;
  const Dataset& data = result.data;
  Series points{"data", Look::circles, color(7), {}};
  std::vector<std::size_t> all;
  double last_psi = 0, largest = 1, smallest = 1;
  for (std::size_t i = 0; i < data.points.size(); ++i)
    if (const auto toughness = data.toughness(i)) {
      all.push_back(i);
      last_psi = std::max(last_psi, toughness->psi());
      largest = std::max(largest, toughness->ratio);
      smallest = std::min(smallest, toughness->ratio);
    }
  if (all.empty()) return {};
  bool errors = false;
  for (const std::size_t i : all) errors |= data.errors_of(i).ratio > 0;
  for (const std::size_t i : shown_points(all)) {
    const double psi = data.toughness(i)->psi(), ratio = data.toughness(i)->ratio, error = data.errors_of(i).ratio;
    points.points.emplace_back(psi, ratio);
    points.hover.push_back(point_hover(data, i));
    if (errors) points.bars.push_back({psi, psi, std::max(ratio - error, 0.5 * smallest), ratio + error});
  }
  const bool logarithmic = largest > 20;
  last_psi = std::min(1.05 * last_psi, 0.5 * pi<double>());
  const double most = logarithmic ? 3 * largest : 1.15 * largest;
  Figure figure{reported.stem + "_toughness",
                "Toughness ratio against phase angle",
                {"ψ [rad]", 0.0, last_psi},
                {"f = G_c/G_{Ic}", logarithmic ? 0.8 * smallest : std::max(0.0, 0.9 * smallest), most, logarithmic},
                {}};
  bool bands = false;
  for (const FitResult* drawn : fits_with_values(result.fits)) {
    const FitResult& fit = *drawn;
    if (auto ends = band(data, fit, last_psi, most)) {
      figure.series.insert(figure.series.begin(), std::move(*ends));
      bands = true;
    }
    const FittedParameter* leading = leading_parameter(fit);
    figure.series.push_back(
        {"model " + fit.model +
             (leading ? ", " + parameter_symbol(leading->name) + " = " + rounded(*leading->value, 4) : ""),
         model_line(fit.model), model_color(fit.model), drawn_toughness(data, fit, last_psi, most)});
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
