// Model c, Papangelo & Ciavarella (2019): f = 1/(1 + (lambda - 1) sin^2 psi) = (y^2 + T^2)/(y^2 + lambda T^2),
// lambda in [0, 1]. lambda = 1 is the ideally brittle Savkoor-Briggs limit, lambda = 0 uncouples the modes.
#pragma once

#include "mechanics/base/law.h"

namespace mixity {

struct PapangeloCiavarella {
  static constexpr ModelInfo info{"c", "Papangelo-Ciavarella 2019", "f = 1/(1 + (lambda-1) sin^2(psi))"};
  static constexpr std::array<ParameterInfo, 1> parameters{{{"lambda", 0, 1, 0.15}}};

  /// Infinite only at psi = pi/2 with lambda = 0.
  template <class S>
  static Differentiated<S, 1> log_toughness(const std::array<S, 1>& p, const Mixity<S>& mixity) {
    return log_toughness_of_packed_form<PapangeloCiavarella>(p, mixity);
  }

  /// Computes 1/f from B = sin^2 psi and 1 - B, as a sum of positive terms.
  static constexpr int kLogSign = -1;
  template <class S>
  static PackedPoint<S> packed_point(const Mixity<S>& mixity) {
    return {mixity.sin * mixity.sin, mixity.cos * mixity.cos};
  }
  template <class S>
  static PackedForm<S> packed_form(const S& lambda, const PackedPoint<S>& point) {
    const S argument = point.second + lambda * point.first, slope = -point.first / argument;
    return {argument, (lambda - S(1)) * point.first, slope, slope * slope};
  }

  /// tau = sqrt(lambda) T does not depend on y, so equilibrium has a closed form.
  template <class S>
  static S shear_on_circle(const std::array<S, 1>& p, const S& T) {
    using std::sqrt;
    return sqrt(p[0]) * T;
  }

  template <class S>
  static ShearTerm<S> shear_term(const std::array<S, 1>& p, const S&, const S& T) {
    return {p[0] * T * T, S(0), S(0)};
  }

  template <class S>
  static S tangential_load(const std::array<S, 1>& p, const S&, const S& tau) {
    using std::sqrt;
    return tau / sqrt(p[0]);
  }

  static double small_shear(const std::array<double, 1>& p) { return p[0]; }
  static ShearBend shear_bend(const std::array<double, 1>& p) { return {2 * p[0], 0, 0}; }
  static ShearReach shear_reach(const std::array<double, 1>&) { return {1, 1, 1}; }

  /// y - 3 pi of the only fold. Load control: 0, the top of the circle. Displacement control: du = 0 on the circle
  /// reads 2 v^2 + 3 (3 pi + P) v + S0^2 = 0 with v = y - 3 pi; the fold is its upper root.
  static double fold_offset(const std::array<double, 1>&, double P, bool displacement) {
    if (!displacement) return 0;
    const double square = 6 * pi<double>() * above_pull_off(P), b = 3 * (3 * pi<double>() + P);
    return -2 * square / (b + std::sqrt(b * b - 8 * square));
  }

  static bool tau_grows_with_edge_load(const std::array<double, 1>&) { return true; }
  static std::string_view equilibrium_domain(const std::array<double, 1>&) { return {}; }
};

template <>
struct ModelSlot<2> {
  using type = PapangeloCiavarella;
};

}  // namespace mixity
