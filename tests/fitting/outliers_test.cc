// Outliers are named where there are some, and seldom where there are none.
#include <gtest/gtest.h>

#include "fitting/fit.h"
#include "fitting/measured_runs.h"

namespace mixity {
namespace outliers_test {

const FitOptions kEstimated{.intervals = false};

/// Loading runs of 15 points each, 1 % of noise.
Dataset with_shift(std::size_t point, double factor) {
  Dataset data = measured_runs(3);
  data.points[point].A *= factor;
  return data;
}

TEST(Outliers, AreNamedWithTheirSignAndSize) {
  // Near T = 0 the curve is flat: the distance is that in A, 6 % in errors of 1 %, and the noise of that point.
  for (const FitOptions& options : {stated_errors(), kEstimated})
    for (const double factor : {0.94, 1.06}) {
      const FitResult fit = fit_model(with_shift(32, factor), "c", options);
      ASSERT_EQ(fit.outliers.size(), 1U);
      EXPECT_EQ(fit.outliers[0].point, 32U);
      EXPECT_NEAR(fit.outliers[0].size, factor < 1 ? 6 : -6, 2);
    }
}

/// Ten of 90 points triple the root mean square of the residuals; their median knows little of them.
TEST(Outliers, DoNotHideEachOther) {
  Dataset data = measured_runs(3);
  for (std::size_t i = 1; i < data.points.size(); i += 9) data.points[i].A *= i % 2 == 0 ? 0.9 : 1.1;
  EXPECT_EQ(fit_model(data, "c", kEstimated).outliers.size(), 10U);
}

TEST(Outliers, OfCleanDataAreNamedInOneFitOfAHundred) {
  for (const FitOptions& options : {stated_errors(), kEstimated}) {
    int named = 0;
    for (unsigned seed = 1; seed <= 400; ++seed)
      named += !fit_model(measured_runs(seed, {}, 5), "c", options).outliers.empty();
    // 4 are expected; 10 or more would be named in 8 of 1000 runs of this test
    EXPECT_LE(named, 9);
  }
}

TEST(Outliers, OfPointsOnTheCurveAreNone) {
  EXPECT_TRUE(fit_model(synthetic_runs("c", {0.15}, {1, 5, 20}), "c", kEstimated).outliers.empty());
}

TEST(Outliers, AreNotLookedForWithoutChecks) {
  FitOptions options = kEstimated;
  options.checks = false;
  EXPECT_TRUE(fit_model(with_shift(32, 0.94), "c", options).outliers.empty());
}

}  // namespace outliers_test
}  // namespace mixity
