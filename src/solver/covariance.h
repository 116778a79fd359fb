// Standard errors of the fitted parameters from the curvature of the cost at its minimum.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "solver/options.h"
#include "solver/problem.h"
#include "solver/results.h"

namespace mixity {

struct Covariance {
  std::vector<std::optional<double>> standard_errors;  // null at a bound, or where the curvature gives none
  std::vector<double> correlations;                    // [p x p]; empty unless several parameters all have errors
  std::string unconstrained;                           // names of parameters that the data do not constrain; else empty
};

/// Covers the parameters that are not `at_bound`: (J'J)^-1 times residual_variance; a robust loss enters by its
/// curvature.
Covariance covariance(const Problem& problem, const Minimum& best, const std::vector<bool>& at_bound,
                      const SolverOptions& options = {});

}  // namespace mixity
