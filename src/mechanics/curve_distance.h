// Signed distances of measured points from the equilibrium curves F(A, T) = 0 (sensitivity.h) of their own loads, in
// the plane of T and A, each in units of its standard error. Regular at a fold, where A at given T is not.
#pragma once

#include "mechanics/registry.h"
#include "mechanics/states.h"

namespace mixity {

/// Implements ContactModel::curve_distances.
template <class Law>
bool curve_distances(const Law& law, const Parameters<Law>& p, const PlanePoints& points, Search search,
                     bool derivatives, CurveDistances& out);

}  // namespace mixity
