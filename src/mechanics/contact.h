// The contact of a sphere with a half-space: its constants, Maugis' dimensionless quantities, JKR and Hertz.
#pragma once

#include <cmath>

#include "mechanics/base/constants.h"

namespace mixity {

// Within these limits a fourth power neither overflows nor underflows, as sums of squares of products require.
inline constexpr double kLeastQuantity = 1e-75, kMostQuantity = 1e75;

/// Whether a positive value is within the limits.
inline bool in_range(double value) { return value >= kLeastQuantity && value <= kMostQuantity; }

/// Constants of a contact in SI units, all > 0: radius R [m], plane-strain modulus E* [Pa], mode-I toughness
/// G_Ic [J/m^2].
struct Contact {
  double radius, modulus, toughness;

  /// xi = (E* R/G_Ic)^(1/3)
  double xi() const { return std::cbrt(modulus * radius / toughness); }

  // One dimensionless unit of each quantity in SI: value_SI = value_dimensionless * unit.
  double force_unit() const { return radius * toughness; }             // P, T, y: R G_Ic [N]
  double length_unit() const { return radius / xi(); }                 // a: R/xi [m]
  double area_unit() const { return length_unit() * length_unit(); }   // A: (R/xi)^2 [m^2]
  double displacement_unit() const { return radius / (xi() * xi()); }  // u: R/xi^2 [m]
  double stress_unit() const { return modulus / xi(); }                // tau0: E*/xi [Pa]
  double stiffness_unit() const { return xi() * xi() * toughness; }    // k: xi^2 G_Ic [N/m]

  /// Whether the units allow calculations without overflow.
  bool usable() const {
    return in_range(force_unit()) && in_range(area_unit()) && in_range(displacement_unit()) &&
           in_range(stress_unit()) && in_range(stiffness_unit());
  }
};

/// E* of a rigid sphere on a soft half-space from its Young's modulus [Pa] and Poisson ratio (0 <= nu <= 0.5).
inline double plane_strain_modulus(double youngs_modulus, double poisson_ratio) {
  return youngs_modulus / (1 - poisson_ratio * poisson_ratio);
}

// From here on everything is dimensionless (Maugis), as in the paper but without its tildes.

/// Edge load y = 4/3 a^3 - P: the Hertz load at radius a minus the applied load.
template <class S>
S edge_load(const S& a, const S& P) {
  return S(4) / S(3) * a * a * a - P;
}

/// a from the edge load: a^3 = 3/4 (y + P), y + P >= 0.
template <class S>
S radius_from_edge_load(const S& y, const S& P) {
  using std::cbrt;
  return cbrt(S(0.75) * (y + P));
}

/// Hertz contact radius (y = 0), P >= 0.
template <class S>
S hertz_radius(const S& P) {
  return radius_from_edge_load(S(0), P);
}

/// Radius S0 of the equilibrium circle, S0^2 = 9 pi^2 + 6 pi P = 6 pi (P + 3 pi/2); P >= -3 pi/2.
template <class S>
S circle_radius(const S& P) {
  using std::sqrt;
  return sqrt(S(6) * pi<S>() * above_pull_off(P));
}

/// JKR contact radius (T = 0, stable branch): 4/3 a^3 = P + 3 pi + S0; P >= -3 pi/2.
template <class S>
S jkr_radius(const S& P) {
  return radius_from_edge_load(S(S(3) * pi<S>() + circle_radius(P)), P);
}

template <class S>
S area_from_radius(const S& a) {
  return pi<S>() * a * a;
}

template <class S>
S area_from_edge_load(const S& y, const S& P) {
  return area_from_radius(radius_from_edge_load(y, P));
}

template <class S>
S radius_from_area(const S& A) {
  using std::sqrt;
  return sqrt(A / pi<S>());
}

}  // namespace mixity
