// Maxima and minima of stick and slip are neither raised by noise nor lowered by frames, and their errors are right.
#include "dataset/logs/cycles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "statistics/drops.h"
#include "statistics/noise.h"

namespace mixity {
namespace cycles_test {

/// A ramp to 60, falls to 40 and rises to 55 three times, at last where T goes back to 0, which may be steady sliding
/// before that. In s and mN.
struct Simulated {
  Frames frames;
  std::size_t falls = 3;
};

Simulated simulate(double rate, double frame_rate, double noise, unsigned seed, bool steady = false) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, noise);
  Simulated made;
  Frames& frames = made.frames;
  std::vector<double> T;
  const auto add = [&](double seconds, double from, double to) {
    const auto n = static_cast<std::size_t>(seconds * rate);
    for (std::size_t i = 0; i < n; ++i)
      T.push_back(from + (to - from) * static_cast<double>(i) / static_cast<double>(n) + normal(random));
  };
  add(4, 0, 60);
  if (steady) {
    made.falls = 1;
    add(0.004, 60, 40);
    add(1.5, 40, 40);
    add(0.3, 40, 0);
  } else {
    for (std::size_t k = 0; k < made.falls; ++k) {
      add(0.004, k == 0 ? 60 : 55, 40);
      add(0.5, 40, 55);
    }
    add(0.3, 55, 0);
  }
  add(0.2, 0, 0);
  const auto each = static_cast<std::size_t>(rate / frame_rate);
  frames.interval = 1 / frame_rate;
  frames.samples = rate / frame_rate;
  for (std::size_t i = 0; i < T.size(); ++i) frames.force_time.push_back(static_cast<double>(i) / rate);
  for (std::size_t i = 0; i + each <= T.size(); i += each) {
    double sum = 0;
    for (std::size_t k = 0; k < each; ++k) sum += T[i + k];
    frames.time.push_back((static_cast<double>(i) + 0.5 * static_cast<double>(each - 1)) / rate);
    frames.T.push_back(sum / static_cast<double>(each));
  }
  frames.force_T = std::move(T);
  return made;
}

std::vector<Cycle> cycles_of(const Frames& frames) {
  return slip_cycles(frames, {frames.T, 1, 0, noise_of(frames.T)}, rising_from(frames.T, 0, frames.T.size()),
                     frames.T.size());
}

/// Errors over their standard errors.
struct Told {
  double sum = 0, squares = 0;
  std::size_t n = 0;
  void add(double error, double standard_error) {
    const double z = error / standard_error;
    sum += z;
    squares += z * z;
    ++n;
  }
  double mean() const { return sum / static_cast<double>(n); }
  double spread() const { return std::sqrt(squares / static_cast<double>(n)); }
};

/// Of a hundred logs: bias below a third of the error that is told, and errors that are neither half nor one and a
/// half.
void expect_unbiased(double rate, double frame_rate, double noise) {
  Told first, later, minima;
  for (unsigned seed = 0; seed < 100; ++seed) {
    const std::vector<Cycle> cycles = cycles_of(simulate(rate, frame_rate, noise, seed).frames);
    ASSERT_EQ(cycles.size(), 3u) << seed;
    first.add(cycles[0].T_peak - 60, cycles[0].error_peak);
    for (const Cycle& cycle : cycles) {
      if (&cycle != &cycles[0]) later.add(cycle.T_peak - 55, cycle.error_peak);
      minima.add(cycle.T_min.value() - 40, cycle.error_min);
    }
    EXPECT_NEAR(cycles[0].time, 4, 0.05);
    EXPECT_NEAR(cycles[0].time_min, 4.004, 0.05);
  }
  for (const Told& told : {first, later, minima}) {
    EXPECT_LT(std::abs(told.mean()), 0.33) << rate << ' ' << frame_rate;
    EXPECT_GT(told.spread(), 0.5) << rate << ' ' << frame_rate;
    EXPECT_LT(told.spread(), 1.5) << rate << ' ' << frame_rate;
  }
}

TEST(Cycles, AreUnbiasedByFastFramesOfNoise) { expect_unbiased(10000, 200, 2); }
TEST(Cycles, AreUnbiasedByFramesOfAFewSamples) { expect_unbiased(1000, 200, 1); }
TEST(Cycles, AreUnbiasedByOneSampleAFrame) { expect_unbiased(200, 200, 1); }
TEST(Cycles, AreUnbiasedBySlowFramesThatHoldAFall) { expect_unbiased(10000, 10, 2); }

TEST(Cycles, AreNotWhereTheShearIsTakenBack) {
  for (const double frame_rate : {10.0, 50.0, 200.0})
    for (unsigned seed = 0; seed < 20; ++seed) {
      const auto cycles = cycles_of(simulate(10000, frame_rate, 2, seed).frames);
      ASSERT_EQ(cycles.size(), 3u) << frame_rate << ' ' << seed;
      EXPECT_GT(cycles.back().T_min.value(), 35);
    }
}

TEST(Cycles, HaveTheirMinimumWhereSlidingIsSteady) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const auto cycles = cycles_of(simulate(10000, 100, 2, seed, true).frames);
    ASSERT_EQ(cycles.size(), 1u) << seed;
    EXPECT_NEAR(cycles[0].T_peak, 60, 4 * cycles[0].error_peak);
    EXPECT_NEAR(cycles[0].T_min.value(), 40, 4 * cycles[0].error_min);
    EXPECT_LT(cycles[0].error_min, 0.5);
  }
}

TEST(Cycles, OfANoiselessLogAreItsOwn) {
  const Frames frames = simulate(1000, 100, 0, 1).frames;
  const auto cycles = slip_cycles(frames, {frames.T, 1, 0, 1e-9}, 10, frames.T.size());
  ASSERT_FALSE(cycles.empty());
  EXPECT_NEAR(cycles[0].T_peak, 60, 0.05);
}

}  // namespace cycles_test
}  // namespace mixity
