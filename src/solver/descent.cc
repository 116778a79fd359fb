#include "solver/descent.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/threads.h"
#include "solver/kernel.h"
#include "solver/linear_algebra.h"

namespace mixity {
namespace {

using Vector = Eigen::VectorXd;

/// Fills `at`, reusing its memory: with many points allocating takes longer than filling.
void evaluate(const Problem& problem, const Eigen::VectorXd& x, Linearised& at) {
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
    const bool held = parameter.held_by_bound(x[k], at.gradient[k]);
    at.held[static_cast<std::size_t>(k)] = held;
    if (held) at.gradient[k] = 0;
    const double slope = at.J.col(k).norm();
    at.settled &= std::abs(at.gradient[k]) <= std::numeric_limits<double>::epsilon() * std::abs(x[k]) * slope * slope;
  }
}

/// Rows [J r] with the same inner products, with the columns of J multiplied by `unit`: of many rows the triangles of
/// parts, as a copy of all and their decomposition would be the largest arrays of a fit.
Eigen::MatrixXd scaled_rows(const Linearised& at, const Vector& unit) {
  constexpr Eigen::Index kPart = 1 << 15, kMany = 2 * kPart;
  const Eigen::Index n = at.r.size(), p = at.J.cols();
  const auto rows = [&](Eigen::Index begin, Eigen::Index count) {
    Eigen::MatrixXd some(count, p + 1);
    some.leftCols(p) = at.J.middleRows(begin, count) * unit.asDiagonal();
    some.col(p) = at.r.segment(begin, count);
    return some;
  };
  if (n < kMany) return rows(0, n);
  const Eigen::Index parts = (n + kPart - 1) / kPart;
  Eigen::MatrixXd triangles(parts * (p + 1), p + 1);
  parallel_for(static_cast<std::size_t>(parts), [&](std::size_t part) {
    const Eigen::Index k = static_cast<Eigen::Index>(part), begin = k * kPart;
    triangles.middleRows(k * (p + 1), p + 1) = qr_triangle(rows(begin, std::min(kPart, n - begin)));
  });
  return triangles;
}

/// The part of r along the columns of J that can move: the offset of D. M. Bates & D. G. Watts (Technometrics 23,
/// 1981). Tested column by column, a point in a narrow valley would seem stationary although it is standard errors off.
void measure(Linearised& at, const SolverOptions& options) {
  const Eigen::Index p = at.J.cols();
  Vector unit(p);
  for (Eigen::Index k = 0; k < p; ++k) {
    const double slope = at.held[static_cast<std::size_t>(k)] ? 0 : at.J.col(k).norm();
    unit[k] = slope > 0 ? 1 / slope : 0;
  }
  const Eigen::MatrixXd rows = scaled_rows(at, unit);
  const Projection found = project(rows.leftCols(p), rows.col(p), options.independent);
  // Single columns are tested, too: a direction that was left out must not hide a gradient.
  const double r = at.r.norm(), gradient = at.gradient.cwiseProduct(unit).lpNorm<Eigen::Infinity>();
  at.stationarity = r > 0 ? std::max(found.along.norm(), gradient) / r : 0;
  at.step = unit.cwiseProduct(-found.solution);
}

}  // namespace

bool linearise(const Problem& problem, const Vector& x, const SolverOptions& options, Linearised& at) {
  evaluate(problem, x, at);
  if (at.finite) measure(at, options);
  return at.finite;
}

bool is_stationary(const Linearised& at, double rounding, const SolverOptions& options) {
  return at.stationarity <= options.stationary || at.stationarity * at.r.norm() <= rounding || at.settled;
}

namespace {

/// At sqrt(eps) of x, rounding hides differences of the cost but not the gradient. Newton steps on the gradient, with
/// central differences for its derivative, give the last digits of the parameters. The rounding of |r| does not end
/// them: without noise |r| is only rounding.
void polish(const Problem& problem, Vector& x, Linearised& at, double rounding, const SolverOptions& options) {
  const Eigen::Index p = x.size();
  Linearised below, above;
  const auto newton = [&](Eigen::MatrixXd H) -> Vector {
    // Columns of J scaled to 1: otherwise the decomposition would treat parameters in a large unit as zero.
    Vector unit(p);
    for (Eigen::Index k = 0; k < p; ++k) unit[k] = at.gradient[k] == 0 ? 1 : 1 / at.J.col(k).norm();
    H = unit.asDiagonal() * H * unit.asDiagonal();
    for (Eigen::Index k = 0; k < p; ++k)
      if (at.gradient[k] == 0) {  // held by a bound, or already there
        H.col(k) = Vector::Unit(p, k);
        H.row(k) = Vector::Unit(p, k).transpose();
      }
    return unit.cwiseProduct(solve_any(H, -unit.cwiseProduct(at.gradient)));
  };
  const auto take_step = [&](Vector step, double gain = 1) {
    if (!step.allFinite()) return false;
    Vector next = x + step;
    bool to_bound = false;
    for (Eigen::Index k = 0; k < p; ++k) {
      const FreeParameter& parameter = problem.parameters()[static_cast<std::size_t>(k)];
      next[k] = parameter.clamped(next[k]);
      to_bound |= next[k] != x[k] && parameter.at_bound(next[k]);
    }
    Linearised& there = below;  // no longer needed
    if (!linearise(problem, next, options, there)) return false;
    // At a bound J may vanish by symmetry, which makes any |r| stationary: a step to one must lower the cost.
    const double rise = at.r.norm() * 1e-12 + (to_bound ? 0 : rounding);
    const bool better = there.stationarity < gain * at.stationarity && there.r.norm() <= at.r.norm() + rise;
    if (!better) return false;
    x = next;
    std::swap(at, there);
    return true;
  };
  const double enough = p == 1 ? options.kernel_stationary : options.newton_stationary;
  for (int iteration = 0; iteration < options.newton_steps && at.stationarity > enough; ++iteration) {
    // For small residuals Gauss-Newton suffices, without differences, in which nearly dependent parameters lose digits.
    if (take_step(at.step, 0.1)) continue;
    Eigen::MatrixXd H = Eigen::MatrixXd::Zero(p, p);
    for (Eigen::Index k = 0; k < p; ++k) {
      if (at.gradient[k] == 0) continue;
      const FreeParameter& parameter = problem.parameters()[static_cast<std::size_t>(k)];
      // Near an upper bound only the distance from it may matter, as for lambda near 1 in model a.
      const double room = parameter.upper - x[k], size = room > 0 ? std::min(std::abs(x[k]), room) : std::abs(x[k]);
      const double h = options.difference_step * std::max(size, parameter.least_size());
      Vector low = x, high = x;
      low[k] = std::max(x[k] - h, parameter.lower);
      high[k] = std::min(x[k] + h, parameter.upper);
      evaluate(problem, low, below);
      evaluate(problem, high, above);
      if (!below.finite || !above.finite) return;
      H.col(k) = (above.J.transpose() * above.r - below.J.transpose() * below.r) / (high[k] - low[k]);
    }
    const double before = at.stationarity;
    if (take_step(newton(H))) {
      // Newton's method squares the error, unless only rounding is left.
      if (before <= options.stationary && at.stationarity > 0.5 * before) return;
      continue;
    }
    // Near a bound the differences may be wider than the distance to the minimum; the Jacobian needs none.
    if (!take_step(at.step)) return;
  }
}

}  // namespace

Minimum polished(const Problem& problem, Vector x, Linearised& at, const SolverOptions& options) {
  const double rounding = residual_rounding(problem);
  polish(problem, x, at, rounding, options);
  const double r = at.r.norm();
  return {{x.begin(), x.end()}, r * r, at.stationarity, is_stationary(at, rounding, options)};
}

namespace {

/// With large residuals the last Gauss-Newton steps converge slowly, so Newton steps follow.
std::optional<Minimum> descend_with_kernel(const Problem& problem, const std::vector<double>& start,
                                           const SolverOptions& options) {
  SolverOptions patient = options;
  patient.most_iterations = options.most_iterations_shown;
  const auto minimum = Kernel(problem, patient).descend(start);
  if (!minimum || start.size() == 1 || (minimum->stationary && !options.last_digits)) return minimum;
  const Remembering near(problem);
  const Vector x = as_vector(minimum->x);
  Linearised at;
  if (!linearise(near, x, options, at)) return std::nullopt;
  return polished(near, x, at, options);
}

}  // namespace

std::optional<Minimum> descend(const Problem& problem, const std::vector<double>& start, const SolverOptions& options) {
  if (options.engine == Engine::kernel) return descend_with_kernel(problem, start, options);
  std::optional<Minimum> minimum;
  {
    const Remembering nearby(problem);
    minimum = descend_with_ceres(nearby, start, options);
    if (!minimum || nearby.evaluated_once()) return minimum;
  }
  // The result must not depend on the path: if the memory misled the descent, repeats it without.
  std::vector<double> residuals(problem.residual_count());
  const auto cost = sum_of_squares(problem, minimum->x, residuals);
  const bool same = cost && std::abs(std::sqrt(*cost) - std::sqrt(minimum->sum_of_squares)) <=
                                1e-9 * std::sqrt(*cost) + residual_rounding(problem);
  return same ? minimum : descend_with_ceres(problem, start, options);
}

}  // namespace mixity
