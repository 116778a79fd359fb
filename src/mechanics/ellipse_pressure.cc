#include "mechanics/ellipse_pressure.h"

#include <algorithm>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_rd.hpp>
#include <cmath>
#include <limits>

#include "mechanics/base/constants.h"

namespace mixity {
namespace {

/// M_jk = int_0^inf ds/((A+s)^j (B+s)^k sqrt((A+s) (B+s) s)) for A = e^q, B = e^-q, A >= B.
struct Potentials {
  double M10, M01, M11, M21;
};

/// Of z, the square of the eccentricity: beyond, the differences below lose less than a digit.
constexpr double kNearCircle = 0.25;

/// A^(j+k+1/2) M_jk = 2F1(k + 1/2, j + k + 1/2; j + k + 1; z) times the integral of the circle, z = 1 - B/A.
double by_series(double j, double k, double of_circle, double z) {
  double term = of_circle, sum = term;
  for (double n = 0; n < 200 && term > 0.5 * std::numeric_limits<double>::epsilon() * sum; ++n) {
    term *= (k + 0.5 + n) * (j + k + 0.5 + n) / ((j + k + 1 + n) * (n + 1)) * z;
    sum += term;
  }
  return sum;
}

Potentials potentials(double q, double A, double B) {
  const double z = -std::expm1(-2 * q), half_pi = 0.5 * pi<double>();
  if (z < kNearCircle) {
    const double one = B * std::sqrt(B);  // A^(-3/2)
    return {by_series(1, 0, half_pi, z) * one, by_series(0, 1, half_pi, z) * one,
            by_series(1, 1, 0.75 * half_pi, z) * one * B, by_series(2, 1, 0.625 * half_pi, z) * one * B * B};
  }
  const double M10 = 2.0 / 3 * boost::math::ellint_rd(0.0, B, A), M01 = 2.0 / 3 * boost::math::ellint_rd(0.0, A, B);
  const double M11 = (M10 - M01) / (B - A), M20 = (M10 - B * M11 / 3) / A;
  return {M10, M01, M11, (M20 - M11) / (B - A)};
}

/// For q >= 0. The equations of a paraboloid with A B = 1, and their derivatives: (j + 1/2) A M_(j+1)k + (k + 1/2) B
/// M_j(k+1) = (j + k + 1/2) M_jk, by parts.
EllipsePressure of_long_axis(double q) {
  const double A = std::exp(q), B = std::exp(-q);
  const auto [M10, M01, M11, M21] = potentials(q, A, B);
  const double X = A * M11, Y = B * M11;
  const double m11 = 2 * M10 - Y, m12 = Y - M10, m21 = X - M01, m22 = 2 * M01 - X, determinant = m11 * m22 - m12 * m21;
  const double alpha = (m22 - m12) / determinant, beta = (m11 - m21) / determinant;
  const double dM10 = Y - 1.5 * M10, dM01 = 1.5 * M01 - X, dM11 = -1.5 * (2 * A * M21 - 5.0 / 3 * M11);
  const double dX = X + A * dM11, dY = -Y + B * dM11;
  const double r1 = -((2 * dM10 - dY) * alpha + (dY - dM10) * beta),
               r2 = -((dX - dM01) * alpha + (2 * dM01 - dX) * beta);
  const double d_alpha = (m22 * r1 - m12 * r2) / determinant, d_beta = (m11 * r2 - m21 * r1) / determinant;
  const double half_pi = 0.5 * pi<double>();
  return {half_pi * (2 * alpha - beta), half_pi * (2 * beta - alpha), half_pi * (2 * d_alpha - d_beta),
          half_pi * (2 * d_beta - d_alpha)};
}

EllipsePressure directly(double q) {
  const EllipsePressure p = of_long_axis(std::abs(q));
  if (q >= 0) return p;
  return {p.across, p.along, -p.across_slope, -p.along_slope};
}

/// g(q) = E(q^2) + q O(q^2) for |q| <= kReach, six times as fast: E and O as polynomials in x = q^2/kHalf - 1, from
/// their values at Chebyshev points. The singularities nearest to q = 0 are +-i pi/2, so that the coefficients fall by
/// 29 from term to term.
class PressureTable {
 public:
  static constexpr double kReach = 0.6;

  PressureTable() {
    double cosines[kTerms][kTerms], even[kTerms], odd[kTerms];
    for (int j = 0; j < kTerms; ++j) {
      const double angle = pi<double>() * (j + 0.5) / kTerms, q = std::sqrt(kHalf * (1 + std::cos(angle)));
      const EllipsePressure p = directly(q);
      even[j] = 0.5 * (p.along + p.across);
      odd[j] = 0.5 * (p.along - p.across) / q;
      for (int k = 0; k < kTerms; ++k) cosines[k][j] = std::cos(k * angle);
    }
    double before[kTerms]{}, chebyshev[kTerms]{1};  // the polynomials T_(k-1) and T_k by powers of x
    for (int k = 0; k < kTerms; ++k) {
      double of_even = 0, of_odd = 0;
      for (int j = 0; j < kTerms; ++j) {
        of_even += cosines[k][j] * even[j];
        of_odd += cosines[k][j] * odd[j];
      }
      const double weight = (k == 0 ? 1.0 : 2.0) / kTerms, twice = k == 0 ? 1 : 2;
      double next[kTerms]{};
      for (int i = 0; i < kTerms; ++i) {
        even_[i] += weight * of_even * chebyshev[i];
        odd_[i] += weight * of_odd * chebyshev[i];
        next[i] = (i > 0 ? twice * chebyshev[i - 1] : 0) - before[i];
      }
      std::copy_n(chebyshev, kTerms, before);
      std::copy_n(next, kTerms, chebyshev);
    }
  }

  EllipsePressure at(double q) const {
    const double x = q * q / kHalf - 1;
    double even = even_[kTerms - 1], odd = odd_[kTerms - 1], even_x = 0, odd_x = 0;
    for (int i = kTerms - 2; i >= 0; --i) {
      even_x = even_x * x + even;
      odd_x = odd_x * x + odd;
      even = even * x + even_[i];
      odd = odd * x + odd_[i];
    }
    const double x_q = 2 * q / kHalf, even_q = even_x * x_q, odd_q = odd + q * odd_x * x_q;
    return {even + q * odd, even - q * odd, even_q + odd_q, even_q - odd_q};
  }

 private:
  static constexpr int kTerms = 13;
  static constexpr double kHalf = 0.5 * kReach * kReach;
  double even_[kTerms]{}, odd_[kTerms]{};
};

}  // namespace

EllipsePressure ellipse_pressure(double q) {
  static const PressureTable table;
  return std::abs(q) <= PressureTable::kReach ? table.at(q) : directly(q);
}

EllipseCompliance ellipse_compliance(double q, double nu) {
  // along a ray at the angle theta the traction integrates to pi/2 of the edge's distance R(theta): K(z) for all, D(z)
  // = (K - E)/z for the part with cos^2 from the long axis; dK/dz = (K - D)/(2 (1 - z))
  const double z = -std::expm1(-2 * std::abs(q)), rest = 1 - z;  // z: square of the eccentricity
  const double all = boost::math::ellint_1(std::sqrt(z)), of_long_axis = boost::math::ellint_rd(0.0, rest, 1.0) / 3;
  const double all_z = (all - of_long_axis) / (2 * rest),
               long_z = z < kNearCircle ? by_series(1, 1, 3 * pi<double>() / 32, z)
                                        : ((all - of_long_axis) / rest - of_long_axis) / (2 * z);
  const double along = q >= 0 ? of_long_axis : all - of_long_axis, along_z = q >= 0 ? long_z : all_z - long_z;
  const double unit = std::exp(-0.5 * std::abs(q)) / (pi<double>() * (1 - nu)),
               value = unit * ((1 - nu) * all + nu * along),
               outwards = 2 * rest * unit * ((1 - nu) * all_z + nu * along_z) - 0.5 * value;
  return {value, q >= 0 ? outwards : -outwards};
}

}  // namespace mixity
