// Areas without shear against JKR, solved here by bisection.
#include "fitting/unsheared.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fitting/measured_runs.h"

namespace mixity {
namespace unsheared_test {

TEST(Unsheared, AgreesWithJkrWhereTheConstantsAreRight) {
  const auto test = test_unsheared(measured_runs(2), stated_errors());
  ASSERT_TRUE(test);
  EXPECT_EQ(test->points, 6u);
  EXPECT_EQ(test->loads, 6u);
  EXPECT_GT(test->p_value, 1e-3);
  ASSERT_EQ(test->implied.size(), 3u);
  EXPECT_EQ(test->implied[0].constant, "modulus");
  EXPECT_NEAR(test->implied[0].value, 2e6, 4 * test->implied[0].standard_error);
  EXPECT_NEAR(test->implied[2].value, 0, 4 * test->implied[2].standard_error);
}

/// A factor f on all areas is one of f^(-3/2) on the modulus: A = pi a^2 and E* a^3 is what the loads say.
TEST(Unsheared, ImpliesTheModulusOfAreasThatAreTooLarge) {
  Dataset data = measured_runs(2);
  for (Point& point : data.points) point.A *= 1.1;
  const auto right = test_unsheared(measured_runs(2), stated_errors()), wrong = test_unsheared(data, stated_errors());
  EXPECT_LT(wrong->p_value, 1e-6);
  EXPECT_NEAR(wrong->implied[0].value, right->implied[0].value * std::pow(1.1, -1.5),
              1e-6 * 2e6);  // what the fit stops at
  EXPECT_NEAR(wrong->implied[0].chi2, right->implied[0].chi2, 1e-6);
  EXPECT_EQ(wrong->points, 6U);
}

TEST(Unsheared, IsSilentWithoutLoadsOrWithoutUnshearedPoints) {
  Dataset data = measured_runs(2);
  std::erase_if(data.points, [](const Point& point) { return point.T == 0; });
  EXPECT_FALSE(test_unsheared(data, stated_errors()));
  data.has_loads = false;
  EXPECT_FALSE(test_unsheared(data, stated_errors()));
}

}  // namespace unsheared_test
}  // namespace mixity
