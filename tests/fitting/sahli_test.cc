#include "fitting/sahli.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fitting/models.h"

namespace mixity {
namespace sahli_test {

/// Runs of model c at these loads, T up to a fraction of the instability.
Dataset runs(double lambda, const std::vector<double>& loads, double fraction) {
  Dataset data;
  data.has_loads = true;
  for (const double P : loads) {
    const ContactModel model = model_named("c");
    const double last = model.first_stable_end(ParameterValues{lambda}, P);
    for (int i = 0; i <= 20; ++i) {
      Point point{};
      point.curve = static_cast<Point::Index>(data.curves.size());
      point.P = P;
      point.T = fraction * last * i / 20;
      const double y = model.equilibria(ParameterValues{lambda}, P, {&point.T, 1}).at[0].y;
      point.A = area_from_radius(radius_from_edge_load(y, P));
      data.points.push_back(point);
    }
    data.curves.push_back("P=" + std::to_string(P));
    data.curve_loads.push_back(P);
  }
  return data;
}

TEST(Sahli, FindsTheSensitivityThatTheModelPredictsAtSmallShear) {
  const SahliResult result = fit_sahli(runs(0.15, {-2, 0, 5, 50}, 0.02), 1, "c", {0.15});
  ASSERT_EQ(result.runs.size(), 4u);
  for (const SahliRun& run : result.runs) {
    // The next order, T^4, is (0.02)^2 of the parabola times a factor of order one.
    const double A0 = area_from_radius(jkr_radius(run.P));
    EXPECT_NEAR(run.alpha, *model_named("c").shear_sensitivity(ParameterValues{0.15}, A0), 1e-3 * run.alpha);
    EXPECT_NEAR(run.A0, A0, 1e-6 * run.A0);
    EXPECT_NEAR(*run.alpha_predicted, run.alpha, 1e-3 * run.alpha);
  }
}

TEST(Sahli, PowerLawTendsToMinusFiveFourthsForLargeAreas) {
  const SahliResult result = fit_sahli(runs(0.3, {1e6, 3e6, 1e7}, 0.01), 1, "c", {0.3});
  // The correction to alpha is 2.2/sqrt(P): 0.2 % at the smallest load, which tilts the slope by less than 0.005.
  EXPECT_NEAR(result.power_law->exponent, -1.25, 5e-3);
  EXPECT_NEAR(result.predicted_power_law->exponent, result.power_law->exponent, 1e-3);
}

TEST(Sahli, UsesOnlyTheShearItIsTold) {
  const Dataset data = runs(0.15, {3}, 0.9);
  EXPECT_EQ(fit_sahli(data, 1).runs[0].points, 21u);
  EXPECT_EQ(fit_sahli(data, 0.5).runs[0].points, 11u);
  EXPECT_FALSE(fit_sahli(data, 1).runs[0].alpha_predicted);
}

/// T^4 is then as small as doubles go.
TEST(Sahli, StandardErrorsOfTheSmallestShearAreFinite) {
  Dataset data = runs(0.15, {5}, 1);
  for (Point& point : data.points) point.T *= 1e-80;
  const SahliResult result = fit_sahli(data, 1, "c", {0.15});
  ASSERT_EQ(result.runs.size(), 1u);
  EXPECT_TRUE(std::isfinite(*result.runs[0].alpha_stderr));
}

TEST(Sahli, RunsWithoutShearAreNamed) {
  Dataset data = runs(0.15, {3}, 0.5);
  data.points.resize(1);
  const SahliResult result = fit_sahli(data, 1);
  EXPECT_TRUE(result.runs.empty());
  EXPECT_EQ(result.skipped.size(), 1u);
  EXPECT_FALSE(result.power_law);
}

}  // namespace sahli_test
}  // namespace mixity
