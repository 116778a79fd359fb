// Every point of the paper's figures against the equations as printed there.
#include "report/figures/paper_figures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "report/page/paper_page.h"

namespace mixity {
namespace paper_figures_test {

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
        if (f >= 1e6) continue;  // beyond the frame
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
      if (series.label.starts_with("JKR")) T = 0;
      if (series.label == "Hertz") {
        for (const auto& [P, a] : series.points) EXPECT_NEAR(4.0 / 3 * a * a * a, P, 1e-13 * P + 1e-300);
        continue;
      }
      if (series.label.starts_with("T = ")) T = stated(series);  // what is unstable follows
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
  for (const auto& [name, loads, models, lambda_ac, lambda_b] : {Case{"fig6_A_T", 4, 3, 0.15, 0.15},
                                                                 {"fig8a", 8, 1, 0.0023, 0.0023},
                                                                 {"fig8b", 8, 1, 0.0023, 0.0023},
                                                                 {"fig8c", 8, 1, 0.0023, 0.0023},
                                                                 {"fig10", 4, 2, 0.2331, 0.30}}) {
    const Figure& drawn = figure(name);
    ASSERT_GE(drawn.series.size(), loads * models);  // and the jumps
    for (std::size_t i = 0; i < loads * models; ++i) {
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
  ASSERT_EQ(by_T.series.size(), areas.series.size());
  for (std::size_t i = 0; i < by_T.series.size(); ++i)  // curves and jumps
    for (std::size_t k = 0; k < by_T.series[i].points.size(); ++k) {
      const auto [T, u] = by_T.series[i].points[k];
      const double a = std::sqrt(areas.series[i].points[k].second / kPi);
      EXPECT_NEAR(u, 0.75 * T / a, 1e-12 * u + 1e-300);  // a few roundings
    }
}

/// Model c's closed forms: T_T, A_T of load control; T_u of displacement control and, on the minus branch, u_u.
TEST(PaperFigures, JumpsOfModelCAreThoseOfTheClosedForms) {
  const Figure &areas = figure("fig6_A_T"), &displacements = figure("fig6_u_T");
  const auto marks = [](const Figure& drawn, Look look) {
    for (const Series& series : drawn.series)
      if (series.look == look) return series.points;  // those of model c come first
    return Series{}.points;
  };
  const double loads[] = {-1, 1, 3, 5}, lambda = 0.15;
  const auto triangles = marks(areas, Look::triangles), diamonds = marks(displacements, Look::diamonds);
  ASSERT_EQ(triangles.size(), 4u);
  ASSERT_EQ(diamonds.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    const double P = loads[i], S0_squared = 9 * kPi * kPi + 6 * kPi * P;
    EXPECT_NEAR(triangles[i].first, std::sqrt(3 * kPi * (3 * kPi + 2 * P) / lambda), 1e-11);
    EXPECT_NEAR(triangles[i].second, kPi * std::pow(0.75, 2.0 / 3) * std::pow(3 * kPi + P, 2.0 / 3), 1e-11);
    const double inner = 3 * std::pow(3 * kPi + P, 2) * (3 * kPi * kPi + 2 * kPi * P + 3 * P * P);
    const double T_u = 0.5 * std::sqrt(1.5 * (S0_squared - 3 * P * P + std::sqrt(inner)) / lambda);
    EXPECT_NEAR(diamonds[i].first, T_u, 1e-11 * T_u);
    const double u_u =
        std::pow(0.75, 2.0 / 3) * T_u / std::cbrt(3 * kPi + P - std::sqrt(S0_squared - lambda * T_u * T_u));
    EXPECT_NEAR(diamonds[i].second, u_u, 1e-10 * u_u);
  }
}

/// Model b at lambda = 0.0023 reaches Hertz beyond T = 10000.
TEST(PaperFigures, LinesThatDoNotJumpRunToTheEndOfTheAxis) {
  const Figure& drawn = figure("fig8b");
  for (std::size_t i = 0; i < 8; ++i) {
    if (stated(drawn.series[i]) < 0) continue;  // these jump off contact
    EXPECT_GT(drawn.series[i].points.back().first, 0.999 * *drawn.x.high) << drawn.series[i].label;
  }
  EXPECT_GT(figure("fig5").series[0].points.back().first, 0.999 * *figure("fig5").x.high);
}

TEST(PaperFigures, CaptionsOfLawsStateThoseThatAreDrawn) {
  EXPECT_EQ(figure("fig9").caption,
            "f = 1 + tan^2((1 - lambda/2) psi) of model b, 1/(1 + (lambda - 1) sin^2(psi)) of c.");
  EXPECT_TRUE(figure("fig3").caption.starts_with("f = 1 + (1 - lambda) tan^2(psi) of model a, 1 + tan^2("));
}

/// "a = ξ a/R" would say that ξ = R.
TEST(PaperPage, StatesTheUnitOfEachQuantity) {
  const std::string page = paper_page({}, {});
  EXPECT_NE(page.find("a is in units of R/ξ with ξ = (E* R/G_Ic)^(1/3), A = π a² of (R/ξ)²"), std::string::npos);
}

TEST(PaperFigures, HaveDistinctNamesAndNamedAxes) {
  std::set<std::string> names;
  for (const Figure& one : paper_figures()) {
    EXPECT_TRUE(names.insert(one.name).second);
    EXPECT_FALSE(one.x.label.empty() || one.y.label.empty()) << one.name;
    EXPECT_EQ(one.title.substr(0, 5), "Fig. ") << one.name;
  }
}

}  // namespace paper_figures_test
}  // namespace mixity
