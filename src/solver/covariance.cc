#include "solver/covariance.h"

#include <cmath>
#include <utility>

#include "solver/linear_algebra.h"

namespace mixity {

Covariance covariance(const Problem& problem, const Minimum& best, const std::vector<bool>& at_bound,
                      const SolverOptions& options) {
  const std::size_t n = problem.residual_count(), p = problem.parameters().size();
  Covariance result{std::vector<std::optional<double>>(p), {}, {}};
  std::vector<double> jacobian(n * p);
  if (std::vector<double> residuals(n); !problem.evaluate(best.x, residuals, jacobian)) return result;
  const auto J = as_matrix(jacobian, p);
  std::vector<Eigen::Index> open;
  for (std::size_t k = 0; k < p; ++k)
    if (!at_bound[k]) open.push_back(static_cast<Eigen::Index>(k));
  if (open.empty()) return result;
  const auto m = static_cast<Eigen::Index>(open.size());
  const auto name = [&](Eigen::Index i) { return problem.parameters()[static_cast<std::size_t>(open[i])].name; };
  const auto unconstrained = [&](auto&& concerned, const char* how) {
    for (Eigen::Index i = 0; i < m; ++i)
      if (concerned(i)) result.unconstrained += (result.unconstrained.empty() ? "" : " and ") + name(i);
    result.unconstrained += how;
    result.standard_errors.assign(p, std::nullopt);
    return result;
  };
  Eigen::VectorXd norms(m);
  for (Eigen::Index i = 0; i < m; ++i) norms[i] = J.col(open[i]).norm();
  if (!(norms.array() > 0).all()) return unconstrained([&](Eigen::Index i) { return !(norms[i] > 0); }, "");
  Eigen::MatrixXd scaled(J.rows(), m);
  for (Eigen::Index i = 0; i < m; ++i) scaled.col(i) = J.col(open[i]) / norms[i];
  jacobian = std::vector<double>();  // frees its memory
  const std::vector<double> bend = problem.curvatures(best.x);
  // QR of J: J'J would lose half of the digits of nearly dependent parameters.
  const Eigen::MatrixXd R = bend.empty() ? qr_triangle(std::move(scaled)) : qr_triangle(scaled);
  const WeakDirection weak = weak_direction(R);
  if (static_cast<Eigen::Index>(n) < m || !(weak.singular_value > options.independent))
    return unconstrained([&](Eigen::Index i) { return std::abs(weak.direction[i]) > 0.1; }, " independently");
  if (n <= p) return result;
  Eigen::MatrixXd inverse;
  if (bend.empty()) {
    inverse = inverse_of_square(R);
  } else {
    auto weighted = inverse_of_weighted_square(scaled, as_vector(bend));
    if (!weighted) return result;  // outliers make the curvature negative
    inverse = std::move(*weighted);
  }
  const double variance = residual_variance(problem, best.sum_of_squares);
  for (Eigen::Index i = 0; i < m; ++i)
    result.standard_errors[static_cast<std::size_t>(open[i])] = std::sqrt(variance * inverse(i, i)) / norms[i];
  // A parameter with a start has a wide range: if its error is a large part of the range, it is unknown.
  const auto unknown = [&](Eigen::Index i) {
    const auto k = static_cast<std::size_t>(open[i]);
    const FreeParameter& parameter = problem.parameters()[k];
    return parameter.start && *result.standard_errors[k] > options.known_part * parameter.width();
  };
  for (Eigen::Index i = 0; i < m; ++i)
    if (unknown(i)) return unconstrained(unknown, "");
  if (m == static_cast<Eigen::Index>(p) && p > 1)
    for (Eigen::Index i = 0; i < m; ++i)
      for (Eigen::Index j = 0; j < m; ++j)
        result.correlations.push_back(inverse(i, j) / std::sqrt(inverse(i, i) * inverse(j, j)));
  return result;
}

}  // namespace mixity
