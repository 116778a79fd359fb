// Minima of a cost that has edges, found and proven by its values alone.
#pragma once

#include <optional>

#include "fitting/minimise.h"

namespace mixity {

/// Where no gradient vanishes and the cost is still the lowest around: on the bend where a measured load is that of the
/// fold, or at the end of what the law can describe.
struct EdgeMinimum {
  Minimum minimum;
  bool at_end;  // the cost is not finite beyond it
};

/// The edge minimum near the place where a solver stopped; null if there is none, and for more than two parameters.
/// Right to some 1e-10 of the parameters.
std::optional<EdgeMinimum> edge_minimum(const LeastSquares& problem, const Minimum& stopped);

}  // namespace mixity
