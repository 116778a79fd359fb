// Newton's method for the nearest points of equilibrium curves to many measured points at once: the vectorised loops of
// curve_distance.cc. Their length is constant, so that the result for a point does not depend on its neighbours.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "mechanics/contact.h"
#include "mechanics/cube_root.h"
#include "mechanics/curve.h"
#include "mechanics/registry.h"
#include "mechanics/vector_math.h"

namespace mixity::nearest_detail {

constexpr std::size_t kBlock = 16;
constexpr double kPerPi = 0.3183098861837907;
using Packed = std::array<double, kBlock>;

struct Block {
  Packed P, T_point, A_point, sigma_T, sigma_A;  // measured
  Packed per_T, per_A;                           // 1/sigma_T, 1/sigma_A
  Packed T, A;                                   // the point on the curve
  Packed y_end, T_end, A_end;                    // where the curve ends: Hertz, or an asymptote (T_end infinite)
  Packed settled, at_end;                        // 1 or 0
};

/// What the curves of a law at all loads have in common.
template <class Law>
struct CurveFamily {
  [[no_unique_address]] Law law;
  Parameters<Law> p;
  bool non_monotone;
  bool uncoupled;  // shear does not affect the area: A = A_JKR for every T
  double small;    // tau^2/T^2 at T -> 0
  double hertz;    // tau^2/T^2 at y = 0
  bool bounded;    // T -> infinity at an edge load > 0, where tau^2/y^2 has reached `excess`
  double excess;
  ShearBend bend;
  ShearReach reach;

  CurveFamily(const Law& of, const Parameters<Law>& parameters)
      : law(of),
        p(parameters),
        non_monotone(is_non_monotone(law, p)),
        uncoupled(!non_monotone && !(law.shear_term(p, 1.0, 1.0).value > 0)),
        small(law.small_shear(p)),
        hertz(law.shear_term(p, 0.0, 1.0).value),
        bounded(std::isfinite(shear_limit(law, p))),
        excess(bounded ? shear_limit(law, p) : 0.0) {
    if constexpr (requires { law.shear_bend(p); }) bend = law.shear_bend(p);
    if constexpr (requires { law.shear_reach(p); }) reach = law.shear_reach(p);
  }
};

/// Equilibrium at (T, A) and its derivatives, in the plane of T/sigma_T and A/sigma_A.
struct Local {
  double a, y, y_A, y_AA;                // radius, edge load, dy/dA, d2y/dA2
  double F, size, per_size;              // F, |grad F| and 1/|grad F|
  double n_T, n_A, along, slope;         // unit normal; the offset from the measured point along it and the tangent
  double F_y, TT, TA, AA;                // second derivatives in the plane
  double x, z;                           // the offset from the measured point
  double F_T, value, d1, d2, inverse_T;  // in T, and tau^2
};

template <class Law>
MIXITY_LOOP Local local_form(const CurveFamily<Law> family, const Block& b, std::size_t i) {
  const double centre = 3 * pi<double>(), P = b.P[i], T = b.T[i], A = b.A[i];
  Local q;
  q.a = std::sqrt(A * kPerPi);
  const double y = (4 / (3 * pi<double>())) * A * q.a - P;
  q.y = y > 1e-100 ? y : 1e-100;
  const ShearTerm<double> tau2 = family.law.shear_term(family.p, q.y, T);
  const bool flat = !(T > 1e-130 * q.y);  // T^2 is negligible
  q.value = flat ? 0.0 : tau2.value;
  q.d1 = flat ? 0.0 : tau2.d1;
  q.d2 = flat ? 0.0 : tau2.d2;
  q.inverse_T = 1 / (flat ? q.y : T);
  const bool upper = q.y > 4;  // which form does not cancel, as in circle_residual
  const double v = q.y - centre, square = 2 * centre * above_pull_off(P);
  const double squared = v * v, expanded = q.y * (q.y - 2 * centre), rest = 2 * centre * P;
  q.F = ((upper ? squared : expanded) + (upper ? -square : 0.0) + q.value) - (upper ? 0.0 : rest);
  q.y_A = (2 / pi<double>()) * q.a;
  q.y_AA = kPerPi * kPerPi / q.a;
  q.F_y = 2 * v + q.d1;
  q.F_T = (2 * q.value - q.y * q.d1) * q.inverse_T;  // tau^2 is homogeneous of degree 2
  const double F_yT = (q.d1 - q.y * q.d2) * q.inverse_T;
  const double F_TT_sheared = (2 * (q.value - q.y * q.d1) + q.y * q.y * q.d2) * q.inverse_T * q.inverse_T;
  const double small = 2 * family.small, F_TT = flat ? small : F_TT_sheared;
  const double sT = b.sigma_T[i], sA = b.sigma_A[i];
  q.TT = F_TT * sT * sT;
  q.TA = F_yT * q.y_A * sT * sA;
  q.AA = ((2 + q.d2) * q.y_A * q.y_A + q.F_y * q.y_AA) * sA * sA;
  const double g_T = q.F_T * sT, g_A = q.F_y * q.y_A * sA;
  q.size = std::sqrt(g_T * g_T + g_A * g_A);
  q.per_size = 1 / q.size;
  q.n_T = g_T * q.per_size;
  q.n_A = g_A * q.per_size;
  q.x = (T - b.T_point[i]) * b.per_T[i];
  q.z = (A - b.A_point[i]) * b.per_A[i];
  q.along = q.x * q.n_T + q.z * q.n_A;
  q.slope = q.x * q.n_A - q.z * q.n_T;
  return q;
}

/// Area of the load y + P: pi (3/4 load)^(2/3).
MIXITY_LOOP double area_of_load(double load) {
  const double a = cube_root(0.75 * (load > 1e-100 ? load : 1e-100));
  return pi<double>() * a * a;
}

/// Where the curve of a load ends: at Hertz or at an asymptote (T infinite). A = 0 if it ends at T = 0.
struct CurveBounds {
  double y, T, A;
};

template <class Law>
MIXITY_LOOP CurveBounds curve_bounds(const CurveFamily<Law> family, double P) {
  const double centre = 3 * pi<double>(), infinite = std::numeric_limits<double>::infinity();
  const double square = 2 * centre * (above_pull_off(P) + P * family.excess);
  const bool asymptote = family.bounded & (square >= 0), hertz = !asymptote & (P > 0);
  const double upper = (centre + std::sqrt(square >= 0 ? square : 0.0)) / (1 + family.excess);
  const double y = asymptote ? upper : 0.0, A = area_of_load(y + P), ratio = 2 * centre * P / family.hertz;
  const double T = std::sqrt(ratio > 0 ? ratio : 0.0);
  return {y, hertz ? T : infinite, asymptote | hertz ? A : 0.0};
}

enum class Begin {
  at_the_point,  // from a point of the curve that `start` finds
  nearby,        // from the points that the block contains
  anywhere       // like nearby, with as many steps as needed; the ends of the curves are already set
};

/// Sets the end of each curve.
template <class Law>
MIXITY_LOOP void set_ends(const CurveFamily<Law> family, Block& b) {
  for (std::size_t i = 0; i < kBlock; ++i) {
    const CurveBounds end = curve_bounds(family, b.P[i]);
    b.y_end[i] = end.y;
    b.T_end[i] = end.T;
    b.A_end[i] = end.A;
    b.settled[i] = family.uncoupled ? 1.0 : 0.0;
    b.at_end[i] = 0;
  }
}

/// Sets the nearest of four start points: on the circle at the measured T, at the measured A, in the measured point's
/// direction from the centre (exact on the curve, regular at the fold), and the end. T is taken as proportional to tau,
/// which is exact for c.
template <class Law>
MIXITY_LOOP void start(const CurveFamily<Law> family, Block& b) {
  const double centre = 3 * pi<double>();
  const double infinite = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < kBlock; ++i) {
    const double P = b.P[i], square = 2 * centre * above_pull_off(P), S0 = std::sqrt(square), y_end = b.y_end[i];
    const double T = b.T_point[i], A = b.A_point[i], sT = b.sigma_T[i], sA = b.sigma_A[i];
    const double y_measured = (4 / (3 * pi<double>())) * A * std::sqrt(A * kPerPi) - P;
    const double least = y_end + 1e-3 * (centre + S0 - y_end), y = y_measured > least ? y_measured : least;
    const double v = y - centre, tau2 = family.law.shear_term(family.p, y, T).value;
    const bool sheared = tau2 > 0;
    const double tau = std::sqrt(sheared ? tau2 : 0.0), per_tau = sheared ? T / tau : 0.0;
    double T_best = T, A_best = A, best = infinite;
    const auto consider = [&](bool valid, double T_new, double A_new) {
      const double x = (T_new - T) / sT, z = (A_new - A) / sA, distance = x * x + z * z;
      const bool better = valid & (distance < best);
      best = better ? distance : best;
      T_best = better ? T_new : T_best;
      A_best = better ? A_new : A_best;
    };
    const double room = square - tau2, width = square - v * v;
    const double radius = std::sqrt(v * v + tau2), scale = S0 / radius, y_radial = centre + v * scale;
    consider(!(room < 0), T, area_of_load(centre + std::sqrt(room > 0 ? room : 0.0) + P));
    consider(!family.uncoupled & (radius > 0) & (y_radial > y_end), T * scale, area_of_load(y_radial + P));
    consider((width >= 0) & sheared & (y_measured > least), per_tau * std::sqrt(width > 0 ? width : 0.0), A);
    consider(b.T_end[i] < infinite, b.T_end[i], b.A_end[i]);
    b.T[i] = T_best;
    b.A[i] = A_best;
  }
}

/// The second derivative of half the squared distance along the curve; 1 for a straight line.
MIXITY_LOOP double curvature(const Local& q) {
  const double t_T = q.n_A, t_A = -q.n_T;
  const double bend = t_T * (q.TT * t_T + q.TA * t_A) + t_A * (q.TA * t_T + q.AA * t_A);
  return 1 - q.along * q.per_size * bend;
}

/// One step of each slot that is not settled: Newton's method on F = 0 and on the slope of the distance along the
/// curve, that is, on the Lagrangian of the least distance. Its curvature is kept positive, so that it finds minima.
template <class Law>
MIXITY_LOOP void step(const CurveFamily<Law> family, Block& b) {
  constexpr double kLeastCurvature = 0.1, kDone = 1e-8;
  Packed T, A, settled, at_end;
  for (std::size_t i = 0; i < kBlock; ++i) {
    const Local q = local_form(family, b, i);
    const double t_T = q.n_A, t_A = -q.n_T, normal = -q.F * q.per_size, multiplier = -q.along * q.per_size;
    const double h_T = q.TT * t_T + q.TA * t_A, h_A = q.TA * t_T + q.AA * t_A;
    const double curvature = 1 + multiplier * (t_T * h_T + t_A * h_A), cross = multiplier * (q.n_T * h_T + q.n_A * h_A);
    const double along_curve =
        -(q.slope + cross * normal) / (curvature > kLeastCurvature ? curvature : kLeastCurvature);
    double dT = (normal * q.n_T + along_curve * t_T) * b.sigma_T[i];
    double dA = (normal * q.n_A + along_curve * t_A) * b.sigma_A[i];
    const double T_old = b.T[i], A_old = b.A[i], end = b.A_end[i];
    // The error after such a step is of the order of its square.
    const bool small = (std::abs(dT) <= kDone * (T_old + 1e-2 * q.y)) & (std::abs(dA) <= kDone * A_old) &
                       (std::abs(dA) * q.y_A <= kDone * (q.y + 1e-6 * A_old * q.a));
    const double most_T = T_old + q.y + (std::abs(q.x) + 1) * b.sigma_T[i], most_A = 0.5 * A_old;
    const double size_T = std::abs(dT) * most_A, size_A = std::abs(dA) * most_T, most = most_T * most_A;
    const double larger = size_A > size_T ? size_A : size_T, share = most / (larger > most ? larger : most);
    const double A_new = A_old + share * dA, T_new = std::abs(T_old + share * dT);
    const bool has_hertz = b.T_end[i] < std::numeric_limits<double>::infinity(),
               beyond = A_new < (has_hertz ? end : end * (1 - 1e-11));
    const bool stays = has_hertz & beyond & (A_old == end) & (T_old == b.T_end[i]);
    const double T_end = b.T_end[i], A_inside = 0.5 * (end + A_old), A_back = has_hertz ? end : A_inside;
    T[i] = has_hertz & beyond ? T_end : T_new;
    A[i] = beyond ? A_back : A_new;
    settled[i] = (small & !beyond) | stays ? 1.0 : 0.0;
    at_end[i] = stays ? 1.0 : 0.0;
  }
  for (std::size_t i = 0; i < kBlock; ++i) {
    const bool moves = !(b.settled[i] > 0);  // a settled slot keeps its bits while its neighbours move
    b.T[i] = moves ? T[i] : b.T[i];
    b.A[i] = moves ? A[i] : b.A[i];
    b.at_end[i] = moves ? at_end[i] : b.at_end[i];
    b.settled[i] = moves ? settled[i] : b.settled[i];
  }
}

template <class Law>
MIXITY_LOOP void settle(const CurveFamily<Law> family, Block& b, int steps) {
  for (int k = 0; k < steps; ++k) {
    double left = 0;
    for (std::size_t i = 0; i < kBlock; ++i) left += 1 - b.settled[i];
    if (left == 0) break;
    step(family, b);
  }
}

}  // namespace mixity::nearest_detail
