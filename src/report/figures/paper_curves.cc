#include "report/figures/paper_curves.h"

#include <functional>

#include "base/number_text.h"
#include "mechanics/contact_model.h"

namespace mixity {
namespace {

/// A published model at one lambda.
struct PaperModel {
  std::string key;
  double lambda;

  ContactModel model() const { return ContactModel::find(key).value(); }
  Look look() const { return model_line(key); }
  /// Samples evenly from JKR to the end of the curve, or to T_most where T becomes infinite.
  std::vector<CurvePoint> curve(double P, double T_most) const {
    return model()
        .curve(ParameterValues{lambda}, P, {.points = kPaperPoints, .T_most = T_most, .first_range_only = true})
        .points;
  }
  std::vector<Fold> folds(double P, Control::Kind kind) const {
    return model().folds(ParameterValues{lambda}, P, {kind});
  }
};

const std::vector<double> kFourLoads{-1, 1, 3, 5};

using Projected = std::function<std::pair<double, double>(const CurvePoint&)>;

std::pair<double, double> area_over_T(const CurvePoint& q) { return {q.T, q.A}; }

/// Whole equilibrium curves of one model, one colour per load; only model c names the loads in the key.
void add_curves(Figure& figure, const PaperModel& model, const std::vector<double>& loads, double T_most,
                const Projected& project, bool stable_only) {
  for (std::size_t k = 0; k < loads.size(); ++k) {
    Series series{model.look() == Look::solid ? "P = " + shortest(loads[k]) : "", model.look(), color(k)};
    for (const CurvePoint& q : model.curve(loads[k], T_most)) {
      if (stable_only && q.dT < 0) break;
      series.points.push_back(project(q));
      if (q.T > T_most) break;
    }
    figure.series.push_back(std::move(series));
  }
}

/// Marks where the contacts jump: triangles under load control, diamonds under displacement control. The latter are on
/// the branch that is unstable under load control.
void add_jumps(Figure& figure, const PaperModel& model, const std::vector<double>& loads, const Projected& project) {
  for (const auto& [kind, look] :
       {std::pair(Control::Kind::load, Look::triangles), std::pair(Control::Kind::displacement, Look::diamonds)}) {
    Series marks{"", look, model_color(model.key)};
    for (const double P : loads)
      for (const Fold& fold : model.folds(P, kind)) {
        CurvePoint at{};
        at.T = fold.T;
        at.u = fold.u;
        at.A = fold.A;
        if (fold.place.maximum) marks.points.push_back(project(at));
      }
    if (!marks.points.empty()) figure.series.push_back(std::move(marks));
  }
}

/// Models a, b and c at lambda = 0.15 and four loads.
Figure fig6(const std::string& name, const std::string& quantities, double T_most, Axis x, Axis y,
            const Projected& project) {
  Figure figure{
      .name = "fig6_" + name,
      .title = "Fig. 6: " + quantities + ", λ = 0.15",
      .x = std::move(x),
      .y = std::move(y),
      .key = {{"a", Look::dash_dot},
              {"b", Look::dashed},
              {"c", Look::solid},
              {"jump, load controlled", Look::triangles},
              {"jump, displacement controlled", Look::diamonds}},
      .key_place = KeyPlace::beside,
      .wide = true,
      .caption =
          "Equilibrium y^2 + T^2 = 8 pi a^3 f(psi), u = 3 T/(4 a). Triangles: T_T = sqrt(3 pi (3 pi + 2 P)/lambda) of "
          "model c, and the folds of a and b. Diamonds: the fold in u. The paper prints u_u and A_u of the plus "
          "branch; the fold lies on the minus branch: u_u = (3/4)^(2/3) T_u/(3 pi + P - sqrt(S0^2 - lambda "
          "T_u^2))^(1/3). Beyond a mark the contact is not stable under that control. Models a and b follow their own "
          "equations here."};
  for (const char* key : {"c", "a", "b"}) add_curves(figure, {key, 0.15}, kFourLoads, T_most, project, false);
  for (const char* key : {"c", "a", "b"}) add_jumps(figure, {key, 0.15}, kFourLoads, project);
  return figure;
}

/// The four ways a contact can end under shear, at one load.
Figure behaviours() {
  constexpr double kLoad = 8, kStrength = 4, kMost = 120;
  Figure figure{
      .name = "fig5",
      .title = "Fig. 5: what becomes of a contact under shear, P = 8",
      .x = {kPaperT, 0.0, kMost},
      .y = {kPaperA, 0.0, 30.0},
      .key_place = KeyPlace::beside,
      .wide = true,
      .caption =
          "Stable branches. Model a with lambda < 1 ends on y^2 g = 6 pi (y + P) with g = 1/(1 - lambda), above Hertz; "
          "b above P = (3 pi/2)/(k cos(pi lambda/4))^2, k = 1 - lambda/2, reaches Hertz; c jumps at T_T = sqrt(3 pi "
          "(3 pi + 2 P)/lambda); an interface of strength tau0 slides where its line is met first."};
  const auto add = [&](const PaperModel& model, const char* label, std::size_t i) {
    Series series{label, model.look(), color(i)};
    for (const CurvePoint& q : model.curve(kLoad, kMost)) {
      if (q.dT < 0) break;
      series.points.emplace_back(q.T, q.A);
      if (q.T > kMost) break;
    }
    figure.series.push_back(std::move(series));
  };
  add({"a", 0.5}, "1 shrinks, never to Hertz (a, λ = 0.5)", 6);
  add({"b", 0.15}, "2 shrinks to Hertz (b, λ = 0.15)", 3);
  add({"c", 0.15}, "3 jumps (c, λ = 0.15)", 1);
  const double hertz = area_from_radius(hertz_radius(kLoad));
  figure.series.push_back(
      {"4 slides first, T = τ_0 A (τ_0 ξ/E^* = 4)", Look::dash_dots, color(7), {{0, 0}, {kMost, kMost / kStrength}}});
  figure.series.push_back({"Hertz", Look::dotted, color(0), {{0, hertz}, {kMost, hertz}}});
  return figure;
}

const std::vector<double> kMergelLoads{30.4, 15.0, 11.5, 6.2, 3.7, 2.0, -0.23, -1.79};
constexpr Contact kMergel{9.42e-3, 2.133e6, 27e-3};
constexpr double kMergelStrength = 0.43e6;  // Pa

/// Fig. 8: one model beside the data, the strength of the interface, the phase angle 3 pi/8 and the locus of the jump.
Figure fig8(const std::string& key, const std::vector<Dataset>& data) {
  constexpr double kMost = 600;
  const PaperModel model{key, kMergelLambda};
  Figure figure{
      .name = "fig8" + key,
      .title = "Fig. 8: contact area against tangential load (Mergel et al. 2018), model " + key + ", λ = 0.0023",
      .x = {kPaperT, 0.0, kMost},
      .y = {kPaperA, 0.0, 45.0},
      .key_place = KeyPlace::beside,
      .wide = true};
  Series angle{"ψ = 3π/8", Look::circles, color(1)};
  for (std::size_t k = 0; k < kMergelLoads.size(); ++k) {
    Series series{"P = " + shortest(kMergelLoads[k]), model.look(), color(k)};
    const CurvePoint* last = nullptr;
    const auto points = model.curve(kMergelLoads[k], kMost);
    for (const CurvePoint& q : points) {
      if (q.dT < 0) break;
      series.points.emplace_back(q.T, q.A);
      if (q.T > kMost) break;
      const double wanted = 0.375 * pi<double>();
      if (last && last->psi < wanted && q.psi >= wanted) angle.points.emplace_back(q.T, q.A);
      last = &q;
    }
    figure.series.push_back(std::move(series));
  }
  for (const Dataset& one : data) {
    if (!one.has_loads || !one.contact) continue;
    Series points{data_label(one), Look::squares, color(0)};
    for (const Point& point : corrected(one).points) points.points.emplace_back(point.shear(), point.A);
    figure.series.push_back(std::move(points));
  }
  Series locus{"locus of the jump", Look::dotted, color(0)};
  for (int i = 0; i <= 60; ++i) {
    const double P = -1.5 * pi<double>() * 0.98 + (32 + 1.5 * pi<double>()) * i / 60;
    for (const Fold& fold : model.folds(P, Control::Kind::load)) {
      if (!fold.place.maximum) continue;
      locus.points.emplace_back(fold.T, fold.A);
      break;
    }
  }
  if (!angle.points.empty()) figure.series.push_back(std::move(angle));
  const bool jumps = locus.points.size() > 1;
  if (jumps) figure.series.push_back(std::move(locus));
  const double strength = kMergelStrength / kMergel.stress_unit();
  figure.series.push_back({"sliding, T = τ_0 A", Look::dash_dots, color(7), {{0, 0}, {kMost, kMost / strength}}});
  figure.caption =
      "Stable branches of y^2 + T^2 = 8 pi a^3 f(psi) with tau0 = 0.43 MPa; circles where psi = 3 pi/8. " +
      std::string(jumps ? "The locus is A_T(T_T) over all loads; of model c A_T = pi (3/4 (3 pi + P))^(2/3) at T_T = "
                          "sqrt(3 pi (3 pi + 2 P)/lambda)."
                        : "This model does not jump at this lambda.");
  return figure;
}

}  // namespace

std::string data_label(const Dataset& data) {
  return data.metadata.provenance == Provenance::unstated ? "data"
                                                          : "data, " + std::string(to_string(data.metadata.provenance));
}

std::vector<Figure> paper_behaviours() {
  const Axis T{kPaperT, 0.0, 60.0}, u{"u ξ^2/R", 0.0, 20.0}, A{kPaperA, 0.0, 25.0};
  return {behaviours(),
          fig6("u_T", "tangential displacement against tangential load", 60, T, u,
               [](const CurvePoint& q) { return std::pair(q.T, q.u); }),
          fig6("A_T", "contact area against tangential load", 60, T, A, area_over_T),
          fig6("A_u", "contact area against tangential displacement", 120, u, A,
               [](const CurvePoint& q) { return std::pair(q.u, q.A); })};
}

std::vector<Figure> paper_areas_of_mergel(const std::vector<Dataset>& data) {
  return {fig8("a", data), fig8("b", data), fig8("c", data)};
}

Figure paper_areas_of_waters() {
  Figure figure{
      .name = "fig10",
      .title = "Fig. 10: contact area against tangential load, b with λ = 0.30, c with λ = 0.2331 (loads chosen here)",
      .x = {kPaperT, 0.0, 30.0},
      .y = {kPaperA, 0.0, 25.0},
      .key = {{"b", Look::dashed}, {"c", Look::solid}},
      .key_place = KeyPlace::beside,
      .wide = true,
      .caption =
          "Stable branches of y^2 + T^2 = 8 pi a^3 f(psi). The paper draws the loads of the experiment, whose "
          "constants it does not give: these loads are those of Fig. 6."};
  add_curves(figure, {"c", 0.2331}, kFourLoads, 30, area_over_T, true);
  add_curves(figure, {"b", 0.30}, kFourLoads, 30, area_over_T, true);
  return figure;
}

}  // namespace mixity
