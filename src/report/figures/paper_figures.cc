#include "report/figures/paper_figures.h"

#include <cmath>
#include <functional>

#include "dataset/number_text.h"
#include "mechanics/constant_shear.h"
#include "mechanics/folds.h"
#include "mechanics/sampling.h"

namespace mixity {
namespace {

constexpr std::size_t kPoints = 400;  // a curve: no corner shows
// What the paper writes with a tilde, spelt out.
const std::string kT = "T/(R G_{Ic})", kA = "A ξ^2/R^2";
const Axis kP{"P/(R G_{Ic})", -6.0, 30.0};

template <class Model>
Look look_of() {
  return model_line(Model::info.key);
}

const std::vector<std::pair<std::string, Look>> kModelKey{
    {"a", Look::dash_dot}, {"b", Look::dashed}, {"c", Look::solid}};

template <class Model>
Series toughness_curve(double lambda, double last_psi) {
  Series series{"model " + std::string(Model::info.key) + ", λ = " + rounded(lambda, 4),
                look_of<Model>(),
                model_color(Model::info.key),
                {}};
  for (std::size_t i = 0; i <= kPoints; ++i) {
    const double psi = last_psi * static_cast<double>(i) / kPoints;
    const double f = std::exp(Model::log_toughness({lambda}, mixity_from_angle(psi)).value);
    if (f < 1e6) series.points.emplace_back(psi, f);
  }
  return series;
}

/// a(P) at constant T: the stable part as the model's line, the rest dotted.
template <class Model>
Figure radius_against_load(const std::string& name, const std::vector<double>& shears) {
  Figure figure{name,
                "Fig. 4: contact radius against normal load at constant tangential load, model " +
                    std::string(Model::info.key) + ", λ = 0.15",
                kP,
                {"a ξ/R", 0.0, 4.5},
                {},
                {{"unstable", Look::dotted}},
                KeyPlace::beside};
  for (std::size_t k = 0; k < shears.size(); ++k) {
    Series unstable{"", Look::dotted, color(k), {}},
        stable{"T = " + shortest(shears[k]), look_of<Model>(), color(k), {}};
    const double largest = 40 * pi<double>() + shears[k];
    for (int i = 1; i <= 1000; ++i) {
      const ConstantShearPoint q = constant_shear_point<Model>({0.15}, shears[k], largest * std::pow(i / 1000.0, 2));
      (q.dP_dy > 0 ? stable : unstable).points.emplace_back(q.P, q.a);
      // the two meet at pull-off
      if (q.dP_dy > 0 && stable.points.size() == 1) unstable.points.emplace_back(q.P, q.a);
    }
    figure.series.push_back(std::move(stable));
    figure.series.push_back(std::move(unstable));
  }
  Series jkr{"JKR, T = 0", Look::dash_dots, color(7), {}}, hertz{"Hertz", Look::dotted, color(7), {}};
  for (std::size_t i = 0; i <= kPoints; ++i) {
    const double P = *figure.x.high * static_cast<double>(i) / kPoints, pull_off = -1.5 * pi<double>();
    const double further = pull_off + (*figure.x.high - pull_off) * static_cast<double>(i) / kPoints;
    jkr.points.emplace_back(further, jkr_radius(further));
    hertz.points.emplace_back(P, hertz_radius(P));
  }
  figure.series.push_back(std::move(jkr));
  figure.series.push_back(std::move(hertz));
  figure.caption =
      "Equilibrium y^2 + T^2 = 8 pi a^3 f(psi) at constant T, between its limits: JKR (no shear) and Hertz "
      "(no adhesion). Stable where P rises with a.";
  return figure;
}

using Projected = std::function<std::pair<double, double>(const CurvePoint&)>;

/// Whole equilibrium curves of one model, a colour for each load; only c names the loads.
template <class Model>
void add_curves(Figure& figure, double lambda, const std::vector<double>& loads, double T_most,
                const Projected& project, bool stable_only) {
  for (std::size_t k = 0; k < loads.size(); ++k) {
    const EquilibriumCurve<Model> curve({lambda}, loads[k]);
    Series series{look_of<Model>() == Look::solid ? "P = " + shortest(loads[k]) : "", look_of<Model>(), color(k), {}};
    for (const CurvePoint& q : sample_uniform(curve, {drawable_ranges(curve, T_most).front()}, kPoints)) {
      if (stable_only && q.dT < 0) break;
      series.points.push_back(project(q));
      if (q.T > T_most) break;
    }
    figure.series.push_back(std::move(series));
  }
}

/// Where the contacts jump: triangles under load control, diamonds under displacement control, which lie beyond what is
/// stable under load.
template <class Model>
void add_jumps(Figure& figure, double lambda, const std::vector<double>& loads, const Projected& project,
               bool stable_only) {
  for (const auto& [kind, look] :
       {std::pair(Control::Kind::load, Look::triangles), std::pair(Control::Kind::displacement, Look::diamonds)}) {
    if (stable_only && kind == Control::Kind::displacement) continue;
    Series marks{"", look, model_color(Model::info.key), {}};
    for (const double P : loads)
      for (const Fold& fold : find_folds(EquilibriumCurve<Model>({lambda}, P), {kind})) {
        CurvePoint at{};
        at.T = fold.T;
        at.u = fold.u;
        at.A = fold.A;
        if (fold.place.maximum) marks.points.push_back(project(at));
      }
    if (!marks.points.empty()) figure.series.push_back(std::move(marks));
  }
}

/// Models a, b and c at the same lambda.
Figure curves(const std::string& name, const std::string& title, double lambda, const std::vector<double>& loads,
              double T_most, Axis x, Axis y, const Projected& project, bool stable_only = false) {
  Figure figure{name, title, std::move(x), std::move(y), {}, kModelKey, KeyPlace::beside};
  figure.wide = true;
  add_curves<PapangeloCiavarella>(figure, lambda, loads, T_most, project, stable_only);
  add_curves<Johnson>(figure, lambda, loads, T_most, project, stable_only);
  add_curves<WatersGuduru>(figure, lambda, loads, T_most, project, stable_only);
  add_jumps<PapangeloCiavarella>(figure, lambda, loads, project, stable_only);
  add_jumps<Johnson>(figure, lambda, loads, project, stable_only);
  add_jumps<WatersGuduru>(figure, lambda, loads, project, stable_only);
  figure.key.emplace_back("jump, load controlled", Look::triangles);
  if (!stable_only) figure.key.emplace_back("jump, displacement controlled", Look::diamonds);
  figure.caption =
      "Equilibrium y^2 + T^2 = 8 pi a^3 f(psi), u = 3 T/(4 a). Triangles: T_T = sqrt(3 pi (3 pi + 2 P)/lambda) of "
      "model c, and "
      "the folds of a and b. Diamonds: the fold in u. The paper prints u_u and A_u of the plus branch; the fold lies "
      "on "
      "the minus branch: u_u = (3/4)^(2/3) T_u/(3 pi + P - sqrt(S0^2 - lambda T_u^2))^(1/3). Models a and b follow "
      "their "
      "own equations here.";
  return figure;
}

}  // namespace

std::vector<Figure> paper_figures() {
  const double right_angle = 0.5 * pi<double>();
  const Axis psi{"ψ [rad]", 0.0, right_angle};
  const auto f = [](double low, double high, bool logarithmic) {
    return Axis{"f = G_c/G_{Ic}", low, high, logarithmic};
  };
  const auto every_model = [&](double lambda) {
    return std::vector{toughness_curve<Johnson>(lambda, right_angle),
                       toughness_curve<WatersGuduru>(lambda, right_angle),
                       toughness_curve<PapangeloCiavarella>(lambda, right_angle)};
  };
  std::vector<Figure> figures;
  const auto toughness = [&](const char* name, const char* title, const Axis& x, const Axis& y,
                             std::vector<Series> series) {
    figures.push_back(Figure{name, title, x, y, std::move(series), {}, KeyPlace::top_left});
  };
  toughness("fig3", "Fig. 3: toughness ratio against phase angle, λ = 0.15", psi, f(0, 10, false), every_model(0.15));

  figures.push_back(radius_against_load<Johnson>("fig4a", {10, 20, 30, 40}));
  figures.push_back(radius_against_load<WatersGuduru>("fig4b", {10, 40, 70, 100}));
  figures.push_back(radius_against_load<PapangeloCiavarella>("fig4c", {10, 20, 30, 40}));

  const std::vector<double> loads{-1, 1, 3, 5};
  const Axis T{kT, 0.0, 60.0}, u{"u ξ^2/R", 0.0, 20.0}, A{kA, 0.0, 25.0};
  const auto area = [](const CurvePoint& q) { return std::pair(q.T, q.A); };
  figures.push_back(curves("fig6_u_T", "Fig. 6: tangential displacement against tangential load, λ = 0.15", 0.15, loads,
                           60, T, u, [](const CurvePoint& q) { return std::pair(q.T, q.u); }));
  figures.push_back(
      curves("fig6_A_T", "Fig. 6: contact area against tangential load, λ = 0.15", 0.15, loads, 60, T, A, area));
  figures.push_back(curves("fig6_A_u", "Fig. 6: contact area against tangential displacement, λ = 0.15", 0.15, loads,
                           120, u, A, [](const CurvePoint& q) { return std::pair(q.u, q.A); }));

  toughness("fig7", "Fig. 7: toughness ratio against phase angle, λ = 0.0023 (Mergel et al. 2018)", psi,
            f(1, 1000, true), every_model(0.0023));
  figures.push_back(curves("fig8", "Fig. 8: contact area against tangential load, λ = 0.0023 (Mergel et al. 2018)",
                           0.0023, {30.4, 15.0, 11.5, 6.2, 3.7, 2.0, -0.23, -1.79}, 600, {kT, 0.0, 600.0},
                           {kA, 0.0, 45.0}, area, true));
  toughness("fig9", "Fig. 9: toughness ratio against phase angle (Waters & Guduru 2010)", {"ψ [rad]", 0.0, 1.3},
            f(0.5, 4, false),
            {toughness_curve<WatersGuduru>(0.30, 1.25), toughness_curve<PapangeloCiavarella>(0.2331, 1.25)});
  // The paper's loads are those of the experiment, whose constants it does not give: those of Fig. 6 stand for them.
  Figure fig10;
  fig10.name = "fig10";
  fig10.title = "Fig. 10: contact area against tangential load, b with λ = 0.30, c with λ = 0.2331 (loads chosen here)";
  fig10.x = {kT, 0.0, 30.0};
  fig10.y = A;
  fig10.key = {{"b", Look::dashed}, {"c", Look::solid}};
  fig10.key_place = KeyPlace::beside;
  fig10.wide = true;
  add_curves<PapangeloCiavarella>(fig10, 0.2331, loads, 30, area, true);
  add_curves<WatersGuduru>(fig10, 0.30, loads, 30, area, true);
  figures.push_back(std::move(fig10));
  return figures;
}

}  // namespace mixity
