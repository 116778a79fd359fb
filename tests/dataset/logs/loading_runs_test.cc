// Logs of a contact that is loaded, sheared and slides: runs begin and end where they do.
#include "dataset/logs/loading_runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "base/input_error.h"
#include "dataset/logs/clocks.h"
#include "dataset/logs/reduced_log.h"
#include "dataset/temporary_folder.h"

namespace mixity {
namespace loading_runs_test {

/// What an apparatus sees of one contact under each load, in N and m^2, and when it was sheared and slid.
struct Simulated {
  Recording forces, areas;
  std::vector<double> shear, onset;
};

struct Conditions {
  double noise_T = 1e-3, noise_A = 0.01, zero_T = 2e-3, zero_P = 0.3e-3, lag = 0, direction = 1;
  double bend = 0;        // of T under shear: how much faster than at the mean it rises at first, and slower at last
  double drift = 0;       // of the zero of T, N/s
  bool steady = false;    // T keeps its height when the contact slides, and the area falls within a tenth of a second
  double frames = 50;     // a second
  std::size_t spike = 0;  // a sample of so many is ten noises off
  unsigned seed = 1;
};

Simulated simulate(const std::vector<double>& loads, const Conditions& c) {
  constexpr double kRate = 1000;
  std::mt19937 random(c.seed);
  std::normal_distribution<double> normal;
  Simulated made;
  double now = 0;
  std::vector<double> areas;
  const auto add = [&](double seconds, auto P, auto T, auto A) {
    const auto n = static_cast<std::size_t>(seconds * kRate);
    for (std::size_t i = 0; i < n; ++i) {
      const double s = static_cast<double>(i) / static_cast<double>(n);
      made.forces.time.push_back(now + static_cast<double>(i) / kRate);
      made.forces.P.push_back(P(s) + c.zero_P + 1e-4 * normal(random));
      const bool spike = c.spike > 0 && made.forces.time.size() % c.spike == 0;
      made.forces.T.push_back(c.direction * T(s) + c.zero_T + c.drift * made.forces.time.back() +
                              c.noise_T * (normal(random) + (spike ? 10 : 0)));
      areas.push_back(A(s));
    }
    now += static_cast<double>(n) / kRate;
  };
  const auto zero = [](double) { return 0.0; };
  for (const double load : loads) {
    const double A0 = 4e-7, most = 0.05 + load;
    const auto held = [=](double) { return load; };
    add(0.7, zero, zero, zero);
    add(
        1, [=](double s) { return load * s; }, zero, [=](double s) { return A0 * (0.5 + 0.5 * s); });
    add(1.1, held, zero, [=](double) { return A0; });
    made.shear.push_back(now);
    add(
        4, held, [=](double s) { return most * s * (1 + c.bend * (1 - s)); },
        [=](double s) { return A0 * (1 - 0.3 * s * s); });
    made.onset.push_back(now);
    if (c.steady)
      add(
          1, held, [=](double) { return most; }, [=](double s) { return A0 * (0.55 + 0.15 * std::exp(-s / 0.1)); });
    for (int slip = 0; slip < (c.steady ? 0 : 3); ++slip) {
      const double top = slip == 0 ? most : 0.9 * most;
      add(
          0.004, held, [=](double s) { return top - 0.3 * most * s; }, [=](double) { return 0.6 * A0; });
      add(
          0.4, held, [=](double s) { return top - 0.3 * most + (0.9 * most - top + 0.3 * most) * s; },
          [=](double) { return 0.58 * A0; });
    }
    add(
        0.3, held, [=](double s) { return 0.6 * most * (1 - s); }, [=](double) { return 0.58 * A0; });
    add(
        0.4, [=](double s) { return load * (1 - s); }, zero, [=](double s) { return 0.58 * A0 * (1 - s); });
  }
  const auto every = static_cast<std::size_t>(kRate / c.frames);
  for (std::size_t i = every / 2; i < areas.size(); i += every) {
    made.areas.time.push_back(made.forces.time[i] + c.lag);
    made.areas.A.push_back(std::max(0.0, areas[i] * (1 + c.noise_A * normal(random))));
  }
  return made;
}

const std::vector<double> kLoads{8e-3, 4e-3, 1e-3};

LoadingRuns find(const Simulated& made, const RunOptions& options = {}, std::optional<double> lag = {}) {
  return find_loading_runs(on_one_clock(made.forces, made.areas, lag), "mN", 1e-3, options);
}

TEST(LoadingRuns, BeginAndEndWhereTheContactIsShearedAndSlides) {
  std::size_t runs = 0, shear_held = 0, onset_held = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    Conditions conditions;
    conditions.seed = seed;
    conditions.lag = 0.37;
    const Simulated made = simulate(kLoads, conditions);
    const LoadingRuns found = find(made);
    EXPECT_NEAR(found.frames.lag, 0.37, 0.01);  // half a frame
    ASSERT_EQ(found.runs.size(), 3u) << seed;
    for (std::size_t k = 0; k < 3; ++k) {
      const LoadingRun& run = found.runs[k];
      ++runs;
      // of four seconds of shear: 1 % is two frames
      EXPECT_NEAR(run.onset.value().time - 0.37, made.onset[k], 0.04) << seed;
      EXPECT_LE(found.frames.time[run.end - 1] - 0.37, made.onset[k] + 0.01);  // no frame from behind it
      EXPECT_NEAR(run.shear.time - 0.37, made.shear[k], 0.1);
      shear_held += run.shear.low - 0.37 <= made.shear[k] && made.shear[k] <= run.shear.high - 0.37;
      onset_held += run.onset->low - 0.37 <= made.onset[k] && made.onset[k] <= run.onset->high - 0.37;
      EXPECT_NEAR(run.baseline, 2e-3, 1.2e-4);  // 4 standard errors of the mean of 55 frames
      EXPECT_NEAR(run.P, kLoads[k], 2e-5);
      EXPECT_NEAR(run.sigma_T[run.T.size() / 2], 1e-3 / std::sqrt(20), 4e-5);  // of the mean of 20 samples
      const double A = found.frames.A[run.begin];
      EXPECT_NEAR(run.sigma_A.front() / A, 0.01, 0.002);
      ASSERT_EQ(run.cycles.size(), 3u);  // where the shear is taken off is none
    }
  }
  EXPECT_GE(shear_held, runs * 88 / 100);  // 95 % are wanted; frames are whole
  EXPECT_GE(onset_held, runs * 88 / 100);
}

/// Counts runs whose onset is within 1 % of T, and none may keep a frame from behind it.
std::size_t onsets_within_a_percent(const Simulated& made, const LoadingRuns& found, double lag) {
  EXPECT_EQ(found.runs.size(), made.onset.size());
  std::size_t near = 0;
  for (std::size_t k = 0; k < std::min(found.runs.size(), made.onset.size()); ++k) {
    const LoadingRun& run = found.runs[k];
    near += run.onset && std::abs(run.onset->time - lag - made.onset[k]) <= 0.04;
    EXPECT_LE(found.frames.time[run.end - 1] - lag, made.onset[k] + 1.5 * found.frames.interval);
  }
  return near;
}

/// Of twenty logs, three runs each, 97 % of the onsets. `look` sees each log and what was found.
template <class Look>
void expect_onsets_found(Conditions conditions, const std::vector<double>& loads, std::optional<double> lag,
                         Look look) {
  std::size_t near = 0;
  for (conditions.seed = 0; conditions.seed < 20; ++conditions.seed) {
    const Simulated made = simulate(loads, conditions);
    const LoadingRuns found = find(made, {}, lag);
    near += onsets_within_a_percent(made, found, found.frames.lag);
    look(found);
  }
  EXPECT_GE(near, 58u);
}

TEST(LoadingRuns, AreNotCutWhereTheShearBends) {
  Conditions conditions;
  conditions.noise_T = 2e-4;
  conditions.noise_A = 0.002;
  conditions.bend = 0.3;
  expect_onsets_found(conditions, kLoads, {0.0}, [](const LoadingRuns&) {});
}

TEST(LoadingRuns, AreNotCutByADriftOrASpikeInTheHold) {
  Conditions conditions;
  conditions.noise_T = 2e-4;
  conditions.spike = 997;
  conditions.drift = -3e-4;
  expect_onsets_found(conditions, kLoads, {0.0}, [](const LoadingRuns& found) {
    EXPECT_GT(found.frames.spikes, 15u);
    EXPECT_TRUE(found.drift_removed);
    EXPECT_NEAR(found.drift_T, -3e-4, 4 * found.drift_error);
    // T is the shear: at the end of a run, 5 seconds behind where its zero was read
    for (const LoadingRun& run : found.runs) EXPECT_NEAR(run.T.back(), 0.05 + run.P, 0.02 * (0.05 + run.P));
  });
}

TEST(LoadingRuns, OfAFastCameraAreNoPiecesOfRampsOfTheLoad) {
  Conditions conditions;
  conditions.frames = 500;
  const Simulated made = simulate(kLoads, conditions);
  EXPECT_EQ(onsets_within_a_percent(made, find(made, {}, {0.0}), 0), 3u);
}

TEST(LoadingRuns, EndWhereSteadySlidingBegins) {
  Conditions conditions;
  conditions.steady = true;
  conditions.noise_A = 0.003;
  conditions.noise_T = 1e-4;
  conditions.lag = -1.21;
  expect_onsets_found(conditions, {8e-3, 7e-3, 6e-3}, {}, [](const LoadingRuns& found) {
    EXPECT_NEAR(found.frames.lag, -1.21, 0.04);  // two frames
    EXPECT_LE(std::abs(found.frames.lag + 1.21), 4 * found.frames.lag_error);
  });
}

// Errors that go with each reading give those that are low by chance more weight: weighted by them, areas of 1 % noise
// are low by 1 % of 1 %, which of 2,000 frames is half a standard error.
TEST(LoadingRuns, HaveErrorsThatDoNotFollowTheNoise) {
  Conditions conditions;
  conditions.frames = 200;
  conditions.noise_A = 0.02;
  double together = 0, noises = 0, errors = 0;
  const LoadingRuns found = find(simulate(kLoads, conditions));
  for (const LoadingRun& run : found.runs)
    for (std::size_t i = run.begin + 1; i + 1 < run.end; ++i) {
      const auto bend = [&](const auto& y, std::size_t k) { return (y[k] - 0.5 * (y[k - 1] + y[k + 1])) / y[k]; };
      const double noise = bend(found.frames.A, i), error = bend(run.sigma_A, i - run.begin);
      together += noise * error;
      noises += noise * noise;
      errors += error * error;
    }
  ASSERT_GT(noises, 0);
  EXPECT_LT(std::sqrt(errors / noises), 0.1);  // as much as the noise where errors follow it
  EXPECT_LT(together / noises, 0.1);
}

TEST(LoadingRuns, TakeTheirLoadOnItsCourse) {
  Simulated made = simulate({8e-3}, {});
  for (std::size_t i = 0; i < made.forces.P.size(); ++i)  // while it is sheared the load rises by 2 %
    made.forces.P[i] += 1.6e-4 * std::clamp((made.forces.time[i] - made.shear[0]) / 4, 0.0, 1.0);
  const LoadingRuns found = find(made, {}, {0.0});
  const LoadingRun& run = found.runs.at(0);
  // 1e-4 N of noise in a sample, 20 in a frame, 26 frames and more: four standard errors of a line's end
  EXPECT_NEAR(run.smooth_P.back(), 8e-3 + 1.6e-4, 4 * 2 * 1e-4 / std::sqrt(20 * 26));
}

/// Neighbouring points share what is left of the noise of P: of a load that is held, only that of its mean.
TEST(LoadingRuns, UnderAConstantLoadDoNotFollowItsNoise) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  Simulated made = simulate({2e-3, 8e-3}, {});
  for (double& P : made.forces.P) P += 5e-4 * normal(random);
  const LoadingRuns found = find(made, {}, {0.0});
  for (const LoadingRun& run : found.runs) {
    const auto [least, most] = std::minmax_element(run.smooth_P.begin(), run.smooth_P.end());
    EXPECT_EQ(*least, *most);
    // 5.1e-4 N of noise in a sample, 20 in a frame, and of the zero: four standard errors of the mean
    EXPECT_NEAR(run.smooth_P[0], found.runs[0].name == run.name ? 2e-3 : 8e-3, 4 * 5.1e-4 / std::sqrt(20 * 200) * 1.4);
  }
  ASSERT_EQ(found.runs.size(), 2u);
}

TEST(LoadingRuns, ThatAreShearedTheOtherWayAreTurnedRound) {
  Conditions conditions;
  conditions.direction = -1;
  const LoadingRuns found = find(simulate(kLoads, conditions), {}, {0.0});
  ASSERT_EQ(found.runs.size(), 3u);
  for (const LoadingRun& run : found.runs) {
    EXPECT_EQ(run.direction, -1);
    EXPECT_GT(run.T.back(), 0.04);
    EXPECT_NEAR(run.T.front(), 0, 1e-3);
  }
}

TEST(LoadingRuns, KeepTheCutsThatAreStated) {
  const Simulated made = simulate(kLoads, {});
  const LoadingRuns as_found = find(made, {}, {0.0});
  RunOptions options;
  options.cuts[as_found.runs.at(1).name] = {made.shear[1] + 0.5, made.onset[1] - 1, false};
  options.cuts[as_found.runs.at(2).name].leave_out = true;
  const LoadingRuns found = find(made, options, {0.0});
  ASSERT_EQ(found.runs.size(), 2u);
  const LoadingRun& run = found.runs[1];
  EXPECT_TRUE(run.shear.stated && run.onset->stated);
  // the last frame that is over then
  EXPECT_LE(found.frames.time[run.end - 1] + 0.01, made.onset[1] - 1);
  EXPECT_GT(found.frames.time[run.end - 1] + 0.03, made.onset[1] - 1);
}

TEST(LoadingRuns, OfALogWithoutShearAreNone) {
  Simulated made = simulate(kLoads, {});
  std::mt19937 random(1);
  std::normal_distribution<double> normal(0, 1e-3);
  for (double& T : made.forces.T) T = normal(random);
  EXPECT_TRUE(find(made, {}, {0.0}).runs.empty());
}

TEST(LoadingRuns, EveryFrameHasAPhase) {
  const LoadingRuns found = find(simulate(kLoads, {}), {}, {0.0});
  std::size_t next = 0;
  for (const Phase& phase : found.phases) {
    EXPECT_EQ(phase.begin, next) << phase.name;
    next = phase.end;
  }
  EXPECT_EQ(next, found.frames.time.size());
}

TEST(Frames, OfClocksThatNothingTiesTogetherAreRefused) {
  Simulated made = simulate(kLoads, {});
  std::fill(made.forces.T.begin(), made.forces.T.end(), 0.0);
  EXPECT_NE(input_error([&] { on_one_clock(made.forces, made.areas, {}); }).find("state it: --lag"), std::string::npos);
  EXPECT_EQ(on_one_clock(made.forces, made.areas, {0.2}).lag, 0.2);
}

TEST(Frames, OfOneFileAreItsRowsWithAnArea) {
  const TemporaryFolder folder;
  std::string text = "time [s],P [mN],T [N],A [mm^2]\n";
  for (int i = 0; i < 100; ++i)
    text += std::to_string(0.01 * i) + "," + std::to_string(i) + ",0.001," + (i % 10 == 5 ? "0.3" : "") + "\n";
  const Recording log = read_recordings(folder.write("log.csv", text), {}).front();
  const Frames frames = make_frames(log, log);
  ASSERT_EQ(frames.time.size(), 10u);
  EXPECT_NEAR(frames.interval, 0.1, 1e-12);
  EXPECT_NEAR(frames.P[4], 44.5e-3, 1e-12);  // the mean of 40 to 49
  EXPECT_EQ(on_one_clock(log, log, {}).lag_source, "one clock");
}

TEST(Frames, OfAreasThatAreHeldAreOneForEachPicture) {
  Recording log;  // 30 pictures a second in a log of 1000 rows: 33 or 34 rows each
  for (int i = 0; i < 2000; ++i) {
    log.time.push_back(1e-3 * i);
    log.P.push_back(1e-3);
    log.T.push_back(1e-3);
    log.A.push_back(1e-7 * (1 + i * 30 / 1000));
  }
  EXPECT_EQ(pictures(log).time.size(), 60u);
  for (double& A : log.A)
    if (A > 3.05e-6 && A < 3.35e-6) A = 3.1e-6;  // three pictures of one area are three
  EXPECT_EQ(pictures(log).time.size(), 60u);
}

TEST(Cuts, ThatCannotBeUnderstoodAreRefusedWithTheirPlace) {
  const auto error = [](const std::string& text) {
    return file_error("cuts.toml", text, [](const std::string& path) {
      Inputs inputs;
      read_cuts(path, inputs);
    });
  };
  EXPECT_EQ(error("[[cuts]]\nrun = \"P=4 mN\"\nonset = \"4.31\"\n"),
            "cuts.toml:3:9: onset must be a time such as \"4.31 s\"");
  EXPECT_EQ(error("[[cuts]]\nonset = \"4.31 s\"\n"),
            "cuts.toml:1:1: a cut needs the name of its run: run = \"P=4.68 mN\"");
  EXPECT_EQ(error("cut = 1\n"), "cuts.toml:1:1: holds tables [[cuts]] and nothing else");
  EXPECT_EQ(error("[[cuts]]\nrun = \"a\"\nshear = \"5 s\"\nonset = \"4 s\"\n"),
            "cuts.toml:1:1: the onset is not later than the start of the shear");
}

}  // namespace loading_runs_test
}  // namespace mixity
