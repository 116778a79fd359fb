// The regime of a contact that is sheared under a constant normal load, and the boundaries between regimes in the plane
// of load and lambda.
#pragma once

#include <optional>
#include <vector>

#include "mechanics/equilibrium.h"
#include "mechanics/limits.h"

namespace mixity {

/// For valid parameters and a load at which the contact exists. tau0 > 0 dimensionless, or null. A jump to a lower
/// stable branch also counts as regime 3 (jumps_to lower_branch): the first critical point decides.
template <class Law>
RegimeReport classify(const Law& law, const Parameters<Law>& p, double P, std::optional<double> tau0 = {});

// ---- Boundaries. These go beyond the paper. ----

/// The load below which a contact jumps and above which it shrinks without a jump; infinite if it jumps at every load,
/// -3 pi/2 if at none. For parameters that define a unique equilibrium.
///
/// With x = ln tan psi, g(x) = (1 + tan^2 psi)/f and D = d ln g/dx, a fold at x is where g y^2 = 6 pi (y + P) and
/// (y + 2 P)/(y + P) = D (load_folds.cc). The second gives y + P = P/(D - 1), and both together the one load that folds
/// there,
///
///     P = 6 pi (D - 1)/(g (2 - D)^2) = 6 pi (g - 2 - d)/(2 + d)^2,      d = d(tau^2/y)/dy = g (2 - D) - 2 at y = 1
///
/// It is -3 pi/2 at psi = 0 and continuous: every load below its largest value has a fold, no load above has one. Where
/// 2 + d <= 0, y has fallen to 0 in a fold at every load. Accurate to about 1e-11, relative and in units of 3 pi/2.
template <class Law>
double critical_load(const Law& law, const Parameters<Law>& p);

/// Law b jumps below and is smooth above this load; k = 1 - lambda/2.
///
/// Near Hertz, psi = pi/2 - epsilon with epsilon = y/T, so cos(k psi) = s + k c epsilon, s = sin(pi lambda/4),
/// c = cos(pi lambda/4), and y^2 g = (y^2 + T^2) cos^2(k psi) = T^2 s^2 + 2 k s c T y + O(y^2) must equal 6 pi (y + P).
/// At y = 0, T_H s = sqrt(6 pi P). To first order in y, d(T s)^2/dy = 6 pi - 2 k c sqrt(6 pi P): T grows towards
/// Hertz (no fold) exactly if P > (3 pi/2)/(k c)^2.
inline double model_b_critical_load(double lambda) {
  const double kc = (1 - 0.5 * lambda) * std::cos(0.25 * pi<double>() * lambda);
  return 1.5 * pi<double>() / (kc * kc);
}

/// A point of the cusp line of model a, where a fold appears on its curve. 1 - lambda is stored separately, because
/// lambda rounds to 1 at large P.
struct CuspPoint {
  double P, lambda, one_minus_lambda;
};

/// The cusp line as a function of X in (0, 1/2]: P -> infinity as X -> 0, (P, lambda) = (0, 8/9) at X = 1/3, and
/// (-15 pi/64, 27/32) at X = 1/2, where it meets the closing line.
///
/// With x = tan^2 psi, m = 1 - lambda, g = (1 + x)/(1 + m x), the fold condition R_y = 0 on the upper branch is
/// lambda x (1 + 3 pi/r) = (1 + x)(1 + m x), r^2 = 9 pi^2 + 6 pi P g. Solved for the load,
///
///     P = (3 pi/2) (rho^2 - 1)/g,      rho = lambda x/(1 + 2 m x + m x^2),
///
/// so the contact folds at P if P is below the maximum of this over x. dP/dx = 0 is (1 + x) times a cubic; with
/// X = m x it reads X^3 - 3 X^2 + m (6 X^2 + 3 X + 1) = 0, that is m = X^2 (3 - X)/(6 X^2 + 3 X + 1).
inline CuspPoint model_a_cusp(double X) {
  const double m = X * X * (3 - X) / ((6 * X + 3) * X + 1);
  const double x = X / m, lambda = 1 - m;
  const double rho = lambda * x / (1 + 2 * X + X * x), g = (1 + x) / (1 + X);
  return {1.5 * pi<double>() * (rho - 1) * (rho + 1) / g, lambda, m};
}

/// P < 0: at lambda above 1 + 2P/(3 pi) the curve of model a closes: it returns to the unstable JKR state, and the
/// contact drops off at the fold. Below, T -> infinity at the asymptote, which exists if 9 pi^2 + 6 pi P/m >= 0.
inline double model_a_closing_lambda(double P) { return 1 + 2 * P / (3 * pi<double>()); }

/// Law a jumps exactly at lambda above this: the cusp line down to P = -15 pi/64, below that the closing line.
/// -3 pi/2 < P <= 1e8.
CuspPoint model_a_jump_boundary(double P);

/// The closed-form boundaries of the model with this key; null if it has none.
std::optional<std::span<const RegimeBoundary>> regime_boundaries(std::string_view key);

}  // namespace mixity
