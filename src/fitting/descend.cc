// The solver proper: Ceres, then Newton steps on the gradient.
#include <ceres/ceres.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "fitting/minimise.h"

namespace mixity {
namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The residuals times `scale`: Ceres damps its steps as if J'J were at least 1e-6, which is all of the
/// size of a step where psi is small.
class CeresAdapter final : public ceres::CostFunction {
 public:
  CeresAdapter(const LeastSquares& problem, double scale) : problem_(problem), scale_(scale) {
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
  const LeastSquares& problem_;
  double scale_;
};

/// Residuals, Jacobian and what the first-order condition makes of them.
struct Linearised {
  Vector r;
  Matrix J;
  Vector gradient;  // J'r, zero where a bound holds the parameter
  bool finite = false;
  double stationarity = 0;
  bool settled = true;  // a step to a zero of the gradient would be lost in the rounding of x
};

/// Into `at`, whose memory is used again: with many points the system's handing it out takes longer than filling it.
void linearise(const LeastSquares& problem, const Vector& x, Linearised& at) {
  const auto n = static_cast<Eigen::Index>(problem.residual_count());
  const auto p = static_cast<Eigen::Index>(problem.parameters().size());
  at.r.resize(n);
  at.J.resize(n, p);
  at.stationarity = 0;
  at.settled = true;
  at.finite = problem.evaluate({x.data(), static_cast<std::size_t>(p)}, {at.r.data(), static_cast<std::size_t>(n)},
                               {at.J.data(), static_cast<std::size_t>(n * p)});
  if (!at.finite) return;
  at.gradient = at.J.transpose() * at.r;
  for (Eigen::Index k = 0; k < p; ++k) {
    const FreeParameter& parameter = problem.parameters()[static_cast<std::size_t>(k)];
    const bool held_low = x[k] <= parameter.lower && at.gradient[k] > 0;
    const bool held_high = x[k] >= parameter.upper && at.gradient[k] < 0;
    if (held_low || held_high) at.gradient[k] = 0;
    const double slope = at.J.col(k).norm(), scale = slope * at.r.norm();
    at.settled &= std::abs(at.gradient[k]) <= std::numeric_limits<double>::epsilon() * std::abs(x[k]) * slope * slope;
    if (scale > 0) at.stationarity = std::max(at.stationarity, std::abs(at.gradient[k]) / scale);
  }
}

/// The first-order condition, or as close to it as rounding lets: `rounding` is that of |r|.
bool is_stationary(const Linearised& at, double rounding) {
  return at.stationarity <= 1e-8 || at.stationarity * at.r.norm() <= rounding || at.settled;
}

Vector clamped(const LeastSquares& problem, Vector x) {
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    const FreeParameter& parameter = problem.parameters()[static_cast<std::size_t>(k)];
    x[k] = std::clamp(x[k], parameter.lower, parameter.upper);
  }
  return x;
}

/// Cost differences vanish in rounding at sqrt(eps) of x; the gradient does not. Newton steps on it, its derivative
/// by central differences, take the parameters to their last digits. `rounding` of |r| is no reason to stop: without
/// noise that is all there is.
void polish(const LeastSquares& problem, Vector& x, Linearised& at, double rounding) {
  const Eigen::Index p = x.size();
  Linearised below, above;
  const auto take_step = [&](Eigen::MatrixXd H) {
    for (Eigen::Index k = 0; k < p; ++k)
      if (at.gradient[k] == 0) {  // held by a bound, or already there
        H.col(k) = Vector::Unit(p, k);
        H.row(k) = Vector::Unit(p, k).transpose();
      }
    const Vector step = H.fullPivLu().solve(-at.gradient);
    if (!step.allFinite()) return false;
    const Vector next = clamped(problem, x + step);
    Linearised& there = below;  // which has served
    linearise(problem, next, there);
    // At a bound J may vanish by symmetry, which makes any |r| stationary: a step to one has to pay.
    bool to_bound = false;
    for (Eigen::Index k = 0; k < p; ++k) {
      const FreeParameter& parameter = problem.parameters()[static_cast<std::size_t>(k)];
      to_bound |= next[k] != x[k] && (next[k] <= parameter.lower || next[k] >= parameter.upper);
    }
    const double rise = at.r.norm() * 1e-12 + (to_bound ? 0 : rounding);
    const bool better = there.finite && there.stationarity < at.stationarity && there.r.norm() <= at.r.norm() + rise;
    if (!better) return false;
    x = next;
    std::swap(at, there);
    return true;
  };
  for (int iteration = 0; iteration < 12 && at.stationarity > 0; ++iteration) {
    Eigen::MatrixXd H = Eigen::MatrixXd::Zero(p, p);
    for (Eigen::Index k = 0; k < p; ++k) {
      if (at.gradient[k] == 0) continue;
      const FreeParameter& parameter = problem.parameters()[static_cast<std::size_t>(k)];
      // Close to an upper bound only the distance from it may matter, as that of lambda from 1 in model a.
      const double room = parameter.upper - x[k], size = room > 0 ? std::min(std::abs(x[k]), room) : std::abs(x[k]);
      const double h = 1e-5 * std::max(size, 1e-9 * (parameter.upper - parameter.lower));
      Vector low = x, high = x;
      low[k] = std::max(x[k] - h, parameter.lower);
      high[k] = std::min(x[k] + h, parameter.upper);
      linearise(problem, low, below);
      linearise(problem, high, above);
      if (!below.finite || !above.finite) return;
      H.col(k) = (above.J.transpose() * above.r - below.J.transpose() * below.r) / (high[k] - low[k]);
    }
    if (take_step(H)) continue;
    // On a bound the distance to the minimum may be far less than that of the differences; the Jacobian knows none.
    if (is_stationary(at, rounding) || !take_step(at.J.transpose() * at.J)) return;
  }
}

}  // namespace

std::optional<Minimum> descend(const LeastSquares& problem, const std::vector<double>& start) {
  Vector x = Eigen::Map<const Vector>(start.data(), static_cast<Eigen::Index>(start.size()));
  Linearised at;
  linearise(problem, x, at);
  if (!at.finite) return std::nullopt;

  // Below 1e-17 a parameter moves no residual by a rounding, over all of its range.
  const double slope = at.J.colwise().norm().maxCoeff();
  CeresAdapter cost(problem, slope > 1e-17 && slope < 1 ? 1 / slope : 1);
  ceres::Problem::Options ownership;
  ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem ceres_problem(ownership);
  ceres_problem.AddResidualBlock(&cost, nullptr, x.data());
  for (int k = 0; k < x.size(); ++k) {
    ceres_problem.SetParameterLowerBound(x.data(), k, problem.parameters()[static_cast<std::size_t>(k)].lower);
    ceres_problem.SetParameterUpperBound(x.data(), k, problem.parameters()[static_cast<std::size_t>(k)].upper);
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = 200;
  // An absolute gradient tolerance would call small residuals converged at once; whether the end is a minimum is
  // judged afterwards, free of scale.
  options.gradient_tolerance = 0;
  // Close enough for polish(), which goes on to the last digits in fewer steps.
  options.function_tolerance = 1e-10;
  options.parameter_tolerance = 1e-14;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  // Where rounding is all that is left of the gradient, no step lowers the cost, of which Ceres would complain.
  if (at.stationarity > 1e-14) ceres::Solve(options, &ceres_problem, &summary);

  linearise(problem, x, at);
  if (!at.finite) return std::nullopt;
  const double rounding = residual_rounding(problem);
  polish(problem, x, at, rounding);
  const double r = at.r.norm();
  return Minimum{{x.begin(), x.end()}, r * r, at.stationarity, is_stationary(at, rounding)};
}

std::string_view solver_version() { return CERES_VERSION_STRING; }

}  // namespace mixity
