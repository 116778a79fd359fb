// What a mode-mixity law must have: a toughness ratio f(psi) = G_c/G_Ic with named, bounded parameters.
//
// A law is an object that takes its parameters p with each call: law.shear_term(p, y, T). A published law is an empty
// struct whose members are static (models/*.h); a law that is defined at run time has state (laws/user_law_view.h).
// Members marked with * are optional.
//
//   info                           key on the command line, name, published formula
//   parameters                     name, range and a typical value of each
//   equilibrium_domain(p)          empty, or why these parameters define no unique equilibrium
//
//   log_toughness(p, mixity)       ln f and its derivatives in the parameters
//   log_toughness_alone(p, mixity)* ln f, where its derivatives would cost more than ln f itself
//   log_toughness_slope(p, y, T)*  d ln f/dp in a form without branches
//   packed_point(mixity)*, packed_form(p, point)*   ln f for vectorised loops, see PackedForm; only with one parameter
//
// The rest describes tau^2 = y^2 (g - 1) of the equilibrium circle (equilibrium.h), where g = (1 + tan^2 psi)/f:
//
//   shear_term(p, y, T)            tau^2 and its derivatives in y
//   small_shear(p)                 lim tau^2/T^2 at T -> 0; may be 0 or infinite
//   shear_limit(p)*                lim tau^2/y^2 at T -> infinity; without it the limit is infinite
//   tau_grows_with_edge_load(p)    whether d(tau^2)/dy >= 0 at fixed T, for all y and T
//   non_monotone(p)*               whether g fails to grow with psi somewhere (non_monotone_curve.h)
//   shear_on_circle(p, T)*         tau, if it does not depend on y: equilibrium is then a closed form
//   tangential_load(p, y, tau)*    T of a state (y, tau) in closed form; without it T is found by iteration
//   fold_offset(p, P, displacement)*   y - 3 pi of the only fold in closed form
//   one_fold_at_most(p)*           whether tau^2 + y^2 is convex in y at fixed T, and tau grows with y
//   shear_bend(p)*, shear_reach(p)*    bounds of the second derivatives of tau^2; without them the nearest point of a
//                                  curve is searched for along the whole curve
//   continuous(p)*                 the parameters nearest to p at which curves do not change abruptly
//
// A published law takes a number in the registry: template <> struct ModelSlot<4> { using type = MyLaw; };
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "mechanics/base/constants.h"

namespace mixity {

/// Direction of the edge load: cos = K_I/|K|, sin = K_II/|K|, both in [0, 1]. Unlike an angle, the two have full
/// relative accuracy both at psi -> 0 and at psi -> pi/2.
template <class S>
struct Mixity {
  S cos, sin;
};

/// Mixity of a state with edge load y > 0 (or y = 0 with T > 0) and tangential load T >= 0.
template <class S>
[[gnu::always_inline]] inline Mixity<S> mixity_from_loads(const S& y, const S& T) {
  using std::sqrt;
  const bool steep = T > y;
  const S t = steep ? S(y / T) : S(T / y), larger = S(1) / sqrt(S(1) + t * t), smaller = t * larger;
  return {steep ? smaller : larger, steep ? larger : smaller};
}

/// What 90 degrees become in radians: the double after the one nearest to pi/2.
inline constexpr double kLargestPhaseAngle = 1.5707963267948968;

/// Mixity at the phase angle psi [rad] in [0, pi/2]. The double nearest to pi/2 counts as pi/2.
inline Mixity<double> mixity_from_angle(double psi) {
  const double c = std::cos(psi);
  return {c < 1.3e-16 ? 0.0 : c, std::sin(psi)};
}

/// Mixity at the mode ratio B = G_II/(G_I + G_II) = sin^2 psi in [0, 1].
inline Mixity<double> mixity_from_mode_ratio(double B) { return {std::sqrt(1 - B), std::sqrt(B)}; }

/// Mixity of two mode energies with a positive sum: sin^2 psi = G_II/(G_I + G_II). A negative energy, which noise can
/// produce, counts as 0.
inline Mixity<double> mixity_from_energies(double G_I, double G_II) {
  const double I = std::fmax(G_I, 0.0), II = std::fmax(G_II, 0.0), sum = I + II;
  return {std::sqrt(I / sum), std::sqrt(II / sum)};
}

/// psi = atan2(K_II, K_I) [rad].
template <class S>
S phase_angle(const Mixity<S>& m) {
  using std::atan2;
  return atan2(m.sin, m.cos);
}

struct ParameterInfo {
  std::string_view name;
  double lower, upper;  // closed range in which the published law makes sense
  double typical;       // shown in help; the start of a fit where nothing better is known
  double neutral = 0;   // > 0: the value at which f = 1 whatever the other parameters are
};

struct ModelInfo {
  std::string_view key;      // "a": what --models takes
  std::string_view name;     // "Johnson 1996"
  std::string_view formula;  // as published
};

/// The input of a vectorised loop for one point, and its result for a law with one parameter: ln f = kLogSign
/// log(argument), with an absolute error of a few eps, and its derivatives; excess = argument - 1 without cancellation.
/// Without branches, compilers process several points at once. log1p(excess) in place of log(argument) would make the
/// loop 22 % slower for law a and 44 % for c (mechanics_benchmark, LogToughnessPacked), a sweep of a fit 12 and 22 %.
/// kLogSign is -1 for c, because dividing first makes the loop 16 % slower.
template <class S>
struct PackedPoint {
  S first, second;
};
template <class S>
struct PackedForm {
  S argument, excess, slope, curvature;
};

/// A function of N parameters with its gradient in them.
template <class S, std::size_t N>
struct Differentiated {
  S value;
  std::array<S, N> gradient;
};

/// The type of a law's parameters: Law::Parameters if the law defines it, else an array with one number for each.
template <class Law, class S>
struct ParametersOf {
  static constexpr std::size_t kMost = std::tuple_size_v<std::remove_cvref_t<decltype(Law::parameters)>>;
  using type = std::array<S, kMost>;
};
template <class Law, class S>
requires requires { typename Law::Parameters; }
struct ParametersOf<Law, S> {
  static constexpr std::size_t kMost = Law::kMostParameters;
  using type = typename Law::Parameters;
};

template <class Law, class S = double>
using Parameters = typename ParametersOf<Law, S>::type;

/// The largest number of parameters of a law of this type; a published law has exactly as many.
template <class Law>
inline constexpr std::size_t parameter_count = ParametersOf<Law, double>::kMost;

/// The parameters with these values, one for each parameter of the law.
template <class Law>
Parameters<Law> parameters_from(std::span<const double> values) {
  if constexpr (requires { Parameters<Law>(values); }) {
    return Parameters<Law>(values);
  } else {
    Parameters<Law> p;
    std::copy_n(values.begin(), p.size(), p.begin());
    return p;
  }
}

/// ln f without its derivatives.
template <class Law>
double log_toughness_alone(const Law& law, const Parameters<Law>& p, const Mixity<double>& mixity) {
  if constexpr (requires { law.log_toughness_alone(p, mixity); })
    return law.log_toughness_alone(p, mixity);
  else
    return law.log_toughness(p, mixity).value;
}

/// ln f to full relative accuracy, also near f = 1.
template <class Law, class S>
Differentiated<S, 1> log_toughness_of_packed_form(const std::array<S, 1>& p, const Mixity<S>& mixity) {
  using std::log, std::log1p;
  const PackedForm<S> form = Law::packed_form(p[0], Law::packed_point(mixity));
  const S value = form.excess > S(-0.5) ? S(log1p(form.excess)) : S(log(form.argument));
  return {S(Law::kLogSign) * value, {form.slope}};
}

/// tau^2 of the equilibrium circle at fixed T, with its first and second derivative in the edge load y.
template <class S>
struct ShearTerm {
  S value, d1, d2;
};

/// Upper bounds of the second derivatives of tau^2 over all y and T; infinite where unknown.
struct ShearBend {
  double TT = std::numeric_limits<double>::infinity(), yT = TT, yy = TT;
};

/// Bounds the change of tau^2's second derivatives, which are homogeneous of degree 0, around a state. Over a step w,
/// the larger of narrow dT/(T + T_part y) and narrow dy/(y + y_part T), the sums of moduli by which nearest_proof.h
/// bounds them grow at most by (1 + 8 w)^2, for w <= 1/4. `narrow` is infinite if unknown.
struct ShearReach {
  double narrow = std::numeric_limits<double>::infinity(), y_part = 0, T_part = 0;
};

/// The header of a published law specialises this for its slot; the registry collects the slots in order.
template <int Slot>
struct ModelSlot {};

}  // namespace mixity
