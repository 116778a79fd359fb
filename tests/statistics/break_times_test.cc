// When a course breaks: as exactly as its readings tell, and not more.
#include "statistics/break_times.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

namespace mixity {
namespace break_times_test {

/// Readings at 0, 1, ... 39 with normal noise of deviation 1.
template <class Course>
std::pair<std::vector<double>, std::vector<double>> readings(unsigned seed, Course course) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> time(40), values(40);
  std::iota(time.begin(), time.end(), 0);
  for (std::size_t i = 0; i < time.size(); ++i) values[i] = course(time[i]) + normal(random);
  return {time, values};
}

TEST(BreakTimes, OfAKinkAreInTheirIntervalsAsOftenAsIsSaid) {
  int held = 0;
  double squares = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    const double at = 20 + 0.37 * (seed % 17) / 17;
    const auto [time, values] = readings(seed, [&](double t) { return t < at ? 2 * (at - t) : 0; });
    const TimeDensity found = break_times(time, values, 1, 10, 30, 0.05, {});
    held += quantile(found, 0.025) <= at && at <= quantile(found, 0.975);
    const auto [mean, deviation] = moments(found);
    squares += std::pow((mean - at) / deviation, 2) / 400;
  }
  EXPECT_GE(held, 362);     // four standard errors below 95 % of 400
  EXPECT_LT(squares, 1.2);  // of 400 squares, 1 +/- 0.07; the average over forms is cautious
}

TEST(BreakTimes, OfAJumpAreAnywhereBetweenTwoReadings) {
  const auto [time, values] = readings(1, [](double t) { return t < 20.5 ? 0 : 100; });
  const TimeDensity found = break_times(time, values, 1, 10, 30, 0.02, {0, 0, false, 0, false});
  const auto [mean, deviation] = moments(found);
  EXPECT_NEAR(mean, 20.5, 0.02);
  EXPECT_NEAR(deviation, 1 / std::sqrt(12), 0.01);
  EXPECT_NEAR(quantile(found, 0.975) - quantile(found, 0.025), 0.95, 0.02);
}

/// The course jumps at some time after the break, as an area may at any time while the force falls.
TEST(BreakTimes, OfAJumpBeforeAKneeAreEarlier) {
  const auto [time, values] = readings(1, [](double t) { return t < 20.5 ? 0 : 100; });
  const TimeDensity found = break_times(time, values, 1, 10, 30, 0.02, {0, 0, false, 4, false});
  const auto [mean, deviation] = moments(found);
  EXPECT_NEAR(mean, 18.5, 0.05);
  EXPECT_NEAR(deviation, std::sqrt((1 + 4 * 4) / 12.0), 0.05);
}

TEST(BreakTimes, OfACourseThatDoesNotBreakAreAnywhere) {
  const auto [time, values] = readings(2, [](double t) { return 3 * t - 0.02 * t * t; });
  EXPECT_GT(moments(break_times(time, values, 1, 10, 30, 0.1, {})).deviation, 0.8 * 20 / std::sqrt(12));
}

TEST(BreakTimes, OfTooFewReadingsAreNone) {
  EXPECT_TRUE(break_times({0, 1, 2}, {0, 1, 2}, 1, 0, 2, 0.1, {}).p.empty());
  EXPECT_TRUE(break_times({0, 1, 2, 3, 4}, {0, 0, 0, 0, 0}, 0, 0, 4, 0.1, {}).p.empty());  // no noise: no odds
}

TEST(BreakTimes, DifferOnceBySumsOfTheirProbabilities) {
  TimeDensity difference{-5, 0.1, std::vector<double>(101)};
  add_differences(normal_times(1, 0.3, 0.1), normal_times(3, 0.4, 0.1), difference);
  const auto [mean, deviation] = moments(difference);
  EXPECT_NEAR(mean, 2, 1e-9);
  EXPECT_NEAR(deviation, 0.5, 0.005);  // ends at four deviations
}

}  // namespace break_times_test
}  // namespace mixity
