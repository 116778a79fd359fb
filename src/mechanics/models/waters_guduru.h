// Model b, Waters & Guduru (2010): f = 1 + tan^2(k psi) = 1/cos^2(k psi), k = 1 - lambda/2, lambda in [0, 2].
// lambda = 2 is the ideally brittle Savkoor-Briggs limit, lambda = 0 uncouples the modes.
#pragma once

#include "mechanics/base/law.h"

namespace mixity {

struct WatersGuduru {
  static constexpr ModelInfo info{"b", "Waters-Guduru 2010", "f = 1 + tan^2((1-lambda/2) psi)"};
  static constexpr std::array<ParameterInfo, 1> parameters{{{"lambda", 0, 2, 0.15}}};

  /// cos(k psi) = cos(psi) cos(h) + sin(psi) sin(h), h = lambda psi/2: a sum of positive terms, so nothing
  /// cancels near psi = pi/2. Infinite only at psi = pi/2 with lambda = 0.
  template <class S>
  static Differentiated<S, 1> log_toughness(const std::array<S, 1>& p, const Mixity<S>& mixity) {
    using std::cos, std::log, std::log1p, std::sin;
    const S psi = phase_angle(mixity), h = S(0.5) * p[0] * psi, k_psi = (S(1) - S(0.5) * p[0]) * psi;
    const S sine = sin(k_psi);
    const S cosine = mixity.cos * cos(h) + mixity.sin * sin(h);
    const S value = sine < S(0.5) ? S(-log1p(-sine * sine)) : S(S(-2) * log(cosine));
    return {value, {-psi / cosine * sine}};
  }

  /// The law as printed; its tangent magnifies rounding of psi by 1/(pi/2 - psi). The cheapest form that does not, the
  /// cotangent of (pi/2 - psi) + h for k psi > pi/4, makes the loop 53 % slower (mechanics_benchmark,
  /// LogToughnessPacked) and a sweep of a fit 36 %.
  static constexpr int kLogSign = 1;
  template <class S>
  static PackedPoint<S> packed_point(const Mixity<S>& mixity) {
    return {phase_angle(mixity), S(0)};
  }
  template <class S>
  static PackedForm<S> packed_form(const S& lambda, const PackedPoint<S>& point) {
    using std::tan;
    const S& psi = point.first;
    const S tangent = tan((S(1) - S(0.5) * lambda) * psi), excess = tangent * tangent, argument = S(1) + excess;
    return {argument, excess, -psi * tangent, S(0.5) * psi * psi * argument};
  }

  /// tau^2 = (y^2 + T^2) (cos^2(k psi) - cos^2 psi) = (y^2 + T^2) sin(h) sin(2 psi - h), h = lambda psi/2, with the
  /// last sine expanded so that y and T replace cos psi and sin psi: nothing cancels at either end, since h <= psi.
  template <class S>
  [[gnu::always_inline]] static inline ShearTerm<S> shear_term(const std::array<S, 1>& p, const S& y, const S& T) {
    using std::atan, std::sqrt, std::tan;
    const S half = S(0.5) * p[0], k = S(1) - half;
    const bool steep = T > y;
    const S near = atan(steep ? S(y / T) : S(T / y)), psi = steep ? S(S(0.5) * pi<S>() - near) : near;
    // sin h and cos h from one tangent, which has a vector form; the pair has none
    const S h = half * psi, tan_h = tan(h), cos_h = S(1) / sqrt(S(1) + tan_h * tan_h), sin_h = tan_h * cos_h;
    const S value = sin_h * (S(2) * y * T * cos_h + (T - y) * (T + y) * sin_h);
    const Mixity<S> mixity = mixity_from_loads(y, T);
    const S &c = mixity.cos, &s = mixity.sin;
    const S sine = s * cos_h - c * sin_h, cosine = c * cos_h + s * sin_h;  // of k psi
    // k T cos(k psi) - y sin(k psi), expanded: the difference itself would lose lambda's digits
    const S d1 = S(2) * sine * (sin_h * (k * T * s + y * c) - half * y * s * cos_h);
    const S d2 = S(2) * (k * s * (S(2) * c * sine * cosine - k * s * (cosine - sine) * (cosine + sine)) - sine * sine);
    return {value, d1, d2};
  }

  /// sin(h) sin(2 psi - h)/psi^2 at psi -> 0: lambda - lambda^2/4.
  static double small_shear(const std::array<double, 1>& p) { return p[0] * (1 - 0.25 * p[0]); }
  /// -psi tan(k psi), k = 1 - lambda/2; where k psi may come near pi/2, from tan h, h = lambda psi/2. At lambda = 2 it
  /// is exactly 0, which tells a fit that the bound is its minimum.
  [[gnu::always_inline]] static inline std::array<double, 1> log_toughness_slope(const std::array<double, 1>& p,
                                                                                 double y, double T) {
    const bool steep = T > y, small = p[0] > 1;
    const double near = std::atan(steep ? y / T : T / y), psi = steep ? 0.5 * pi<double>() - near : near;
    const double share = small ? 1 - 0.5 * p[0] : 0.5 * p[0], tangent = std::tan(share * psi);
    return {-psi * (small ? tangent : (T - y * tangent) / (y + T * tangent))};
  }
  /// In polar coordinates tau^2 = r^2 S(psi), S = (cos 2 k psi - cos 2 psi)/2; its second derivatives are 2 S, S' and
  /// S'' + 2 S. With |S| <= pi l/4, |S'| <= (1 + pi) l/2 and |S'' + 2 S| <= (2 + pi/2) l, their sum bounds the norm.
  static ShearBend shear_bend(const std::array<double, 1>& p) {
    const double bound = 5.7 * p[0];
    return {bound, bound, bound};
  }
  static ShearReach shear_reach(const std::array<double, 1>&) { return {1, 1, 1}; }
  static bool tau_grows_with_edge_load(const std::array<double, 1>&) { return true; }
  /// 2 + d^2(tau^2)/dy^2 = 1 + cos(2 k psi) (1 - 2 k^2 sin^2 psi) + k sin(2 psi) sin(2 k psi). The last term is not
  /// negative, and the second is at least -1.
  static bool one_fold_at_most(const std::array<double, 1>&) { return true; }
  static std::string_view equilibrium_domain(const std::array<double, 1>&) { return {}; }
};

template <>
struct ModelSlot<1> {
  using type = WatersGuduru;
};

}  // namespace mixity
