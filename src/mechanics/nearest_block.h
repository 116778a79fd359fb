// The stages of nearest_newton.h and nearest_proof.h applied to a block of measured points.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "mechanics/nearest_proof.h"
#include "mechanics/states.h"

namespace mixity::nearest_detail {

/// In vectors if the law has a packed form; the loops of other laws are not vectorised.
template <class Law, class Stage>
void run_stage(const Stage& stage) {
  if constexpr (HasPackedForm<Law>)
    in_vectors(stage);
  else
    stage();
}

template <class Law>
void measure_block(const CurveFamily<Law>& family, bool derivatives, const Block& block, Result<Law>& result) {
  if (derivatives)
    run_stage<Law>([&] { measure<true>(family, block, result); });
  else
    run_stage<Law>([&] { measure<false>(family, block, result); });
}

/// Runs all stages. Begin::anywhere skips the search for a start.
template <Begin kBegin, class Law>
void run_block(const CurveFamily<Law>& family, int steps, bool derivatives, Block& block, Result<Law>& result) {
  if constexpr (kBegin != Begin::anywhere) run_stage<Law>([&] { set_ends(family, block); });
  if constexpr (kBegin == Begin::at_the_point) run_stage<Law>([&] { start(family, block); });
  run_stage<Law>([&] { settle(family, block, steps); });
  measure_block(family, derivatives, block, result);
}

/// All bits set if true: comparisons of doubles that are joined by & and | become vectors.
MIXITY_LOOP std::int64_t mask(bool is) { return is ? -1 : 0; }

/// The arrays of as many measured points as a block has slots.
struct BlockArrays {
  const double *P, *T, *A, *sigma_T, *sigma_A;
};

/// Fills all slots. False if a point cannot be a measured one.
MIXITY_LOOP bool fill_slots(const BlockArrays points, Block& __restrict block) {
  constexpr double kFinite = std::numeric_limits<double>::max();
  std::int64_t all = -1;
  for (std::size_t i = 0; i < kBlock; ++i) {
    const double P = points.P[i], T = std::abs(points.T[i]), A = points.A[i], sigma_T = points.sigma_T[i],
                 sigma_A = points.sigma_A[i];
    all &= mask(std::abs(P) <= kLargestLoad) & mask(above_pull_off(P) >= 0) & mask(T <= kLargestLoad) & mask(A > 0) &
           mask(A <= kFinite) & mask(sigma_T > 0) & mask(sigma_T <= kFinite) & mask(sigma_A > 0) &
           mask(sigma_A <= kFinite);
    block.P[i] = P;
    block.T_point[i] = T;
    block.A_point[i] = A;
    block.sigma_T[i] = sigma_T;
    block.sigma_A[i] = sigma_A;
    block.per_T[i] = 1 / sigma_T;
    block.per_A[i] = 1 / sigma_A;
  }
  return all != 0;
}

/// What holds for all slots of a block; idle ones repeat the last.
struct OfAll {
  bool inside, finite;  // settled between the ends of the curves; with their derivatives
};
/// `p`: the number of parameters, for which there may be more arrays.
template <class Law>
MIXITY_LOOP OfAll of_all(const Block& block, const Result<Law>& result, bool derivatives, std::size_t p) {
  std::int64_t inside = -1, finite = -1;
  const auto check = [&finite](const Packed& values) {
    for (std::size_t i = 0; i < kBlock; ++i)
      finite &= mask(std::abs(values[i]) <= std::numeric_limits<double>::max());
  };
  for (std::size_t i = 0; i < kBlock; ++i) inside &= mask(block.settled[i] > 0) & ~mask(block.at_end[i] > 0);
  check(result.r);
  check(result.dA);
  if (derivatives) {
    check(result.dP);
    check(result.dT);
    for (std::size_t k = 0; k < p; ++k) check(result.parameters[k]);
  }
  return {inside != 0, finite != 0};
}

/// The arrays that a block is written to; null are derivatives or places that are not wanted.
struct WrittenArrays {
  const double* T_point;  // measured, with their signs
  double *r, *T, *A, *dP, *dT, *dA, *parameters;
};

template <class Law>
MIXITY_LOOP void write_slots(const Block& block, const Result<Law>& result, std::size_t count, std::size_t p,
                             const WrittenArrays& to) {
  for (std::size_t i = 0; i < count; ++i) to.r[i] = result.r[i];
  for (std::size_t i = 0; to.A && i < count; ++i) to.T[i] = block.T[i];
  for (std::size_t i = 0; to.A && i < count; ++i) to.A[i] = block.A[i];
  if (!to.dA) return;
  for (std::size_t i = 0; i < count; ++i) to.dP[i] = result.dP[i];
  for (std::size_t i = 0; i < count; ++i) to.dT[i] = result.dT[i] * std::copysign(1.0, to.T_point[i]);
  for (std::size_t i = 0; i < count; ++i) to.dA[i] = result.dA[i];
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < p; ++k) to.parameters[i * p + k] = result.parameters[k][i];
}

/// Starts all slots at these places. False if one has none.
MIXITY_LOOP bool begin_slots(const double* __restrict T, const double* __restrict A, Block& __restrict block) {
  std::int64_t all = -1;
  for (std::size_t i = 0; i < kBlock; ++i) {
    block.T[i] = T[i];
    block.A[i] = A[i];
    all &= mask(A[i] > 0);
  }
  return all != 0;
}

inline void set_point(Block& block, std::size_t slot, const PlanePoints& points, std::size_t i) {
  block.P[slot] = points.P[i];
  block.T_point[slot] = std::abs(points.T[i]);
  block.A_point[slot] = points.A[i];
  block.sigma_T[slot] = points.sigma_T[i];
  block.sigma_A[slot] = points.sigma_A[i];
  block.per_T[slot] = 1 / points.sigma_T[i];
  block.per_A[slot] = 1 / points.sigma_A[i];
}

/// Fills a block with `count` points; the idle slots repeat the last. False if a point cannot be a measured one.
inline bool set_points(Block& block, const PlanePoints& points, std::size_t from, std::size_t count) {
  const std::span<const double> lists[] = {points.P, points.T, points.A, points.sigma_T, points.sigma_A};
  std::array<Packed, std::size(lists)> repeated;
  std::array<const double*, std::size(lists)> arrays;
  for (std::size_t k = 0; k < arrays.size(); ++k) {
    arrays[k] = &lists[k][from];
    if (count == kBlock) continue;
    for (std::size_t slot = 0; slot < kBlock; ++slot) repeated[k][slot] = lists[k][from + std::min(slot, count - 1)];
    arrays[k] = repeated[k].data();
  }
  const BlockArrays all{arrays[0], arrays[1], arrays[2], arrays[3], arrays[4]};
  return in_vectors([&] { return fill_slots(all, block); });
}

/// Replaces the derivatives in `out`, those of -F/|grad F|, by those of the distance from an end or a corner of the
/// curve. Its A depends on the load alone, with dA/dP = A_P; its T is constant (T_stays) or changes so that F = 0.
template <class Law>
void measure_from_end(const Block& block, std::size_t i, double A_P, bool T_stays, Result<Law>& out) {
  const double r = out.r[i];
  if (r == 0) return;
  const double e_T = (block.T[i] - block.T_point[i]) / block.sigma_T[i] / (r * block.sigma_T[i]);
  const double e_A = (block.A[i] - block.A_point[i]) / block.sigma_A[i] / (r * block.sigma_A[i]);
  const double per_T = T_stays ? 0 : -e_T / out.dT[i];
  out.dP[i] = per_T * (out.dA[i] * A_P + out.dP[i]) + e_A * A_P;
  for (auto& slope : out.parameters) slope[i] *= per_T;
  out.dT[i] = -e_T;
  out.dA[i] = -e_A;
}

/// A point of a curve, and its distance from the measured one.
struct Place {
  double T, A, distance;
};

inline double distance_to(const Block& b, std::size_t i, double T, double A) {
  return std::hypot((T - b.T_point[i]) / b.sigma_T[i], (A - b.A_point[i]) / b.sigma_A[i]);
}

/// The nearest of three points of the curve: JKR, Hertz if the curve ends there, and the one in the direction of the
/// measured point as seen from the circle's centre.
template <class Law>
Place known_place(const CurveFamily<Law>& family, const Block& block, std::size_t slot) {
  const double P = block.P[slot], centre = 3 * pi<double>(), S0 = circle_radius(P), jkr = centre + S0;
  Place best{0, area_from_radius(jkr_radius(P)), 0};
  if (family.uncoupled) best.T = block.T_point[slot];
  best.distance = distance_to(block, slot, best.T, best.A);
  const auto consider = [&](double T, double A) {
    const double distance = distance_to(block, slot, T, A);
    if (distance < best.distance) best = {T, A, distance};
  };
  consider(block.T_end[slot], block.A_end[slot]);
  const double A = block.A_point[slot], T = block.T_point[slot];
  if constexpr (kMayBeNonMonotone<Law>) {
    if (family.non_monotone) {  // the third point is at the measured T/y instead
      const double t = T / std::max(edge_load(radius_from_area(A), P), 1e-3 * jkr);
      if (const auto y_there = NonMonotoneCurve<Law>(family.law, family.p, P).upper_edge_load(t))
        consider(t * *y_there, area_from_edge_load(*y_there, P));
      return best;
    }
  }
  const double end = std::max(edge_load(radius_from_area(block.A_end[slot]), P), 0.0), least = end + 1e-3 * (jkr - end);
  const double y = std::max(edge_load(radius_from_area(A), P), least), v = y - centre;
  const double tau2 = std::max(family.law.shear_term(family.p, y, T).value, 0.0), radius = std::sqrt(v * v + tau2);
  const double y_radial = std::max(centre + v * S0 / radius, least), v_radial = y_radial - centre;
  const double tau = std::sqrt(std::max((S0 - v_radial) * (S0 + v_radial), 0.0));
  if (!family.uncoupled)
    consider(tangential_load(family.law, family.p, y_radial, tau), area_from_edge_load(y_radial, P));
  return best;
}

}  // namespace mixity::nearest_detail
