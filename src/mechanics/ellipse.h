// The contact of a sphere as an ellipse: semi-axes a along the shear and b across it. Mode II acts at the ends of a,
// mode III at those of b; each has the toughness ratio f of the same law with parameters of its own. With Y = w g(+-q)
// - P (ellipse_pressure.h) and T' = T/sqrt(1 - nu) for mode III, Griffith's criterion at the two ends reads
//
//     Y^2 + tau^2(Y, T)  = 6 pi w sqrt(b/a)     at (a, 0), parameters of mode II
//     Y^2 + tau^2(Y, T') = 6 pi w sqrt(a/b)     at (0, b), parameters of mode III
//
// with the law's tau^2 = (Y^2 + T^2)/f - Y^2 (base/law.h). Equal parameters and nu = 0 give the circle. The tangential
// traction is that of a uniform displacement, T/(2 pi a b)/sqrt(1 - (x/a)^2 - (y/b)^2): K_II = T/(2 b sqrt(pi a)),
// K_III = T/(2 a sqrt(pi b)). Two couplings as in Papangelo, Scheibert, Sahli, Pallares & Ciavarella 2019
// (arXiv:1906.02957).
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "mechanics/states.h"

namespace mixity {

/// What follows a law's key in that of its model of elliptic contacts: with parameters of its own for each mode, and
/// with the same for both.
inline constexpr std::string_view kEllipse = "-ellipse", kEqualEllipse = "-ellipse-equal";

/// The last parameter of each model of elliptic contacts.
inline constexpr std::string_view kPoissonRatio = "poisson_ratio";

/// What the law does at the two ends. poisson_ratio: of the compliant body, in [0, 1/2].
struct EndParameters {
  std::span<const double> mode_II, mode_III;
  double poisson_ratio = 0.5;
};

/// Dimensionless semi-axes at a tangential load, and the phase angles [rad] at the ends of the axes: atan(T/Y),
/// atan(T'/Y). NaN unless the status is ok.
struct EllipseState {
  EquilibriumStatus status = EquilibriumStatus::invalid;
  double a = std::numeric_limits<double>::quiet_NaN(), b = a, psi_II = a, psi_III = a;
};

/// Derivatives of the semi-axes at fixed T, P and parameters otherwise: in T, P, the parameters of mode II, those of
/// mode III, Poisson's ratio; point after point. Not finite on a fold, NaN where a state is not ok.
struct EllipseSlopes {
  std::vector<double> a, b;  // [points x (3 + 2 parameters)]
};

/// Where the stable branch that starts at T = 0 ends: at a fold of the controlled quantity (Control), or where K_I
/// reaches 0 at the ends of an axis, so that the edge closes or slips there; the equations do not hold beyond.
enum class EllipseEnd : unsigned char { fold, closes_along, closes_across };
inline std::string_view to_string(EllipseEnd end) {
  constexpr std::string_view kNames[]{"fold", "closes_along", "closes_across"};
  return name_among(kNames, end);
}
struct EllipseBranchEnd {
  EllipseEnd kind;
  double T, u, a, b;
};

struct Ellipses {
  std::vector<EllipseState> at;           // in the order of the T
  std::optional<EllipseBranchEnd> end{};  // set if it was asked for or if a T lies beyond it
};

}  // namespace mixity
