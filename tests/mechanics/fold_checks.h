// What the tests of folds share: the controls, and the printed equation along which a fold is one.
#pragma once

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "mechanics/base/law.h"
#include "mechanics/folds.h"
#include "mechanics/printed_equation.h"

namespace mixity {

inline constexpr Control kLoad{Control::Kind::load}, kDisplacement{Control::Kind::displacement};
inline Control spring(double k) { return {Control::Kind::stiffness, k}; }

template <class Law>
std::string describe(const Law& law, const Parameters<Law>& p, double P, const Control& control) {
  std::ostringstream out;
  out.precision(17);
  out << law.info.key << ' ' << p[0] << ' ' << (p.size() > 1 ? p[1] : 0) << " P=" << P << ' ' << to_string(control.kind)
      << ' ' << control.stiffness;
  return out.str();
}

inline void expect_near(double value, const truth::Digits50& expected, double relative, const std::string& what) {
  EXPECT_LE(abs(truth::Digits50(value) - expected), relative * abs(expected))
      << what << " is " << value << " not " << expected;
}

/// How v = T, u or u + T/k changes along the printed curve at a state (y, T) on it, in 50 digits: d ln v/d ln y, from
/// central differences of the printed equation.
template <class Law>
truth::Digits50 printed_slope(const Law& law, const Parameters<Law>& p, double P, const Control& control,
                              const truth::Digits50& y, const truth::Digits50& T) {
  using truth::Digits50;
  const double last = p.size() > 1 ? p[p.size() - 1] : 0.0;
  const auto F = [&](const Digits50& y_, const Digits50& T_) {
    return truth::printed_residual<Digits50>(law.info.key, p[0], last, P, y_, T_);
  };
  const Digits50 h = y * Digits50(1e-15), k = T * Digits50(1e-15);
  const Digits50 T_y = -((F(y + h, T) - F(y - h, T)) / h) / ((F(y, T + k) - F(y, T - k)) / k);
  if (control.kind == Control::Kind::load) return T_y * y / T;
  const Digits50 a = cbrt(Digits50(Digits50(3) / 4 * (y + P))), u = Digits50(3) / 4 * T / a;
  const Digits50 u_y = u * (T_y / T - 1 / (4 * a * a * a));
  if (control.kind == Control::Kind::displacement) return u_y * y / u;
  return (u_y + T_y / control.stiffness) * y / (u + T / control.stiffness);
}

}  // namespace mixity
