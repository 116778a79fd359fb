// The distance of a measured point from a point of an equilibrium curve, its derivatives, and the proof that no other
// point of the curve is nearer, for many measured points at once.
#pragma once

#include "mechanics/nearest_newton.h"
#include "mechanics/packed_toughness.h"

namespace mixity::nearest_detail {

template <class Law>
struct Result {
  Packed r, dP, dT, dA, distance, sure;
  Packed stationary;  // 1 where the offset from the measured point is along the normal
  Packed on_curve;    // 1 where F vanishes; Newton's steps also vanish where F is extremely steep
  Packed curvature;   // the second derivative of half the squared distance along the curve
  std::array<Packed, parameter_count<Law>> parameters;
};

/// d ln f/d parameters at fixed y and T; without branches where the law has a packed form.
template <class Law>
MIXITY_LOOP Parameters<Law> log_toughness_slope(const Law& law, const Parameters<Law>& p, double y, double T) {
  if constexpr (requires { law.log_toughness_slope(p, y, T); }) {
    return law.log_toughness_slope(p, y, T);
  } else if constexpr (HasPackedForm<Law>) {
    return {law.packed_form(p[0], law.packed_point(mixity_from_loads(y, T))).slope};
  } else {
    return law.log_toughness(p, mixity_from_loads(y, T)).gradient;
  }
}

/// r and its derivatives in P, T and A at a point Q of the curve, and whether no other point of the curve is nearer.
///
/// The proof: let d be the distance of Q, n its unit normal, and q another point that is no further away. Then |q -
/// Q|^2 <= 2 d n.(q - Q), because the measured point is Q + d n (up to sign; at an end the offset also points away from
/// the curve, which only helps). F(q) = F(Q) = 0 gives |grad F| |n.(q - Q)| <= L |q - Q|^2/2 with L the norm of the
/// second derivatives between them, so that q = Q wherever d L < |grad F|. L follows from bounds of tau^2's second
/// derivatives over all (y, T), or, where the circle of radius 2 d about Q is small in y and T, from their moduli at Q.
template <bool kDerivatives, class Law>
MIXITY_LOOP void measure(const CurveFamily<Law> family, const Block& b, Result<Law>& out) {
  for (std::size_t i = 0; i < kBlock; ++i) {
    const Local q = local_form(family, b, i);
    const double distance = std::sqrt(q.x * q.x + q.z * q.z);
    const bool end = b.at_end[i] > 0, settled = b.settled[i] > 0;
    const double signed_distance = q.along < 0 ? -distance : distance;
    // Rounding of Q does not matter along the normal; F/|grad F| is its distance from the curve.
    const double normal = q.along - q.F * q.per_size;
    // false where Newton's steps vanish at a corner (bk with eta < 1)
    const bool stationary = std::abs(q.slope) <= 1e-4 * distance + 1e-6;
    out.stationary[i] = stationary ? 1.0 : 0.0;
    // beside a corner (bk with eta < 1, T = 1e-80) F/|grad F| is tiny also off the curve
    const double v = q.y - 3 * pi<double>(), terms = v * v + 6 * pi<double>() * (above_pull_off(b.P[i]) + 5);
    const bool on_curve = family.uncoupled | (std::abs(q.F) <= 1e-8 * terms);
    out.on_curve[i] = on_curve ? 1.0 : 0.0;
    out.r[i] = settled & !end & stationary ? normal : signed_distance;
    out.distance[i] = distance;
    out.curvature[i] = curvature(q);
    const double F_A = q.F_y * q.y_A, F_P = -(2 * q.y + q.d1);
    out.dP[i] = -F_P * q.per_size;
    out.dT[i] = -q.F_T * q.per_size;
    out.dA[i] = -F_A * q.per_size;
    if constexpr (kDerivatives) {
      const Parameters<Law> log_f = log_toughness_slope(family.law, family.p, q.y, b.T[i]);
      const double held = q.y * q.y + q.value;
      for (std::size_t k = 0; k < log_f.size(); ++k) out.parameters[k][i] = held * log_f[k] * q.per_size;
    }

    const double sT = b.sigma_T[i], sA = b.sigma_A[i], T = b.T[i], d = distance;
    const double step_T = 2 * d * sT, step_A = 2 * d * sA, step_y = 1.2 * step_A * q.y_A;
    const double m1 = std::abs(q.d1), m2 = std::abs(q.d2), W = q.inverse_T;
    const bool flat = !(T > 1e-130 * q.y);
    const double reach_T = T + family.reach.T_part * q.y, reach_y = q.y + family.reach.y_part * T;
    const double part_T = step_T * reach_y, part_y = step_y * reach_T;
    const double way = family.reach.narrow * (part_T > part_y ? part_T : part_y) / (reach_T * reach_y);
    const bool near = way <= 0.25;
    const double growth = (1 + 8 * way) * (1 + 8 * way);
    const double TT_sheared = (2 * (q.value + q.y * m1) + q.y * q.y * m2) * W * W, small = 3 * family.small;
    const double TT_here = flat ? small : TT_sheared;
    const double yT_here = (m1 + q.y * m2) * W, yy_here = m2 + m1 / (q.y + T);
    const auto least = [&](double here, double bound) {
      const double grown = growth * here;
      return near & (grown < bound) ? grown : bound;
    };
    const double TT = least(TT_here, family.bend.TT), yT = least(yT_here, family.bend.yT),
                 yy = 2 + least(yy_here, family.bend.yy);
    // A changes at most by a quarter, y_A by a factor 1.12 and y_AA by 1.16.
    const double slope = std::abs(q.F_y) + yy * step_y + yT * step_T;
    const double AA = (1.26 * yy * q.y_A * q.y_A + 1.16 * slope * q.y_AA) * sA * sA;
    const double TA = 1.12 * yT * q.y_A * sT * sA, TT_plane = TT * sT * sT;
    const double norm = (TT_plane > AA ? TT_plane : AA) + TA;
    const bool alone = (step_A <= 0.25 * b.A[i]) & ((end ? 2 : 1.05) * d * norm < q.size);
    out.sure[i] = family.uncoupled | (settled & (end | stationary) & on_curve & alone) ? 1.0 : 0.0;
  }
}

}  // namespace mixity::nearest_detail
