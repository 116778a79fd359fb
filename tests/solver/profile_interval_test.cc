#include <gtest/gtest.h>

#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "solver/interval.h"
#include "solver/solve.h"

namespace mixity {
namespace profile_interval_test {

double sum_of_squares(const std::vector<double>& r) {
  double sum = 0;
  for (const double x : r) sum += x * x;
  return sum;
}

/// intercept + slope t, in any range and number of the solver's.
class Line final : public Problem {
 public:
  Line(std::vector<double> data, std::vector<FreeParameter> parameters)
      : data_(std::move(data)), parameters_(std::move(parameters)) {}
  std::size_t residual_count() const override { return data_.size(); }
  const std::vector<FreeParameter>& parameters() const override { return parameters_; }
  bool evaluate(std::span<const double> x, std::span<double> r, std::span<double> J) const override {
    for (std::size_t i = 0; i < data_.size(); ++i) {
      const double t = static_cast<double>(i);
      r[i] = x[0] + x[1] * t - data_[i];
      if (J.empty()) continue;
      J[2 * i] = 1;
      J[2 * i + 1] = t;
    }
    return true;
  }
  double data_norm() const override { return std::sqrt(sum_of_squares(data_)); }

 private:
  std::vector<double> data_;
  std::vector<FreeParameter> parameters_;
};

const std::vector<double> kLine{1.1, 1.4, 2.2, 2.4, 3.1, 3.4, 4.2};

/// Textbook regression of a straight line: estimates, standard errors and the t interval.
struct Regression {
  double value[2], error[2], squares = 0, quantile;
  explicit Regression(const std::vector<double>& data, double confidence = 0.95) {
    const auto n = static_cast<double>(data.size());
    double mean_t = (n - 1) / 2, mean = 0, tt = 0, ty = 0;
    for (const double y : data) mean += y / n;
    for (std::size_t i = 0; i < data.size(); ++i) {
      const double t = static_cast<double>(i) - mean_t;
      tt += t * t;
      ty += t * data[i];
    }
    value[1] = ty / tt;
    value[0] = mean - value[1] * mean_t;
    for (std::size_t i = 0; i < data.size(); ++i)
      squares += std::pow(value[0] + value[1] * static_cast<double>(i) - data[i], 2);
    const double s = std::sqrt(squares / (n - 2));
    error[1] = s / std::sqrt(tt);
    error[0] = s * std::sqrt(1 / n + mean_t * mean_t / tt);
    quantile = boost::math::quantile(boost::math::students_t(n - 2), 0.5 + 0.5 * confidence);
  }
};

TEST(ProfileOfALine, IsTheTInterval) {
  const Line line(kLine, {{"intercept", -10, 10}, {"slope", -10, 10}});
  const Verdict verdict = solve(line);
  ASSERT_EQ(verdict.status, FitStatus::ok) << verdict.message;
  for (const double confidence : {0.5, 0.95, 0.999}) {
    const Regression known(kLine, confidence);
    const double allowance = cost_allowance(confidence, verdict.best.sum_of_squares, kLine.size(), 2, false);
    for (std::size_t k = 0; k < 2; ++k) {
      const Interval interval =
          profile_intervals(line, verdict.best, confidence, allowance, verdict.standard_errors)[k];
      const double half = known.quantile * known.error[k];
      EXPECT_EQ(interval.low_status, EndStatus::found);
      EXPECT_EQ(interval.high_status, EndStatus::found);
      // The ends are good to 1e-10 of their distance, and to eps S/S' where the cost is flat in its rounding.
      EXPECT_NEAR(interval.low, known.value[k] - half, 1e-9 * half);
      EXPECT_NEAR(interval.high, known.value[k] + half, 1e-9 * half);
      EXPECT_EQ(interval.confidence, confidence);
    }
  }
}

TEST(ProfileOfALine, AllowanceIsChiSquareOfKnownErrorsAndFOfUnknownOnes) {
  EXPECT_NEAR(cost_allowance(0.95, 17, 40, 2, true), 3.841458820694124, 1e-13);
  EXPECT_NEAR(cost_allowance(0.6826894921370859, 17, 40, 2, true), 1, 1e-13);
  // t(0.975, 10) = 2.22813885198627...; F(1, m) = t(m)^2
  EXPECT_NEAR(cost_allowance(0.95, 5, 12, 2, false), 5.0 / 10 * std::pow(2.2281388519862744, 2), 1e-13);
}

TEST(ProfileOfALine, StopsAtABoundThatTheDataDoNotExclude) {
  const Regression known(kLine);
  const double half = known.quantile * known.error[1];
  // the slope's range ends between estimate and upper end; that of the intercept does not matter
  const double upper = known.value[1] + 0.5 * half;
  const Line line(kLine, {{"intercept", -10, 10}, {"slope", -10, upper}});
  const Verdict verdict = solve(line);
  ASSERT_EQ(verdict.status, FitStatus::ok) << verdict.message;
  const double allowance = cost_allowance(0.95, verdict.best.sum_of_squares, kLine.size(), 2, false);
  const Interval interval = profile_intervals(line, verdict.best, 0.95, allowance, verdict.standard_errors)[1];
  EXPECT_EQ(interval.high_status, EndStatus::at_bound);
  EXPECT_EQ(interval.high, upper);
  EXPECT_EQ(interval.low_status, EndStatus::found);
  EXPECT_NEAR(interval.low, known.value[1] - half, 1e-9 * half);
}

/// A minimum at its bound has an interval to one side, without a standard error to begin with.
TEST(ProfileOfALine, FromABoundGoesOneWay) {
  const Regression known(kLine);
  const Line line(kLine, {{"intercept", -10, 10}, {"slope", -10, known.value[1] - known.error[1]}});
  const Verdict verdict = solve(line);
  ASSERT_EQ(verdict.status, FitStatus::at_bound);
  const Interval interval = profile_intervals(line, verdict.best, 0.95, 1, {{}, {}})[1];
  EXPECT_EQ(interval.high_status, EndStatus::at_bound);
  EXPECT_EQ(interval.low_status, EndStatus::found);
  // cost above the free minimum S: ((b - x)/error)^2 S/(n - 2); from one error to where it has grown by the allowance 1
  const double variance = known.squares / static_cast<double>(kLine.size() - 2);
  const double low = known.value[1] - known.error[1] * std::sqrt(1 + 1 / variance);
  EXPECT_NEAR(interval.low, low, 1e-9 * known.error[1]);
}

/// A constant of the experiment has a wide but arbitrary range: reaching its end says nothing.
TEST(ProfileOfALine, IsOpenWhereOnlyTheSearchEnds) {
  const Regression known(kLine);
  const double upper = known.value[1] + 0.5 * known.error[1];
  const Line line(kLine, {{"intercept", -10, 10}, {"slope", -10, upper, 0.4}});
  const Verdict verdict = solve(line);
  ASSERT_EQ(verdict.status, FitStatus::ok) << verdict.message;
  const double allowance = cost_allowance(0.95, verdict.best.sum_of_squares, kLine.size(), 2, false);
  const Interval interval = profile_intervals(line, verdict.best, 0.95, allowance, verdict.standard_errors)[1];
  EXPECT_EQ(interval.high_status, EndStatus::open);
  EXPECT_EQ(interval.low_status, EndStatus::found);
}

}  // namespace profile_interval_test
}  // namespace mixity
