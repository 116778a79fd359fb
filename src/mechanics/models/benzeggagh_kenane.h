// Model bk, Benzeggagh & Kenane (1996), the law of composite delamination: f = 1 + (r - 1) B^eta,
// B = sin^2 psi = G_II/(G_I + G_II), r = G_IIc/G_Ic.
#pragma once

#include <limits>

#include "mechanics/model.h"

namespace mixity {

struct BenzeggaghKenane {
  static constexpr ModelInfo info{"bk", "Benzeggagh-Kenane 1996", "f = 1 + (r-1) B^eta, B = sin^2(psi)"};
  static constexpr std::array<ParameterInfo, 2> parameters{{{"r", 1e-3, 1e3, 2}, {"eta", 1e-2, 1e2, 2}}};

  /// B^eta and what it is made of, for B > 0. ln B comes from cos psi where B is near 1, and 1 - B^eta from ln B, so
  /// that neither the exponent nor a small r magnifies a rounding.
  template <class S>
  struct Power {
    bool tiny;                   // B underflows, which B^eta need not: 1e-300^0.01 = 0.001
    S log_B, reduced, value, f;  // reduced = B^(eta-1), meaningless if tiny; value = B^eta, f = (1 - B^eta) + r B^eta
    Power(const std::array<S, 2>& p, const Mixity<S>& mixity) {
      using std::exp, std::expm1, std::log, std::log1p, std::pow;
      const S B = mixity.sin * mixity.sin;
      tiny = !(B > S(1e-290));
      log_B = tiny ? S(S(2) * log(mixity.sin)) : B < S(0.5) ? S(log(B)) : S(log1p(-mixity.cos * mixity.cos));
      if (tiny) {
        reduced = S(0);
        value = pow(mixity.sin, S(2) * p[1]);
      } else if (p[1] < S(0.5)) {  // eta - 1 would round eta off, times ln B
        value = pow(B, p[1]);
        reduced = value / B;
      } else {
        reduced = B < S(0.5) ? S(pow(B, p[1] - S(1))) : S(exp((p[1] - S(1)) * log_B));
        value = reduced * B;
      }
      f = p[0] * value - expm1(p[1] * log_B);
    }
  };

  /// Finite for every psi.
  template <class S>
  static Differentiated<S, 2> log_toughness(const std::array<S, 2>& p, const Mixity<S>& mixity) {
    using std::log, std::log1p;
    if (!(mixity.sin > S(0))) return {S(0), {S(0), S(0)}, {S(0), S(0), S(0), S(0)}};
    const Power<S> power(p, mixity);
    const S q = (p[0] - S(1)) * power.value;
    const S u = power.value / power.f, v = q * power.log_B / power.f;
    const S cross = u * power.log_B / power.f;
    const S value = power.f < S(0.5) ? S(log(power.f)) : S(log1p(q));
    return {value, {u, v}, {-u * u, cross, cross, v * power.log_B / power.f}};
  }

  /// tau^2 = (y^2 + T^2)/f - y^2 = T^2 (1 - (f - 1) y^2/T^2)/f, with (f - 1) y^2/T^2 = (r - 1) B^(eta-1) (1 - B), whose
  /// difference from 1 is taken as (1 - (r - 1) B^(eta-1)) + (r - 1) B^eta for the sake of eta = 1, r = 2.
  template <class S>
  static ShearTerm<S> shear_term(const std::array<S, 2>& p, const S& y, const S& T) {
    if (!(T > S(0))) return {S(0), S(0), S(0)};
    const S& eta = p[1];
    const Mixity<S> mixity = mixity_from_loads(y, T);
    const S C = mixity.cos * mixity.cos;
    if (!(mixity.sin > S(0))) return {S(0), S(0), S(0)};
    const Power<S> power(p, mixity);
    if (power.tiny && p[0] >= S(1)) return {S(0), S(0), S(0)};  // eta >= 1 then: of the size of T^2, which underflows
    const S& f = power.f;
    const S q = (p[0] - S(1)) * power.value;
    const S g = q * (eta - f) / (f * f);
    const S value = power.tiny ? S(-q * y * y / f) : S(T * T * ((S(1) - (p[0] - S(1)) * power.reduced) + q) / f);
    return {value, S(2) * y * g, S(2) * g - S(4) * eta * q * C * ((eta - S(1)) - (eta + S(1)) * q) / (f * f * f)};
  }

  /// d(tau^2)/dy has the sign of (r - 1)(eta - f), and f lies between 1 and r.
  /// 1 - (r - 1) B^(eta-1) at B -> 0: 1 for eta > 1, 2 - r for eta = 1. For eta < 1 (r < 1) the area falls faster than
  /// T^2 and the limit is infinite; only its sign is used then.
  static double small_shear(const std::array<double, 2>& p) {
    return p[1] > 1 ? 1 : p[1] == 1 ? 2 - p[0] : p[0] < 1 ? std::numeric_limits<double>::infinity() : 1;
  }
  static bool tau_grows_with_edge_load(const std::array<double, 2>& p) {
    return p[0] >= 1 ? p[1] >= p[0] : p[1] <= p[0];
  }

  /// The map from psi to the circle is one-to-one when g = (1 + tan^2 psi)/f grows with psi:
  /// 1 - (r - 1) B^(eta-1) (eta - (eta+1) B) >= 0. For r <= 1 that holds always; for r > 1 the worst B is
  /// (eta-1)/(eta+1), which leaves (r - 1) ((eta-1)/(eta+1))^(eta-1) <= 1, and eta < 1 never qualifies.
  static std::string_view equilibrium_domain(const std::array<double, 2>& p) {
    const double r = p[0], eta = p[1];
    if (r <= 1) return {};
    if (eta < 1) return "the Benzeggagh-Kenane law with r > 1 needs eta >= 1 to define a unique equilibrium";
    if ((r - 1) * std::pow((eta - 1) / (eta + 1), eta - 1) <= 1) return {};
    return "the Benzeggagh-Kenane law defines a unique equilibrium only for (r-1)((eta-1)/(eta+1))^(eta-1) <= 1";
  }
};

template <>
struct ModelSlot<3> {
  using type = BenzeggaghKenane;
};

}  // namespace mixity
