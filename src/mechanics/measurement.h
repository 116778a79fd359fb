// The toughness at a measured point (P, T, A): f = (y^2 + T^2)/(8 pi a^3) at tan psi = T/y.
#pragma once

#include <cmath>
#include <optional>

#include "mechanics/base/law.h"
#include "mechanics/contact.h"

namespace mixity {

struct ToughnessPoint {
  Mixity<double> mixity;
  double ratio;  // G_c/G_Ic

  double psi() const { return phase_angle(mixity); }  // rad
};

/// f at radius a and edge load y = edge_load(a, P).
inline double toughness_ratio(double y, double T, double a) { return (y * y + T * T) / (8 * pi<double>() * a * a * a); }

/// The toughness at a load P, a shear T of either sign (equilibrium depends on T^2) and an area A > 0, dimensionless.
/// Null if the edge load is y <= 0, where the contact has no adhesive edge load and psi is not defined.
inline std::optional<ToughnessPoint> toughness_of_area(double P, double T, double A) {
  const double a = radius_from_area(A), y = edge_load(a, P);
  if (!(y > 0)) return std::nullopt;
  return ToughnessPoint{mixity_from_loads(y, T < 0 ? -T : T), toughness_ratio(y, T, a)};
}

}  // namespace mixity
