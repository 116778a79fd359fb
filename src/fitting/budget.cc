#include "fitting/budget.h"

#include <cmath>

#include "solver/linear_algebra.h"
#include "statistics/distributions.h"

namespace mixity {
namespace {

/// Residuals so many times what rounding may leave are noise of the data.
constexpr double kRounding = 100;

/// How many independent tests act like these, from the eigenvalues of their correlations (Galwey 2009).
double effective_number(const std::vector<Eigen::VectorXd>& columns) {
  const auto m = static_cast<Eigen::Index>(columns.size());
  if (m == 0) return 0;
  Eigen::MatrixXd correlations(m, m);
  for (Eigen::Index i = 0; i < m; ++i)
    for (Eigen::Index j = 0; j < m; ++j)
      correlations(i, j) = columns[static_cast<std::size_t>(i)].dot(columns[static_cast<std::size_t>(j)]);
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
  const auto rows = static_cast<Eigen::Index>(n);
  const RowMajorMatrix J =
      Eigen::Map<const RowMajorMatrix>(jacobian.data(), rows, static_cast<Eigen::Index>(all)) / unit;
  const Eigen::VectorXd r = Eigen::Map<const Eigen::VectorXd>(residuals.data(), rows) / unit;
  if (!J.allFinite() || !r.allFinite()) return std::nullopt;
  const bool scatters = r.norm() * unit > kRounding * residual_rounding(problem);

  std::vector<Eigen::Index> open;  // columns of what the fit moves
  for (std::size_t k = 0; k < fitted; ++k)
    if (!held[k]) open.push_back(static_cast<Eigen::Index>(k));
  const Eigen::MatrixXd open_J = J(Eigen::all, open), of_data = open_J.transpose() * open_J;
  Eigen::MatrixXd H = of_data;
  for (std::size_t i = 0; i < open.size(); ++i)
    if (const double prior = parameters[static_cast<std::size_t>(open[i])].prior; prior > 0)
      H(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i)) += 1 / (prior * prior);
  // scaled to a unit diagonal, for the sake of rounding
  const Eigen::VectorXd scale = H.diagonal().cwiseSqrt().cwiseInverse();
  if (!scale.allFinite()) return std::nullopt;
  H = scale.asDiagonal() * H * scale.asDiagonal();
  const auto solve = [&](const Eigen::VectorXd& right) -> Eigen::VectorXd {
    return scale.cwiseProduct(solve_symmetric(H, scale.cwiseProduct(right)));
  };
  Budget budget{parameters[0].name, parameters[0].unit, {}, {}, {}, 0};
  std::vector<Eigen::VectorXd> tested;  // what each score test looks along
  const bool moves = !held[0];
  if (moves) {
    const Eigen::VectorXd row = solve(Eigen::VectorXd::Unit(static_cast<Eigen::Index>(open.size()), 0));
    const double variance = row[0];
    if (!row.allFinite() || !(variance > 0)) return std::nullopt;
    budget.scatter = row.dot(of_data * row) / variance;
    for (std::size_t i = 0; i < open.size(); ++i) {
      const FreeParameter& parameter = parameters[static_cast<std::size_t>(open[i])];
      if (!(parameter.prior > 0)) continue;
      const double part = row[static_cast<Eigen::Index>(i)] / parameter.prior;
      budget.parts.push_back({parameter.name, part * part / variance,
                              (x[static_cast<std::size_t>(open[i])] - *parameter.start) / parameter.prior});
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
    // what differs from the fit's own columns by rounding alone says nothing
    if (left > 1e-9 * square && scatters) {
      const double slope = column.dot(r), fall = slope * slope / left;
      const Eigen::VectorXd apart = column - open_J * moved;
      tested.push_back(apart.normalized());
      double p_value = chi_squared_p_value(fall, 1);
      if (const Eigen::Index freedom = rows - static_cast<Eigen::Index>(open.size()) - 1; !problem.known_errors()) {
        // Of unknown size: the larger p of two, one for errors that are all alike, one where each residual stands for
        // its own, larger by its leverage, with the constant free (MacKinnon & White's HC3).
        const Eigen::ArrayXd leverage = apart.array().square() / left,
                             free = (r - apart * (slope / left)).array() / (1 - leverage).max(0.1);
        double robust = (apart.array() * free).square().sum();
        for (std::size_t i = 0; i < open.size(); ++i)
          if (const double prior = parameters[static_cast<std::size_t>(open[i])].prior; prior > 0)
            robust += std::pow(moved[static_cast<Eigen::Index>(i)] / prior, 2);
        const double alike = left * std::max(r.squaredNorm() - fall, 0.0) / static_cast<double>(freedom);
        p_value = freedom > 0 && robust > 0 && alike > 0
                      ? student_p_value(slope / std::sqrt(std::max(robust, alike)), static_cast<double>(freedom))
                      : 1;
      }
      constant.score = {fall, parameter.shown(at - slope / left), p_value};
    }
    budget.exact.push_back(std::move(constant));
  }
  budget.independent = effective_number(tested);
  return budget;
}

}  // namespace mixity
