// Folds of the equilibrium curve: where a contact loses stability that is driven by a load, by a displacement or
// through a spring, and what it jumps to.
#pragma once

#include <vector>

#include "mechanics/curve.h"

namespace mixity {

/// Only the positions of the first folds, in the order along the curve from T = 0; see find_folds.
template <class Law>
std::vector<FoldPlace> locate_folds(const EquilibriumCurve<Law>& curve, Control control,
                                    std::size_t at_most = std::numeric_limits<std::size_t>::max());

/// All folds in the order along the curve from T = 0, as zeros of a derivative: with R(y; T) = (y - 3 pi)^2 + tau^2 -
/// S0^2 the driving quantity has an extremum where
///
///     R_y (3 + 4 a/k) (y + P) + 2 tau^2 - y tau^2_y = 0      (displacement: k -> infinity; load: R_y = 0)
///
/// Sign changes over the whole curve, down to 1e-18 of its ends, are refined to the last digits; a dip between two
/// samples is followed to its bottom, so that close pairs are found. Under load control psi is sampled, from which y
/// and T follow in closed form. Law c has closed forms under load and displacement, and a law with at most one fold is
/// not sampled. Relative errors: T below 1e-13, A and u below 1e-12.
template <class Law>
std::vector<Fold> find_folds(const EquilibriumCurve<Law>& curve, Control control);

}  // namespace mixity
