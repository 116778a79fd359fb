// Points and curves of the area and behaviour figures against the file and the printed equation.
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/run.h"
#include "base/number_text.h"
#include "dataset/temporary_folder.h"
#include "report/example_results.h"
#include "report/figures/data_figures.h"
#include "report/figures/read_back.h"

namespace mixity {
namespace area_figures_test {

const double kPi = std::acos(-1.0);
// Mergel et al. (2018): units of the figures in dimensionless ones
constexpr double kRadius = 9.42e-3, kModulus = 2.133e6, kToughness = 27e-3;
const double kForce = kRadius * kToughness * 1e3;  // mN
const double kXi = std::cbrt(kModulus * kRadius / kToughness);
const double kArea = std::pow(kRadius / kXi * 1e3, 2);     // mm^2
const double kDisplacement = kRadius / (kXi * kXi) * 1e6;  // um

double printed_f(char model, double lambda, double psi) {
  if (model == 'a') return 1 + (1 - lambda) * std::pow(std::tan(psi), 2);
  if (model == 'b') return 1 + std::pow(std::tan((1 - lambda / 2) * psi), 2);
  return 1 / (1 + (lambda - 1) * std::pow(std::sin(psi), 2));
}

/// Of y^2 + T^2 = 8 pi a^3 f(psi), relative; P, T, A dimensionless.
double printed_residual(char model, double lambda, double P, double T, double A) {
  const double a3 = std::pow(A / kPi, 1.5), y = 4.0 / 3 * a3 - P;
  return (y * y + T * T) / (8 * kPi * a3 * printed_f(model, lambda, std::atan2(T, y))) - 1;
}

double fitted_lambda(const std::string& model) {
  for (const FitResult& fit : shipped("mergel2018").fits)
    if (fit.model == model) return *fit.parameters[0].value;
  throw std::runtime_error(model);
}

const ReportedData& reported() {
  static const ReportedData data = reported_data(shipped("mergel2018"), "m");
  return data;
}

const std::vector<Figure>& figures() {
  static const std::vector<Figure> drawn = [] {
    std::vector<Figure> all = area_figures(reported());
    for (Figure& figure : behaviour_figures(reported())) all.push_back(std::move(figure));
    return all;
  }();
  return drawn;
}

TEST(AreaFigures, ShowEveryPointOfTheFileWithItsLine) {
  const Dataset& data = shipped("mergel2018").data;
  for (const char* name : {"m_area_models", "m_area_c"}) {
    std::size_t found = 0;
    for (const Series& series : figure_named(figures(), name).series)
      for (std::size_t i = 0; i < series.hover.size(); ++i) {
        std::size_t line = 0;
        if (std::sscanf(series.hover[i].c_str(), "line %zu", &line) != 1) continue;
        const Point& point = data.points.at(line - 2);  // the file has a header and no other lines
        EXPECT_EQ(point.line, line);
        EXPECT_NEAR(series.points[i].first, point.T * kForce, 1e-12 * kForce);
        EXPECT_NEAR(series.points[i].second, point.A * kArea, 1e-12);
        ++found;
      }
    EXPECT_EQ(found, data.points.size()) << name;
  }
}

TEST(AreaFigures, CurvesOfEveryModelAreInEquilibriumAtTheirLoad) {
  const Dataset& data = shipped("mergel2018").data;
  for (const char model : {'a', 'b', 'c'}) {
    const double lambda = fitted_lambda(std::string(1, model));
    const Figure& figure = figure_named(figures(), std::string("m_area_") + model);
    std::size_t checked = 0;
    double P = 0;
    for (const Series& series : figure.series) {
      if (series.look == Look::circles) P = data.curve_loads[reported().figured.runs[checked++]];  // its curves follow
      if (series.look != Look::solid && series.look != Look::dashed) continue;
      for (const auto& [T, A] : series.points) {
        const double a3 = std::pow(A / kArea / kPi, 1.5);
        // y = 4/3 a^3 - P loses what it is smaller than P by, and A was rounded to the file's unit and back
        if (4.0 / 3 * a3 - P < 1e-2) continue;
        EXPECT_LT(std::abs(printed_residual(model, lambda, P, T / kForce, A / kArea)), 1e-9)
            << model << " P=" << P << " T=" << T;
      }
    }
    EXPECT_EQ(checked, data.curves.size());
  }
}

TEST(AreaFigures, JumpsOfModelCAreAtThePublishedClosedForms) {
  const Dataset& data = shipped("mergel2018").data;
  const double lambda = fitted_lambda("c");
  const Figure& figure = figure_named(figures(), "m_area_c");
  const Series *load = nullptr, *displacement = nullptr;
  for (const Series& series : figure.series) {
    if (series.look == Look::triangles) load = &series;
    if (series.look == Look::diamonds) displacement = &series;
  }
  ASSERT_TRUE(load && displacement);
  const std::vector<std::size_t> runs = reported().figured.runs;
  ASSERT_EQ(load->points.size(), runs.size());
  ASSERT_EQ(displacement->points.size(), runs.size());
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const double P = data.curve_loads[runs[k]];
    const double T = std::sqrt(3 * kPi * (3 * kPi + 2 * P) / lambda);
    EXPECT_NEAR(load->points[k].first / (T * kForce), 1, 1e-12);
    EXPECT_NEAR(load->points[k].second / (kPi * std::pow(0.75, 2.0 / 3) * std::pow(3 * kPi + P, 2.0 / 3) * kArea), 1,
                1e-12);
    const double root = std::sqrt(3 * std::pow(3 * kPi + P, 2) * (3 * kPi * kPi + 2 * kPi * P + 3 * P * P));
    const double T_u = 0.5 * std::sqrt(1.5 * (9 * kPi * kPi + 6 * kPi * P - 3 * P * P + root) / lambda);
    EXPECT_NEAR(displacement->points[k].first / (T_u * kForce), 1, 1e-12);
  }
}

/// Model c to this share of its jump at one load, P = 3, and lambda = 0.15.
Figure figure_of_data_up_to(double share) {
  const TemporaryFolder folder;
  constexpr double kLoad = 3, kLambda = 0.15;
  const double jump = std::sqrt(3 * kPi * (3 * kPi + 2 * kLoad) / kLambda);
  std::string text = "P,T,A\n";
  for (int i = 0; i <= 12; ++i) {
    const double T = share * jump * i / 12;
    const double y = 3 * kPi + std::sqrt(9 * kPi * kPi + 6 * kPi * kLoad - kLambda * T * T);
    text += "3," + shortest(T) + "," + shortest(kPi * std::pow(0.75 * (y + kLoad), 2.0 / 3)) + "\n";
  }
  FitRequest request;
  request.data_path = folder.write("run.csv", text);
  request.models = {"c"};
  const Analysis result = run(request);
  return figure_named(area_figures(reported_data(result, "m")), "m_area_c");
}

TEST(AreaFigures, HoldTheJumpUnlessThatLeavesTheDataLessThanHalfOfTheWidth) {
  const double jump = std::sqrt(3 * kPi * (3 * kPi + 6) / 0.15);
  for (const double share : {0.95, 0.77, 0.51}) {
    const Figure figure = figure_of_data_up_to(share);
    EXPECT_GE(*figure.x.high, 1.04 * jump) << share;
    EXPECT_EQ(figure.caption.find("Beyond the frame"), std::string::npos) << share;
  }
  const Figure far = figure_of_data_up_to(0.3);
  EXPECT_NEAR(*far.x.high, 1.05 * 0.3 * jump, 1e-6 * jump);
  EXPECT_NE(far.caption.find("Beyond the frame the contact jumps, under load control, at T = 31.13 (P = 3)."),
            std::string::npos)
      << far.caption;
}

TEST(AreaFigures, StrengthLineIsTheStatedStressTimesTheArea) {
  const Series& line = series_named(figure_named(figures(), "m_area_c"), "sliding, T = τ_0 A");
  const auto& [T, A] = line.points.back();
  EXPECT_NEAR(T / A, 0.43e6 * 1e-6 * 1e3, 1e-9);  // MPa in mN/mm^2
}

TEST(AreaFigures, OfAllModelsEndWhereTheContactJumps) {
  const Figure& figure = figure_named(figures(), "m_area_models");
  const Series& top = *std::find_if(figure.series.begin(), figure.series.end(),
                                    [](const Series& series) { return series.look == Look::solid; });
  const double P = shipped("mergel2018").data.curve_loads[reported().figured.runs[0]];
  const double T_fold = std::sqrt(3 * kPi * (3 * kPi + 2 * P) / fitted_lambda("c")) * kForce;
  EXPECT_LE(top.points.back().first, T_fold * (1 + 1e-12));
  EXPECT_GT(top.points.back().first, 0.99 * T_fold);  // the last point before the turn
}

TEST(BehaviourFigures, DisplacementIsThreeQuartersOfTOverA) {
  const Figure &u_T = figure_named(figures(), "m_u_T"), &A_u = figure_named(figures(), "m_A_u");
  ASSERT_EQ(u_T.series.size(), A_u.series.size());
  for (std::size_t i = 0; i < u_T.series.size(); ++i) {
    ASSERT_EQ(u_T.series[i].points.size(), A_u.series[i].points.size());
    for (std::size_t k = 0; k < u_T.series[i].points.size(); ++k) {
      const auto& [T, u] = u_T.series[i].points[k];
      const double A = A_u.series[i].points[k].second;
      if (A < 1e-6) continue;  // towards the vanishing contact both T and a go
      EXPECT_NEAR(u / kDisplacement, 0.75 * T / kForce / std::sqrt(A / kArea / kPi), 1e-9 * (1 + u / kDisplacement));
    }
  }
}

TEST(BehaviourFigures, RadiiAtConstantShearAreInEquilibrium) {
  const Figure& figure = figure_named(figures(), "m_a_P");
  double largest = 0;
  for (const Point& point : shipped("mergel2018").data.points) largest = std::max(largest, point.T);
  std::size_t i = 0;
  for (const FitResult& fit : shipped("mergel2018").fits)
    for (int quarter = 1; quarter <= 4; ++quarter)
      for (int part = 0; part < 2; ++part, ++i)  // stable, unstable
        for (const auto& [P, a] : figure.series.at(i).points) {
          const double area = kPi * a * a / kArea, y = 4.0 / 3 * std::pow(area / kPi, 1.5) - P / kForce;
          if (y < 1e-2) continue;
          EXPECT_LT(std::abs(printed_residual(fit.model[0], *fit.parameters[0].value, P / kForce, largest * quarter / 4,
                                              area)),
                    1e-8)
              << fit.model << ' ' << P;
        }
}

}  // namespace area_figures_test
}  // namespace mixity
