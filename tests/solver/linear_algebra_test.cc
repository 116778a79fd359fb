#include "solver/linear_algebra.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mixity {
namespace linear_algebra_test {

constexpr double kRounding = 1e-14;

Eigen::MatrixXd tall() {
  Eigen::MatrixXd J(4, 2);
  J << 1, 2, 3, -1, 0.5, 4, -2, 1;
  return J;
}

TEST(LinearAlgebra, TriangleHasTheSquareOfTheMatrix) {
  const Eigen::MatrixXd J = tall(), R = qr_triangle(J);
  EXPECT_EQ(R(1, 0), 0);
  EXPECT_LT((R.transpose() * R - J.transpose() * J).norm(), kRounding * J.squaredNorm());
  EXPECT_LT((inverse_of_square(R) * J.transpose() * J - Eigen::MatrixXd::Identity(2, 2)).norm(), 10 * kRounding);
}

TEST(LinearAlgebra, TriangleOfTooFewRowsEndsInZeros) {
  Eigen::MatrixXd J(1, 2);
  J << 3, 4;
  const Eigen::MatrixXd R = qr_triangle(J);
  EXPECT_EQ(R.row(1).norm(), 0);
  const WeakDirection weak = weak_direction(R);
  EXPECT_LT(weak.singular_value, kRounding);
  EXPECT_LT(std::abs((J * weak.direction)[0]), kRounding);
  EXPECT_NEAR(weak.direction.norm(), 1, kRounding);
}

TEST(LinearAlgebra, LeveragesAreTheDiagonalOfTheProjection) {
  const Eigen::MatrixXd J = tall();
  const Eigen::VectorXd h = (J * inverse_of_square(qr_triangle(J)) * J.transpose()).diagonal();
  EXPECT_LT((leverages(J) - h).norm(), kRounding);
  EXPECT_NEAR(leverages(J).sum(), 2, kRounding);
}

TEST(LinearAlgebra, DefiniteMatricesHaveAnInverseAndADeterminant) {
  const Eigen::MatrixXd J = tall();
  Eigen::VectorXd c(4);
  c << 1, 0.5, 2, 1;
  const Eigen::MatrixXd H = J.transpose() * c.asDiagonal() * J;
  EXPECT_LT((inverse_of_weighted_square(J, c).value() * H - Eigen::MatrixXd::Identity(2, 2)).norm(), 10 * kRounding);
  EXPECT_NEAR(log_determinant(H).value(), std::log(H(0, 0) * H(1, 1) - H(0, 1) * H(1, 0)), kRounding);
  EXPECT_FALSE(inverse_of_weighted_square(J, -c).has_value());
  EXPECT_FALSE(log_determinant(-H).has_value());
}

TEST(LinearAlgebra, EigenvaluesAscend) {
  Eigen::MatrixXd A(2, 2);
  A << 2, 1, 1, 2;
  EXPECT_NEAR(eigenvalues(A)[0], 1, kRounding);
  EXPECT_NEAR(eigenvalues(A)[1], 3, kRounding);
}

TEST(LinearAlgebra, Solves) {
  Eigen::MatrixXd H(2, 2);
  H << 2, 1, 1, -3;
  const Eigen::Vector2d b(4, -5);
  EXPECT_LT((H * solve_symmetric(H, b) - b).norm(), 10 * kRounding);
  EXPECT_LT((H * solve_any(H, b) - b).norm(), 10 * kRounding);
  EXPECT_EQ(solve_symmetric(Eigen::MatrixXd(0, 0), Eigen::VectorXd(0)).size(), 0);
}

/// Small matrices take no memory of their own.
TEST(LinearAlgebra, SolvesSmallAndLargeMatricesAlike) {
  for (const Eigen::Index n : {1, 8, 9, 30}) {
    Eigen::MatrixXd H(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index k = 0; k < n; ++k) H(i, k) = 1.0 / static_cast<double>(1 + std::abs(i - k)) + (i == k ? 2 : 0);
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(n, 1, 3);
    EXPECT_LT((H * solve_symmetric(H, b) - b).norm(), 100 * kRounding) << n;
    EXPECT_LT((H * solve_columns(H, H) - H).norm(), 1000 * kRounding) << n;
    EXPECT_NEAR(*log_determinant(H), std::log(H.determinant()), 100 * kRounding) << n;
  }
}

TEST(LinearAlgebra, SquareAlongLeavesOutDirectionsThatTheMatrixDoesNotHave) {
  // v v' + w w' with orthogonal v and w: u = 2 v + 3 w has the square 4 + 9.
  const Eigen::Vector3d v(1, 2, 2), w(2, 1, -2);
  const Eigen::MatrixXd S = v * v.transpose() + w * w.transpose();
  const SquareAlong found = square_along(S, 2 * v + 3 * w, 1e-9);
  EXPECT_NEAR(found.square, 13, 1e-12);
  EXPECT_EQ(found.directions, 2);
}

TEST(LinearAlgebra, ProjectionLeavesOutColumnsThatDependOnOthers) {
  Eigen::MatrixXd J(3, 2);
  J << 1, 2, 0, 0, 1, 2 * (1 + 1e-13);
  const Eigen::Vector3d b(1, 5, 2);
  const Projection one = project(J, b, 1e-9);
  ASSERT_EQ(one.along.size(), 1);
  EXPECT_NEAR(std::abs(one.along[0]), 3 / std::sqrt(2.0), 1e-12);
}

TEST(LinearAlgebra, ProjectionSolvesInTheSenseOfLeastSquares) {
  const Eigen::MatrixXd J = tall();
  const Eigen::Vector4d b(1, 5, 2, -1);
  const Projection found = project(J, b, 1e-9);
  EXPECT_EQ(found.along.size(), 2);
  EXPECT_LT((J.transpose() * (J * found.solution - b)).norm(), 10 * kRounding);
  EXPECT_NEAR(found.along.norm(), (J * found.solution).norm(), 10 * kRounding);
}

}  // namespace linear_algebra_test
}  // namespace mixity
