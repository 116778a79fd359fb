// A fit: finds minima by a search of the whole range and from guesses, and judges the lowest.
#pragma once

#include <vector>

#include "solver/options.h"
#include "solver/problem.h"
#include "solver/results.h"

namespace mixity {

/// Start values, in addition to a search of the whole range or in place of it.
struct StartingPoints {
  std::vector<double> near{};                  // if not empty, replaces the search, for refits of almost the same data
  std::vector<std::vector<double>> guesses{};  // additional starts
};

/// Judges the lowest minimum found (verdict.h).
Verdict solve(const Problem& problem, const StartingPoints& starting = {}, const SolverOptions& options = {});

/// The minimum of ProblemWithPriors(data, unit); unit is 1 without priors.
struct SolvedWithPriors {
  Verdict verdict;
  double unit;
};

/// Residuals of unknown size are divided by their scatter about the fit, which depends on the result: iterates until it
/// no longer changes.
SolvedWithPriors solve_with_priors(const Problem& data, const StartingPoints& starting = {},
                                   const SolverOptions& options = {});

}  // namespace mixity
