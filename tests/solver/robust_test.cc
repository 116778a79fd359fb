#include "solver/robust.h"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/solve.h"

namespace mixity {
namespace robust_test {

/// Residuals x^2 + 2 y - d_i: enough to see each by itself.
class Differences final : public Problem {
 public:
  explicit Differences(std::vector<double> data) : data_(std::move(data)) {}
  std::size_t residual_count() const override { return data_.size(); }
  const std::vector<FreeParameter>& parameters() const override { return parameters_; }
  bool evaluate(std::span<const double> x, std::span<double> r, std::span<double> J) const override {
    for (std::size_t i = 0; i < data_.size(); ++i) {
      r[i] = x[0] * x[0] + 2 * x[1] - data_[i];
      if (J.empty()) continue;
      J[2 * i] = 2 * x[0];
      J[2 * i + 1] = 2;
    }
    return true;
  }
  double data_norm() const override { return 1; }

 private:
  std::vector<double> data_;
  std::vector<FreeParameter> parameters_{{"x", -10, 10}, {"y", -10, 10}};
};

/// As printed: Huber r^2 up to s, then s (2|r| - s); Cauchy s^2 ln(1 + r^2/s^2).
double printed_rho(Loss loss, double r, double s) {
  if (loss == Loss::huber) return std::abs(r) <= s ? r * r : s * (2 * std::abs(r) - s);
  return s * s * std::log1p(r * r / (s * s));
}

const std::vector<double> kData{0, 0.5, 0.999, 1, 1.001, 1.3, 2.5, 4, -0.7, -40, 1e6};

TEST(Robust, CostIsThePrintedLoss) {
  const Differences problem(kData);
  for (const Loss loss : {Loss::huber, Loss::cauchy})
    for (const double scale : {0.3, 1.0, 2.3849}) {
      std::vector<double> plain(kData.size()), robust(kData.size());
      const std::vector<double> x{1, 0};
      ASSERT_TRUE(problem.evaluate(x, plain, {}));
      ASSERT_TRUE(RobustProblem(problem, loss, scale).evaluate(x, robust, {}));
      for (std::size_t i = 0; i < plain.size(); ++i) {
        const double rho = printed_rho(loss, plain[i], scale);
        EXPECT_NEAR(robust[i] * robust[i], rho, 1e-14 * rho) << to_string(loss) << ' ' << plain[i];  // a few roundings
        EXPECT_EQ(std::signbit(robust[i]), std::signbit(plain[i]));
      }
    }
}

/// -2 ln of Student's density over that of a residual of 0.
TEST(Robust, CostOfTIsItsLikelihood) {
  const Differences problem(kData);
  const double freedom = 3.2, s = 0.7;
  const RobustProblem t(problem, Loss::t, std::sqrt(freedom) * s, freedom);
  EXPECT_TRUE(t.known_errors());
  std::vector<double> plain(kData.size()), robust(kData.size()), jacobian(2 * kData.size()), low(robust), high(robust);
  const std::vector<double> x{1.2, 0.1};
  ASSERT_TRUE(problem.evaluate(x, plain, {}));
  ASSERT_TRUE(t.evaluate(x, robust, jacobian));
  const double h = 1e-6;
  ASSERT_TRUE(t.evaluate(std::vector<double>{x[0] - h, x[1]}, low, {}));
  ASSERT_TRUE(t.evaluate(std::vector<double>{x[0] + h, x[1]}, high, {}));
  for (std::size_t i = 0; i < plain.size(); ++i) {
    const double printed = -2 * std::log(std::pow(1 + plain[i] * plain[i] / (freedom * s * s), -(freedom + 1) / 2));
    EXPECT_NEAR(robust[i] * robust[i], printed, 1e-13 * printed);  // the power of a large number
    EXPECT_NEAR(jacobian[2 * i], (high[i] - low[i]) / (2 * h), 1e-8 + 1e-9 * std::abs(robust[i])) << kData[i];
  }
}

TEST(Robust, JacobianMatchesDifferences) {
  const Differences problem(kData);
  for (const Loss loss : {Loss::huber, Loss::cauchy})
    for (const double scale : {0.3, 1.0, 2.3849}) {
      const RobustProblem robust(problem, loss, scale);
      const std::size_t n = kData.size();
      const std::vector<double> x{1.2, 0.1};
      std::vector<double> r(n), low(n), high(n), jacobian(2 * n);
      ASSERT_TRUE(robust.evaluate(x, r, jacobian));
      for (std::size_t k = 0; k < 2; ++k) {
        const double h = 1e-6;
        std::vector<double> below = x, above = x;
        below[k] -= h;
        above[k] += h;
        ASSERT_TRUE(robust.evaluate(below, low, {}));
        ASSERT_TRUE(robust.evaluate(above, high, {}));
        for (std::size_t i = 0; i < n; ++i)
          // h^2 = 1e-12 of the third derivative, and eps |r|/h: residuals are below 1e3 s, sqrt(2 * 1e6 s)
          EXPECT_NEAR(jacobian[2 * i + k], (high[i] - low[i]) / (2 * h), 1e-8 + 1e-9 * std::abs(r[i])) << kData[i];
      }
    }
}

/// Wald's error is that of the cost's own curvature, which outliers lower: here of one mean, by second differences.
TEST(Robust, StandardErrorsFollowTheCurvatureOfTheLoss) {
  class Mean final : public Problem {
   public:
    std::size_t residual_count() const override { return 9; }
    const std::vector<FreeParameter>& parameters() const override { return parameters_; }
    bool evaluate(std::span<const double> x, std::span<double> r, std::span<double> J) const override {
      const double data[] = {0.1, -0.3, 0.5, 1.1, -0.9, 0.05, -0.2, 4, 9};
      for (std::size_t i = 0; i < 9; ++i) {
        r[i] = x[0] - data[i];
        if (!J.empty()) J[i] = 1;
      }
      return true;
    }
    double data_norm() const override { return 10; }

   private:
    std::vector<FreeParameter> parameters_{{"mean", -5, 5}};
  } mean;
  for (const Loss loss : {Loss::huber, Loss::cauchy}) {
    const RobustProblem robust(mean, loss, 1.5);
    const Verdict verdict = solve(robust);
    ASSERT_TRUE(verdict.standard_errors[0]) << verdict.message;
    const auto cost = [&](double mean_value) {
      std::vector<double> residuals(9);
      return sum_of_squares(robust, {&mean_value, 1}, residuals).value();
    };
    const double x = verdict.best.x[0], h = 1e-4;  // errors h^2 and eps/h^2
    const double curvature = (cost(x + h) - 2 * cost(x) + cost(x - h)) / (h * h);
    EXPECT_NEAR(*verdict.standard_errors[0], std::sqrt(verdict.best.sum_of_squares / 8 / (0.5 * curvature)), 1e-5)
        << to_string(loss);
  }
}

/// An exact zero among the residuals: its slope is the plain one, and nothing divides by it.
TEST(Robust, ResidualsOfZeroStayWhatTheyAre) {
  const Differences problem({1.0});
  for (const Loss loss : {Loss::huber, Loss::cauchy}) {
    std::vector<double> r(1), jacobian(2);
    ASSERT_TRUE(RobustProblem(problem, loss, 1).evaluate(std::vector<double>{1, 0}, r, jacobian));
    EXPECT_EQ(r[0], 0);
    EXPECT_EQ(jacobian, (std::vector<double>{2, 2}));
  }
}

}  // namespace robust_test
}  // namespace mixity
