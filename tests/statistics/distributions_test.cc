#include "statistics/distributions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace mixity {
namespace distributions_test {

// Closed forms: chi^2 of two degrees of freedom is exponential, Student's t of one is Cauchy's, F(2, 2) is F/(1 + F).
TEST(Distributions, KnowTheirClosedForms) {
  for (const double x : {1e-6, 0.3, 2.0, 25.0}) {
    EXPECT_NEAR(chi_squared_p_value(x, 2) / std::exp(-x / 2), 1, 1e-14) << x;
    EXPECT_NEAR(student_p_value(x, 1) * std::numbers::pi / (2 * std::atan(1 / x)), 1, 1e-13) << x;
    EXPECT_NEAR(fisher_p_value(x, 2, 2) * (1 + x), 1, 1e-14) << x;
    EXPECT_NEAR(2 * normal_below(-x) / std::erfc(x / std::numbers::sqrt2), 1, 1e-13) << x;
  }
}

// NIST/SEMATECH e-Handbook 1.3.6.7.
TEST(Distributions, KnowThePrintedTables) {
  EXPECT_NEAR(normal_quantile(0.975), 1.959963984540054, 1e-15);
  EXPECT_NEAR(normal_below(1.959963984540054), 0.975, 1e-15);
  EXPECT_NEAR(student_p_value(2.228139, 10), 0.05, 1e-7);
  EXPECT_NEAR(chi_squared_quantile(0.95, 1), 3.841458820694124, 1e-14);
  EXPECT_NEAR(chi_squared_p_value(18.307038, 10), 0.05, 1e-8);
  EXPECT_NEAR(fisher_quantile(0.95, 1, 10), 4.964603, 1e-6);
  EXPECT_NEAR(fisher_p_value(3.325835, 5, 10), 0.05, 1e-7);
}

TEST(Distributions, TailsAreSymmetricAndQuantilesInvertThem) {
  EXPECT_EQ(student_p_value(-1.7, 4.5), student_p_value(1.7, 4.5));
  for (const double p : {1e-9, 0.2, 0.5, 0.9999}) {
    EXPECT_NEAR(normal_below(normal_quantile(p)) / p, 1, 1e-13);
    EXPECT_NEAR(1 - chi_squared_p_value(chi_squared_quantile(p, 3.5), 3.5), p, 1e-14);
    EXPECT_NEAR(1 - fisher_p_value(fisher_quantile(p, 1, 7), 1, 7), p, 1e-14);
  }
}

/// Any size of sample, from exact data to residuals that overflow.
TEST(Distributions, AreProbabilitiesWhateverTheArguments) {
  const double none = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const double x : {0.0, 1e-300, 1e-20, 1e-3, 1.0, 1e3, 1e20, 1e300, infinity, none})
    for (const double freedom : {1.0, 3.0, 3511.0, 1e5, 1e7}) {
      for (const double p : {chi_squared_p_value(x, freedom), student_p_value(x, freedom),
                             fisher_p_value(x, 3, freedom), fisher_p_value(x, freedom, 7)})
        EXPECT_TRUE(p >= 0 && p <= 1) << x << ' ' << freedom << ' ' << p;
    }
  EXPECT_EQ(chi_squared_p_value(1e-20, 4000), 1);
  // where the bound takes over, what is missing from 1 is below its rounding
  EXPECT_EQ(chi_squared_p_value(3000, 4000), 1);
  EXPECT_LT(chi_squared_p_value(3500, 4000), 1);
}

TEST(Distributions, NoChiSquaredIsNoSurprise) {
  EXPECT_EQ(chi_squared_p_value(0, 3), 1);
  EXPECT_EQ(chi_squared_p_value(-1e-18, 3), 1);
  EXPECT_EQ(chi_squared_p_value(std::numeric_limits<double>::quiet_NaN(), 3), 1);
}

}  // namespace distributions_test
}  // namespace mixity
