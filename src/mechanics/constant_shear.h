// Contact radius against normal load at a constant tangential load (the paper's Fig. 4).
#pragma once

#include "mechanics/curve.h"

namespace mixity {

/// The state with edge load y > 0 at tangential load T >= 0: equilibrium y^2 g = 6 pi (y + P) is explicit in P, and
/// y^2 g = y^2 + tau^2(y, T). y runs from the unstable end (y -> 0, where P -> tau^2/(6 pi)) to infinity.
template <class Law>
ConstantShearPoint constant_shear_point(const Law& law, const Parameters<Law>& p, double T, double y) {
  const ShearTerm<double> tau2 = law.shear_term(p, y, T);
  const double six_pi = 6 * pi<double>();
  const double sum = (y * y + tau2.value) / six_pi;  // y + P = 4/3 a^3
  return {y, sum - y, std::cbrt(0.75 * sum), (2 * y + tau2.d1) / six_pi - 1};
}

}  // namespace mixity
