// The vectorised cost of objective toughness against the general one, through residuals and Jacobian.
#include <gtest/gtest.h>

#include <cmath>

#include "fitting/models.h"
#include "fitting/toughness_objective.h"

namespace mixity {
namespace packed_toughness_test {

class PackedCost : public OfModel {};
INSTANTIATE_TEST_SUITE_P(OfLambda, PackedCost, ::testing::Values("a", "b", "c"));

TEST_P(PackedCost, IsTheGeneralOne) {
  constexpr std::size_t kPoints = 203;  // no multiple of any number of lanes
  std::vector<ToughnessPoint> points;
  std::vector<double> errors(kPoints), weights(kPoints);
  for (std::size_t i = 0; i < kPoints; ++i) {
    const auto t = static_cast<double>(i);
    const auto mixity = mixity_from_angle(1.5 * (t + 0.5) / kPoints);
    points.push_back({mixity, std::exp(log_f(model(), {0.2}, mixity) + 0.05 * std::sin(12 * t * t))});
    errors[i] = 1 + 0.1 * static_cast<double>(i % 7);
    weights[i] = static_cast<double>(i % 4);
  }
  const ToughnessObjective problem(points, Scale::log, FreeChoice(model(), {{0.15}, {}}, {}), errors);
  const auto packed = problem.cost();
  ASSERT_TRUE(packed->exact_curvature());
  const auto general = problem.Problem::cost();  // of any problem
  CostValue one, other, low, high;
  for (const double x : {1e-3, 0.2, 0.8})
    for (const auto& w : {std::vector<double>{}, weights}) {
      packed->at({&x, 1}, w, one);
      general->at({&x, 1}, w, other);
      ASSERT_TRUE(one.finite && other.finite);
      EXPECT_NEAR(one.value, other.value, 1e-12 * other.value);  // 203 roundings in another order
      EXPECT_NEAR(one.gradient[0], other.gradient[0], 1e-11 * other.slope_size[0] * std::sqrt(other.value));
      EXPECT_NEAR(one.slope_size[0], other.slope_size[0], 1e-12 * other.slope_size[0]);
      const double h = 1e-5 * x, below = x - h, above = x + h;  // central difference of the slope: error h^2 and eps/h
      packed->at({&below, 1}, w, low);
      packed->at({&above, 1}, w, high);
      const double curvature = (high.gradient[0] - low.gradient[0]) / (2 * h);
      EXPECT_NEAR(one.hessian(0, 0), curvature,
                  1e-6 * std::abs(curvature) + 1e-6 * one.slope_size[0] * one.slope_size[0]);
    }
}

}  // namespace packed_toughness_test
}  // namespace mixity
