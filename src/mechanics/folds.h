// Folds of the equilibrium curve: where a contact that is driven by a load, a displacement or a spring loses stability,
// and what it jumps to.
#pragma once

#include <vector>

#include "mechanics/curve.h"

namespace mixity {

/// The positions of the first folds alone, in order along the curve from T = 0; see find_folds.
template <class Law>
std::vector<FoldPlace> locate_folds(const EquilibriumCurve<Law>& curve, Control control,
                                    std::size_t at_most = std::numeric_limits<std::size_t>::max());

/// All folds in order along the curve from T = 0. With R(y; T) = (y - 3 pi)^2 + tau^2 - S0^2 the driving quantity has
/// an extremum where
///
///     R_y (3 + 4 a/k) (y + P) + 2 tau^2 - y tau^2_y = 0      (displacement: k -> infinity; load: R_y = 0)
///
/// Sign changes over the whole curve, down to 1e-18 of its ends, are refined to the last digits; a dip between two
/// samples is followed to its bottom, so that close pairs are found. Under load control the samples are values of psi,
/// from which y and T follow in closed form. Law c has closed forms under load and displacement, and a law with at most
/// one fold is not sampled. Relative errors: T below 1e-13, A and u below 1e-12.
template <class Law>
std::vector<Fold> find_folds(const EquilibriumCurve<Law>& curve, Control control);

}  // namespace mixity
