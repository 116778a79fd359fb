#include "solver/linear_algebra.h"

#include <Eigen/Dense>
#include <algorithm>

namespace mixity {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd qr_triangle(MatrixXd J) {
  const Eigen::Index rows = std::min(J.rows(), J.cols());
  MatrixXd R = MatrixXd::Zero(J.cols(), J.cols());
  const Eigen::HouseholderQR<Eigen::Ref<MatrixXd>> factors(J);  // in place
  R.topRows(rows) = J.topRows(rows).triangularView<Eigen::Upper>();
  return R;
}

VectorXd leverages(MatrixXd J) {
  const Eigen::HouseholderQR<Eigen::Ref<MatrixXd>> qr(J);  // in place
  const MatrixXd Q = qr.householderQ() * MatrixXd::Identity(J.rows(), J.cols());
  VectorXd squares(Q.rows());
  for (Eigen::Index i = 0; i < Q.rows(); ++i) squares[i] = Q.row(i).squaredNorm();
  return squares;
}

MatrixXd inverse_of_square(const MatrixXd& R) {
  const MatrixXd root = R.triangularView<Eigen::Upper>().solve(MatrixXd::Identity(R.rows(), R.rows()));
  return root * root.transpose();
}

WeakDirection weak_direction(const MatrixXd& R) {
  // Eigen's default QR preconditioner is for matrices that are not square, and takes 8 s to compile.
  const Eigen::JacobiSVD<MatrixXd, Eigen::NoQRPreconditioner> svd(R, Eigen::ComputeFullV);
  return {svd.singularValues()[R.cols() - 1], svd.matrixV().col(R.cols() - 1)};
}

std::optional<MatrixXd> inverse_of_weighted_square(const MatrixXd& J, const VectorXd& c) {
  const Eigen::LLT<MatrixXd> factors(J.transpose() * c.asDiagonal() * J);
  if (factors.info() != Eigen::Success) return std::nullopt;
  return factors.solve(MatrixXd::Identity(J.cols(), J.cols()));
}

std::optional<double> log_determinant(const MatrixXd& H) {
  const Eigen::LLT<MatrixXd> factors(H);
  if (factors.info() != Eigen::Success) return std::nullopt;
  return 2 * factors.matrixLLT().diagonal().array().log().sum();
}

VectorXd eigenvalues(const MatrixXd& symmetric) {
  return Eigen::SelfAdjointEigenSolver<MatrixXd>(symmetric, Eigen::EigenvaluesOnly).eigenvalues();
}

Eigenvectors eigenvectors(const MatrixXd& symmetric) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solved(symmetric);
  return {solved.eigenvalues(), solved.eigenvectors()};
}

VectorXd solve_symmetric(const MatrixXd& H, const VectorXd& b) {
  return b.size() == 0 ? b : VectorXd(H.ldlt().solve(b));
}

MatrixXd solve_columns(const MatrixXd& H, const MatrixXd& B) { return B.size() == 0 ? B : MatrixXd(H.ldlt().solve(B)); }

VectorXd solve_any(const MatrixXd& H, const VectorXd& b) { return H.fullPivLu().solve(b); }

Projection project(MatrixXd J, VectorXd b, double independent) {
  Eigen::ColPivHouseholderQR<Eigen::Ref<MatrixXd>> factors(J);  // in place
  factors.setThreshold(independent);
  b.applyOnTheLeft(factors.householderQ().adjoint());
  const Eigen::Index pivots = factors.nonzeroPivots();
  VectorXd solution = VectorXd::Zero(J.cols()), first = b.head(pivots);
  factors.matrixQR().topLeftCorner(pivots, pivots).triangularView<Eigen::Upper>().solveInPlace(first);
  for (Eigen::Index k = 0; k < pivots; ++k) solution[factors.colsPermutation().indices()[k]] = first[k];
  return {b.head(std::min(factors.rank(), J.rows())), solution};
}

}  // namespace mixity
