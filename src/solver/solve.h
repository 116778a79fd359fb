// A fit: finding minima, from wherever a search of the whole range or somebody's guess says to begin, and judging them.
#pragma once

#include <vector>

#include "solver/options.h"
#include "solver/problem.h"
#include "solver/results.h"

namespace mixity {

/// Where to start beside, or instead of, a search of the whole range.
struct StartingPoints {
  std::vector<double> near{};                  // not empty: no search, for refits of almost the same data
  std::vector<std::vector<double>> guesses{};  // beside it
};

/// The lowest of the minima that are found, judged (verdict.h).
Verdict solve(const Problem& problem, const StartingPoints& starting = {}, const SolverOptions& options = {});

/// The minimum of ProblemWithPriors(data, unit).
struct SolvedWithPriors {
  Verdict verdict;
  double unit;
};

/// Residuals whose size is not known are measured by their own scatter about the fit, on which that depends: until it
/// no longer changes.
SolvedWithPriors solve_with_priors(const Problem& data, const StartingPoints& starting = {},
                                   const SolverOptions& options = {});

}  // namespace mixity
