// What a verdict says whatever the residuals' number of minima and unit.
#include "solver/solve.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mixity {
namespace solve_test {

/// Two groups of points that want different lambdas leave two equal minima.
TEST(Solve, SaysMultimodalWhenTwoMinimaFitAlike) {
  class TwoWells final : public Problem {
   public:
    std::size_t residual_count() const override { return 4; }
    const std::vector<FreeParameter>& parameters() const override { return parameters_; }
    bool evaluate(std::span<const double> x, std::span<double> r, std::span<double> J) const override {
      for (std::size_t i = 0; i < 4; ++i) {
        const double sign = i % 2 == 0 ? 1 : -1;
        r[i] = (x[0] - 0.3) * (x[0] - 0.7) * 10 + sign;
        if (!J.empty()) J[i] = 10 * (2 * x[0] - 1);
      }
      return true;
    }
    double data_norm() const override { return 2; }

   private:
    std::vector<FreeParameter> parameters_{{"x", 0, 1}};
  };
  const Verdict verdict = solve(TwoWells());
  EXPECT_EQ(verdict.status, FitStatus::multimodal) << verdict.message;
  ASSERT_EQ(verdict.others.size(), 1u);
  // each is a simple zero of the gradient
  EXPECT_NEAR(verdict.best.x[0] + verdict.others[0].x[0], 1, 1e-12);
}

/// Unweighted residuals of any size: the verdict must not depend on their unit.
TEST(Solve, DoesNotCallTheStartAMinimumWhenResidualsAreTiny) {
  class Scaled final : public Problem {
   public:
    explicit Scaled(double scale) : scale_(scale) {}
    std::size_t residual_count() const override { return 3; }
    const std::vector<FreeParameter>& parameters() const override { return parameters_; }
    bool evaluate(std::span<const double> x, std::span<double> r, std::span<double> J) const override {
      for (std::size_t i = 0; i < 3; ++i) {
        const double t = static_cast<double>(i + 1);
        r[i] = scale_ *
               (std::exp(-x[0] * t) - std::exp(-0.4 * t) + 0.01 * std::sin(static_cast<double>(12 * i * i + 7 * i)));
        if (!J.empty()) J[i] = -scale_ * t * std::exp(-x[0] * t);
      }
      return true;
    }
    double data_norm() const override { return scale_; }

   private:
    double scale_;
    std::vector<FreeParameter> parameters_{{"x", 0, 1}};
  };
  const Verdict reference = solve(Scaled(1));
  ASSERT_EQ(reference.status, FitStatus::ok) << reference.message;
  for (const double scale : {1e-12, 1e-6, 1e6, 1e12}) {
    const Verdict verdict = solve(Scaled(scale));
    EXPECT_EQ(verdict.status, FitStatus::ok) << verdict.message;
    EXPECT_NEAR(verdict.best.x[0], reference.best.x[0], 1e-12);  // rounding of three terms
  }
}

}  // namespace solve_test
}  // namespace mixity
