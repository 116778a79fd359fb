// Pull-off loads against the shear that is held: measured, and of the fitted models.
#include <algorithm>
#include <cmath>

#include "dataset/display_units.h"
#include "fitting/predicted_curves.h"
#include "report/figures/data_figures.h"

namespace mixity {
namespace {

Figure pull_off_figure(const ReportedData& reported, HeldShear held) {
  const Dataset& data = reported.result.data;
  const DrawnUnits units(data);
  const bool by_load = held == HeldShear::load;
  const double of_shear = by_load ? units.force : data.display.length_scale;
  const std::string length = data.display.length;
  Figure figure{.name = reported.stem + (by_load ? "_pull_off" : "_pull_off_u"),
                .title = std::string("Pull-off load against the ") + (by_load ? "tangential load" : "displacement") +
                         " that is held",
                .x = {by_load          ? units.T()
                      : length.empty() ? units.u()
                                       : "u [" + length + "]",
                      0.0,
                      {}},
                .y = {units.P(), {}, {}},
                .caption = "Compression is positive. Below the curve there is no adhesive contact."};
  Series points{"measured", Look::circles, color(7)};
  double most = 0;
  const auto& errors = reported.result.fits.front().errors;
  for (const PullOffReading& one : data.pull_off) {
    if (one.held != held) continue;
    const double x = std::abs(one.shear) * of_shear, y = one.P * units.force,
                 dx = std::max(one.sigma_shear, 0.0) * of_shear,
                 dy = one.error_of_load(errors ? errors->pull_off : 0) * units.force;
    points.points.emplace_back(x, y);
    points.bars.push_back({x - dx, x + dx, y - dy, y + dy});
    most = std::max(most, std::abs(one.shear));
  }
  for (const FitResult& fit : reported.result.fits) {
    if (!has_all_values(fit) || fit.pull_off == 0) continue;
    Series line{fit.model, Look::solid, model_color(fit.model)};
    for (const auto& [shear, P] : drawn_pull_off(data, reported.result.request.options, fit, held, 1.05 * most))
      line.points.emplace_back(shear * of_shear, P * units.force);
    figure.series.push_back(std::move(line));
  }
  figure.series.push_back(std::move(points));
  return figure;
}

}  // namespace

std::vector<Figure> pull_off_figures(const ReportedData& reported) {
  std::vector<Figure> figures;
  const auto& list = reported.result.data.pull_off;
  for (const HeldShear held : {HeldShear::load, HeldShear::displacement})
    if (std::any_of(list.begin(), list.end(), [&](const PullOffReading& one) { return one.held == held; }))
      figures.push_back(pull_off_figure(reported, held));
  return figures;
}

}  // namespace mixity
