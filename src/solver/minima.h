// Finding the minima of a problem: from wherever a search of the whole range, or somebody's guess, says to begin.
#pragma once

#include <limits>
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

struct FoundMinima {
  std::vector<Minimum> list;  // each once, lowest first; the first by the engine of the options
  double least = std::numeric_limits<double>::infinity();  // the lowest cost met, at starts, too
  std::vector<std::vector<double>> dearest{};              // of the search, see Starts
  bool started = false;                                    // false: the cost is nowhere finite
};

FoundMinima find_minima(const Problem& problem, const StartingPoints& starting, const SolverOptions& options);

}  // namespace mixity
