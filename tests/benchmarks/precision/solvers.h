// Solvers of other libraries on a problem of one parameter, each called as its documentation shows.
//
// A problem has size(), lower, upper, a count of `sweeps` over its points, and two functions that return false where
// the model is not finite:
//   problem(&x, residuals)              for any scalar, so that derivatives can be automatic
//   problem.evaluate(x, residuals, J)   J may be null
#pragma once

#include <ceres/ceres.h>
#include <ceres/tiny_solver.h>
#include <ceres/tiny_solver_autodiff_function.h>

#include <limits>
#include <string>
#include <vector>

namespace mixity::precision {

struct Answer {
  double x = 0;
  bool converged = false;
  std::string claim{};
  double sweeps = 0;
};

/// `cost`: TinySolver's alone, absolute.
struct Tolerances {
  double function, gradient, parameter, cost;

  static Tolerances all(double tolerance) { return {tolerance, tolerance, tolerance, tolerance * tolerance}; }
};

/// Enough for every case here that converges at all.
inline constexpr int kIterations = 200;

enum class Derivatives { analytic, automatic, numeric };

/// What stands for residuals where the model is not finite: no solver accepts a step there. (GSL accepts one to NaN,
/// and ends the fit if the function fails; TinySolver does not look at failures.)
inline constexpr double kOutOfReach = 1e100;

/// As a functor that a cost function may own.
template <class Problem>
struct Reference {
  const Problem* problem;
  int NumResiduals() const { return static_cast<int>(problem->size()); }
  template <class S>
  bool operator()(const S* x, S* residuals) const {
    if ((*problem)(x, residuals)) return true;
    for (std::size_t i = 0; i < problem->size(); ++i) residuals[i] = S(kOutOfReach);
    return false;
  }
};

template <class Problem>
class AnalyticCost final : public ceres::CostFunction {
 public:
  explicit AnalyticCost(const Problem& problem) : problem_(problem) {
    set_num_residuals(static_cast<int>(problem.size()));
    mutable_parameter_block_sizes()->push_back(1);
  }
  bool Evaluate(const double* const* x, double* residuals, double** jacobians) const override {
    return problem_.evaluate(x[0][0], residuals, jacobians ? jacobians[0] : nullptr);
  }

 private:
  const Problem& problem_;
};

inline ceres::Solver::Options ceres_options(const Tolerances& tolerances, int most_iterations) {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = most_iterations;
  options.function_tolerance = tolerances.function;
  options.gradient_tolerance = tolerances.gradient;
  options.parameter_tolerance = tolerances.parameter;
  options.logging_type = ceres::SILENT;
  return options;
}

/// What Ceres says of its answer.
inline const char* claim_of(const ceres::Solver::Summary& summary) {
  return summary.termination_type == ceres::CONVERGENCE ? "converged"
         : summary.termination_type == ceres::FAILURE   ? "failed"
                                                        : "no convergence";
}

/// All residuals in one block: what a careful user of Ceres writes, and several times faster than a block for each.
template <class Problem>
Answer with_ceres(const Problem& problem, Derivatives derivatives, double start, const Tolerances& tolerances) {
  using Functor = Reference<Problem>;
  const auto n = static_cast<int>(problem.size());
  ceres::CostFunction* cost = nullptr;
  if (derivatives == Derivatives::analytic)
    cost = new AnalyticCost<Problem>(problem);
  else if (derivatives == Derivatives::automatic)
    cost = new ceres::AutoDiffCostFunction<Functor, ceres::DYNAMIC, 1>(new Functor{&problem}, n);
  else
    cost = new ceres::NumericDiffCostFunction<Functor, ceres::CENTRAL, ceres::DYNAMIC, 1>(new Functor{&problem},
                                                                                          ceres::TAKE_OWNERSHIP, n);
  const auto before = problem.sweeps;
  double x = start;
  ceres::Problem fit;
  fit.AddResidualBlock(cost, nullptr, &x);
  fit.SetParameterLowerBound(&x, 0, problem.lower);
  fit.SetParameterUpperBound(&x, 0, problem.upper);
  ceres::Solver::Summary summary;
  ceres::Solve(ceres_options(tolerances, kIterations), &fit, &summary);
  return {x, summary.termination_type == ceres::CONVERGENCE, claim_of(summary),
          static_cast<double>(problem.sweeps - before)};
}

/// Ceres' small solver, with automatic derivatives. It knows no bounds, and no failure but too many iterations.
template <class Problem>
Answer with_tiny_solver(const Problem& problem, double start, const Tolerances& tolerances) {
  using Function = ceres::TinySolverAutoDiffFunction<Reference<Problem>, Eigen::Dynamic, 1>;
  const auto before = problem.sweeps;
  const Reference<Problem> functor{&problem};
  const Function function(functor);
  ceres::TinySolver<Function> solver;
  solver.options.max_num_iterations = kIterations;
  solver.options.gradient_tolerance = tolerances.gradient;
  solver.options.parameter_tolerance = tolerances.parameter;
  solver.options.function_tolerance = tolerances.function;
  solver.options.cost_threshold = tolerances.cost;
  typename ceres::TinySolver<Function>::Parameters x;
  x[0] = start;
  solver.Solve(function, &x);
  const bool converged = solver.summary.status != ceres::TinySolver<Function>::HIT_MAX_ITERATIONS;
  return {x[0], converged, converged ? "converged" : "no convergence", static_cast<double>(problem.sweeps - before)};
}

template <class Problem>
void fill(const Problem& problem, double x, double* residuals) {
  Reference<Problem>{&problem}(&x, residuals);
}

template <class Problem>
void fill_slopes(const Problem& problem, double x, double* slopes) {
  std::vector<double> residuals(problem.size());
  if (problem.evaluate(x, residuals.data(), slopes)) return;
  for (std::size_t i = 0; i < problem.size(); ++i) slopes[i] = std::numeric_limits<double>::quiet_NaN();
}

}  // namespace mixity::precision
