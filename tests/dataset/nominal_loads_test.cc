// Readings of the load that scatter are those of one nominal load; loads that were set are not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "dataset/load_text.h"
#include "dataset/unnamed_runs.h"

namespace mixity {
namespace nominal_loads_test {

using Levels = std::vector<std::size_t>;

/// So many readings of each load, one load after the other, with noise of this standard deviation, rounded to `step`.
std::vector<double> readings(const std::vector<double>& loads, std::size_t each, double noise, double step,
                             unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, noise);
  std::vector<double> all;
  for (const double load : loads)
    for (std::size_t i = 0; i < each; ++i) {
      const double reading = load + (noise > 0 ? normal(random) : 0);
      all.push_back(step > 0 ? step * std::round(reading / step) : reading);
    }
  return all;
}

Levels blocks(std::size_t loads, std::size_t each) {
  Levels levels;
  for (std::size_t i = 0; i < loads * each; ++i) levels.push_back(i / each);
  return levels;
}

const std::vector<double> kLoads{7.73, 3.81, 2.92, 1.58, 0.94, 0.51, -0.06, -0.46};

TEST(NominalLoads, AreTheLevelsOfNoisyReadings) {
  for (unsigned seed = 0; seed < 200; ++seed)
    for (const std::size_t each : {5u, 25u, 400u}) {
      EXPECT_EQ(group_by_nominal_load(readings(kLoads, each, 0.02, 0, seed)), blocks(kLoads.size(), each)) << seed;
      EXPECT_EQ(group_by_nominal_load(readings({4.68}, each, 0.02, 0, seed)), blocks(1, each)) << seed;
      EXPECT_EQ(group_by_nominal_load(readings({0.01}, 4 * each, 0.02, 0, seed)), blocks(1, 4 * each)) << seed;
    }
}

TEST(NominalLoads, AreTheLevelsOfReadingsInSteps) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    EXPECT_EQ(group_by_nominal_load(readings(kLoads, 50, 0.02, 0.01, seed)), blocks(kLoads.size(), 50)) << seed;
    EXPECT_EQ(group_by_nominal_load(readings({4.68}, 50, 0.004, 0.01, seed)), blocks(1, 50)) << seed;
  }
}

TEST(NominalLoads, ThatLieCloseTogetherAreTwoIfTheirNoiseSaysSo) {
  EXPECT_EQ(group_by_nominal_load(readings({10, 10.4}, 15, 0.02, 0, 3)).back(), 1u);
  const Levels one = group_by_nominal_load(readings({10}, 30, 0.2, 0, 3));
  EXPECT_EQ(*std::max_element(one.begin(), one.end()), 0u);
}

TEST(NominalLoads, OneAfterTheOtherMayHaveExtremeReadingsThatTouch) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    EXPECT_EQ(group_by_nominal_load(readings({5, 5.5, 6}, 300, 0.05, 0, seed)), blocks(3, 300)) << seed;
    EXPECT_EQ(group_by_nominal_load(readings({2.5, 2.6, 2.7}, 30, 0.012, 0, seed)), blocks(3, 30)) << seed;
    EXPECT_EQ(group_by_nominal_load(readings({0.5, 1}, 40, 0.05, 0, seed)), blocks(2, 40)) << seed;
  }
  // of many readings, to the reading
  EXPECT_EQ(group_by_nominal_load(readings({5, 5.5, 6}, 20001, 0.03, 0, 1)), blocks(3, 20001));
}

TEST(NominalLoads, ThatDriftAreOne) {
  std::vector<double> ten, noisy = readings({5}, 300, 0.02, 0, 1);
  for (int i = 0; i < 10; ++i) ten.push_back(4.68 * (1 + 0.03 * i / 9));
  for (std::size_t i = 0; i < noisy.size(); ++i) noisy[i] += 0.001 * static_cast<double>(i);
  EXPECT_EQ(group_by_nominal_load(ten), blocks(1, 10));
  const Levels drift = group_by_nominal_load(noisy);
  EXPECT_EQ(drift, Levels(drift.size(), 0));
}

TEST(NominalLoads, OfRowsInTheOrderOfSomethingElseAreTheirLevels) {
  const auto rows = readings({5, 5.5, 6}, 100, 0.04, 0, 1);
  std::vector<double> in_turn;
  Levels wanted;
  for (std::size_t i = 0; i < 300; ++i) {
    in_turn.push_back(rows[i % 3 * 100 + i / 3]);
    wanted.push_back(i % 3);
  }
  EXPECT_EQ(group_by_nominal_load(in_turn), wanted);
}

TEST(NominalLoads, ThatWereSetAreTakenAsTheyStand) {
  EXPECT_EQ(group_by_nominal_load(readings(kLoads, 25, 0, 0, 0)), Levels());
  EXPECT_EQ(group_by_nominal_load(readings(kLoads, 1, 0, 0, 0)), Levels());
  EXPECT_EQ(group_by_nominal_load(readings({4, 4.1}, 25, 0, 0, 0)), Levels());
  std::vector<double> in_turn;
  for (int i = 0; i < 20; ++i) in_turn.insert(in_turn.end(), kLoads.begin(), kLoads.end());
  EXPECT_EQ(group_by_nominal_load(in_turn), Levels());
  std::vector<double> ramp;
  for (int i = 0; i < 100; ++i) ramp.push_back(0.1 * i);
  EXPECT_EQ(group_by_nominal_load(ramp), Levels());
}

TEST(NominalLoads, AreRunsWhosePointsKeepTheLoadThatWasRead) {
  std::string text = "P,T,A\n";
  const auto loads = readings({30.4, 3.7}, 10, 0.05, 0.001, 1);
  for (std::size_t i = 0; i < loads.size(); ++i)
    text += std::to_string(loads[i]) + "," + std::to_string(i % 10) + ",60\n";
  const Dataset data = load_text(text);
  EXPECT_EQ(data.curves, (std::vector<std::string>{"P=30.4", "P=3.7"}));
  for (std::size_t i = 0; i < loads.size(); ++i) {
    EXPECT_NEAR(data.points[i].P, loads[i], 1e-6);  // what std::to_string prints
    EXPECT_EQ(data.points[i].curve, i / 10);
  }
  EXPECT_EQ(texts_of(data.notes).at(0).substr(0, 30), "readings of P scatter by up to");
}

TEST(RunLoads, AreTheMeanOfWhatWasReadInWhateverOrder) {
  const Dataset falling = load_text("curve,P,T,A\nx,4.4,0,20\nx,4,1,19\nx,3.6,2,18\ny,0.1,0,9\ny,0.1,1,9\ny,0.1,2,9\n"),
                rising = load_text("curve,P,T,A\nx,3.6,2,18\nx,4,1,19\nx,4.4,0,20\ny,0.1,0,9\ny,0.1,1,9\ny,0.1,2,9\n");
  EXPECT_DOUBLE_EQ(falling.curve_loads[0], 4);
  EXPECT_DOUBLE_EQ(rising.curve_loads[0], 4);
  EXPECT_EQ(falling.curve_loads[1], 0.1);  // to the bit where all read the same
}

}  // namespace nominal_loads_test
}  // namespace mixity
