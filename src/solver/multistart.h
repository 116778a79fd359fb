// Start points of descents: local minima of the cost over the whole range of the parameters that have no start.
#pragma once

#include <vector>

#include "solver/kernel.h"
#include "solver/options.h"
#include "solver/problem.h"

namespace mixity {

struct Starts {
  std::vector<Start> list;  // best first
  /// The points tried by the search, highest cost first; empty if every parameter has a start.
  std::vector<std::vector<double>> dearest{};
};

/// Searches on grids over the parameters without a start (one or two), with the others at theirs; for one parameter
/// with exact curvature (problem.h), adaptively (basins.h). Empty if the cost is finite nowhere.
Starts find_starts(const Problem& problem, const SolverOptions& options = {});

/// False if the cost is lower just inside this bound of the only parameter. The slope there may be zero by symmetry, as
/// for model b at lambda = 2.
bool lowest_at_bound(const Problem& problem, double bound);

}  // namespace mixity
