// Whether a place is a minimum, free of scale, and Newton's steps to the last digits of one.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "solver/linear_algebra.h"
#include "solver/options.h"
#include "solver/problem.h"
#include "solver/results.h"

namespace mixity {

/// Residuals, Jacobian and what the first-order condition makes of them.
struct Linearised {
  Eigen::VectorXd r;
  RowMajorMatrix J;
  Eigen::VectorXd gradient;  // J'r, zero where a bound holds the parameter
  std::vector<bool> held;    // by a bound
  Eigen::VectorXd step;      // Gauss-Newton's
  bool finite = false;
  double stationarity = 0;  // see Minimum
  bool settled = true;      // a step to a zero of the gradient would be lost in the rounding of x
};

/// Into `at`, whose memory is used again. False if a value is not finite.
bool linearise(const Problem& problem, const Eigen::VectorXd& x, const SolverOptions& options, Linearised& at);

/// The first-order condition, or as close to it as rounding lets: `rounding` is that of |r|.
bool is_stationary(const Linearised& at, double rounding, const SolverOptions& options);

/// Newton steps on the gradient from x, linearised there, to the last digits of a minimum close by.
Minimum polished(const Problem& problem, Eigen::VectorXd x, Linearised& at, const SolverOptions& options);

}  // namespace mixity
