// What a measured point (P, T, A) says about the toughness: f = (y^2 + T^2)/(8 pi a^3) at tan psi = T/y.
#pragma once

#include "mechanics/contact.h"
#include "mechanics/model.h"

namespace mixity {

template <class S>
struct MeasuredToughness {
  Mixity<S> mixity;
  S ratio;  // G_c/G_Ic
};

/// Dimensionless load P, shear T >= 0 and contact radius a > 0. The caller has checked edge_load(a, P) > 0:
/// at y <= 0 the contact carries no adhesive edge load and the point has no phase angle.
template <class S>
MeasuredToughness<S> measured_toughness(const S& P, const S& T, const S& a) {
  const S y = edge_load(a, P);
  return {mixity_from_loads(y, T), (y * y + T * T) / (S(8) * pi<S>() * a * a * a)};
}

}  // namespace mixity
