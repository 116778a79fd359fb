// The state of a contact at (P, T): what `mixity predict` prints. Dimensionless.
#pragma once

#include <string_view>

#include "mechanics/equilibrium.h"

namespace mixity {

/// Where T is so large that f exceeds every double, this is returned for it.
inline constexpr double kLargestRatio = std::numeric_limits<double>::max();

struct ContactState {
  double P, T;
  double y;    // edge load, 4/3 a^3 - P
  double a;    // contact radius
  double A;    // contact area, pi a^2
  double u;    // tangential displacement at nu = 1/2, 3/4 T/a
  double psi;  // phase angle [rad], atan2(T, y)
  double f;    // toughness ratio G_c/G_Ic in equilibrium, (y^2 + T^2)/(8 pi a^3); at most kLargestRatio
};

/// The state that follows from a solved edge load y with y + P > 0 (a contact that has not vanished).
inline ContactState contact_state(double P, double T, double y) {
  const double a = radius_from_edge_load(y, P);
  const Mixity<double> mixity = mixity_from_loads(y, T);
  const double f = T > 0 ? (y * y + T * T) / (6 * pi<double>() * (y + P)) : 1.0;
  return {P, T, y, a, area_from_radius(a), 0.75 * T / a, phase_angle(mixity), std::fmin(f, kLargestRatio)};
}

/// The name of a status in every output format.
inline std::string_view to_string(EquilibriumStatus status) {
  switch (status) {
    case EquilibriumStatus::ok:
      return "ok";
    case EquilibriumStatus::no_equilibrium:
      return "no_equilibrium";
    case EquilibriumStatus::invalid:
      break;
  }
  return "invalid";
}

}  // namespace mixity
