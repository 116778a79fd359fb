#include "statistics/steps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace mixity {
namespace steps_test {

/// A smooth run, read in steps and printed with these digits.
std::vector<double> stepped(double step, double digit, double from, std::size_t n) {
  std::vector<double> run;
  for (std::size_t i = 0; i < n; ++i) {
    const double value = from + 0.3 * std::sin(0.01 * static_cast<double>(i));
    run.push_back(std::round(std::round(value / step) * step / digit) * digit);
  }
  return run;
}

TEST(CommonStep, IsThatOfTheConverterAlsoWhereItIsPrintedRounded) {
  for (const double step : {0.01, 0.0317, 0.005}) {
    // two runs share the step; printed to a thousandth of it, single differences are off by that
    const double found = common_step({stepped(step, 1e-3 * step, 0.5, 400), stepped(step, 1e-3 * step, 0.7, 400)});
    EXPECT_NEAR(found, step, 1e-4 * step) << step;
  }
}

TEST(CommonStep, IsNoneOfNoisyReadings) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  std::vector<double> run(300);
  for (double& one : run) one = normal(random);
  EXPECT_EQ(common_step({run}), 0);
}

TEST(CommonStep, IsNoneOfSetPointsThatRunsShare) {
  const std::vector<double> set_points{0, 1, 2, 3, 4, 5, 6, 7};
  EXPECT_EQ(common_step({set_points, set_points, set_points}), 0);
}

TEST(CommonStep, IsNoneOfNothingAndOfOneValue) {
  EXPECT_EQ(common_step({}), 0);
  EXPECT_EQ(common_step({{2}}), 0);
  EXPECT_EQ(common_step({{2, 2, 2}}), 0);
}

}  // namespace steps_test
}  // namespace mixity
