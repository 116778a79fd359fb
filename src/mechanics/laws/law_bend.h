// How strongly tau^2 bends under a law that was defined at run time: bounds for the proof of nearest points.
#pragma once

#include <span>

#include "mechanics/laws/taylor.h"
#include "mechanics/model.h"

namespace mixity {

/// Logarithms of the sums of moduli of tau^2's second derivatives that nearest_proof.h takes, on the unit circle in y
/// and T.
struct LawBend {
  double psi = 0, TT = 0, yT = 0, yy = 0;
};

/// At psi with sine s and cosine c. `f` has its derivatives in psi.
LawBend bend_of(const Taylor& f, double psi, double s, double c);

/// Twice the largest of each sum; infinite where it rises towards an end.
ShearBend bend_everywhere(std::span<const LawBend> bends);

/// As the sums change from one angle to the next, with a margin of two.
ShearReach reach_of(std::span<const LawBend> bends);

}  // namespace mixity
