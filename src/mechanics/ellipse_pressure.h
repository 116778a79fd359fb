// The pressure under a sphere whose contact is an ellipse with semi-axes a and b.
//
// p = [p0 - alpha (x/a)^2 - beta (y/b)^2]/sqrt(1 - (x/a)^2 - (y/b)^2) deforms a half-space into a paraboloid
// (potentials of an ellipsoid: Kellogg 1929, Foundations of Potential Theory, chapter VII). With c = sqrt(a b), q =
// ln(a/b), w = 4/3 c^3 and the normal load P, the stress intensities K_I at the ends of the two axes follow from one
// function:
//
//     at (a, 0): K_I = Y/(2 b sqrt(pi a)) with Y = w g(q) - P       at (0, b): K_I = Y/(2 a sqrt(pi b)) with Y = w
//     g(-q) - P
//
// g(0) = 1 is Hertz's load of a circle, and g(q) = 1 + 3/2 q + ... All dimensionless (contact.h).
#pragma once

namespace mixity {

/// g at the end of each axis, and its derivatives in q = ln(a/b).
struct EllipsePressure {
  double along, across;              // g(q) at (a, 0), g(-q) at (0, b)
  double along_slope, across_slope;  // d g(q)/dq, d g(-q)/dq
};

/// Relative error below 1e-14 for |q| <= 5. Carlson's elliptic integrals, or where their differences cancel a series.
EllipsePressure ellipse_pressure(double q);

/// u sqrt(a b)/T and its derivative in q, for the traction of a uniform tangential displacement u along a: 3/4 for a
/// circle at nu = 1/2. From Cerruti's solution at the centre, the integral of the traction times ((1 - nu)/r + nu
/// x^2/r^3)/(2 pi G) with G = (1 - nu)/2 in units of E*. `poisson_ratio`: nu.
struct EllipseCompliance {
  double value, slope;
};
EllipseCompliance ellipse_compliance(double q, double poisson_ratio);

}  // namespace mixity
