#include <algorithm>
#include <cmath>
#include <functional>

#include "base/number_text.h"
#include "dataset/display_units.h"
#include "fitting/predicted_curves.h"
#include "report/figures/data_figures.h"

namespace mixity {
namespace {

using Project = std::function<std::pair<double, double>(const DrawnPoint&)>;

/// The curves that u(T) and A(u) both show, in the order of fits and runs.
struct Behaviour {
  std::vector<const FitResult*> fits;
  std::vector<std::size_t> runs;
  double T_most;                                // dimensionless
  std::vector<std::vector<DrawnCurve>> curves;  // [fit][run]

  explicit Behaviour(const ReportedData& reported)
      : fits(fits_with_values(reported.result.fits)),
        runs(shown_runs(reported.result.data)),
        T_most(1.3 * largest_shear(reported.result.data)) {
    for (const FitResult* fit : fits) {
      curves.emplace_back();
      for (const std::size_t run : runs)
        curves.back().push_back(drawn_curve(reported.result.data, reported.result.request.options, *fit,
                                            reported.result.data.curve_loads[run], T_most));
    }
  }
};

/// Whole equilibrium curves, a colour for each load and the model's line.
Figure curves(const ReportedData& reported, const Behaviour& behaviour, const std::string& name,
              const std::string& title, Axis x, Axis y, const Project& project) {
  const Dataset& data = reported.result.data;
  const DrawnUnits units(data);
  Figure figure{reported.stem + name, title, std::move(x), std::move(y), {}};
  figure.key_title = units.P();
  figure.key_place = KeyPlace::beside;
  figure.wide = true;
  double x_most = 0, y_most = 0;
  for (std::size_t m = 0; m < behaviour.fits.size(); ++m) {
    const std::string& model = behaviour.fits[m]->model;
    if (behaviour.fits.size() > 1) figure.key.emplace_back("model " + model, model_line(model));
    for (std::size_t k = 0; k < behaviour.runs.size(); ++k) {
      const double load = data.curve_loads[behaviour.runs[k]];
      Series series{m == 0 ? rounded(load * units.force, 4) : "", model_line(model), color(k), {}};
      for (const DrawnPoint& q : behaviour.curves[m][k].points) {
        series.points.push_back(project(q));
        if (!q.stable || q.T > behaviour.T_most * units.force) continue;
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
  const auto [least, most] = std::minmax_element(data.curve_loads.begin(), data.curve_loads.end());
  const double P_most = *most + 0.1 * (*most - *least) + 1, T_data = largest_shear(data);
  const auto fits = fits_with_values(reported.result.fits);
  for (const FitResult* fit : fits) {
    if (fits.size() > 1) figure.key.emplace_back("model " + fit->model, model_line(fit->model));
    for (std::size_t k = 0; k < 4; ++k) {
      const double T = T_data * static_cast<double>(k + 1) / 4;
      DrawnRadii drawn = drawn_radii(reported.result.data, reported.result.request.options, *fit, T, P_most);
      figure.series.push_back({fit == fits.front() ? rounded(T * units.force, 4) : "", model_line(fit->model), color(k),
                               std::move(drawn.stable)});
      figure.series.push_back({"", Look::dotted, color(k), std::move(drawn.unstable)});
    }
  }
  figure.key.emplace_back("unstable", Look::dotted);
  figure.x.high = P_most * units.force;
  figure.x.low = std::min(*least * units.force, 0.0);
  figure.caption = "The contact at a quarter, half, three quarters and all of the largest tangential load measured.";
  return figure;
}

}  // namespace

std::vector<Figure> behaviour_figures(const ReportedData& reported) {
  const Dataset& data = reported.result.data;
  if (!data.has_loads || data.points.empty() || fits_with_values(reported.result.fits).empty()) return {};
  if (!(largest_shear(data) > 0)) return {};
  const DrawnUnits units(data);
  const Axis T{units.T(), 0.0, {}}, u{units.u(), 0.0, {}}, A{units.A(), 0.0, {}};
  const Behaviour behaviour(reported);
  return {curves(reported, behaviour, "_u_T", "Tangential displacement against tangential load", T, u,
                 [](const DrawnPoint& q) { return std::pair(q.T, q.u); }),
          curves(reported, behaviour, "_A_u", "Contact area against tangential displacement", u, A,
                 [](const DrawnPoint& q) { return std::pair(q.u, q.A); }),
          radii(reported)};
}

}  // namespace mixity
