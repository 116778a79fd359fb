// The paper's printed equilibrium y^2 + T^2 = 8 pi a^3 f(psi), solved by brute force in 50 digits. Shares no
// formula with the library: the models stand here as they are printed, with angles.
#pragma once

#include <array>
#include <boost/math/constants/constants.hpp>
#include <cstddef>
#include <string_view>
#include <type_traits>

#include "many_digits.h"

namespace mixity::truth {

inline const Digits50 kPi = boost::math::constants::pi<Digits50>();

/// Where psi lies within 1e-30 of pi/2 an angle in 50 digits is not enough.
using Digits700 = Digits<700>;

/// The rounding of a double, a little more than 2^-52, by which results are allowed to differ from the truth.
inline constexpr double kEps = 2.3e-16;

/// f(psi) as printed. parameters: {lambda} for a, b, c; {r, eta} for bk; {p, n} for tan_power, which nobody published.
template <class Number>
Number printed_toughness(std::string_view model, const Number& p0, const Number& p1, const Number& y, const Number& T) {
  const Number psi = atan2(T, y);
  if (model == "a") return 1 + (1 - p0) * pow(T / y, 2);
  if (model == "tan_power") return T == 0 ? Number(1) : Number(1 + p0 * pow(T / y, p1));
  if (model == "b") return 1 + pow(tan((1 - p0 / 2) * psi), 2);
  const Number B = pow(sin(psi), 2);
  if (model == "c") return 1 / (1 + (p0 - 1) * B);
  return B == 0 ? Number(1) : Number(1 + (p0 - 1) * pow(B, p1));
}

/// y^2 + T^2 - 8 pi a^3 f, divided by f: > 0 at the JKR edge load when T > 0.
template <class Number>
Number printed_residual(std::string_view model, const Number& p0, const Number& p1, const Number& P, const Number& y,
                        const Number& T) {
  const Number pi_ = boost::math::constants::pi<Number>();
  return (y * y + T * T) / printed_toughness<Number>(model, p0, p1, y, T) - 6 * pi_ * (y + P);
}

/// The same for a model of the library, of which only the name and the parameters are taken.
template <class Model, class Number = Digits50, std::size_t N>
Number residual_of(const std::array<double, N>& p, const std::type_identity_t<Number>& P,
                   const std::type_identity_t<Number>& y, const std::type_identity_t<Number>& T) {
  return printed_residual<Number>(Model::info.key, p[0], N > 1 ? p[N - 1] : 0.0, P, y, T);
}

inline Digits50 jkr_edge_load(const Digits50& P) { return 3 * kPi + sqrt(9 * kPi * kPi + 6 * kPi * P); }

/// Area at the root in [low, high] of the printed equation, by bisection to 2^-70 of its width; the residual
/// must be <= 0 at low and >= 0 at high.
inline Digits50 printed_area(std::string_view model, const Digits50& p0, const Digits50& p1, const Digits50& P,
                             const Digits50& T, Digits50 low, Digits50 high) {
  for (int i = 0; i < 70; ++i) {
    const Digits50 middle = (low + high) / 2;
    (printed_residual<Digits50>(model, p0, p1, P, middle, T) > 0 ? high : low) = middle;
  }
  const Digits50 a = cbrt(Digits50(Digits50(3) / 4 * ((low + high) / 2 + P)));
  return kPi * a * a;
}

}  // namespace mixity::truth
