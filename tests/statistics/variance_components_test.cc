#include "statistics/variance_components.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

namespace mixity {
namespace variance_components_test {

/// Deviations of readings x = 0..1 whose variance is constant + proportional x^2.
Deviations readings(std::size_t n, double constant, double proportional, unsigned seed, std::size_t pooled = 1) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  Deviations rows(2, pooled);
  for (std::size_t i = 0; i < n; ++i) {
    const double x = (static_cast<double>(i) + 0.5) / static_cast<double>(n);
    const double e = normal(random) * std::sqrt(constant + proportional * x * x);
    rows.add(e * e, 1, 0, std::vector<double>{1, x * x});
  }
  return rows;
}

TEST(VarianceComponents, OfOneConstantIsTheMeanSquare) {
  const Deviations rows = readings(50, 4, 0, 1);
  const auto found = fit_variances(rows, 1);
  double mean = 0;
  for (const double square : rows.squares) mean += square / 50;
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->theta[0], mean, 1e-12 * mean);
  EXPECT_EQ(found->theta[1], 0);
  EXPECT_NEAR(found->log_likelihood, -25 * (std::log(mean) + 1), 1e-9);
}

TEST(VarianceComponents, AreWhereTheLikelihoodIsStationaryOrOnTheBound) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    const Deviations rows = readings(200, seed % 2 ? 0.01 : 1, seed % 3 ? 4 : 0, seed);
    const auto found = fit_variances(rows, 3);
    ASSERT_TRUE(found);
    double constant = 0, proportional = 0, size = 0;  // the derivatives of ln L
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double x2 = rows.shapes[1][i], v = found->theta[0] + found->theta[1] * x2,
                   slope = (rows.squares[i] / v - 1) / v / 2;
      constant += slope;
      proportional += slope * x2;
      size += 1 / v;
    }
    // theta is right to 1e-9; the curvature of ln L times that
    EXPECT_LT(found->theta[0] > 0 ? std::abs(constant) : constant, 1e-7 * size) << seed;
    EXPECT_LT(found->theta[1] > 0 ? std::abs(proportional) : proportional, 1e-7 * size) << seed;
  }
}

TEST(VarianceComponents, AreTheTrueOnesWithinTheirScatter) {
  double constant = 0, proportional = 0;
  constexpr int kSamples = 200;
  for (unsigned seed = 0; seed < kSamples; ++seed) {
    const auto found = fit_variances(readings(400, 1, 9, seed), 3);
    ASSERT_TRUE(found);
    constant += found->theta[0] / kSamples;
    proportional += found->theta[1] / kSamples;
  }
  EXPECT_NEAR(constant, 1, 0.05);  // four standard errors of the mean of 200
  EXPECT_NEAR(proportional, 9, 0.35);
}

/// Rows that are pooled have the mean of the shapes, which within a pool differ by a hundredth here: less than a
/// hundredth of the scatter of what is found.
TEST(VarianceComponents, OfPooledRowsAreThoseOfAllRows) {
  constexpr std::size_t kRows = 20000, kPool = 30;  // the last pool is not full
  const Deviations all = readings(kRows, 1, 9, 5), pools = readings(kRows, 1, 9, 5, kPool);
  EXPECT_EQ(pools.size(), kRows / kPool + 1);
  const auto found = fit_variances(all, 3), of_pools = fit_variances(pools, 3);
  ASSERT_TRUE(found && of_pools);
  for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(of_pools->theta[k], found->theta[k], 2e-4 * found->theta[k]);
  double squares = 0, shares = 0;
  for (std::size_t i = 0; i < pools.size(); ++i) {
    squares += pools.shares[i] * pools.squares[i];
    shares += pools.shares[i];
  }
  EXPECT_NEAR(shares, kRows, 1e-8 * kRows);
  EXPECT_NEAR(squares, std::accumulate(all.squares.begin(), all.squares.end(), 0.0), 1e-10 * squares);
}

TEST(VarianceComponents, AddToTheFixedPart) {
  Deviations rows(1);
  for (const double square : {5.0, 7.0, 6.0}) rows.add(square, 1, 2, std::vector<double>{1});
  const auto found = fit_variances(rows, 1);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->theta[0], 4, 1e-12);
  rows.fixed = {9, 9, 9};
  const auto none = fit_variances(rows, 1);
  ASSERT_TRUE(none);
  EXPECT_EQ(none->theta[0], 0);
  EXPECT_EQ(none->used, 0u);
}

TEST(VarianceComponents, AreChosenWhereTheDataAskForThem) {
  const std::vector<std::uint32_t> choices{1, 2, 3};
  int constant = 0, proportional = 0, both = 0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    constant += choose_variances(readings(200, 1, 0, seed), choices)->theta[1] == 0;
    proportional += choose_variances(readings(200, 0, 1, seed), choices)->theta[0] == 0;
    both += choose_variances(readings(400, 1, 16, seed), choices)->used == 2;
  }
  EXPECT_GT(constant, 93);  // BIC of 200 rows errs in 2 to 3 of 100
  EXPECT_GT(proportional, 93);
  EXPECT_GT(both, 97);
}

TEST(VarianceComponents, HaveNoFitWithoutVariance) {
  Deviations rows(1);
  for (int i = 0; i < 5; ++i) rows.add(0, 1, 0, std::vector<double>{1});
  EXPECT_FALSE(fit_variances(rows, 1));
}

}  // namespace variance_components_test
}  // namespace mixity
