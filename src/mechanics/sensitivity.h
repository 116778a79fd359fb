// The derivatives of equilibrium in all its variables. With y = 4/3 a^3 - P and A = pi a^2, equilibrium is
//
//     F(A, T, P, parameters) = y^2 + tau^2(y, T) - 6 pi (y + P) = 0,
//
// the circle. The gradient of F gives them all: dA/dT = -F_T/F_A, dA/dlambda = -F_lambda/F_A, and to first order
// F/|grad F| is the distance of a point from the curve. Since y^2 + tau^2 = (y^2 + T^2)/f, the derivative in a
// parameter needs only d(ln f).
#pragma once

#include "mechanics/base/law.h"
#include "mechanics/contact.h"
#include "mechanics/registry.h"

namespace mixity {

template <class Law>
struct EquilibriumGradient {
  double held;     // y^2 + tau^2 = (y^2 + T^2)/f, which equals 6 pi (y + P) in equilibrium
  double A, T, P;  // dF/dA at fixed T and P, and so on
  Parameters<Law> parameters;
};

/// The gradient at any state y >= 0, T >= 0 (not both 0), y + P > 0, in equilibrium or not. Infinite where ln f is
/// (model a at y = 0).
template <class Law>
EquilibriumGradient<Law> equilibrium_gradient(const Law& law, const Parameters<Law>& p, double P, double T, double y) {
  const ShearTerm<double> tau2 = law.shear_term(p, y, T);
  const double a = radius_from_edge_load(y, P), held = y * y + tau2.value;
  EquilibriumGradient<Law> gradient{};
  gradient.held = held;
  gradient.A = (2 * (y - 3 * pi<double>()) + tau2.d1) * 2 * a / pi<double>();  // dy/dA = 2 a/pi
  gradient.T = T > 0 ? (2 * tau2.value - y * tau2.d1) / T : 0.0;               // tau^2 is homogeneous of degree 2
  gradient.P = -(2 * y + tau2.d1);                                             // at fixed y + P: dy/dP = -1
  const auto log_f = law.log_toughness(p, mixity_from_loads(y, T));
  gradient.parameters = log_f.gradient;
  for (double& slope : gradient.parameters) slope *= -held;
  return gradient;
}

}  // namespace mixity
