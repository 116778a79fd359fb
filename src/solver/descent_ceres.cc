#include <ceres/ceres.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>

#include "solver/descent.h"

namespace mixity {
namespace {

/// Multiplies the residuals by `scale`: Ceres damps its steps as if J'J were at least 1e-6, which would dominate where
/// psi is small.
class CeresAdapter final : public ceres::CostFunction {
 public:
  CeresAdapter(const Problem& problem, double scale) : problem_(problem), scale_(scale) {
    set_num_residuals(static_cast<int>(problem.residual_count()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(problem.parameters().size()));
  }
  bool Evaluate(const double* const* x, double* residuals, double** jacobians) const override {
    const std::size_t n = problem_.residual_count(), p = problem_.parameters().size();
    const bool wanted = jacobians && jacobians[0];
    try {
      if (!problem_.evaluate({x[0], p}, {residuals, n}, {wanted ? jacobians[0] : nullptr, wanted ? n * p : 0}))
        return false;
    } catch (...) {  // not through Ceres
      thrown_ = std::current_exception();
      return false;
    }
    for (std::size_t i = 0; i < n; ++i) residuals[i] *= scale_;
    for (std::size_t i = 0; wanted && i < n * p; ++i) jacobians[0][i] *= scale_;
    return true;
  }
  void rethrow() const {
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  const Problem& problem_;
  double scale_;
  mutable std::exception_ptr thrown_;
};

}  // namespace

std::optional<Minimum> descend_with_ceres(const Problem& problem, const std::vector<double>& start,
                                          const SolverOptions& options) {
  Eigen::VectorXd x = as_vector(start);
  Linearised at;
  if (!linearise(problem, x, options, at)) return std::nullopt;

  // A slope below 1e-17 changes no residual by more than rounding.
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
  // An absolute gradient tolerance would accept small residuals at once; a scale-free test decides afterwards whether
  // the end is a minimum.
  settings.gradient_tolerance = 0;
  settings.parameter_tolerance = options.ceres_step;
  settings.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  const double rounding = residual_rounding(problem);
  for (const double change : {options.ceres_cost_change, std::numeric_limits<double>::epsilon()}) {
    // If the gradient is only rounding, no step lowers the cost, and Ceres would report an error.
    if (!(at.stationarity > (at.J.cols() == 1 ? options.kernel_stationary : options.newton_stationary))) break;
    settings.function_tolerance = change;
    std::copy(start.begin(), start.end(), x.begin());
    ceres::Solve(settings, &ceres_problem, &summary);
    cost.rethrow();
    if (!linearise(problem, x, options, at)) return std::nullopt;
    // The undamped step would lower the cost by the square of this. If that is far more than `change`, Ceres stopped
    // early.
    if (at.stationarity <= 100 * std::sqrt(change) || is_stationary(at, rounding, options)) break;
  }
  return polished(problem, x, at, options);
}

std::string_view solver_version() { return CERES_VERSION_STRING; }

}  // namespace mixity
