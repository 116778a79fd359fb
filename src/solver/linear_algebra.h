// Decompositions of small dense matrices. Only linear_algebra.cc includes Eigen's, which take seconds to compile
// wherever they are used. [n x m]: n rows, m columns.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

namespace mixity {

/// A Jacobian of residuals, stored by rows.
using RowMajorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Views an array as a vector, or as a matrix with this many columns, stored by rows.
inline Eigen::Map<const Eigen::VectorXd> as_vector(std::span<const double> values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}
inline Eigen::Map<const RowMajorMatrix> as_matrix(std::span<const double> values, std::size_t columns) {
  return {values.data(), static_cast<Eigen::Index>(values.size() / columns), static_cast<Eigen::Index>(columns)};
}

/// The upper triangle R of J = QR, [m x m]; its last rows are 0 if J has fewer rows than columns.
Eigen::MatrixXd qr_triangle(Eigen::MatrixXd J);
/// Squared norm of each row of Q where J = QR: the leverage of each residual. J has at least as many rows as columns.
Eigen::VectorXd leverages(Eigen::MatrixXd J);
/// (R'R)^-1 of an upper triangle without a zero on its diagonal.
Eigen::MatrixXd inverse_of_square(const Eigen::MatrixXd& R);

/// The least singular value of a square matrix and its right singular vector.
struct WeakDirection {
  double singular_value;
  Eigen::VectorXd direction;
};
WeakDirection weak_direction(const Eigen::MatrixXd& R);

/// (J' diag(c) J)^-1; null unless that matrix is positive definite.
std::optional<Eigen::MatrixXd> inverse_of_weighted_square(const Eigen::MatrixXd& J, const Eigen::VectorXd& c);
/// ln of the determinant; null unless H is positive definite.
std::optional<double> log_determinant(const Eigen::MatrixXd& H);
/// Eigenvalues of a symmetric matrix, in ascending order.
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& symmetric);

/// Solves H x = b for a symmetric H of any size, also 0 (LDL').
Eigen::VectorXd solve_symmetric(const Eigen::MatrixXd& H, const Eigen::VectorXd& b);
/// The same for each column of B.
Eigen::MatrixXd solve_columns(const Eigen::MatrixXd& H, const Eigen::MatrixXd& B);
/// u' S^-1 u over the directions of a positive semidefinite S, in which u lies, and their number: pivots of LDL' up to
/// `least` are rounding.
struct SquareAlong {
  double square = 0, directions = 0;
};
SquareAlong square_along(const Eigen::MatrixXd& S, const Eigen::VectorXd& u, double least);
/// Solves H x = b with full pivoting; H may be singular.
Eigen::VectorXd solve_any(const Eigen::MatrixXd& H, const Eigen::VectorXd& b);

/// `along`: the projection of b onto the columns of J, in an orthonormal basis without the columns whose pivot is below
/// `independent` times the largest. `solution`: the least-squares solution of J x = b with all columns.
struct Projection {
  Eigen::VectorXd along, solution;
};
Projection project(Eigen::MatrixXd J, Eigen::VectorXd b, double independent);

}  // namespace mixity
