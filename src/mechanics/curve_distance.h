// Signed distances of measured points from the equilibrium curves F(A, T) = 0 (sensitivity.h) of their own loads, in
// the plane of T and A, each in units of its standard error. Regular at a fold, where A at given T is not.
#pragma once

#include "mechanics/registry.h"
#include "mechanics/states.h"

namespace mixity {

/// Fills out.r, and if `derivatives` the rest (otherwise those may be empty), each result a function of its own point
/// alone. False if a point has no curve (its load lies below pull-off, the law is undefined for these parameters), a
/// point is invalid, its nearest place is the contact that vanishes at P = 0, or a result is not finite; `out` then
/// holds nothing of use. r to some roundings of T/sigma_T and A/sigma_A, derivatives to 1e-10 or so.
template <class Law>
bool curve_distances(const Law& law, const Parameters<Law>& p, const PlanePoints& points, Search search,
                     bool derivatives, CurveDistances& out);

}  // namespace mixity
