// Model bk, Benzeggagh & Kenane (1996), the law of composite delamination: f = 1 + (r - 1) B^eta,
// B = sin^2 psi = G_II/(G_I + G_II), r = G_IIc/G_Ic.
#pragma once

#include <limits>

#include "mechanics/base/law.h"

namespace mixity {

struct BenzeggaghKenane {
  static constexpr ModelInfo info{"bk", "Benzeggagh-Kenane 1996", "f = 1 + (r-1) B^eta, B = sin^2(psi)"};
  static constexpr std::array<ParameterInfo, 2> parameters{{{"r", 1e-3, 1e3, 2, 1}, {"eta", 1e-2, 1e2, 2}}};

  /// B = sin^2 psi, C = 1 - B and ln B. `tiny` is set where B underflows although B^eta may not: 1e-300^0.01 = 0.001.
  /// Then scaled = 2^600 sin psi replaces B, since T/y may be less than any double, too.
  template <class S>
  struct ModeRatio {
    S B, C, log_B, scaled;
    bool tiny;

    explicit ModeRatio(const Mixity<S>& mixity)
        : B(mixity.sin * mixity.sin), C(mixity.cos * mixity.cos), scaled(mixity.sin), tiny(is_tiny(B)) {
      if (tiny) scaled = mixity.sin * S(kScale);
      set_log();
    }
    /// From the ratio of the loads, without the roots of sin psi and cos psi: eta multiplies each rounding of B.
    ModeRatio(const S& y, const S& T) : scaled(T) {
      const bool steep = T > y;
      const S t = steep ? S(y / T) : S(T / y), square = t * t, larger = S(1) / (S(1) + square),
              smaller = square * larger;
      B = steep ? larger : smaller;
      C = steep ? smaller : larger;
      tiny = is_tiny(B);
      if (tiny) scaled = T * S(kScale) / y;
      set_log();
    }

   private:
    static constexpr double kScale = 0x1p600;
    static bool is_tiny(const S& B) { return !(B > S(1e-290)); }
    /// Uses C where B is near 1, so that the exponent does not magnify a rounding of B.
    void set_log() {
      using std::log, std::log1p;
      log_B = tiny ? S(S(2) * (log(scaled) - log(S(kScale)))) : B < S(0.5) ? S(log(B)) : S(log1p(-C));
    }
    friend struct BenzeggaghKenane;
  };

  /// B^eta and derived quantities, for B > 0. 1 - B^eta comes from ln B, so that a small r magnifies no rounding.
  template <class S>
  struct Power {
    S reduced, value, f;  // reduced = B^(eta-1), meaningless if tiny; value = B^eta, f = (1 - B^eta) + r B^eta
    Power(const std::array<S, 2>& p, const ModeRatio<S>& mode) {
      using std::exp, std::expm1, std::pow;
      const S& B = mode.B;
      if (mode.tiny) {
        reduced = S(0);
        value = pow(mode.scaled, S(2) * p[1]) * pow(S(1 / ModeRatio<S>::kScale), S(2) * p[1]);
      } else if (p[1] < S(0.5)) {  // eta - 1 would lose digits of eta, multiplied by ln B
        value = pow(B, p[1]);
        reduced = value / B;
      } else {
        reduced = B < S(0.5) ? S(pow(B, p[1] - S(1))) : S(exp((p[1] - S(1)) * mode.log_B));
        value = reduced * B;
      }
      f = p[0] * value - expm1(p[1] * mode.log_B);
    }
  };

  /// Finite for every psi.
  template <class S>
  static Differentiated<S, 2> log_toughness(const std::array<S, 2>& p, const Mixity<S>& mixity) {
    using std::log, std::log1p;
    if (!(mixity.sin > S(0))) return {S(0), {S(0), S(0)}};
    const ModeRatio<S> mode(mixity);
    const Power<S> power(p, mode);
    const S q = (p[0] - S(1)) * power.value;
    const S value = power.f < S(0.5) ? S(log(power.f)) : S(log1p(q));
    return {value, {power.value / power.f, q * mode.log_B / power.f}};
  }

  static double log_toughness_alone(const std::array<double, 2>& p, const Mixity<double>& mixity) {
    if (!(mixity.sin > 0)) return 0;
    const ModeRatio<double> mode(mixity);
    if (mode.tiny) return log_toughness(p, mixity).value;
    const double power = std::exp(p[1] * mode.log_B), q = (p[0] - 1) * power;
    return q < -0.5 ? log_toughness(p, mixity).value : std::log1p(q);
  }

  /// tau^2 = (y^2 + T^2)/f - y^2 = T^2 (1 - (f - 1) y^2/T^2)/f, with (f - 1) y^2/T^2 = k (1 - B), k = (r - 1)
  /// B^(eta-1). For k <= 1, the bracket is computed as (1 - k) + k B, which is B for eta = 1 and r = 2, and 1 - k as a
  /// sum of two terms that do not cancel. For k > 1, where 1 - k < 0 would cancel with k B, it is computed as 1 - k (1
  /// - B).
  template <class S>
  static ShearTerm<S> shear_term(const std::array<S, 2>& p, const S& y, const S& T) {
    using std::expm1;
    if (!(T > S(0))) return {S(0), S(0), S(0)};
    const S& eta = p[1];
    const ModeRatio<S> mode(y, T);
    if (mode.tiny && p[0] >= S(1)) return {S(0), S(0), S(0)};  // here eta >= 1: tau^2 is of order T^2 and underflows
    const Power<S> power(p, mode);
    const S& f = power.f;
    const S k = (p[0] - S(1)) * power.reduced, q = (p[0] - S(1)) * power.value;
    const S slack = (eta - S(1)) - q, g = q * slack / (f * f);  // slack = eta - f
    const S rest = k > S(0.5) ? S((S(2) - p[0]) - (p[0] - S(1)) * expm1((eta - S(1)) * mode.log_B)) : S(S(1) - k);
    const S left = k > S(1) ? S(S(1) - k * mode.C) : S(rest + q);
    const S value = mode.tiny ? S(-q * y * y / f) : S(T * T * left / f);
    return {value, S(2) * y * g, S(2) * g - S(4) * eta * q * mode.C * ((eta - S(1)) - (eta + S(1)) * q) / (f * f * f)};
  }

  /// 1 - (r - 1) B^(eta-1) at B -> 0: 1 for eta > 1, 2 - r for eta = 1. For eta < 1 the limit is infinite: with r < 1
  /// the area falls faster than T^2; with r > 1 no equilibrium is unique, and f rises from 1 with an infinite slope.
  static double small_shear(const std::array<double, 2>& p) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    if (p[1] > 1 || p[0] == 1) return 1;
    return p[1] == 1 ? 2 - p[0] : p[0] < 1 ? kInfinity : -kInfinity;
  }
  /// Near psi = pi/2 B^eta is exp(-eta cos^2 psi), and f bends from its slope to r where eta cos^2 psi = r.
  static ShearReach shear_reach(const std::array<double, 2>& p) {
    const double eta = p[1], narrow = std::sqrt(std::fmin(p[0], 1) / std::fmax(eta, 1));
    return {eta > 2 ? std::sqrt(eta) : 1, narrow, eta >= 2 ? narrow : 0};
  }
  /// d(tau^2)/dy has the sign of (r - 1)(eta - f), and f lies between 1 and r.
  static bool tau_grows_with_edge_load(const std::array<double, 2>& p) {
    return p[0] >= 1 ? p[1] >= p[0] : p[1] <= p[0];
  }

  /// The map from psi to the circle is one-to-one when g = (1 + tan^2 psi)/f grows with psi: 1 - (r - 1) B^(eta-1) (eta
  /// - (eta+1) B) >= 0. This always holds for r <= 1. For r > 1 the worst B is (eta-1)/(eta+1), which leaves (r - 1)
  /// ((eta-1)/(eta+1))^(eta-1) <= 1; it never holds for eta < 1.
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
