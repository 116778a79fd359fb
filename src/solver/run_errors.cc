#include "solver/run_errors.h"

#include <algorithm>
#include <cmath>

#include "solver/linear_algebra.h"

namespace mixity {

RunErrors::RunErrors(const Problem& problem, const std::vector<double>& fitted,
                     const std::vector<std::vector<std::size_t>>& groups) {
  const std::size_t n = problem.residual_count(), p = fitted.size();
  std::vector<double> residuals(n), jacobian(n * p);
  if (!problem.evaluate(fitted, residuals, jacobian)) return;
  const auto J = as_matrix(jacobian, p);
  const auto r = as_vector(residuals);
  std::size_t points = 0;
  for (const auto& group : groups) {
    const RowMajorMatrix of_group = J(group, Eigen::all);
    squares_.push_back(of_group.transpose() * of_group);
    slopes_.push_back(of_group.transpose() * r(group));
    points += group.size();
  }
  const RowMajorMatrix priors = J.bottomRows(static_cast<Eigen::Index>(n - points));
  of_priors_ = priors.transpose() * priors;
}

std::vector<double> RunErrors::operator()(const std::vector<double>& drawn, const std::vector<double>& change) const {
  const auto runs = std::count_if(drawn.begin(), drawn.end(), [](double one) { return one > 0; });
  if (runs < 3 || squares_.empty()) return {};
  Eigen::MatrixXd H = of_priors_, scores = of_priors_;
  const auto moved = as_vector(change);
  double count = 0;
  for (std::size_t g = 0; g < drawn.size(); ++g) {
    const Eigen::VectorXd score = slopes_[g] + squares_[g] * moved;
    H += drawn[g] * squares_[g];
    scores += drawn[g] * score * score.transpose();
    count += drawn[g];
  }
  if (!log_determinant(H)) return {};
  const Eigen::MatrixXd half = solve_columns(H, scores), covariance = solve_columns(H, half.transpose());
  std::vector<double> errors;
  for (Eigen::Index k = 0; k < H.rows(); ++k)
    errors.push_back(std::sqrt(std::max(covariance(k, k), 0.0) * count / (count - 1)));
  return errors;
}

}  // namespace mixity
