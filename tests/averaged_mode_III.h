// The contact with mode III averaged over its edge (Johnson 1996; Waters & Guduru 2010), by bisection and with nothing
// of the library: y^2 + kappa T^2 = 8 pi a^3 f(psi), tan psi = sqrt(kappa) T/y, in Maugis' dimensionless quantities.
#pragma once

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace mixity {

inline double averaged_law(const std::string& model, double lambda, double psi) {
  if (model == "a") return 1 + (1 - lambda) * std::pow(std::tan(psi), 2);
  if (model == "b") return 1 + std::pow(std::tan((1 - lambda / 2) * psi), 2);
  if (model == "c") return 1 / (1 + (lambda - 1) * std::pow(std::sin(psi), 2));
  throw std::invalid_argument(model);
}

/// The energy release rate over the toughness, times 8 pi a^3, less that.
inline double averaged_excess(const std::string& model, double lambda, double kappa, double P, double T, double a) {
  const double y = 4.0 / 3 * a * a * a - P, weighted = std::sqrt(kappa) * T;
  return y * y + weighted * weighted -
         8 * std::numbers::pi * a * a * a * averaged_law(model, lambda, std::atan2(weighted, y));
}

/// The area on the branch that begins at JKR's; T must lie below the fold.
inline double averaged_area(const std::string& model, double lambda, double kappa, double P, double T) {
  const double pi = std::numbers::pi;
  double above = std::cbrt(0.75 * (P + 3 * pi + std::sqrt(9 * pi * pi + 6 * pi * P))), below = above;
  constexpr double kStep = 1e-4;  // far below the distance of the two branches in these tests
  while (averaged_excess(model, lambda, kappa, P, T, below) > 0) {
    above = below;
    below *= 1 - kStep;
    if (below < 0.1) throw std::invalid_argument("T lies beyond the fold");
  }
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (above + below);
    (averaged_excess(model, lambda, kappa, P, T, middle) > 0 ? above : below) = middle;
  }
  return pi * below * below;
}

}  // namespace mixity
