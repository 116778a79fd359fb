// Where to descend from: the local minima of the cost over the whole range of the parameters without a start.
#pragma once

#include <vector>

#include "solver/kernel.h"
#include "solver/options.h"
#include "solver/problem.h"

namespace mixity {

struct Starts {
  std::vector<Start> list;  // best first
  /// What the search looked at that costs most, dearest first; empty if every parameter has a start. The cost there may
  /// be less than the search took it for.
  std::vector<std::vector<double>> dearest{};
};

/// Grids over the parameters without a start (one or two), the others at theirs. A single one whose curvature is exact
/// (problem.h) is divided where value, slope and curvature disagree on what lies between. Empty where the cost is
/// nowhere finite.
Starts find_starts(const Problem& problem, const SolverOptions& options = {});

/// False if the cost is lower just inside this bound of the only parameter. A slope of zero does not show it where the
/// cost is stationary by symmetry, as model b's is at lambda = 2.
bool lowest_at_bound(const Problem& problem, double bound);

}  // namespace mixity
