// Judging what was found: tests of a sentence each.
#pragma once

#include <string>

#include "solver/options.h"
#include "solver/problem.h"
#include "solver/results.h"

namespace mixity {

/// Why a fit of more parameters than different points, less one, has no result.
std::string too_few_points(std::size_t distinct, std::size_t points, std::size_t parameters);

/// `not_converged`, without a word.
Verdict no_verdict(std::size_t parameters);

/// How far above the least sum of squares a fit counts as no worse: chi^2 of one parameter at 95 %, in units of the
/// known errors or of the scatter. Needs more residuals than parameters.
double fit_tolerance(const Problem& problem, double least);

/// The lowest of the minima, judged. More residuals than parameters.
Verdict judge(const Problem& problem, const FoundMinima& found, const SolverOptions& options = {});

}  // namespace mixity
