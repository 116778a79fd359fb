// Evidence and posterior against closed forms and against sums over a grid.
#include "solver/evidence.h"

#include <gtest/gtest.h>

#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <functional>
#include <numbers>

#include "solver/prior.h"
#include "solver/solve.h"

namespace mixity {
namespace evidence_test {

/// A straight line through ten points with errors of 0.1: slope in a range, and an offset with or without a prior.
class Line final : public Problem {
 public:
  Line(double lower, double upper, double prior, bool known = true, double bend = 0) : known_(known), bend_(bend) {
    parameters_.push_back({"slope", lower, upper});
    if (prior == 0) return;
    parameters_.push_back({"offset", -10, 10, 0.0});
    parameters_.back().prior = prior;
  }
  std::size_t residual_count() const override { return 10; }
  const std::vector<FreeParameter>& parameters() const override { return parameters_; }
  double data_norm() const override { return 10; }
  bool known_errors() const override { return known_; }
  bool evaluate(std::span<const double> x, std::span<double> r, std::span<double> jacobian) const override {
    for (std::size_t i = 0; i < 10; ++i) {
      const double t = 0.1 * static_cast<double>(i), noise = 0.05 * std::sin(7.0 * static_cast<double>(i));
      const double bent = x[0] + bend_ * x[0] * x[0];
      r[i] = (bent * t + (x.size() > 1 ? x[1] : 0) - 0.4 * t - noise) / 0.1;
      if (jacobian.empty()) continue;
      jacobian[i * x.size()] = (1 + 2 * bend_ * x[0]) * t / 0.1;
      if (x.size() > 1) jacobian[i * x.size() + 1] = 10;
    }
    return true;
  }

 private:
  std::vector<FreeParameter> parameters_;
  bool known_;
  double bend_;
};

/// Three points whose residuals are steeper above a kink than below it, as where a nearest place comes to the end of a
/// curve.
class Kinked final : public Problem {
 public:
  std::size_t residual_count() const override { return 3; }
  const std::vector<FreeParameter>& parameters() const override { return parameters_; }
  double data_norm() const override { return 1; }
  bool known_errors() const override { return true; }
  bool evaluate(std::span<const double> x, std::span<double> r, std::span<double> jacobian) const override {
    const double slope = x[0] > kKink ? 14 : 10;
    for (std::size_t i = 0; i < 3; ++i) {
      r[i] = 10 * (kKink - 0.5) + slope * (x[0] - kKink) + 0.2 * (static_cast<double>(i) - 1);
      if (!jacobian.empty()) jacobian[i] = slope;
    }
    return true;
  }

 private:
  static constexpr double kKink = 0.53;  // a third of a standard error above the peak
  std::vector<FreeParameter> parameters_{{"x", -2, 3}};
};

double cost(const Problem& problem, const std::vector<double>& x) {
  std::vector<double> r(problem.residual_count());
  problem.evaluate(x, r, {});
  double sum = 0;
  for (const double one : r) sum += one * one;
  return sum;
}

Evidence found(const Problem& problem, EvidenceOptions choice = {}) {
  const Verdict verdict = solve(problem);
  const auto result = evidence(problem, verdict.best, verdict.standard_errors[0], choice);
  EXPECT_TRUE(result);
  return result.value_or(Evidence{});
}

/// ln of the mean of a likelihood over a range, and the posterior's mean and quantiles, by a sum over a fine grid in u.
template <class Log, class Outer>
Evidence summed(Log log_likelihood, double low, double high, Outer outer, int n = 400000) {
  std::vector<double> logs(static_cast<std::size_t>(n));
  const double h = (high - low) / n;
  double most = -1e300;
  for (int i = 0; i < n; ++i)
    most = std::max(most, logs[static_cast<std::size_t>(i)] = log_likelihood(outer(low + (i + 0.5) * h)));
  double sum = 0, first = 0, second = 0;
  for (int i = 0; i < n; ++i) {
    const double density = std::exp(logs[static_cast<std::size_t>(i)] - most), x = outer(low + (i + 0.5) * h);
    sum += density;
    first += density * x;
    second += density * x * x;
  }
  Evidence result{most + std::log(sum / n), first / sum, 0, 0, 0};
  result.standard_deviation = std::sqrt(second / sum - result.mean * result.mean);
  double run = 0;
  for (int i = 0; i < n; ++i) {
    run += std::exp(logs[static_cast<std::size_t>(i)] - most) / sum;
    if (run < 0.025) result.low = outer(low + (i + 1) * h);
    if (run < 0.975) result.high = outer(low + (i + 1) * h);
  }
  return result;
}

/// `step`: of the grid that the quantiles were read from.
void expect_same(const Evidence& one, const Evidence& other, double step) {
  EXPECT_NEAR(one.log_evidence, other.log_evidence, 1e-6);  // what the header promises
  EXPECT_NEAR(one.mean, other.mean, 1e-6);
  EXPECT_NEAR(one.standard_deviation, other.standard_deviation, 1e-6);
  EXPECT_NEAR(one.low, other.low, 2 * step);
  EXPECT_NEAR(one.high, other.high, 2 * step);
}

TEST(Evidence, OfALineIsThatOfTheNormalDistribution) {
  const Line line(0, 1000, 0);  // a peak of 1e-4 of the range
  const Minimum best = solve(line).best;
  double square = 0;
  for (int i = 0; i < 10; ++i) square += i * i;
  const double error = 1 / std::sqrt(square);  // of the slope: 0.1/(0.1 |i|)
  const double expected = -0.5 * best.sum_of_squares + std::log(std::sqrt(2 * std::numbers::pi) * error / 1000);
  const Evidence evidence = found(line);
  EXPECT_NEAR(evidence.log_evidence, expected, 1e-6);  // 1e-9 of the peak lies below 0
  EXPECT_NEAR(evidence.mean, best.x[0], 1e-9);
  EXPECT_NEAR(evidence.standard_deviation, error, 1e-8);
  const double z = quantile(boost::math::normal(), 0.975);
  EXPECT_NEAR(evidence.low, best.x[0] - z * error, 1e-8);
  EXPECT_NEAR(evidence.high, best.x[0] + z * error, 1e-8);
}

TEST(Evidence, OfAPeakBeyondItsBoundIsThatOfTheTail) {
  const Line line(0.5, 1, 0);
  const auto likelihood = [&](double x) { return -0.5 * cost(line, {x}); };
  expect_same(found(line), summed(likelihood, 0.5, 1, [](double u) { return u; }), 0.5 / 400000);
}

TEST(Evidence, WithALogUniformPriorIsUniformInTheLogarithm) {
  const Line line(0, 1, 0, true, 3);
  const auto likelihood = [&](double x) { return -0.5 * cost(line, {x}); };
  const Evidence expected = summed(
      likelihood, std::log(kLeastOfUpper), 0, [](double u) { return std::exp(u); }, 4000000);
  expect_same(found(line, {.prior = RangePrior::log_uniform}), expected, 4e-6);
}

TEST(Evidence, ALogUniformPriorBeginsWhereItIsStatedTo) {
  const Line line(0, 1, 0, true, 3);
  const auto likelihood = [&](double x) { return -0.5 * cost(line, {x}); };
  const Evidence expected = summed(
      likelihood, std::log(1e-3), 0, [](double u) { return std::exp(u); }, 4000000);
  expect_same(found(line, {.prior = RangePrior::log_uniform, .from = 1e-3}), expected, 4e-6);
  const Verdict verdict = solve(line);
  EXPECT_FALSE(evidence(line, verdict.best, verdict.standard_errors[0], {.prior = RangePrior::log_uniform, .from = 1}));
}

/// With a normal prior and a residual linear in the offset, Laplace's method is exact.
TEST(Evidence, OverAConstantWithAPriorIsThatOfTheDoubleIntegral) {
  const Line line(0, 2, 0.05, true, 0.5);
  const ProblemWithPriors with(line);
  const auto likelihood = [&](double x) {  // over the offset by sums, which are exact for a normal shape
    double sum = 0;
    const double h = 0.002;
    for (int i = -500; i <= 500; ++i) sum += std::exp(-0.5 * cost(with, {x, i * h}));
    return std::log(sum * h / (0.05 * std::sqrt(2 * std::numbers::pi)));
  };
  expect_same(found(with),
              summed(
                  likelihood, 0, 2, [](double u) { return u; }, 40000),
              2.0 / 40000);
}

/// Each value comes with its slope, so that half as many suffice.
TEST(Evidence, OfASkewDensityNeedsFewValues) {
  struct Counting final : Problem {
    Line line{0, 3, 0, true, 0.5};
    mutable int count = 0;
    std::size_t residual_count() const override { return line.residual_count(); }
    const std::vector<FreeParameter>& parameters() const override { return line.parameters(); }
    double data_norm() const override { return line.data_norm(); }
    bool known_errors() const override { return true; }
    bool evaluate(std::span<const double> x, std::span<double> r, std::span<double> jacobian) const override {
      ++count;
      return line.evaluate(x, r, jacobian);
    }
  } problem;
  const Verdict verdict = solve(problem);
  problem.count = 0;
  const auto result = evidence(problem, verdict.best, verdict.standard_errors[0], {});
  ASSERT_TRUE(result);
  EXPECT_LE(problem.count, 6);  // at both ends, one of which takes two steps, and three places between
  expect_same(*result, summed([&](double x) { return -0.5 * cost(problem, {x}); }, 0, 3, std::identity(), 400000),
              3.0 / 400000);
}

/// Interpolation converges slowly there, and ends where three digits are known.
TEST(Evidence, OfADensityWithAKinkIsThatOfItsIntegral) {
  const Kinked problem;
  const Evidence is = found(problem), expected = summed([&](double x) { return -0.5 * cost(problem, {x}); }, -2, 3,
                                                        [](double u) { return u; });
  EXPECT_NEAR(is.log_evidence, expected.log_evidence, 1e-3);
  EXPECT_NEAR(is.mean, expected.mean, 1e-3 * expected.standard_deviation);
  EXPECT_NEAR(is.standard_deviation, expected.standard_deviation, 1e-3 * expected.standard_deviation);
}

TEST(Evidence, OfErrorsOfUnknownSizeIsAveragedOverTheirSize) {
  const Line line(0, 2, 0, false);
  const auto likelihood = [&](double x) { return -5 * std::log(cost(line, {x})); };  // S^(-n/2)
  expect_same(found(line, {.unit = 1}), summed(likelihood, 0, 2, [](double u) { return u; }), 2.0 / 400000);
}

TEST(Evidence, NeedsAFiniteRange) {
  const Line line(0, std::numeric_limits<double>::infinity(), 0);
  const Verdict verdict = solve(Line(0, 10, 0));
  EXPECT_FALSE(evidence(line, verdict.best, verdict.standard_errors[0], {}));
}

}  // namespace evidence_test
}  // namespace mixity
