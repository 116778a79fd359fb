// Where to descend from: the local minima of the cost over the whole range of the parameters without a start.
#pragma once

#include <vector>

#include "solver/kernel.h"
#include "solver/options.h"
#include "solver/problem.h"

namespace mixity {

struct Starts {
  std::vector<Start> list;  // best first
  /// The points of the search, highest cost first, as the search took it; empty if every parameter has a start.
  std::vector<std::vector<double>> dearest{};
};

/// Grids over the parameters without a start (one or two), with the others at theirs; for one parameter with an exact
/// curvature (problem.h) an adaptive search (basins.h). Empty where the cost is nowhere finite.
Starts find_starts(const Problem& problem, const SolverOptions& options = {});

/// False if the cost is lower just inside this bound of the only parameter. The slope may be zero there by symmetry, as
/// for model b at lambda = 2.
bool lowest_at_bound(const Problem& problem, double bound);

}  // namespace mixity
