// The limit of small shear.
#pragma once

#include <cmath>
#include <optional>

#include "mechanics/contact.h"
#include "mechanics/registry.h"

namespace mixity {

/// alpha of A = A0 - alpha T^2 + O(T^4), dimensionless. On the circle a small T lowers y by tau^2/(2 S0), where tau^2 =
/// w T^2 and w = law.small_shear, so
///
///     alpha = pi (3/4)^(2/3) w/(3 S0 (3 pi + P + S0)^(1/3)).
///
/// w is lambda for models a and c, lambda - lambda^2/4 for b; for bk it is 1 if eta > 1 and 2 - r if eta = 1. For
/// eta < 1 the area falls as T^(2 eta) and no alpha exists: null. Null also at or below pull-off, where S0 = 0. For a
/// large area A0, alpha -> pi^(7/4) w/(8 sqrt 2) A0^(-5/4); the next term is smaller by a factor 2.2/sqrt(P).
template <class Law>
std::optional<double> shear_sensitivity(const Law& law, const Parameters<Law>& p, double P) {
  const double w = law.small_shear(p);
  if (!std::isfinite(w) || !(above_pull_off(P) > 0)) return std::nullopt;
  const double S0 = circle_radius(P);
  return pi<double>() * std::pow(0.75, 2.0 / 3) * w / (3 * S0 * std::cbrt(3 * pi<double>() + P + S0));
}

/// The load at which JKR's stable branch has the area A0. With h = 4/3 a^3, h = P + 3 pi + S0 gives P = h - sqrt(6 pi
/// h). A0 must be at least the area at pull-off, 4/3 a^3 = 3 pi/2.
inline std::optional<double> jkr_load(double A0) {
  const double a = radius_from_area(A0), h = 4.0 / 3 * a * a * a;
  if (!(h >= 1.5 * pi<double>())) return std::nullopt;
  return h - std::sqrt(6 * pi<double>() * h);
}

}  // namespace mixity
