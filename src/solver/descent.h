// One descent to a minimum: Ceres, then Newton steps on the gradient to the last digits. Includes a scale-free test for
// a minimum.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>
#include <vector>

#include "solver/linear_algebra.h"
#include "solver/options.h"
#include "solver/problem.h"
#include "solver/results.h"

namespace mixity {

/// Descends from one start by the engine of the options. Null if no finite cost was found from there.
std::optional<Minimum> descend(const Problem& problem, const std::vector<double>& start,
                               const SolverOptions& options = {});

/// The same by Ceres, in its own source file, which the explorer replaces because it has no Ceres.
std::optional<Minimum> descend_with_ceres(const Problem& problem, const std::vector<double>& start,
                                          const SolverOptions& options);

/// The version of Ceres.
std::string_view solver_version();

/// Residuals, Jacobian and first-order condition at one point.
struct Linearised {
  Eigen::VectorXd r;
  RowMajorMatrix J;
  Eigen::VectorXd gradient;  // J'r; 0 for parameters held by a bound
  std::vector<bool> held;    // parameters held by a bound
  Eigen::VectorXd step;      // the Gauss-Newton step
  bool finite = false;
  double stationarity = 0;  // see Minimum
  bool settled = true;      // the Newton step is below the rounding of x
};

/// Fills `at`, reusing its memory. False if a value is not finite.
bool linearise(const Problem& problem, const Eigen::VectorXd& x, const SolverOptions& options, Linearised& at);

/// True if the first-order optimality condition holds to rounding error; `rounding` is the rounding error of |r|.
bool is_stationary(const Linearised& at, double rounding, const SolverOptions& options);

/// Newton steps on the gradient from x, where `at` is linearised, to the last digits of a nearby minimum.
Minimum polished(const Problem& problem, Eigen::VectorXd x, Linearised& at, const SolverOptions& options);

}  // namespace mixity
