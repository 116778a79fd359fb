#include "report/figures/paper_figures.h"

#include <cmath>

#include "base/number_text.h"
#include "fitting/predicted_curves.h"
#include "report/figures/paper_curves.h"

namespace mixity {
namespace {

/// a(P) at constant T: the stable part as the model's line, the rest dotted.
Figure fig4(const std::string& key, const std::vector<double>& shears) {
  const ContactModel model = ContactModel::find(key).value();
  constexpr double kLast = 30;
  const double pull_off = -1.5 * pi<double>();
  Figure figure{
      .name = "fig4" + key,
      .title = "Fig. 4: contact radius against normal load at constant tangential load, model " + key + ", λ = 0.15",
      .x = {"P/(R G_{Ic})", -6.0, kLast},
      .y = {"a ξ/R", 0.0, 4.5},
      .key = {{"unstable", Look::dotted}},
      .key_place = KeyPlace::beside,
      .caption =
          "Equilibrium y^2 + T^2 = 8 pi a^3 f(psi) at constant T, beside JKR (no shear) and Hertz (no "
          "adhesion). Stable where P rises with a."};
  for (std::size_t k = 0; k < shears.size(); ++k) {
    Series unstable{"", Look::dotted, color(k)}, stable{"T = " + shortest(shears[k]), model_line(key), color(k)};
    const double largest = 40 * pi<double>() + shears[k];
    std::vector<double> edge_loads;
    for (int i = 1; i <= 1000; ++i) edge_loads.push_back(largest * std::pow(i / 1000.0, 2));
    for (const ConstantShearPoint& q : model.at_constant_shear(ParameterValues{0.15}, shears[k], edge_loads)) {
      (q.dP_dy > 0 ? stable : unstable).points.emplace_back(q.P, q.a);
      // the two parts meet at pull-off
      if (q.dP_dy > 0 && stable.points.size() == 1) unstable.points.emplace_back(q.P, q.a);
    }
    figure.series.push_back(std::move(stable));
    figure.series.push_back(std::move(unstable));
  }
  Series jkr{"JKR, T = 0", Look::dash_dots, color(7)}, hertz{"Hertz", Look::dashed, color(7)};
  for (std::size_t i = 0; i <= kPaperPoints; ++i) {
    const double P = kLast * static_cast<double>(i) / kPaperPoints;
    const double further = pull_off + (kLast - pull_off) * static_cast<double>(i) / kPaperPoints;
    jkr.points.emplace_back(further, jkr_radius(further));
    hertz.points.emplace_back(P, hertz_radius(P));
  }
  figure.series.push_back(std::move(jkr));
  figure.series.push_back(std::move(hertz));
  return figure;
}

/// A figure of f against psi up to last_psi.
Figure toughness_figure(const std::string& name, const std::string& title, double last_psi, Axis f,
                        const std::vector<std::pair<std::string, double>>& lambdas, double drawn_psi) {
  Figure figure{.name = name,
                .title = title,
                .x = {"ψ [rad]", 0.0, last_psi},
                .y = std::move(f),
                .key_place = KeyPlace::top_left};
  for (const auto& [key, lambda] : lambdas) {
    figure.series.push_back(
        {"model " + key + ", λ = " + rounded(lambda, 4), model_line(key), model_color(key),
         toughness_curve(ContactModel::find(key).value(), ParameterValues{lambda}, drawn_psi, 1e6, kPaperPoints)});
    figure.caption += (figure.caption.empty() ? "f = " : ", ") +
                      std::string(key == "a"   ? "1 + (1 - lambda) tan^2(psi)"
                                  : key == "b" ? "1 + tan^2((1 - lambda/2) psi)"
                                               : "1/(1 + (lambda - 1) sin^2(psi))") +
                      (figure.caption.empty() ? " of model " : " of ") + key;
  }
  figure.caption += ".";
  return figure;
}

/// Measured toughness, for figures of f against psi.
void add_toughness(Figure& figure, const std::vector<Dataset>& data, bool with_loads) {
  for (const Dataset& one : data) {
    if (one.has_loads != with_loads) continue;
    Series points{data_label(one), Look::circles, color(0)};
    for (std::size_t i = 0; i < one.points.size(); ++i)
      if (const auto toughness = one.toughness(i)) points.points.emplace_back(toughness->psi(), toughness->ratio);
    figure.series.push_back(std::move(points));
  }
}

}  // namespace

std::vector<Figure> paper_figures(const std::vector<Dataset>& data) {
  const double right_angle = 0.5 * pi<double>();
  const std::string f = "f = G_c/G_{Ic}";
  std::vector<Figure> figures{
      toughness_figure("fig3", "Fig. 3: toughness ratio against phase angle, λ = 0.15", right_angle, {f, 0.0, 10.0},
                       {{"a", 0.15}, {"b", 0.15}, {"c", 0.15}}, right_angle),
      fig4("a", {10, 20, 30, 40}), fig4("b", {10, 40, 70, 100}), fig4("c", {10, 20, 30, 40})};
  for (Figure& one : paper_behaviours()) figures.push_back(std::move(one));
  figures.push_back(toughness_figure(
      "fig7", "Fig. 7: toughness ratio against phase angle, λ = 0.0023 (Mergel et al. 2018)", right_angle,
      {f, 1.0, 1000.0, true}, {{"a", kMergelLambda}, {"b", kMergelLambda}, {"c", kMergelLambda}}, right_angle));
  add_toughness(figures.back(), data, true);
  for (Figure& one : paper_areas_of_mergel(data)) figures.push_back(std::move(one));
  figures.push_back(toughness_figure("fig9", "Fig. 9: toughness ratio against phase angle (Waters & Guduru 2010)", 1.3,
                                     {f, 0.5, 4.0}, {{"b", 0.30}, {"c", 0.2331}}, 1.25));
  add_toughness(figures.back(), data, false);
  figures.push_back(paper_areas_of_waters());
  return figures;
}

}  // namespace mixity
