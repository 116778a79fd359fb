#include <algorithm>
#include <cmath>
#include <functional>

#include "base/number_text.h"
#include "dataset/display_units.h"
#include "report/figures/data_figures.h"

namespace mixity {
namespace {

using Project = std::function<std::pair<double, double>(const DrawnPoint&)>;

/// Whole equilibrium curves, a colour for each load and the model's line.
Figure curves(const ReportedData& reported, const std::string& name, const std::string& title, Axis x, Axis y,
              const Project& project) {
  const Dataset& data = reported.result.data;
  const DrawnUnits units(data);
  const FiguredModels& figured = reported.figured;
  const double T_most = 1.3 * figured.T_data * units.force;
  Figure figure{reported.stem + name, title, std::move(x), std::move(y), {}};
  figure.key_title = units.P();
  figure.key_place = KeyPlace::beside;
  figure.wide = true;
  double x_most = 0, y_most = 0;
  for (const ModelCurves& curves : figured.models) {
    const std::string& model = curves.fit->model;
    const bool first = &curves == figured.models.data();
    if (figured.models.size() > 1) figure.key.emplace_back("model " + model, model_line(model));
    for (std::size_t k = 0; k < figured.runs.size(); ++k) {
      const double load = data.curve_loads[figured.runs[k]];
      Series series{first ? rounded(load * units.force, 4) : "", model_line(model), color(k), {}};
      for (const DrawnPoint& q : curves.areas[k].points) {
        series.points.push_back(project(q));
        if (!q.stable || q.T > T_most) continue;
        x_most = std::max(x_most, series.points.back().first);
        y_most = std::max(y_most, series.points.back().second);
      }
      figure.series.push_back(std::move(series));
    }
  }
  // As far as stable branches go: towards Hertz at small a, u = 3/4 T/a runs away.
  figure.x.high = 1.05 * x_most;
  figure.y.high = 1.1 * y_most;
  figure.caption = "Equilibrium curves at the data's loads and the fitted parameters; u = 3/4 T/a, not measured.";
  return figure;
}

/// a(P) at a few tangential loads, all models; the part that is unstable under load dotted.
Figure radii(const ReportedData& reported) {
  const Dataset& data = reported.result.data;
  const DrawnUnits units(data);
  Figure figure{reported.stem + "_a_P",
                "Contact radius against normal load at constant tangential load",
                {units.P(), {}, {}},
                {units.a(), 0.0, {}},
                {}};
  figure.key_title = units.T();
  figure.key_place = KeyPlace::beside;
  figure.wide = true;
  const FiguredModels& figured = reported.figured;
  for (const ModelCurves& curves : figured.models) {
    const std::string& model = curves.fit->model;
    const bool first = &curves == figured.models.data();
    if (figured.models.size() > 1) figure.key.emplace_back("model " + model, model_line(model));
    for (std::size_t k = 0; k < curves.radii.size(); ++k) {
      figure.series.push_back({first ? rounded(figured.shears[k] * units.force, 4) : "", model_line(model), color(k),
                               curves.radii[k].stable});
      figure.series.push_back({"", Look::dotted, color(k), curves.radii[k].unstable});
    }
  }
  figure.key.emplace_back("unstable", Look::dotted);
  figure.x.high = figured.P_most * units.force;
  figure.x.low = std::min(*std::min_element(data.curve_loads.begin(), data.curve_loads.end()) * units.force, 0.0);
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
  return {curves(reported, "_u_T", "Tangential displacement against tangential load", T, u,
                 [](const DrawnPoint& q) { return std::pair(q.T, q.u); }),
          curves(reported, "_A_u", "Contact area against tangential displacement", u, A,
                 [](const DrawnPoint& q) { return std::pair(q.u, q.A); }),
          radii(reported)};
}

}  // namespace mixity
