// Every point of the paper's figures against the equations as printed there.
#include "report/figures/paper_figures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace mixity {
namespace {

const double kPi = std::acos(-1.0);

double printed_f(char model, double lambda, double psi) {
  if (model == 'a') return 1 + (1 - lambda) * std::pow(std::tan(psi), 2);
  if (model == 'b') return 1 + std::pow(std::tan((1 - lambda / 2) * psi), 2);
  return 1 / (1 + (lambda - 1) * std::pow(std::sin(psi), 2));
}

char model_of(Look look) { return look == Look::dash_dot ? 'a' : look == Look::dashed ? 'b' : 'c'; }

/// Of y^2 + T^2 = 8 pi a^3 f(psi), relative.
double printed_residual(char model, double lambda, double P, double T, double a) {
  const double y = 4.0 / 3 * a * a * a - P, right = 8 * kPi * a * a * a * printed_f(model, lambda, std::atan2(T, y));
  return (y * y + T * T) / right - 1;
}

const Figure& figure(const std::string& name) {
  static const std::vector<Figure> figures = paper_figures();
  for (const Figure& one : figures)
    if (one.name == name) return one;
  throw std::runtime_error(name);
}

/// Load or shear that a label states: "P = -1".
double stated(const Series& series) { return std::stod(series.label.substr(series.label.find('=') + 1)); }

TEST(PaperFigures, ToughnessFollowsThePrintedLaws) {
  for (const auto& [name, lambdas] : std::vector<std::pair<std::string, std::vector<double>>>{
           {"fig3", {0.15, 0.15, 0.15}}, {"fig7", {0.0023, 0.0023, 0.0023}}, {"fig9", {0.30, 0.2331}}}) {
    const Figure& drawn = figure(name);
    ASSERT_EQ(drawn.series.size(), lambdas.size());
    for (std::size_t i = 0; i < lambdas.size(); ++i)
      for (const auto& [psi, f] : drawn.series[i].points) {
        const double printed = printed_f(model_of(drawn.series[i].look), lambdas[i], psi);
        // rounding of psi, which tan^2 psi multiplies by 2 tan psi, up to 1e3 here
        EXPECT_NEAR(f / printed, 1, 1e-12) << name << ' ' << psi;
      }
  }
}

TEST(PaperFigures, RadiusAgainstLoadIsInEquilibriumAtItsShear) {
  for (const auto& [name, model] : {std::pair("fig4a", 'a'), std::pair("fig4b", 'b'), std::pair("fig4c", 'c')}) {
    double T = 0;
    for (const Series& series : figure(name).series) {
      if (!series.label.empty()) T = stated(series);  // what is unstable follows
      for (const auto& [P, a] : series.points) {
        // y = 4/3 a^3 - P loses what it is smaller than P by
        if (4.0 / 3 * a * a * a - P < 1e-2) continue;
        EXPECT_LT(std::abs(printed_residual(model, 0.15, P, T, a)), 1e-9) << name << " T=" << T << " P=" << P;
      }
    }
  }
}

TEST(PaperFigures, AreasAreInEquilibriumAtTheirLoad) {
  struct Case {
    const char* name;
    std::size_t loads, models;
    double lambda, lambda_b;
  };
  for (const auto& [name, loads, models, lambda_ac, lambda_b] :
       {Case{"fig6_A_T", 4, 3, 0.15, 0.15}, {"fig8", 8, 3, 0.0023, 0.0023}, {"fig10", 4, 2, 0.2331, 0.30}}) {
    const Figure& drawn = figure(name);
    ASSERT_EQ(drawn.series.size(), loads * models);
    for (std::size_t i = 0; i < drawn.series.size(); ++i) {
      const double P = stated(drawn.series[i % loads]);  // the first model's labels name the loads
      ASSERT_GT(drawn.series[i].points.size(), 50u);
      for (const auto& [T, A] : drawn.series[i].points) {
        const double a = std::sqrt(A / kPi);
        if (4.0 / 3 * a * a * a - P < 1e-2) continue;
        const char model = model_of(drawn.series[i].look);
        EXPECT_LT(std::abs(printed_residual(model, model == 'b' ? lambda_b : lambda_ac, P, T, a)), 1e-9)
            << name << ' ' << i << " T=" << T;
      }
    }
  }
}

TEST(PaperFigures, DisplacementsAreThoseOfTheirLoadsAndRadii) {
  const Figure &by_T = figure("fig6_u_T"), &areas = figure("fig6_A_T");
  for (std::size_t i = 0; i < by_T.series.size(); ++i)
    for (std::size_t k = 0; k < by_T.series[i].points.size(); ++k) {
      const auto [T, u] = by_T.series[i].points[k];
      const double a = std::sqrt(areas.series[i].points[k].second / kPi);
      EXPECT_NEAR(u, 0.75 * T / a, 1e-12 * u + 1e-300);  // a few roundings
    }
}

TEST(PaperFigures, HaveDistinctNamesAndNamedAxes) {
  std::set<std::string> names;
  for (const Figure& one : paper_figures()) {
    EXPECT_TRUE(names.insert(one.name).second);
    EXPECT_FALSE(one.x.label.empty() || one.y.label.empty()) << one.name;
    EXPECT_EQ(one.title.substr(0, 5), "Fig. ") << one.name;
  }
}

}  // namespace
}  // namespace mixity
