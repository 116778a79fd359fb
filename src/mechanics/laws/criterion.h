// The root of a fracture criterion. With K_I = exp(q/2) cos psi and K_II = exp(q/2) sin psi, an equation in K_I and
// K_II is one in q = ln(G_c/G_Ic). The root depends on the equation and the start alone, to the last bit.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "mechanics/laws/taylor.h"

namespace mixity {

/// A root q, and the slope of the equation in q there.
struct CriterionRoot {
  double q, slope;
};

/// Finds a root by Halley's steps from `start`; null where these do not halve, or pass over a nearer root. equation(q)
/// returns the function whose zero is sought, with two derivatives in q. For criteria in powers of the intensities,
/// log(left/right) is nearly linear in q: two or three evaluations suffice.
template <class Equation>
std::optional<CriterionRoot> contracted_root(const Equation& equation, double start) {
  constexpr double kFirst = 60;     // largest first step in ln f
  constexpr double kEnough = 1e-6;  // the cube of such a step is negligible
  constexpr double kBend = 1e-5;    // largest relative change of the slope in the last step; the error is its square
  constexpr int kMost = 12;
  double q = start, before = 2 * kFirst, at_start = 0;
  for (int i = 0; i < kMost; ++i) {
    const Taylor here = equation(q);
    if (i == 0) at_start = here.value;
    const double newton = -here.value / here.first;
    const double step = newton / std::clamp(1 + 0.5 * newton * here.second / here.first, 0.5, 2.0);
    if (!(std::abs(step) <= 0.5 * before)) return std::nullopt;  // or NaN
    q += step;
    before = std::abs(step);
    if (before > kEnough || std::abs(step * here.second) > kBend * std::abs(here.first)) continue;
    const CriterionRoot root{q, here.first + step * here.second};
    if (root.slope * (q - start) * at_start > 0) return std::nullopt;
    return root;
  }
  return std::nullopt;
}

/// The root nearest to 0 (to a factor of two in distance) with |q| <= 600, by a bracketing search of about 14
/// evaluations; null if there is none.
template <class Equation>
std::optional<CriterionRoot> enclosed_root(const Equation& equation) {
  constexpr double kFarthest = 600;
  Taylor here = equation(0);
  if (here.value == 0) return CriterionRoot{0, here.first};
  double beyond = 0;
  for (double step = 0.25; step <= kFarthest && beyond == 0; step *= 2)
    for (const double side : {step, -step})
      if (beyond == 0 && std::signbit(equation(side).value) != std::signbit(here.value)) beyond = side;
  if (beyond == 0) return std::nullopt;
  double low = std::min(0.0, beyond), high = std::max(0.0, beyond), q = 0.5 * beyond;
  const bool rises = std::signbit(equation(low).value);
  for (int i = 0; i < 200; ++i) {
    here = equation(q);
    if (here.value == 0) break;
    (std::signbit(here.value) == rises ? low : high) = q;
    double next = q - here.value / here.first;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    const bool settled = std::abs(next - q) <= 1e-9 * std::max(1.0, std::abs(q)) || next == low || next == high;
    q = next;
    if (settled) break;
  }
  here = equation(q);
  const double last = -here.value / here.first;
  if (!(std::abs(last) < 1e-6 * std::max(1.0, std::abs(q)))) return CriterionRoot{q, here.first};
  return CriterionRoot{q + last, here.first + last * here.second};
}

}  // namespace mixity
