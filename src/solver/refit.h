// A minimum near a known one, for its values alone: refits of almost the same data.
#pragma once

#include <optional>
#include <vector>

#include "solver/options.h"
#include "solver/problem.h"
#include "solver/results.h"

namespace mixity {

/// The minimum of the data's residuals and the priors (prior.h) near `x`, to SolverOptions::kernel_stationary.
/// Residuals of unknown size are divided by their scatter, as in solve_with_priors; `sum_of_squares` is that of all
/// residuals. Null where this is no short way: at a bound, where the cost rises, or where it is not finite.
struct NearMinimum {
  Minimum minimum;
  double unit;
};
std::optional<NearMinimum> refit_near(const Problem& data, std::vector<double> x, const SolverOptions& options);

}  // namespace mixity
