#include <algorithm>
#include <array>

#include "dataset/display_units.h"
#include "fitting/predicted_curves.h"
#include "report/figures/data_figures.h"

namespace mixity {
namespace {

Series data_loads(const Dataset& data, const ModelCurves& curves) {
  const DrawnUnits units(data);
  const FittedParameter& lambda = curves.fit->parameters.front();
  Series loads{"these data", model_symbol(curves.fit->model), color(0)};
  const auto& interval = lambda.interval;
  for (std::size_t run = 0; run < data.curves.size(); ++run) {
    const double P = data.curve_loads[run] * units.force;
    const std::optional<Regime>& regime = curves.map->runs[run];
    loads.points.emplace_back(P, *lambda.value);
    loads.bars.push_back({P, P,
                          interval && interval->low ? std::max(*interval->low, curves.map->frame.low) : *lambda.value,
                          interval && interval->high ? *interval->high : *lambda.value});
    loads.hover.push_back("run " + data.curves[run] + ": P = " + with_unit(P, 4, units.force_unit) + ", " +
                          (regime ? regime_text(*regime) : "no contact"));
  }
  return loads;
}

Figure regime_figure(const ReportedData& reported, const ModelCurves& curves) {
  const Dataset& data = reported.result.data;
  const DrawnUnits units(data);
  const std::string& model = curves.fit->model;
  const RegimeMapFrame& frame = curves.map->frame;
  Figure figure{.name = reported.stem + "_regimes_" + model,
                .title = "Regimes of the contact over load and lambda, model " + model,
                .x = {units.P(), frame.P_low * units.force, frame.P_high * units.force},
                .y = {"λ", frame.low, frame.high, frame.logarithmic},
                .caption = "Regimes of model " + model +
                           (stated_strength(data) ? " with the stated shear strength" : "") +
                           "; symbols are the data's loads at the fitted lambda."};
  static constexpr std::array<std::size_t, 4> kTint{6, 3, 1, 7};
  std::array<bool, 5> named{};
  for (const RegimeRegion& region : curves.map->regions) {
    if (!region.regime) continue;
    const auto number = static_cast<std::size_t>(*region.regime);
    Series series{named[number] ? "" : regime_text(*region.regime), Look::band, color(kTint[number - 1])};
    named[number] = true;
    for (const auto& [P, lambda] : region.outline) series.points.emplace_back(P * units.force, lambda);
    figure.series.push_back(std::move(series));
  }
  figure.series.push_back(data_loads(data, curves));
  return figure;
}

}  // namespace

std::vector<Figure> regime_figures(const ReportedData& reported, std::vector<MissingFigure>& left_out) {
  std::vector<Figure> figures;
  for (const ModelCurves& curves : reported.figured.models) {
    if (!curves.map) continue;
    if (const auto& regions = curves.map->regions; regions.size() == 1 && regions.front().regime)
      left_out.push_back({"regime map of model " + curves.fit->model,
                          "one regime everywhere: " + std::string(regime_text(*regions.front().regime))});
    else
      figures.push_back(regime_figure(reported, curves));
  }
  return figures;
}

}  // namespace mixity
