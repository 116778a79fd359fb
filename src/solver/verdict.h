// Judges a minimum: each test contributes one sentence.
#pragma once

#include <string>

#include "solver/options.h"
#include "solver/problem.h"
#include "solver/results.h"

namespace mixity {

/// The message for a fit that needs more distinct points than it has.
std::string too_few_points(std::size_t distinct, std::size_t points, std::size_t parameters);

/// A fit is as good as the best if its sum of squares is higher by at most this: chi^2 of one parameter at 95 %, in
/// units of residual_variance.
double fit_tolerance(const Problem& problem, double least);

/// Judges the lowest of the minima. Needs more residuals than parameters.
Verdict judge(const Problem& problem, const FoundMinima& found, const SolverOptions& options = {});

}  // namespace mixity
