#include "solver/descent.h"

#include <Eigen/Core>
#include <cmath>

#include "solver/kernel.h"
#include "solver/polish.h"

namespace mixity {
namespace {

using Vector = Eigen::VectorXd;

/// Gauss-Newton's last steps gain little where the residuals are large; Newton's do.
std::optional<Minimum> descend_with_kernel(const Problem& problem, const std::vector<double>& start,
                                           const SolverOptions& options) {
  SolverOptions patient = options;
  patient.most_iterations = options.most_iterations_shown;
  const auto minimum = Kernel(problem, patient).descend(start);
  if (!minimum || start.size() == 1 || (minimum->stationary && !options.last_digits)) return minimum;
  const Remembering near(problem);
  const Vector x = Eigen::Map<const Vector>(minimum->x.data(), static_cast<Eigen::Index>(start.size()));
  Linearised at;
  if (!linearise(near, x, options, at)) return std::nullopt;
  return polished(near, x, at, options);
}

}  // namespace

std::optional<Minimum> descend(const Problem& problem, const std::vector<double>& start, const SolverOptions& options) {
  if (options.engine == Engine::kernel) return descend_with_kernel(problem, start, options);
  auto minimum = descend_with_ceres(Remembering(problem), start, options);
  if (!minimum) return std::nullopt;
  // What is shown must not depend on the way to it: where memory led astray, without.
  std::vector<double> residuals(problem.residual_count());
  const auto cost = sum_of_squares(problem, minimum->x, residuals);
  const bool same = cost && std::abs(std::sqrt(*cost) - std::sqrt(minimum->sum_of_squares)) <=
                                1e-9 * std::sqrt(*cost) + residual_rounding(problem);
  return same ? minimum : descend_with_ceres(problem, start, options);
}

}  // namespace mixity
