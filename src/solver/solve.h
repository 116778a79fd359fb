// A fit: finds minima, from a search of the whole range and from guesses, and judges the lowest.
#pragma once

#include <vector>

#include "solver/options.h"
#include "solver/problem.h"
#include "solver/results.h"

namespace mixity {

/// Where to start, in addition to a search of the whole range or instead of it.
struct StartingPoints {
  std::vector<double> near{};                  // not empty: instead of the search, for refits of almost the same data
  std::vector<std::vector<double>> guesses{};  // in addition
};

/// Judges the lowest minimum found (verdict.h).
Verdict solve(const Problem& problem, const StartingPoints& starting = {}, const SolverOptions& options = {});

/// The minimum of ProblemWithPriors(data, unit); unit is 1 without priors.
struct SolvedWithPriors {
  Verdict verdict;
  double unit;
};

/// Residuals of unknown size are divided by their own scatter about the fit, which depends on it: iterated until that
/// no longer changes.
SolvedWithPriors solve_with_priors(const Problem& data, const StartingPoints& starting = {},
                                   const SolverOptions& options = {});

}  // namespace mixity
