#include "fitting/budget.h"

#include <cmath>
#include <limits>

#include "solver/linear_algebra.h"
#include "statistics/distributions.h"

namespace mixity {
namespace {

/// Residuals larger than so many rounding errors are noise of the data.
constexpr double kRounding = 100;

/// The effective number of independent tests, from the eigenvalues of their correlations (Galwey 2009).
double effective_number(const std::vector<Eigen::VectorXd>& columns) {
  const std::size_t m = columns.size();
  if (m == 0) return 0;
  Eigen::MatrixXd correlations(m, m);
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < m; ++j)
      correlations(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = columns[i].dot(columns[j]);
  const Eigen::VectorXd values = eigenvalues(correlations).cwiseMax(0);
  return std::pow(values.cwiseSqrt().sum(), 2) / values.sum();
}

}  // namespace

std::optional<Budget> error_budget(const Problem& problem, const std::vector<double>& x, double unit,
                                   const std::vector<bool>& held, const std::vector<ConstantStep>& exact) {
  const std::size_t n = problem.residual_count(), fitted = held.size(), all = fitted + exact.size();
  const auto& parameters = problem.parameters();
  std::vector<double> residuals(n), jacobian(n * all);
  if (fitted == 0 || !(unit > 0) || !problem.evaluate(x, residuals, jacobian)) return std::nullopt;
  const RowMajorMatrix J = as_matrix(jacobian, all) / unit;
  const Eigen::VectorXd r = as_vector(residuals) / unit;
  if (!J.allFinite() || !r.allFinite()) return std::nullopt;
  const bool scatters = r.norm() * unit > kRounding * residual_rounding(problem);

  std::vector<std::size_t> open;  // columns of parameters that the fit moves
  for (std::size_t k = 0; k < fitted; ++k)
    if (!held[k]) open.push_back(k);
  const auto m = static_cast<Eigen::Index>(open.size());
  Eigen::VectorXd priors(m);  // infinite where nothing is known
  for (Eigen::Index i = 0; i < m; ++i) {
    const double prior = parameters[open[static_cast<std::size_t>(i)]].prior;
    priors[i] = prior > 0 ? prior : std::numeric_limits<double>::infinity();
  }
  const Eigen::MatrixXd open_J = J(Eigen::all, open), of_data = open_J.transpose() * open_J;
  Eigen::MatrixXd H = of_data;
  H.diagonal() += priors.cwiseAbs2().cwiseInverse();
  // scaled to a unit diagonal, against rounding errors
  const Eigen::VectorXd scale = H.diagonal().cwiseSqrt().cwiseInverse();
  if (!scale.allFinite()) return std::nullopt;
  H = scale.asDiagonal() * H * scale.asDiagonal();
  const auto solve = [&](const Eigen::VectorXd& right) -> Eigen::VectorXd {
    return scale.cwiseProduct(solve_symmetric(H, scale.cwiseProduct(right)));
  };
  Budget budget{parameters[0].name, parameters[0].unit, {}, {}, {}, 0};
  std::vector<Eigen::VectorXd> tested;  // direction of each score test
  const bool moves = !held[0];
  if (moves) {
    const Eigen::VectorXd row = solve(Eigen::VectorXd::Unit(m, 0));
    const double variance = row[0];
    if (!row.allFinite() || !(variance > 0)) return std::nullopt;
    budget.scatter = row.dot(of_data * row) / variance;
    for (Eigen::Index i = 0; i < m; ++i) {
      const std::size_t k = open[static_cast<std::size_t>(i)];
      const double part = row[i] / priors[i];
      if (parameters[k].prior > 0)
        budget.parts.push_back({parameters[k].name, part * part / variance, (x[k] - *parameters[k].start) / priors[i]});
    }
  }
  for (const ConstantStep& one : exact) {
    const FreeParameter& parameter = parameters[one.parameter];
    const Eigen::VectorXd column = J.col(static_cast<Eigen::Index>(one.parameter));
    const Eigen::VectorXd moved = solve(open_J.transpose() * column);  // of the fit, for each unit of the constant
    const double at = x[one.parameter], scale_of = parameters[0].shown_slope(x[0]);
    ExactConstant constant{parameter.name,
                           parameter.unit,
                           moves ? std::optional(-moved[0] * one.step * scale_of) : std::nullopt,
                           parameter.shown(at + one.step) - parameter.shown(at),
                           {}};
    const double square = column.squaredNorm(), left = square - (open_J.transpose() * column).dot(moved);
    // a column that depends on those of the fit, to rounding, cannot be tested
    if (left > 1e-9 * square && scatters) {
      const double slope = column.dot(r), fall = slope * slope / left;
      const Eigen::VectorXd apart = column - open_J * moved;
      tested.push_back(apart.normalized());
      double p_value = chi_squared_p_value(fall, 1);
      if (const Eigen::Index freedom = static_cast<Eigen::Index>(n) - m - 1; !problem.known_errors()) {
        // Errors of unknown size: the larger p of two, for one variance of all residuals, and for a variance of each
        // from the residual and its leverage with the constant free (MacKinnon & White's HC3).
        const Eigen::ArrayXd leverage = apart.array().square() / left,
                             free = (r - apart * (slope / left)).array() / (1 - leverage).max(0.1);
        double robust = (apart.array() * free).square().sum();
        for (Eigen::Index i = 0; i < m; ++i) robust += std::pow(moved[i] / priors[i], 2);
        const double alike = left * std::max(r.squaredNorm() - fall, 0.0) / static_cast<double>(freedom);
        p_value = freedom > 0 && robust > 0 && alike > 0
                      ? student_p_value(slope / std::sqrt(std::max(robust, alike)), static_cast<double>(freedom))
                      : 1;
      }
      constant.score = {fall, parameter.shown(at - slope / left), p_value};
      if (moves) {
        const double variance = solve(Eigen::VectorXd::Unit(m, 0))[0];
        constant.score->change = moved[0] * slope / left / std::sqrt(variance);
        constant.score->widening = std::sqrt(1 + moved[0] * moved[0] / left / variance);
      }
    }
    budget.exact.push_back(std::move(constant));
  }
  budget.independent = effective_number(tested);
  return budget;
}

}  // namespace mixity
