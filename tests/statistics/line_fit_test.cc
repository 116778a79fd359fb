// Against the sums of the textbook, for a few whole numbers.
#include "statistics/line_fit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mixity {
namespace line_fit_test {

TEST(LineFit, HasTheStandardErrorsOfItsDeviations) {
  const LineFit line = fit_line({0, 1, 2, 3}, {1, 3, 4, 8});
  EXPECT_DOUBLE_EQ(line.slope, 2.2);        // 11/5
  EXPECT_DOUBLE_EQ(line.intercept(), 0.7);  // 4 - 2.2 * 1.5
  EXPECT_DOUBLE_EQ(line.squares, 1.8);      // 26 - 11^2/5
  EXPECT_DOUBLE_EQ(*line.slope_stderr(), std::sqrt(0.9 / 5));
  EXPECT_DOUBLE_EQ(*line.intercept_stderr(), std::sqrt(0.9 * (0.25 + 2.25 / 5)));
}

TEST(LineFit, HasNoErrorsWithoutThreePointsAtTwoPlaces) {
  EXPECT_DOUBLE_EQ(fit_line({1, 2}, {0, 5}).slope, 5);
  EXPECT_FALSE(fit_line({1, 2}, {0, 5}).slope_stderr());
  const LineFit level = fit_line({2, 2, 2}, {1, 2, 6});
  EXPECT_EQ(level.slope, 0);
  EXPECT_DOUBLE_EQ(level.mean_y, 3);
  EXPECT_DOUBLE_EQ(level.squares, 14);
  EXPECT_FALSE(level.intercept_stderr());
}

}  // namespace line_fit_test
}  // namespace mixity
