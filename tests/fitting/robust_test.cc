#include "fitting/robust.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fitting/fit.h"
#include "fitting/synthetic_runs.h"

namespace mixity {
namespace {

/// Residuals x^2 + 2 y - d_i: enough to see each by itself.
class Differences final : public LeastSquares {
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
  class Mean final : public LeastSquares {
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
    const Verdict verdict = minimise(robust);
    ASSERT_TRUE(verdict.stderrs[0]) << verdict.message;
    const auto cost = robust.single_cost();
    const double x = verdict.best.x[0], h = 1e-4;  // errors h^2 and eps/h^2
    const double curvature = (*cost->value(x + h) - 2 * *cost->value(x) + *cost->value(x - h)) / (h * h);
    EXPECT_NEAR(*verdict.stderrs[0], std::sqrt(verdict.best.sum_of_squares / 8 / (0.5 * curvature)), 1e-5)
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

Dataset scattered(unsigned seed) {
  SeededNoise noise(seed, 0.01);
  return synthetic_runs<PapangeloCiavarella>({0.15}, {0.5, 5, 20}, 30, 0.85, noise);
}

FitOptions area_with(Loss loss, std::optional<double> scale = {}) {
  return {.objective = Objective::area,
          .sigma_A = *parse_quantity("1%"),
          .loss = loss,
          .loss_scale = scale,
          .intervals = false};
}

TEST(Robust, OfALargeScaleIsNoLossAtAll) {
  const Dataset data = scattered(1);
  const FitResult plain = fit_model(data, "c", area_with(Loss::none));
  ASSERT_EQ(plain.status, FitStatus::ok);
  const double huber = *fit_model(data, "c", area_with(Loss::huber, 1e6)).parameters[0].value;
  EXPECT_NEAR(huber, *plain.parameters[0].value, 1e-12);  // the same residuals to the bit
  const double cauchy = *fit_model(data, "c", area_with(Loss::cauchy, 1e6)).parameters[0].value;
  EXPECT_NEAR(cauchy, *plain.parameters[0].value, 1e-9);  // r^2/s^2 = 1e-11 is left
}

TEST(Robust, OutliersMoveAFitLessThanLeastSquares) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Dataset clean = scattered(seed);
    Dataset spoilt = clean;
    for (std::size_t i = 0; i < 10; ++i) {
      const Point& p = clean.points[9 * i + 4];
      spoilt.points[9 * i + 4] = {p.line, p.curve, p.P, p.T, 1.3 * p.A};
    }
    const auto moved = [&](Loss loss) {
      return std::abs(*fit_model(spoilt, "c", area_with(loss)).parameters[0].value -
                      *fit_model(clean, "c", area_with(loss)).parameters[0].value);
    };
    // Ten of ninety points are off by thirty standard errors; Huber's influence is cut at 1.345, Cauchy's falls to 0.2.
    const double plain = moved(Loss::none), huber = moved(Loss::huber), cauchy = moved(Loss::cauchy);
    EXPECT_LT(huber, 0.2 * plain) << seed;
    EXPECT_LT(cauchy, 0.5 * huber) << seed;
  }
}

/// Errors of unknown size: the loss bends at so many of the residuals' own spread.
TEST(Robust, ScaleFollowsTheSpreadWhereErrorsAreNotKnown) {
  const Dataset data = scattered(3);
  const FitOptions options{.loss = Loss::huber, .intervals = false};
  const FitResult fit = fit_model(data, "c", options);
  ASSERT_EQ(fit.status, FitStatus::ok);
  // ln f scatters by more than A does; its median and RMS agree to some ten percent for Gaussian noise without tails
  EXPECT_NEAR(fit.loss_scale / 1.345, *fit.rmse, 0.5 * *fit.rmse);
  EXPECT_EQ(fit_model(data, "c", area_with(Loss::huber)).loss_scale, 1.345);
}

}  // namespace
}  // namespace mixity
