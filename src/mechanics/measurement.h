// What a measured point (P, T, A) says about the toughness: f = (y^2 + T^2)/(8 pi a^3) at tan psi = T/y.
#pragma once

#include <cmath>
#include <optional>

#include "mechanics/contact.h"
#include "mechanics/model.h"

namespace mixity {

template <class S>
struct MeasuredToughness {
  Mixity<S> mixity;
  S ratio;  // G_c/G_Ic

  S psi() const { return phase_angle(mixity); }  // rad; figures and tables ask for it, fits do not
};
using ToughnessPoint = MeasuredToughness<double>;

/// f of the edge load y = edge_load(a, P).
template <class S>
S toughness_ratio(const S& y, const S& T, const S& a) {
  return (y * y + T * T) / (S(8) * pi<S>() * a * a * a);
}

/// Dimensionless load P, shear T of either sign, as equilibrium depends on T^2, and contact radius a > 0. The caller
/// has checked edge_load(a, P) > 0: at y <= 0 the contact carries no adhesive edge load and the point has no phase
/// angle.
template <class S>
MeasuredToughness<S> measured_toughness(const S& P, const S& T, const S& a) {
  const S y = edge_load(a, P);
  return {mixity_from_loads(y, T < S(0) ? S(-T) : T), toughness_ratio(y, T, a)};
}

/// The same from the area A > 0; null at y <= 0.
inline std::optional<ToughnessPoint> toughness_of_area(double P, double T, double A) {
  const double a = radius_from_area(A);
  if (!(edge_load(a, P) > 0)) return std::nullopt;
  return measured_toughness(P, T, a);
}

}  // namespace mixity
