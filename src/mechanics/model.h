// What a mode-mixity model is: a toughness ratio f(psi) = G_c/G_Ic with named, bounded parameters.
//
// A model is a struct with static members only (see models/*.h):
//   parameters                          names, bounds and a typical value
//   info                                key on the command line, name, published formula
//   log_toughness(p, mixity)            ln f and its derivatives in the parameters
//   log_toughness_alone(p, mixity)      optional: ln f where its derivatives would cost more than it does
//   lane_point(mixity), lane(p, point)  optional: ln f for loops over many points, see LaneValue; lane_log_toughness
//                                       then makes log_toughness of it
//   shear_term(p, y, T)                 tau^2 = y^2 (g - 1) of the equilibrium circle and its derivatives in y
//   small_shear(p)                      lim tau^2/T^2 at T -> 0 (may be 0 or infinite)
//   shear_limit(p)                      optional: lim tau^2/y^2 at T -> infinity where it may be finite
//   shear_bend(p), shear_reach(p)       optional: how strongly tau^2 bends; without them a distance from a curve takes
//                                       a search of the whole curve
//   continuous(p)                       optional: the parameters next to these at which curves do not change abruptly
//   log_toughness_slope(p, y, T)        optional: d ln f/d p in a form without branches
//   tangential_load(p, y, tau)          optional: T of a state (y, tau) where that is a closed form
//   fold_offset(p, P, displacement)     optional: y - 3 pi where the curve folds, if that is a closed form
//   one_fold_at_most(p)                 optional: true if tau^2 + y^2 is convex in y at fixed T and tau grows with y
//   shear_on_circle(p, T)               only if tau does not depend on y: makes the equilibrium a closed form
//   tau_grows_with_edge_load(p)         true if d(tau^2)/dy >= 0 at fixed T for these parameters
//   turns(p)                            optional: true where g does not grow with psi throughout (turning_curve.h)
//   equilibrium_domain(p)               empty, or the reason why these parameters define no unique equilibrium
// and it fills the slot of its number: template <> struct ModelSlot<4> { using type = MyModel; };
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string_view>

#include "mechanics/constants.h"

namespace mixity {

/// Direction of the edge load: cos = K_I/|K|, sin = K_II/|K|, both in [0, 1]. Holding both keeps full relative
/// accuracy at psi -> 0 and at psi -> pi/2, which an angle cannot.
template <class S>
struct Mixity {
  S cos, sin;
};

/// From edge load y > 0 (or y = 0 with T > 0) and tangential load T >= 0.
template <class S>
Mixity<S> mixity_from_loads(const S& y, const S& T) {
  using std::sqrt;
  const bool steep = T > y;
  const S t = steep ? S(y / T) : S(T / y), larger = S(1) / sqrt(S(1) + t * t), smaller = t * larger;
  return {steep ? smaller : larger, steep ? larger : smaller};
}

/// 90 degrees as they come from degrees: the double behind the one nearest to pi/2.
inline constexpr double kLargestPhaseAngle = 1.5707963267948968;

/// From the phase angle psi [rad] in [0, pi/2]. The double nearest to pi/2 means pi/2.
inline Mixity<double> mixity_from_angle(double psi) {
  const double c = std::cos(psi);
  return {c < 1.3e-16 ? 0.0 : c, std::sin(psi)};
}

/// From the mode ratio B = G_II/(G_I + G_II) = sin^2 psi in [0, 1].
inline Mixity<double> mixity_from_mode_ratio(double B) { return {std::sqrt(1 - B), std::sqrt(B)}; }

/// From the energies of the two modes, whose sum is positive: sin^2 psi = G_II/(G_I + G_II). One below zero counts as
/// 0: measured about zero it may be, by noise.
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
  double typical;       // shown in help, and the start where nothing better is known
  double neutral = 0;   // > 0: where f = 1 whatever the other parameters; only the distance from it matters nearby
};

struct ModelInfo {
  std::string_view key;      // "a": what --models takes
  std::string_view name;     // "Johnson 1996"
  std::string_view formula;  // as published
};

/// One point as loops over many see it, and what a one-parameter law says of it: ln f = kLogSign log(argument) to an
/// absolute error of some eps, with its derivatives in the parameter; excess = argument - 1, which does not cancel. No
/// branches, so that compilers can take several points at once. The loop takes the logarithm of the argument, as log1p
/// of the excess costs 22 % more of the loop for a and 44 % for c (mechanics_benchmark, LogToughnessLanes), 12 and 22 %
/// of a sweep of a fit; for c kLogSign = -1, as 1/argument under the logarithm costs 16 % of the loop.
template <class S>
struct LanePoint {
  S first, second;
};
template <class S>
struct LaneValue {
  S argument, excess, slope, curvature;
};

/// A function of N parameters with its gradient in them.
template <class S, std::size_t N>
struct Differentiated {
  S value;
  std::array<S, N> gradient;
};

/// ln f without its derivatives.
template <class Law, std::size_t N>
double log_toughness_alone(const std::array<double, N>& p, const Mixity<double>& mixity) {
  if constexpr (requires { Law::log_toughness_alone(p, mixity); })
    return Law::log_toughness_alone(p, mixity);
  else
    return Law::log_toughness(p, mixity).value;
}

/// ln f of a law that has lanes to full relative accuracy: near f = 1 its argument has lost that of the excess.
template <class Law, class S>
Differentiated<S, 1> lane_log_toughness(const std::array<S, 1>& p, const Mixity<S>& mixity) {
  using std::log, std::log1p;
  const LaneValue<S> lane = Law::lane(p[0], Law::lane_point(mixity));
  const S value = lane.excess > S(-0.5) ? S(log1p(lane.excess)) : S(log(lane.argument));
  return {S(Law::kLogSign) * value, {lane.slope}};
}

/// tau^2 of the equilibrium circle at fixed T, with its first and second derivative in the edge load y.
template <class S>
struct ShearTerm {
  S value, d1, d2;
};

/// Upper bounds of |d^2 tau^2| over all y and T; infinite where nothing is known.
struct ShearBend {
  double TT = std::numeric_limits<double>::infinity(), yT = TT, yy = TT;
};

/// The second derivatives are homogeneous of degree 0. Over a way w, the larger of `narrow` times dT/(T + T_part y) and
/// narrow dy/(y + y_part T), the sums of moduli that curve_distance takes for them grow to (1 + 8 w)^2 of themselves at
/// most, up to w = 1/4: as much as y and T to the fourth power of opposite sign. `narrow` is infinite where nothing is
/// known.
struct ShearReach {
  double narrow = std::numeric_limits<double>::infinity(), y_part = 0, T_part = 0;
};

/// A model header fills the slot of its number; the registry collects the filled ones in order.
template <int Slot>
struct ModelSlot {};

}  // namespace mixity
