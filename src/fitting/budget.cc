#include "fitting/budget.h"

#include <atomic>
#include <cmath>
#include <limits>
#include <span>

#include "base/threads.h"
#include "solver/linear_algebra.h"
#include "statistics/distributions.h"

namespace mixity {
namespace {

/// Residuals above this many rounding errors are noise of the data.
constexpr double kRounding = 100;

/// The effective number of independent tests, from the eigenvalues of their correlation matrix (Galwey 2009).
double effective_number(const Eigen::MatrixXd& correlations) {
  if (correlations.size() == 0) return 0;
  const Eigen::VectorXd values = eigenvalues(correlations).cwiseMax(0);
  return std::pow(values.cwiseSqrt().sum(), 2) / values.sum();
}

/// The rows of a problem divided by a unit, part by part; several parts are evaluated again in each pass.
class Rows {
 public:
  Rows(const Problem& problem, const std::vector<double>& x, double unit) : problem_(problem), x_(x), unit_(unit) {}

  /// Calls take(J, r, sums) for each part, and adds the parts' sums, in their order, to `sums`. False if a value is not
  /// finite.
  template <class Sums, class Take>
  bool each(Sums& sums, const Take& take) {
    if (problem_.parts() == 1) {
      if (residuals_.empty() && !evaluate(0, residuals_, jacobian_)) return false;
      return taken(residuals_, jacobian_, sums, take);
    }
    std::vector<Sums> of_parts(problem_.parts(), sums);
    std::atomic<std::size_t> next = 0;
    std::atomic<bool> finite = true;
    run_on_idle_processors(of_parts.size(), [&] {
      std::vector<double> residuals, jacobian;
      for (std::size_t part; finite && (part = next++) < of_parts.size();)
        if (!evaluate(part, residuals, jacobian) || !taken(residuals, jacobian, of_parts[part], take)) finite = false;
    });
    for (std::size_t part = 0; finite && part < of_parts.size(); ++part) sums.add(of_parts[part]);
    return finite;
  }

 private:
  bool evaluate(std::size_t part, std::vector<double>& residuals, std::vector<double>& jacobian) const {
    if (!problem_.evaluate_part(part, x_, residuals, jacobian)) return false;
    for (std::vector<double>* const list : {&residuals, &jacobian})
      for (double& one : *list) one /= unit_;
    return true;
  }

  template <class Sums, class Take>
  bool taken(const std::vector<double>& residuals, const std::vector<double>& jacobian, Sums& sums,
             const Take& take) const {
    const auto J = as_matrix(jacobian, x_.size());
    const auto r = as_vector(residuals);
    if (!J.allFinite() || !r.allFinite()) return false;
    take(J, r, sums);
    return true;
  }

  const Problem& problem_;
  const std::vector<double>& x_;
  double unit_;
  std::vector<double> residuals_, jacobian_;
};

/// Sums over the rows; J has the columns of parameters that the fit can move.
struct Products {
  Eigen::MatrixXd of_data;          // J'J
  double squares = 0;               // r'r
  Eigen::MatrixXd across;           // J'c of each constant that was not fitted
  Eigen::VectorXd lengths, slopes;  // its |c|^2 and c'r
  void add(const Products& other) {
    of_data += other.of_data;
    squares += other.squares;
    across += other.across;
    lengths += other.lengths;
    slopes += other.slopes;
  }
};

/// Sums over the rows for the constants that are tested.
struct Tests {
  Eigen::MatrixXd correlations;
  Eigen::VectorXd robust;  // the sums of squares of HC3
  void add(const Tests& other) {
    correlations += other.correlations;
    robust += other.robust;
  }
};

/// A constant that was not fitted.
struct Tested {
  std::size_t column;
  double square = 0, slope = 0;  // |c|^2 and c'r
  Eigen::VectorXd across{};      // J'c for the parameters that the fit can move
  Eigen::VectorXd moved{};       // how far the fit moves them per unit of the constant
  bool tested = false;           // its column is independent of those of the fit
  double robust = 0;             // the sum of squares of HC3
  double left() const { return square - across.dot(moved); }
  double fall() const { return slope * slope / left(); }
};

}  // namespace

std::optional<Budget> error_budget(const Problem& problem, const std::vector<double>& x, double unit,
                                   const std::vector<bool>& held, const std::vector<ConstantStep>& exact) {
  const std::size_t n = problem.residual_count(), fitted = held.size();
  const auto& parameters = problem.parameters();
  if (fitted == 0 || !(unit > 0)) return std::nullopt;
  Rows rows(problem, x, unit);
  std::vector<std::size_t> open;  // columns of parameters that the fit can move
  for (std::size_t k = 0; k < fitted; ++k)
    if (!held[k]) open.push_back(k);
  const auto m = static_cast<Eigen::Index>(open.size());
  Eigen::VectorXd priors(m);  // infinite without a prior
  for (Eigen::Index i = 0; i < m; ++i) {
    const double prior = parameters[open[static_cast<std::size_t>(i)]].prior;
    priors[i] = prior > 0 ? prior : std::numeric_limits<double>::infinity();
  }
  std::vector<Tested> constants;
  for (const ConstantStep& one : exact) constants.push_back({one.parameter});
  const auto all = static_cast<Eigen::Index>(exact.size());
  Products sums{Eigen::MatrixXd::Zero(m, m), 0, Eigen::MatrixXd::Zero(m, all), Eigen::VectorXd::Zero(all),
                Eigen::VectorXd::Zero(all)};
  const bool finite = rows.each(sums, [&](const auto& J, const auto& r, Products& to) {
    const Eigen::MatrixXd open_J = J(Eigen::all, open);
    to.of_data += open_J.transpose() * open_J;
    to.squares += r.squaredNorm();
    for (Eigen::Index k = 0; k < all; ++k) {
      const Eigen::VectorXd column = J.col(static_cast<Eigen::Index>(exact[static_cast<std::size_t>(k)].parameter));
      to.lengths[k] += column.squaredNorm();
      to.across.col(k) += open_J.transpose() * column;
      to.slopes[k] += column.dot(r);
    }
  });
  if (!finite) return std::nullopt;
  const Eigen::MatrixXd& of_data = sums.of_data;
  const double squares = sums.squares;
  for (std::size_t k = 0; k < constants.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    constants[k].square = sums.lengths[column];
    constants[k].slope = sums.slopes[column];
    constants[k].across = sums.across.col(column);
  }
  const bool scatters = std::sqrt(squares) * unit > kRounding * residual_rounding(problem);
  Eigen::MatrixXd H = of_data;
  H.diagonal() += priors.cwiseAbs2().cwiseInverse();
  // scaled to a unit diagonal, which reduces rounding errors
  const Eigen::VectorXd scale = H.diagonal().cwiseSqrt().cwiseInverse();
  if (!scale.allFinite()) return std::nullopt;
  H = scale.asDiagonal() * H * scale.asDiagonal();
  const auto solve = [&](const Eigen::VectorXd& right) -> Eigen::VectorXd {
    return scale.cwiseProduct(solve_symmetric(H, scale.cwiseProduct(right)));
  };
  Budget budget{parameters[0].name, parameters[0].unit, {}, {}, {}, 0};
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
  std::vector<Tested*> tests;
  for (Tested& one : constants) {
    one.moved = solve(one.across);
    // a column that depends on those of the fit, within rounding, cannot be tested
    one.tested = one.left() > 1e-9 * one.square && scatters;
    if (one.tested) tests.push_back(&one);
  }
  const auto count = static_cast<Eigen::Index>(tests.size());
  Tests found{Eigen::MatrixXd::Zero(count, count), Eigen::VectorXd::Zero(count)};
  const bool whole = problem.parts() == 1;  // the columns' lengths are then known at once
  const bool again = tests.empty() || rows.each(found, [&](const auto& J, const auto& r, Tests& to) {
    const Eigen::MatrixXd open_J = J(Eigen::all, open);
    Eigen::MatrixXd directions(J.rows(), count);  // one column per test
    for (Eigen::Index k = 0; k < count; ++k) {
      const Tested& one = *tests[static_cast<std::size_t>(k)];
      auto apart = directions.col(k);
      apart = J.col(static_cast<Eigen::Index>(one.column));
      for (Eigen::Index i = 0; i < m; ++i) apart -= one.moved[i] * open_J.col(i);
      // Errors of unknown size: the larger of two p-values, for a common variance of the residuals, and for individual
      // variances from residual and leverage with the constant free (MacKinnon & White's HC3).
      const double per_left = 1 / one.left(), move = one.slope * per_left;
      for (Eigen::Index i = 0; i < apart.size() && !problem.known_errors(); ++i) {
        const double size = apart[i], free = (r[i] - size * move) / std::max(1 - size * size * per_left, 0.1);
        to.robust[k] += std::pow(size * free, 2);
      }
      if (whole) apart.normalize();
    }
    for (Eigen::Index i = 0; i < count; ++i)
      for (Eigen::Index j = 0; j < count; ++j) to.correlations(i, j) += directions.col(i).dot(directions.col(j));
  });
  if (!again) return std::nullopt;
  Eigen::MatrixXd& correlations = found.correlations;
  for (std::size_t k = 0; k < tests.size(); ++k) tests[k]->robust = found.robust[static_cast<Eigen::Index>(k)];
  if (!whole) {
    const Eigen::VectorXd lengths = correlations.diagonal().cwiseSqrt();
    correlations.array() /= (lengths * lengths.transpose()).array();
  }
  for (std::size_t k = 0; k < exact.size(); ++k) {
    const ConstantStep& step = exact[k];
    const Tested& one = constants[k];
    const FreeParameter& parameter = parameters[one.column];
    const double at = x[one.column], scale_of = parameters[0].shown_slope(x[0]);
    ExactConstant constant{parameter.name,
                           parameter.unit,
                           moves ? std::optional(-one.moved[0] * step.step * scale_of) : std::nullopt,
                           parameter.shown(at + step.step) - parameter.shown(at),
                           {}};
    if (one.tested) {
      const double left = one.left(), fall = one.fall();
      double p_value = chi_squared_p_value(fall, 1);
      if (const Eigen::Index freedom = static_cast<Eigen::Index>(n) - m - 1; !problem.known_errors()) {
        double robust = one.robust;
        for (Eigen::Index i = 0; i < m; ++i) robust += std::pow(one.moved[i] / priors[i], 2);
        const double alike = left * std::max(squares - fall, 0.0) / static_cast<double>(freedom);
        p_value = freedom > 0 && robust > 0 && alike > 0
                      ? student_p_value(one.slope / std::sqrt(std::max(robust, alike)), static_cast<double>(freedom))
                      : 1;
      }
      constant.score = {fall, parameter.shown(at - one.slope / left), p_value};
      if (moves) {
        const double variance = solve(Eigen::VectorXd::Unit(m, 0))[0];
        constant.score->change = one.moved[0] * one.slope / left / std::sqrt(variance);
        constant.score->widening = std::sqrt(1 + one.moved[0] * one.moved[0] / left / variance);
      }
    }
    budget.exact.push_back(std::move(constant));
  }
  budget.independent = effective_number(correlations);
  return budget;
}

}  // namespace mixity
