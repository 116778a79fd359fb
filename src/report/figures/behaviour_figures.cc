#include <algorithm>
#include <cmath>

#include "base/number_text.h"
#include "dataset/display_units.h"
#include "report/figures/data_figures.h"

namespace mixity {
namespace {

Figure beside_key(const ReportedData& reported, const std::string& name, const std::string& title, Axis x, Axis y,
                  const std::string& key_title) {
  Figure figure{.name = reported.stem + name,
                .title = title,
                .x = std::move(x),
                .y = std::move(y),
                .key_place = KeyPlace::beside,
                .key_title = key_title,
                .wide = true};
  if (reported.figured.models.size() > 1)
    for (const ModelCurves& curves : reported.figured.models)
      figure.key.emplace_back("model " + curves.fit->model, model_line(curves.fit->model));
  return figure;
}

/// Whole equilibrium curves, one colour per load, with the model's line.
Figure equilibrium_curves(const ReportedData& reported, const std::string& name, const std::string& title, Axis x,
                          Axis y, double DrawnPoint::*x_value, double DrawnPoint::*y_value) {
  const Dataset& data = reported.result.data;
  const DrawnUnits units(data);
  const FiguredModels& figured = reported.figured;
  const double T_most = 1.3 * figured.T_data * units.force;
  Figure figure = beside_key(reported, name, title, std::move(x), std::move(y), units.P());
  double x_most = 0, y_most = 0;
  for (const ModelCurves& curves : figured.models)
    for (std::size_t k = 0; k < figured.runs.size(); ++k) {
      const std::string load = rounded(data.curve_loads[figured.runs[k]] * units.held, 4);
      Series series{&curves == figured.models.data() ? load : "", model_line(curves.fit->model), color(k)};
      for (const DrawnPoint& q : curves.areas[k].points) {
        series.points.emplace_back(q.*x_value, q.*y_value);
        if (!q.stable || q.T > T_most) continue;
        x_most = std::max(x_most, q.*x_value);
        y_most = std::max(y_most, q.*y_value);
      }
      figure.series.push_back(std::move(series));
    }
  // Only as far as stable branches extend: towards Hertz at small a, u = 3/4 T/a grows without limit.
  figure.x.high = 1.05 * x_most;
  figure.y.high = 1.1 * y_most;
  figure.caption =
      "Equilibrium curves at the data's loads and the fitted parameters; u = 3/4 T/a, that of nu = 1/2, is not "
      "measured.";
  return figure;
}

/// P(T) at held approaches, with the loads that were measured beside them.
Figure loads_figure(const ReportedData& reported, const Axis& T) {
  const Dataset& data = reported.result.data;
  const DrawnUnits units(data);
  Figure figure = equilibrium_curves(reported, "_P_T", "Normal load against tangential load at held approaches", T,
                                     {DrawnUnits::with("P", units.force_unit, "/(R G_{Ic})"), {}, {}}, &DrawnPoint::T,
                                     &DrawnPoint::P);
  if (data.loads_beside.empty()) return figure;
  for (std::size_t k = 0; k < reported.figured.runs.size(); ++k) {
    Series measured{"", Look::circles, color(k)};
    for (std::size_t i = 0; i < data.points.size(); ++i)
      if (data.points[i].curve == reported.figured.runs[k] && std::isfinite(data.loads_beside[i].q))
        measured.points.emplace_back(data.points[i].shear() * units.force, data.loads_beside[i].q * units.force);
    figure.series.push_back(std::move(measured));
  }
  figure.key.emplace_back("measured", Look::circles);
  return figure;
}

/// a(P) of all models at a few tangential loads; the part that is unstable under load is dotted.
Figure radii_figure(const ReportedData& reported) {
  const Dataset& data = reported.result.data;
  const DrawnUnits units(data);
  const FiguredModels& figured = reported.figured;
  const double least = *std::min_element(data.curve_loads.begin(), data.curve_loads.end());
  Figure figure = beside_key(reported, "_a_P",
                             data.holds_approach() ? "Contact radius against approach at constant tangential load"
                                                   : "Contact radius against normal load at constant tangential load",
                             {units.P(), std::min(least * units.held, 0.0), figured.P_most * units.held},
                             {units.a(), 0.0, {}}, units.T());
  for (const ModelCurves& curves : figured.models)
    for (std::size_t k = 0; k < curves.radii.size(); ++k) {
      const std::string shear = rounded(figured.shears[k] * units.force, 4);
      figure.series.push_back({&curves == figured.models.data() ? shear : "", model_line(curves.fit->model), color(k),
                               curves.radii[k].stable});
      figure.series.push_back({"", Look::dotted, color(k), curves.radii[k].unstable});
    }
  figure.key.emplace_back("unstable", Look::dotted);
  figure.caption = "The contact at a quarter, half, three quarters and all of the largest tangential load measured.";
  return figure;
}

}  // namespace

std::vector<Figure> behaviour_figures(const ReportedData& reported) {
  const Dataset& data = reported.result.data;
  if (!data.has_loads || data.points.empty() || reported.figured.models.empty()) return {};
  if (!(reported.figured.T_data > 0)) return {};
  const DrawnUnits units(data);
  const Axis T{units.T(), 0.0, {}}, u{units.u(), 0.0, {}}, A{units.A(), 0.0, {}};
  std::vector<Figure> figures{equilibrium_curves(reported, "_u_T", "Tangential displacement against tangential load", T,
                                                 u, &DrawnPoint::T, &DrawnPoint::u),
                              equilibrium_curves(reported, "_A_u", "Contact area against tangential displacement", u, A,
                                                 &DrawnPoint::u, &DrawnPoint::A)};
  if (data.holds_approach()) figures.push_back(loads_figure(reported, T));
  const auto& models = reported.figured.models;
  // a(P) at constant T is known of circles alone
  if (std::any_of(models.begin(), models.end(), [](const ModelCurves& one) {
        return std::any_of(one.radii.begin(), one.radii.end(),
                           [](const DrawnRadii& radii) { return !radii.stable.empty() || !radii.unstable.empty(); });
      }))
    figures.push_back(radii_figure(reported));
  return figures;
}

}  // namespace mixity
