#include "solver/joint.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "solver/solve.h"

namespace mixity {
namespace joint_test {

/// y = slope t + offset.
class OffsetLine final : public Problem {
 public:
  OffsetLine(std::vector<double> t, std::vector<double> y)
      : t_(std::move(t)), y_(std::move(y)), parameters_{{"slope", -10, 10}, {"offset", -10, 10, 0.0}} {}
  std::size_t residual_count() const override { return t_.size(); }
  const std::vector<FreeParameter>& parameters() const override { return parameters_; }
  double data_norm() const override { return 1; }
  bool known_errors() const override { return true; }
  bool evaluate(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian) const override {
    for (std::size_t i = 0; i < t_.size(); ++i) {
      residuals[i] = x[0] * t_[i] + x[1] - y_[i];
      if (jacobian.empty()) continue;
      jacobian[2 * i] = t_[i];
      jacobian[2 * i + 1] = 1;
    }
    return true;
  }

 private:
  std::vector<double> t_, y_;
  std::vector<FreeParameter> parameters_;
};

/// Two slopes, one offset: the normal equations in full.
TEST(JointProblem, FindsWhatTheNormalEquationsSay) {
  const std::vector<double> t{0, 1, 2, 3}, u{1, 2, 5}, y{0.9, 2.1, 2.7, 4.3}, z{0.2, -1.1, -3.8};
  const OffsetLine first(t, y), second(u, z);
  const JointProblem joint({&first, &second}, 1);
  ASSERT_EQ(joint.parameters().size(), 3U);
  EXPECT_EQ(joint.parameters()[1].name, "slope");
  EXPECT_EQ(joint.parameters()[2].name, "offset");
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(7, 3);
  Eigen::VectorXd right(7);
  for (int i = 0; i < 7; ++i) {
    const auto k = static_cast<std::size_t>(i);
    J(i, i < 4 ? 0 : 1) = i < 4 ? t[k] : u[k - 4];
    J(i, 2) = 1;
    right[i] = i < 4 ? y[k] : z[k - 4];
  }
  const Eigen::VectorXd expected = J.colPivHouseholderQr().solve(right);
  const Eigen::MatrixXd covariance = (J.transpose() * J).inverse();
  const Verdict verdict = solve(joint, {.near = {0, 0, 0}});
  ASSERT_EQ(verdict.status, FitStatus::ok) << verdict.message;
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(verdict.best.x[static_cast<std::size_t>(k)], expected[k], 1e-12);  // rounding of seven points
    EXPECT_NEAR(*verdict.standard_errors[static_cast<std::size_t>(k)], std::sqrt(covariance(k, k)), 1e-12);
  }
  std::vector<double> residuals(7), jacobian(21);
  ASSERT_TRUE(joint.evaluate(verdict.best.x, residuals, jacobian));
  for (int i = 0; i < 7; ++i)
    for (int k = 0; k < 3; ++k) EXPECT_EQ(jacobian[static_cast<std::size_t>(3 * i + k)], J(i, k));
}

}  // namespace joint_test
}  // namespace mixity
