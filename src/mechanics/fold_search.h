// The searches among which locate_folds chooses, for folds.h and its tests.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "mechanics/folds.h"

namespace mixity {

// Where the search for folds begins and ends in the logistic coordinate: e^-42 = 6e-19 of the piece.
inline constexpr double kFirstCoordinate = -20;

/// Near Hertz the coordinate is about ln(T/y). There rounding, of relative size t^2 eps, destroys the slope of a user's
/// law in t, so that any fold found would be noise.
template <class Law>
inline constexpr double kLastCoordinate = kMayBeNonMonotone<Law> ? 27 : 42;

/// A pair of folds shallower than this is rounding, not a jump.
inline constexpr double kShallow = 2e-15;

/// The driving quantity along the curve.
template <class Law>
struct Driven {
  const EquilibriumCurve<Law>& curve;
  Control control;

  double radius(const CurvePosition& at) const { return radius_from_edge_load(at.y, curve.load()); }

  /// Weight w of u in the driving quantity w u + (1 - w) T: 0 for load, 1 for displacement, k/(1 + k) for a spring. 1 -
  /// w has its own function, since it would cancel for a stiff spring.
  double share() const {
    if (control.kind == Control::Kind::stiffness) return control.stiffness / (1 + control.stiffness);
    return control.kind == Control::Kind::displacement ? 1 : 0;
  }
  double rest() const { return control.kind == Control::Kind::stiffness ? 1 / (1 + control.stiffness) : 1 - share(); }

  /// w u + (1 - w) T, with T limited to kInfiniteT.
  double value(const CurvePosition& at) const {
    const double T = std::min(curve.tangential_load(at), kInfiniteT);
    return share() * std::min(0.75 * T / radius(at), kInfiniteT) + rest() * T;
  }

  /// Positive where the value grows as y falls (stable), 0 at a fold. Scaled by the size of its terms, so that a few
  /// eps are rounding.
  double slope(const CurvePosition& at) const {
    // Just before an asymptote the computed T is infinite; tau^2 is then that of any large T.
    const double tau2 = curve.tau_squared(at), T = std::min(curve.tangential_load(at), kInfiniteT);
    const double d1 = curve.law().shear_term(curve.parameters(), at.y, T).d1;
    const double twice = 2 * curve.offset(at), R_y = twice + d1, size = std::abs(twice) + std::abs(d1);
    const double load = (3 * share() + 4 * radius(at) * rest()) * (at.y + curve.load());
    const double all = size * load + share() * (2 * tau2 + std::abs(at.y * d1));
    return all > 0 ? (R_y * load + share() * (2 * tau2 - at.y * d1)) / all : 0;
  }
};

/// Collects the first `at_most` folds of a curve. Skips those near the largest load, which are rounding.
struct FoundFolds {
  std::size_t at_most;
  std::vector<FoldPlace> places{};

  /// Returns whether the search should go on.
  bool add(const FoldPlace& place) {
    if (place.T < 0.1 * kInfiniteT) places.push_back(place);
    return places.size() < at_most;
  }
};

/// Searches under any control along each piece of the curve. T of a position may take an iteration.
template <class Law>
void folds_by_position(const EquilibriumCurve<Law>& curve, Control control, FoundFolds& found);

/// Searches under load control along the phase angle, from which y and T follow in closed form. False, without folds,
/// if the first fold lies at less shear than doubles resolve.
template <class Law>
bool folds_by_angle(const EquilibriumCurve<Law>& curve, FoundFolds& found);

/// v = y - 3 pi and T of a fold under load control.
struct LoadFold {
  double v, T;
};

/// Newton's method on R = R_y = 0 in v and T; R's derivatives in T follow from its homogeneity. Null if it leaves y > 0
/// (the curve may reach Hertz without a fold) or does not converge.
template <class Law>
std::optional<LoadFold> newton_fold(const Law& law, const Parameters<Law>& p, double P, double v, double T);

}  // namespace mixity
