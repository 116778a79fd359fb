// Signed distances of measured points from the equilibrium curves F(A, T) = 0 (sensitivity.h) of their own loads, in
// the plane of T and A, each in units of its standard error. Regular at a fold, where A at given T is not.
#pragma once

#include <span>

#include "mechanics/registry.h"

namespace mixity {

/// Measured points, dimensionless: A > 0, both standard errors > 0, T of either sign (equilibrium depends on T^2).
/// Spans of one size.
struct PlanePoints {
  std::span<const double> P, T, A, sigma_T, sigma_A;
};

/// local: the place of the curve that Newton's method reaches from the point, which is the nearest where the point lies
/// within some standard errors of the curve, and never nearer than the nearest. global: the nearest of the whole curve
/// that starts from JKR.
/// rough: to first order, from a place of the curve beside the point, whatever Newton's method would make of it.
enum class Search { rough, local, global };

/// r is positive where the area of the model is the larger. The nearest place is found anew for each value, so that by
/// the envelope theorem the derivatives are those of -F/|grad F| there; where the place is an end or a corner of the
/// curve, those of the distance from it. `parameters` holds those in the model's parameters, point after point.
/// d r/d ln sigma_T is -r (dT sigma_T)^2, and so for A.
///
/// `place_T` and `place_A`, unless empty, hold places to start from, as near a point's own as those of parameters
/// nearby are (A = 0: none), and the nearest places afterwards.
struct CurveDistances {
  std::span<double> r, dP, dT, dA, parameters, place_T{}, place_A{};
};

/// Fills out.r, and if `derivatives` the rest (otherwise those may be empty), each result a function of its own point
/// alone. False if a point has no curve (its load lies below pull-off, the law is undefined for these parameters), a
/// point is invalid, its nearest place is the contact that vanishes at P = 0, or a result is not finite; `out` then
/// holds nothing of use. r to some roundings of T/sigma_T and A/sigma_A, derivatives to 1e-10 or so.
template <class Model>
bool curve_distances(const Parameters<Model>& p, const PlanePoints& points, Search search, bool derivatives,
                     CurveDistances& out);

}  // namespace mixity
