// Model a, Johnson (1996): f = 1 + (1 - lambda) tan^2 psi = (y^2 + (1 - lambda) T^2)/y^2, lambda in [0, 1].
// lambda = 1 is the ideally brittle Savkoor-Briggs limit, lambda = 0 uncouples the modes.
#pragma once

#include <limits>

#include "mechanics/base/law.h"

namespace mixity {

struct Johnson {
  static constexpr ModelInfo info{"a", "Johnson 1996", "f = 1 + (1-lambda) tan^2(psi)"};
  static constexpr std::array<ParameterInfo, 1> parameters{{{"lambda", 0, 1, 0.15}}};

  /// Infinite at psi = pi/2 for lambda < 1; must not be called there.
  template <class S>
  static Differentiated<S, 1> log_toughness(const std::array<S, 1>& p, const Mixity<S>& mixity) {
    return log_toughness_of_packed_form<Johnson>(p, mixity);
  }

  static constexpr int kLogSign = 1;
  template <class S>
  static PackedPoint<S> packed_point(const Mixity<S>& mixity) {
    const S tan = mixity.sin / mixity.cos;
    return {tan * tan, S(0)};
  }
  template <class S>
  static PackedForm<S> packed_form(const S& lambda, const PackedPoint<S>& point) {
    const S excess = (S(1) - lambda) * point.first, argument = S(1) + excess, slope = -point.first / argument;
    return {argument, excess, slope, -slope * slope};
  }

  /// tau^2 = lambda T^2 y^2/(y^2 + m T^2), m = 1 - lambda. `mode_II` = m T^2/(y^2 + m T^2) lies in [0, 1].
  template <class S>
  static ShearTerm<S> shear_term(const std::array<S, 1>& p, const S& y, const S& T) {
    const S& lambda = p[0];
    const S m = S(1) - lambda;
    const bool steep = T > y;  // compute with the smaller of y/T and T/y
    const S w = steep ? S(y / T) : S(T / y), square = w * w;
    const S d = steep ? S(square + m) : S(S(1) + m * square), of_II = steep ? m : S(m * square);
    const S side = steep ? y : T;
    const bool vanishes = !(d > S(0));  // lambda = 1 where y^2/T^2 underflows
    const S value = vanishes ? S(lambda * T * T) : S(lambda * side * (side / d));
    const S mode_II = vanishes ? S(0) : S(of_II / d);
    const S slope = S(2) * value * mode_II;
    return {value, slope / y, slope * (S(4) * mode_II - S(3)) / (y * y)};
  }

  /// From (T/y)^2 = q/(lambda - m q), q = (tau/y)^2: T = tau y/sqrt(lambda y^2 - m tau^2), infinite beyond the
  /// asymptote.
  template <class S>
  static S tangential_load(const std::array<S, 1>& p, const S& y, const S& tau) {
    using std::sqrt;
    const S one = sqrt(p[0]) * y, other = sqrt(S(1) - p[0]) * tau;
    if (!(one > other)) return p[0] < S(1) ? S(std::numeric_limits<double>::infinity()) : tau;
    return tau * y / (sqrt(one - other) * sqrt(one + other));
  }

  static double small_shear(const std::array<double, 1>& p) { return p[0]; }
  /// Infinite for lambda = 1.
  static double shear_limit(const std::array<double, 1>& p) { return p[0] / (1 - p[0]); }
  /// At lambda = 1 the curve ends at Hertz; for any smaller lambda it continues along an asymptote that tends to Hertz.
  /// A fit uses the latter limit at the bound, where its cost would otherwise jump.
  static std::array<double, 1> continuous(const std::array<double, 1>& p) { return {std::fmin(p[0], 1 - 0x1p-53)}; }
  /// With w = m T^2/y^2: 2 l (1 - 3w)/(1 + w)^3, 8 l sqrt(w^3/m)/(1 + w)^3 and 2 (l/m) w^2 (w - 3)/(1 + w)^3.
  static ShearBend shear_bend(const std::array<double, 1>& p) {
    const double l = p[0], m = 1 - l;
    if (!(m > 0)) return {2, 0, 0};
    return {2 * l, l / std::sqrt(m), 2 * l / m};
  }
  static ShearReach shear_reach(const std::array<double, 1>& p) { return {1, std::sqrt(1 - p[0]), 1}; }
  static bool tau_grows_with_edge_load(const std::array<double, 1>&) { return true; }
  /// The minimum of d^2(tau^2)/dy^2, at y^2 = (1-lambda) T^2, is -lambda/(2 (1-lambda)): >= -2 up to lambda = 0.8.
  static bool one_fold_at_most(const std::array<double, 1>& p) { return p[0] <= 0.8; }
  static std::string_view equilibrium_domain(const std::array<double, 1>&) { return {}; }
};

template <>
struct ModelSlot<0> {
  using type = Johnson;
};

}  // namespace mixity
