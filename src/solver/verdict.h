// Finding the minimum of a problem, and judging it: two passes.
#pragma once

#include <string>
#include <vector>

#include "solver/options.h"
#include "solver/problem.h"
#include "solver/results.h"

namespace mixity {

/// Why a fit of more parameters than different points, less one, has no result.
std::string too_few_points(std::size_t distinct, std::size_t points, std::size_t parameters);

/// How far above the least sum of squares a fit counts as no worse: chi^2 of one parameter at 95 %, in units of the
/// known errors or of the scatter. Needs more residuals than parameters.
double fit_tolerance(const Problem& problem, double least);

/// Where to start beside, or instead of, a search of the whole range.
struct StartingPoints {
  std::vector<double> near{};                  // not empty: no search, for refits of almost the same data
  std::vector<std::vector<double>> guesses{};  // beside it
};

/// Descends from every local minimum of the search, and judges the best.
Verdict solve(const Problem& problem, const StartingPoints& starting = {}, const SolverOptions& options = {});

}  // namespace mixity
