#include "solver/linear_algebra.h"

#include <Eigen/Dense>
#include <algorithm>

namespace mixity {

using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// A matrix that needs no memory of its own: most have a row for each of a few parameters.
constexpr Eigen::Index kSmall = 8;
using Small = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kSmall, kSmall>;

template <class Result>
Result solved(const MatrixXd& H, const Result& B) {
  if (B.size() == 0) return B;
  if (H.rows() <= kSmall) return Eigen::LDLT<Small>(H).solve(B);
  return H.ldlt().solve(B);
}

}  // namespace

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
  const auto of = [](const auto& factors) {
    return factors.info() == Eigen::Success ? std::optional(2 * factors.matrixLLT().diagonal().array().log().sum())
                                            : std::nullopt;
  };
  return H.rows() <= kSmall ? of(Eigen::LLT<Small>(H)) : of(Eigen::LLT<MatrixXd>(H));
}

VectorXd eigenvalues(const MatrixXd& symmetric) {
  return Eigen::SelfAdjointEigenSolver<MatrixXd>(symmetric, Eigen::EigenvaluesOnly).eigenvalues();
}

VectorXd solve_symmetric(const MatrixXd& H, const VectorXd& b) { return solved(H, b); }

MatrixXd solve_columns(const MatrixXd& H, const MatrixXd& B) { return solved(H, B); }

SquareAlong square_along(const MatrixXd& S, const VectorXd& u, double least) {
  const Eigen::LDLT<MatrixXd> factors(S);
  const VectorXd pivots = factors.vectorD();
  VectorXd rest = factors.transpositionsP() * u;
  factors.matrixL().solveInPlace(rest);
  SquareAlong found;
  for (Eigen::Index i = 0; i < rest.size(); ++i) {
    if (!(pivots[i] > least)) continue;
    found.square += rest[i] * rest[i] / pivots[i];
    ++found.directions;
  }
  return found;
}

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
