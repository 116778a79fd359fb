#include "solver/descent.h"

#include <ceres/ceres.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/kernel.h"

namespace mixity {
namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// For one descent: each evaluation has the memory of the last.
class Remembering final : public WrappedProblem {
 public:
  using WrappedProblem::WrappedProblem;
  bool evaluate(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian) const override {
    return problem_.evaluate_again(x, residuals, jacobian, memory_);
  }

 private:
  mutable std::vector<double> memory_;
};

/// The residuals times `scale`: Ceres damps its steps as if J'J were at least 1e-6, which is all of the
/// size of a step where psi is small.
class CeresAdapter final : public ceres::CostFunction {
 public:
  CeresAdapter(const Problem& problem, double scale) : problem_(problem), scale_(scale) {
    set_num_residuals(static_cast<int>(problem.residual_count()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(problem.parameters().size()));
  }
  bool Evaluate(const double* const* x, double* residuals, double** jacobians) const override {
    const std::size_t n = problem_.residual_count(), p = problem_.parameters().size();
    const bool wanted = jacobians && jacobians[0];
    if (!problem_.evaluate({x[0], p}, {residuals, n}, {wanted ? jacobians[0] : nullptr, wanted ? n * p : 0}))
      return false;
    for (std::size_t i = 0; i < n; ++i) residuals[i] *= scale_;
    for (std::size_t i = 0; wanted && i < n * p; ++i) jacobians[0][i] *= scale_;
    return true;
  }

 private:
  const Problem& problem_;
  double scale_;
};

/// Residuals, Jacobian and what the first-order condition makes of them.
struct Linearised {
  Vector r;
  Matrix J;
  Vector gradient;         // J'r, zero where a bound holds the parameter
  std::vector<bool> held;  // by a bound
  Vector step;             // Gauss-Newton's, of measure()
  bool finite = false;
  double stationarity = 0;  // of measure()
  bool settled = true;      // a step to a zero of the gradient would be lost in the rounding of x
};

/// Into `at`, whose memory is used again: with many points the system's handing it out takes longer than filling it.
void linearise(const Problem& problem, const Vector& x, Linearised& at) {
  const auto n = static_cast<Eigen::Index>(problem.residual_count());
  const auto p = static_cast<Eigen::Index>(problem.parameters().size());
  at.r.resize(n);
  at.J.resize(n, p);
  at.held.assign(static_cast<std::size_t>(p), false);
  at.settled = true;
  at.finite = problem.evaluate({x.data(), static_cast<std::size_t>(p)}, {at.r.data(), static_cast<std::size_t>(n)},
                               {at.J.data(), static_cast<std::size_t>(n * p)});
  if (!at.finite) return;
  at.gradient = at.J.transpose() * at.r;
  for (Eigen::Index k = 0; k < p; ++k) {
    const FreeParameter& parameter = problem.parameters()[static_cast<std::size_t>(k)];
    const bool held_low = x[k] <= parameter.lower && at.gradient[k] > 0;
    const bool held_high = x[k] >= parameter.upper && at.gradient[k] < 0;
    at.held[static_cast<std::size_t>(k)] = held_low || held_high;
    if (held_low || held_high) at.gradient[k] = 0;
    const double slope = at.J.col(k).norm();
    at.settled &= std::abs(at.gradient[k]) <= std::numeric_limits<double>::epsilon() * std::abs(x[k]) * slope * slope;
  }
}

/// How much of r lies along the columns of J that may move: the offset of D. M. Bates & D. G. Watts (Technometrics 23,
/// 1981). Each column alone would call a place in a narrow valley stationary that is standard errors off.
void measure(Linearised& at, const SolverOptions& options) {
  const Eigen::Index p = at.J.cols();
  Matrix J(at.J.rows(), p);
  Vector unit(p);
  for (Eigen::Index k = 0; k < p; ++k) {
    const double slope = at.held[static_cast<std::size_t>(k)] ? 0 : at.J.col(k).norm();
    unit[k] = slope > 0 ? 1 / slope : 0;
    J.col(k) = at.J.col(k) * unit[k];
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(J.rows(), p);
  factors.setThreshold(options.independent);  // what does not count as independent has no direction
  factors.compute(J);
  const Vector along = (factors.householderQ().adjoint() * at.r).head(std::min(factors.rank(), J.rows()));
  // Each column, too: a direction that was left out must not hide a gradient.
  const double r = at.r.norm(), gradient = at.gradient.cwiseProduct(unit).lpNorm<Eigen::Infinity>();
  at.stationarity = r > 0 ? std::max(along.norm(), gradient) / r : 0;
  at.step = unit.cwiseProduct(factors.solve(-at.r));
}

/// The first-order condition, or as close to it as rounding lets: `rounding` is that of |r|.
bool is_stationary(const Linearised& at, double rounding, const SolverOptions& options) {
  return at.stationarity <= options.stationary || at.stationarity * at.r.norm() <= rounding || at.settled;
}

Vector clamped(const Problem& problem, Vector x) {
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    const FreeParameter& parameter = problem.parameters()[static_cast<std::size_t>(k)];
    x[k] = std::clamp(x[k], parameter.lower, parameter.upper);
  }
  return x;
}

/// Cost differences vanish in rounding at sqrt(eps) of x; the gradient does not. Newton steps on it, its derivative
/// by central differences, take the parameters to their last digits. `rounding` of |r| is no reason to stop: without
/// noise that is all there is.
void polish(const Problem& problem, Vector& x, Linearised& at, double rounding, const SolverOptions& options) {
  const Eigen::Index p = x.size();
  Linearised below, above;
  const auto newton = [&](Eigen::MatrixXd H) -> Vector {
    // Columns of J scaled to 1: else the factors take what is small in its unit for zero.
    Vector unit(p);
    for (Eigen::Index k = 0; k < p; ++k) unit[k] = at.gradient[k] == 0 ? 1 : 1 / at.J.col(k).norm();
    H = unit.asDiagonal() * H * unit.asDiagonal();
    for (Eigen::Index k = 0; k < p; ++k)
      if (at.gradient[k] == 0) {  // held by a bound, or already there
        H.col(k) = Vector::Unit(p, k);
        H.row(k) = Vector::Unit(p, k).transpose();
      }
    return unit.cwiseProduct(H.fullPivLu().solve(-unit.cwiseProduct(at.gradient)));
  };
  const auto take_step = [&](Vector step, double gain = 1) {
    if (!step.allFinite()) return false;
    const Vector next = clamped(problem, x + step);
    Linearised& there = below;  // which has served
    linearise(problem, next, there);
    if (!there.finite) return false;
    measure(there, options);
    // At a bound J may vanish by symmetry, which makes any |r| stationary: a step to one has to pay.
    bool to_bound = false;
    for (Eigen::Index k = 0; k < p; ++k) {
      const FreeParameter& parameter = problem.parameters()[static_cast<std::size_t>(k)];
      to_bound |= next[k] != x[k] && (next[k] <= parameter.lower || next[k] >= parameter.upper);
    }
    const double rise = at.r.norm() * 1e-12 + (to_bound ? 0 : rounding);
    const bool better = there.stationarity < gain * at.stationarity && there.r.norm() <= at.r.norm() + rise;
    if (!better) return false;
    x = next;
    std::swap(at, there);
    return true;
  };
  const double enough = p == 1 ? options.kernel_stationary : options.newton_stationary;
  for (int iteration = 0; iteration < options.newton_steps && at.stationarity > enough; ++iteration) {
    // Where the residuals are small Gauss-Newton needs no differences, in which parameters that hardly differ lose
    // their digits.
    if (take_step(at.step, 0.1)) continue;
    Eigen::MatrixXd H = Eigen::MatrixXd::Zero(p, p);
    for (Eigen::Index k = 0; k < p; ++k) {
      if (at.gradient[k] == 0) continue;
      const FreeParameter& parameter = problem.parameters()[static_cast<std::size_t>(k)];
      // Close to an upper bound only the distance from it may matter, as that of lambda from 1 in model a.
      const double room = parameter.upper - x[k], size = room > 0 ? std::min(std::abs(x[k]), room) : std::abs(x[k]);
      const double h = options.difference_step * std::max(size, parameter.least_size());
      Vector low = x, high = x;
      low[k] = std::max(x[k] - h, parameter.lower);
      high[k] = std::min(x[k] + h, parameter.upper);
      linearise(problem, low, below);
      linearise(problem, high, above);
      if (!below.finite || !above.finite) return;
      H.col(k) = (above.J.transpose() * above.r - below.J.transpose() * below.r) / (high[k] - low[k]);
    }
    const double before = at.stationarity;
    if (take_step(newton(H))) {
      // Newton squares the error, but where rounding is all that is left.
      if (before <= options.stationary && at.stationarity > 0.5 * before) return;
      continue;
    }
    // On a bound the distance to the minimum may be far less than that of the differences; the Jacobian knows none.
    if (!take_step(at.step)) return;
  }
}

Minimum polished(const Problem& problem, Vector x, Linearised& at, const SolverOptions& options) {
  const double rounding = residual_rounding(problem);
  polish(problem, x, at, rounding, options);
  const double r = at.r.norm();
  return {{x.begin(), x.end()}, r * r, at.stationarity, is_stationary(at, rounding, options)};
}

std::optional<Minimum> descend_with_ceres(const Problem& problem, const std::vector<double>& start,
                                          const SolverOptions& options) {
  Vector x = Eigen::Map<const Vector>(start.data(), static_cast<Eigen::Index>(start.size()));
  Linearised at;
  linearise(problem, x, at);
  if (!at.finite) return std::nullopt;
  measure(at, options);

  // Below 1e-17 a parameter moves no residual by a rounding, over all of its range.
  const double slope = at.J.colwise().norm().maxCoeff();
  CeresAdapter cost(problem, slope > 1e-17 && slope < 1 ? 1 / slope : 1);
  ceres::Problem::Options ownership;
  ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem ceres_problem(ownership);
  ceres_problem.AddResidualBlock(&cost, nullptr, x.data());
  for (int k = 0; k < x.size(); ++k) {
    const FreeParameter& parameter = problem.parameters()[static_cast<std::size_t>(k)];
    if (std::isfinite(parameter.lower)) ceres_problem.SetParameterLowerBound(x.data(), k, parameter.lower);
    if (std::isfinite(parameter.upper)) ceres_problem.SetParameterUpperBound(x.data(), k, parameter.upper);
  }
  ceres::Solver::Options settings;
  settings.linear_solver_type = ceres::DENSE_QR;
  settings.max_num_iterations = options.most_iterations_shown;
  // An absolute gradient tolerance would call small residuals converged at once; whether the end is a minimum is
  // judged afterwards, free of scale.
  settings.gradient_tolerance = 0;
  settings.parameter_tolerance = options.ceres_step;
  settings.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  const double rounding = residual_rounding(problem);
  for (const double change : {options.ceres_cost_change, std::numeric_limits<double>::epsilon()}) {
    // Where rounding is all that is left of the gradient, no step lowers the cost, of which Ceres would complain.
    if (!(at.stationarity > (at.J.cols() == 1 ? options.kernel_stationary : options.newton_stationary))) break;
    settings.function_tolerance = change;
    std::copy(start.begin(), start.end(), x.begin());
    ceres::Solve(settings, &ceres_problem, &summary);
    linearise(problem, x, at);
    if (!at.finite) return std::nullopt;
    measure(at, options);
    // Undamped, the next step would lower the cost by the square of this, far more than what stopped Ceres: it creeps.
    if (at.stationarity <= 100 * std::sqrt(change) || is_stationary(at, rounding, options)) break;
  }
  return polished(problem, x, at, options);
}

/// Gauss-Newton's last steps gain little where the residuals are large; Newton's do.
std::optional<Minimum> descend_with_kernel(const Problem& problem, const std::vector<double>& start,
                                           const SolverOptions& options) {
  SolverOptions patient = options;
  patient.most_iterations = options.most_iterations_shown;
  const auto minimum = Kernel(problem, patient).descend(start);
  if (!minimum || start.size() == 1) return minimum;
  const Vector x = Eigen::Map<const Vector>(minimum->x.data(), static_cast<Eigen::Index>(start.size()));
  Linearised at;
  linearise(problem, x, at);
  if (!at.finite) return std::nullopt;
  measure(at, options);
  return polished(problem, x, at, options);
}

}  // namespace

std::optional<Minimum> descend(const Problem& problem, const std::vector<double>& start, const SolverOptions& options) {
  if (options.engine == Engine::kernel) return descend_with_kernel(problem, start, options);
  return descend_with_ceres(Remembering(problem), start, options);
}

std::string_view solver_version() { return CERES_VERSION_STRING; }

}  // namespace mixity
