// Bootstrap and jackknife: reproducible, and what they mean.
#include "solver/resample.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "solver/prior.h"

namespace mixity {
namespace resample_test {

/// Straight line through the origin, y = slope t: everything about it is known in closed form.
class Line final : public Problem {
 public:
  Line(std::vector<double> t, std::vector<double> y, const FreeParameter& slope = {"slope", -10, 10})
      : t_(std::move(t)), y_(std::move(y)), parameters_{slope} {}
  std::size_t residual_count() const override { return t_.size(); }
  const std::vector<FreeParameter>& parameters() const override { return parameters_; }
  double data_norm() const override { return 1; }
  bool evaluate(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian) const override {
    for (std::size_t i = 0; i < t_.size(); ++i) {
      residuals[i] = parameters_[0].shown(x[0]) * t_[i] - y_[i];
      if (!jacobian.empty()) jacobian[i] = parameters_[0].shown_slope(x[0]) * t_[i];
    }
    return true;
  }
  double slope_without(std::size_t out) const {
    double ty = 0, tt = 0;
    for (std::size_t i = 0; i < t_.size(); ++i)
      if (i != out) ty += t_[i] * y_[i], tt += t_[i] * t_[i];
    return ty / tt;
  }

 private:
  std::vector<double> t_, y_;
  std::vector<FreeParameter> parameters_;
};

Line noisy_line(std::size_t n) {
  std::vector<double> t, y;
  for (std::size_t i = 0; i < n; ++i) {
    t.push_back(1 + static_cast<double>(i) / static_cast<double>(n));
    y.push_back(0.7 * t.back() + 0.1 * std::sin(37.0 * static_cast<double>(i) * static_cast<double>(i)));
  }
  return {t, y};
}

std::vector<std::size_t> runs_of(std::size_t n, std::size_t length) {
  std::vector<std::size_t> runs(n);
  for (std::size_t i = 0; i < n; ++i) runs[i] = i / length;
  return runs;
}

/// The points say little of the slope, and what is known beforehand nearly all.
TEST(Bootstrap, DrawsWhatIsKnownBeforehandAnew) {
  FreeParameter slope{"slope", -10, 10, 0.7};
  slope.prior = 0.02;
  std::vector<double> t, y;
  for (std::size_t i = 0; i < 40; ++i) {
    t.push_back(0.1);
    y.push_back(0.07 + (i % 2 == 0 ? 1 : -1));  // errors of 1: the slope to 1/sqrt(0.4)
  }
  const Line line(t, y, slope);
  const ProblemWithPriors with(line);
  const double posterior = 1 / std::sqrt(1 / (0.02 * 0.02) + 0.4);
  const auto found = bootstrap(with, {0.7}, runs_of(40, 40), {4000, Resample::points, 5, 2}, 0.95).parameters.at(0);
  EXPECT_NEAR(found.standard_deviation, posterior, 0.05 * posterior);  // 4000 replicates: 1.1 %
  EXPECT_NEAR(found.bias, 0, 0.1 * posterior);
}

TEST(Bootstrap, DoesNotDependOnTheNumberOfThreads) {
  const Line line = noisy_line(40);
  const std::vector<double> fitted{line.slope_without(40)};
  const auto with = [&](unsigned threads, std::uint64_t seed) {
    return bootstrap(line, fitted, runs_of(40, 40), {500, Resample::points, seed, threads}, 0.95).parameters.at(0);
  };
  const Bootstrapped one = with(1, 3), two = with(2, 3), other_seed = with(2, 4);
  EXPECT_EQ(one.low, two.low);
  EXPECT_EQ(one.high, two.high);
  EXPECT_EQ(one.standard_deviation, two.standard_deviation);
  EXPECT_NE(one.low, other_seed.low);
}

/// For a mean-like estimate the bootstrap's standard deviation is sqrt(sum t^2 r^2)/sum t^2 up to 1/n.
TEST(Bootstrap, HasTheStandardDeviationOfTheSandwichFormula) {
  const std::size_t n = 200;
  const Line line = noisy_line(n);
  const double x = line.slope_without(n);
  std::vector<double> r(n), t(n);
  line.evaluate({&x, 1}, r, t);
  double square = 0, tt = 0;
  for (std::size_t i = 0; i < n; ++i) square += t[i] * t[i] * r[i] * r[i], tt += t[i] * t[i];
  const auto result = bootstrap(line, {x}, runs_of(n, n), {4000, Resample::points, 1, 0}, 0.95);
  ASSERT_EQ(result.failed, 0u);
  const double expected = std::sqrt(square) / tt;
  // 4000 replicates know it to 1/sqrt(8000) = 1.1 %, four times that; and terms of 1/n = 0.5 %
  EXPECT_NEAR(result.parameters[0].standard_deviation, expected, 0.05 * expected);
  EXPECT_NEAR(result.parameters[0].high - result.parameters[0].low, 2 * 1.96 * expected, 0.3 * expected);
  EXPECT_NEAR(result.parameters[0].bias, 0, 4 * expected / std::sqrt(4000.0));
}

TEST(Bootstrap, OfWholeRunsDrawsRunsAndNotPoints) {
  // Two runs that disagree: every draw of whole runs gives one of three slopes.
  const Line line({1, 1, 1, 1}, {0.5, 0.5, 0.9, 0.9});
  const auto result = bootstrap(line, {0.7}, {0, 0, 1, 1}, {200, Resample::curves, 1, 1}, 0.95);
  EXPECT_NEAR(result.parameters.at(0).low, 0.5, 1e-12);
  EXPECT_NEAR(result.parameters.at(0).high, 0.9, 1e-12);
  const auto points = bootstrap(line, {0.7}, {0, 0, 1, 1}, {200, Resample::points, 1, 1}, 0.95);
  EXPECT_NEAR(points.parameters.at(0).standard_deviation, 0, 1e-12);  // within a run all points are the same
}

/// Eight runs, each with a slope of its own by chance: percentiles hold the mean in 8 of 10 experiments.
TEST(Bootstrap, OfRunsHoldsTheTruthAsOftenAsItSays) {
  constexpr int kExperiments = 400;
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  int held = 0;
  for (int experiment = 0; experiment < kExperiments; ++experiment) {
    std::vector<double> t, y;
    for (int run = 0; run < 8; ++run) {
      const double slope = 0.7 + 0.1 * normal(random);
      for (int i = 0; i < 5; ++i) {
        t.push_back(1 + 0.2 * i);
        y.push_back(slope * t.back() + 0.05 * normal(random));
      }
    }
    const Line line(t, y);
    const auto found = bootstrap(line, {line.slope_without(40)}, runs_of(40, 5), {400, Resample::curves, 1, 1}, 0.95);
    held += found.parameters.at(0).low <= 0.7 && 0.7 <= found.parameters.at(0).high;
  }
  EXPECT_NEAR(held, 0.95 * kExperiments, 4 * std::sqrt(0.95 * 0.05 * kExperiments));  // of a binomial count
}

TEST(Influence, OfEachPointIsTheChangeWhenItIsLeftOut) {
  const std::size_t n = 30;
  const Line line = noisy_line(n);
  const double x = line.slope_without(n);
  const Influence result = influence(line, {x}, runs_of(n, 10), 2);
  ASSERT_EQ(result.points.size(), n);
  ASSERT_EQ(result.runs.size(), 3u);
  std::vector<double> r(n), t(n);
  line.evaluate({&x, 1}, r, t);
  double tt = 0, rr = 0, leverage = 0;
  for (std::size_t i = 0; i < n; ++i) tt += t[i] * t[i], rr += r[i] * r[i];
  for (std::size_t i = 0; i < n; ++i) {
    const double h = t[i] * t[i] / tt, cook = r[i] * r[i] * h * (n - 1) / (rr * (1 - h) * (1 - h));
    EXPECT_NEAR(result.points[i].change.at(0), line.slope_without(i) - x, 1e-12);
    EXPECT_NEAR(result.points[i].leverage, h, 1e-14);
    EXPECT_NEAR(result.points[i].cooks_distance, cook, 1e-10 * cook);
    leverage += result.points[i].leverage;
  }
  EXPECT_NEAR(leverage, 1, 1e-13);  // one parameter
}

/// Three runs that disagree by far, so that a logarithm is not straight between their slopes.
TEST(Resampling, IsOfWhatAReaderSeesHoweverTheSolverCounts) {
  const std::vector<double> t{1, 1, 1, 1, 1, 1}, y{0.5, 0.52, 0.9, 0.9, 3, 3.1};
  const std::vector<std::size_t> runs = runs_of(6, 2);
  const FreeParameter logarithm{"slope", -10, 10, {}, 2, true};
  const Line plain(t, y), by_logarithm(t, y, logarithm);
  const double slope = plain.slope_without(6), x = std::log(slope / 2);
  const BootstrapOptions draws{300, Resample::curves, 1, 1};
  const Bootstrapped one = bootstrap(plain, {slope}, runs, draws, 0.9).parameters.at(0),
                     other = bootstrap(by_logarithm, {x}, runs, draws, 0.9).parameters.at(0);
  // to what a gradient of 1e-8 leaves
  EXPECT_NEAR(one.low, other.low, 1e-8);
  EXPECT_NEAR(one.high, other.high, 1e-8);
  EXPECT_NEAR(one.standard_deviation, other.standard_deviation, 1e-8);
  EXPECT_NEAR(one.bias, other.bias, 1e-8);
  const Influence moved = influence(by_logarithm, {x}, runs, 1), expected = influence(plain, {slope}, runs, 1);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(moved.points[i].change.at(0), expected.points[i].change.at(0), 1e-8);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(moved.runs[i].at(0), expected.runs[i].at(0), 1e-8);
  EXPECT_GT(std::abs(expected.runs[2].at(0)), 0.5 * slope);
}

}  // namespace resample_test
}  // namespace mixity
