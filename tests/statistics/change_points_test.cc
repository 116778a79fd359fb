// Changes of a noisy course are found where they are, and their likelihoods say how well.
#include "statistics/change_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "statistics/noise.h"

namespace mixity {
namespace change_points_test {

using Values = std::vector<double>;

Values noise(std::size_t n, double sigma, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, sigma);
  Values values;
  for (std::size_t i = 0; i < n; ++i) values.push_back(normal(random));
  return values;
}

/// The least cost of all partitions, by the recursion without pruning.
double by_brute_force(const Values& y, double variance, double penalty) {
  Values cost(y.size() + 1, std::numeric_limits<double>::infinity());
  cost[0] = -penalty;
  for (std::size_t end = 1; end <= y.size(); ++end)
    for (std::size_t begin = 0; begin < end; ++begin) {
      double mean = 0, squares = 0;
      for (std::size_t i = begin; i < end; ++i) mean += y[i] / static_cast<double>(end - begin);
      for (std::size_t i = begin; i < end; ++i) squares += (y[i] - mean) * (y[i] - mean);
      cost[end] = std::min(cost[end], cost[begin] + squares / variance + penalty);
    }
  return cost.back();
}

double cost_of(const Values& y, std::vector<std::size_t> begins, double variance, double penalty) {
  begins.push_back(y.size());
  double cost = -penalty;
  for (std::size_t k = 0; k + 1 < begins.size(); ++k) {
    double mean = 0, squares = 0;
    const auto n = static_cast<double>(begins[k + 1] - begins[k]);
    for (std::size_t i = begins[k]; i < begins[k + 1]; ++i) mean += y[i] / n;
    for (std::size_t i = begins[k]; i < begins[k + 1]; ++i) squares += (y[i] - mean) * (y[i] - mean);
    cost += squares / variance + penalty;
  }
  return cost;
}

TEST(ChangePoints, OfLevelsAreTheBestPartitionOfAll) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    Values y = noise(80, 1, seed);
    for (std::size_t i = 20; i < 45; ++i) y[i] += 3;
    for (std::size_t i = 60; i < 80; ++i) y[i] -= 2;
    const double penalty = 10;
    EXPECT_NEAR(cost_of(y, mean_changes(y, 1, penalty), 1, penalty), by_brute_force(y, 1, penalty),
                1e-9);  // 80 sums of O(1)
  }
}

TEST(ChangePoints, OfABreakHoldTheTruthAsOftenAsTheySay) {
  std::size_t held = 0;
  constexpr std::size_t kTries = 1000;
  for (unsigned seed = 0; seed < kTries; ++seed) {
    Values T = noise(30, 1, seed), A = noise(30, 1, seed + 100000);
    for (std::size_t i = 0; i < 30; ++i) T[i] += i <= 14 ? 0.5 * static_cast<double>(i) : 4.0;
    for (std::size_t i = 15; i < 30; ++i) A[i] -= 2;
    const auto found = break_point({{&T, 1}, {&A, 1}}, 0, 30).value();
    held += found.first <= 14 && 14 <= found.last;
  }
  EXPECT_GT(held, kTries * 93 / 100);  // 95 % are wanted; a cut between readings counts in whole ones
}

TEST(ChangePoints, OfAHingeAreFoundWithTheirLevel) {
  std::size_t held = 0;
  constexpr std::size_t kTries = 1000;
  for (unsigned seed = 0; seed < kTries; ++seed) {
    Values T = noise(120, 0.5, seed);
    for (std::size_t i = 0; i < 120; ++i) T[i] += 3 + 0.3 * std::max(0.0, static_cast<double>(i) - 50);
    const auto found = hinge_point({&T, 0.5}, 0, 120).value();
    held += found.change.first <= 50 && 50 <= found.change.last;
    EXPECT_NEAR(found.level, 3, 0.5);  // 5 standard errors of a mean of fifty and the slope's part
    EXPECT_NEAR(found.slope, 0.3, 0.02);
  }
  EXPECT_GT(held, kTries * 92 / 100);
}

TEST(Noise, OfASmoothCourseIsWhatScatters) {
  Values y = noise(2000, 0.2, 1);
  for (std::size_t i = 0; i < y.size(); ++i)
    y[i] += 50 * std::sin(0.002 * static_cast<double>(i)) + (i > 1000 ? 30 : 0);
  EXPECT_NEAR(noise_of(y), 0.2, 0.015);  // 3 standard errors of a median of 2000
  EXPECT_EQ(noise_of({1, 2, 3}), 0);
}

// 10 kHz of a load cell that is noisier than what one sample falls by: the break of two lines is the fall's middle.
TEST(ChangePoints, AFallBeginsWhereItDoesThoughNoiseHidesThatItTakesTime) {
  constexpr std::size_t kBefore = 1600, kFalling = 40, kBehind = 300;
  constexpr double kNoise = 5, kDrop = 20;
  int held = 0, held_by_the_middle = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    Values y = noise(kBefore + kFalling + kBehind, kNoise, seed);
    for (std::size_t i = 0; i < y.size(); ++i) {
      y[i] += 0.002 * static_cast<double>(i);
      if (i >= kBefore) y[i] -= kDrop * std::min(1.0, static_cast<double>(i - kBefore + 1) / kFalling);
    }
    const ChangePoint middle = *break_point({{&y, kNoise}}, 0, y.size());
    const ChangePoint top = beginning_of_drop({&y, kNoise}, 0, y.size(), middle, 400);
    const auto holds = [&](const ChangePoint& cut) { return cut.first <= kBefore - 1 && kBefore - 1 <= cut.last; };
    held += holds(top);
    held_by_the_middle += holds(middle);
  }
  EXPECT_GE(held, 177);  // of 200 at 95 %: 190, less four standard deviations
  EXPECT_LT(held_by_the_middle, 20);
}

}  // namespace change_points_test
}  // namespace mixity
