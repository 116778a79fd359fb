// Judges a predicted area by the printed equation in 50 digits.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "mechanics/equilibrium.h"
#include "mechanics/printed_equation.h"
#include "mechanics/states.h"

namespace mixity {

using truth::Digits50;

template <class Model>
struct Judge {
  Parameters<Model> p;
  double P, T;

  Digits50 residual(const Digits50& y, const Digits50& shear) const {
    if (T < 1e15) return truth::residual_of<Model>(p, P, y, shear);
    using truth::Digits700;
    return Digits50(truth::residual_of<Model, Digits700>(p, P, Digits700(y), Digits700(shear)));
  }
  Digits50 edge_load_of(const Digits50& A) const {
    const Digits50 a = sqrt(Digits50(A / truth::kPi));
    return Digits50(4) / 3 * a * a * a - P;
  }
  /// True if the printed equation changes sign between areas within this relative distance of A. The middle is asked,
  /// too: near a fold it may lie between two roots.
  bool brackets(double A, double tolerance) const {
    const Digits50 low = edge_load_of(Digits50(A) * (1 - Digits50(tolerance)));
    const Digits50 high = edge_load_of(Digits50(A) * (1 + Digits50(tolerance)));
    const Digits50 middle = edge_load_of(A);
    const bool below = low <= 0 || residual(low, T) <= 0 || residual(middle, T) <= 0;
    return below && residual(high, T) >= 0;
  }
  /// The same for some distance up to the tolerance: near a fold the next root may lie closer than that.
  bool root_within(double A, double tolerance) const {
    for (double t = std::min(4e-15, tolerance); t < 2 * tolerance; t *= 2)
      if (brackets(A, std::min(t, tolerance))) return true;
    return false;
  }
  /// How many times a relative change of T, P or of the equation's own terms is magnified in A.
  double condition(double y) const {
    const Digits50 h = Digits50(1e-12) * y, k = Digits50(1e-12) * T;
    const Digits50 R_y = (residual(y + h, T) - residual(y - h, T)) / (2 * h);
    const Digits50 R_T = T > 0 ? Digits50((residual(y, T + k) - residual(y, T - k)) / (2 * k)) : Digits50(0);
    const Digits50 terms = abs(R_T * T) + 6 * truth::kPi * std::abs(P);
    return static_cast<double>(Digits50(terms / (abs(R_y) * (Digits50(y) + P) * 1.5)));
  }
  /// True if the printed equation is positive at places between y and JKR: no root lies there, as must be above the
  /// upper branch. In double, which can tell; what it denies is asked again in 50 digits.
  bool nothing_above(double y) const {
    const double top = 3 * pi<double>() + circle_radius(P);
    if (top - y < 1e-9 * top) return true;  // nothing lies between
    for (int i = 1; i < 40; ++i) {
      const double z = y + (top - y) * (1e-4 + (1 - 2e-4) * i / 40);
      if (!(truth::residual_of<Model, double>(p, P, z, T) >= 0) && residual(z, T) < 0) return false;
    }
    return true;
  }
  /// True if it is positive from JKR down to where the contact would have vanished: over a grid, and at the bottom of
  /// its deepest dip, where `far` in relation to its terms tells a root from rounding.
  bool nothing_at_all() const {
    const double top = 3 * pi<double>() + circle_radius(P), low = std::max(0.0, -P);
    const auto place = [&](double x) { return low + (top - low) * x * x; };
    const auto value = [&](double x) { return truth::residual_of<Model, double>(p, P, place(x), T); };
    constexpr int kPlaces = 40;
    int deepest = 1;
    for (int i = 2; i < kPlaces; ++i)
      if (value(1.0 * i / kPlaces) < value(1.0 * deepest / kPlaces)) deepest = i;
    double from = (deepest - 1.0) / kPlaces, to = (deepest + 1.0) / kPlaces;
    for (int i = 0; i < 40; ++i) {
      const double one = from + 0.382 * (to - from), two = to - 0.382 * (to - from);
      (value(one) < value(two) ? to : from) = value(one) < value(two) ? two : one;
    }
    const double x = 0.5 * (from + to), far = 1e-12 * 6 * pi<double>() * (place(x) + std::abs(P));
    return value(x) >= -far || residual(place(x), T) >= -far;
  }
  /// How far T lies beyond the fold at an edge load near y, as a part of what rounding may do to the fold's load; null
  /// if no fold is there.
  ///
  /// At the fold R = (y - 3 pi)^2 + tau^2 - S0^2 and R_y vanish, and R_T T = 2 tau^2 - y tau^2_y = 6 pi (y + 2 P),
  /// since tau^2 is homogeneous of degree 2 in y and T. The least R over y at this T is R_T (T - T_f). Terms of R that
  /// are right to e (S0^2, of which tau^2 is a part, and (y - 3 pi)^2, to which a rounding of y does 2 (y - 3 pi) y e)
  /// move T_f by the part e (S0^2 + 2 |y - 3 pi| y)/(R_T T): e/2 for c, e/(2 eta) for bk where eta < 1 and B is small.
  /// At least e, T's own rounding; and where T is denormal, what its last place is of it.
  struct Fold {
    double y, beyond;
  };
  std::optional<Fold> fold_near(double start) const {
    constexpr double e = 4e-15;
    Digits50 y = start, least = 0;
    for (int i = 0; i < 3; ++i) {
      const Digits50 h = Digits50(1e-12) * y, here = residual(y, T), up = residual(y + h, T), down = residual(y - h, T);
      const Digits50 slope = (up - down) / (2 * h), bend = (up - 2 * here + down) / (h * h), step = -slope / bend;
      if (!(bend > 0) || abs(step) > Digits50(1e-4) * (y + std::abs(P))) return std::nullopt;
      y += step;
      least = here + slope * step / 2;
    }
    const Digits50 growth = 6 * truth::kPi * (y + 2 * Digits50(P)), offset = y - 3 * truth::kPi;
    const Digits50 size = 9 * truth::kPi * truth::kPi + 6 * truth::kPi * P + 2 * abs(offset) * y;
    const double rounding = static_cast<double>(Digits50(e * size / growth));
    const double allowed = std::max(rounding, e) + std::numeric_limits<double>::denorm_min() / T;
    return Fold{static_cast<double>(y), static_cast<double>(Digits50(least / growth)) / allowed};
  }
  /// Relative distance of the area at y from the root that Newton's method in 50 digits goes to. Null where that step
  /// says nothing: at y = 0, or where the slope vanishes or is that of another branch.
  std::optional<double> error_at(double y) const {
    if (!(y > 0)) return std::nullopt;
    const Digits50 h = Digits50(1e-20) * y, here = residual(y, T), slope = (residual(y + h, T) - here) / h;
    if (!(slope > 0)) return std::nullopt;
    return static_cast<double>(Digits50(abs(here / slope) / (Digits50(y) + P))) * 2 / 3;
  }
};

/// What is wrong with the area `found` at T, empty if nothing; `error` is its relative error where that is known.
///
/// Within a few roundings away from folds; towards one, what the condition number leaves of a double, and at the fold
/// itself (where it is infinite) sqrt(eps), or at the cusp of model a, where three states meet, its cube root. Where
/// T is the fold's to what rounding may do to that, the fold's area is right: the equation may have no root there, or
/// two that no double lies between.
template <class Model>
std::string wrong_with_area(const LoadedContact<Model>& contact, const Judge<Model>& judge, const Equilibrium& found,
                            double& error) {
  error = 0;
  if (found.status == EquilibriumStatus::invalid) return "invalid";
  if (found.status == EquilibriumStatus::no_equilibrium) {
    if (!(judge.T > contact.last_load())) return "no equilibrium, but the contact lasts to a larger T";
    if (!judge.nothing_at_all()) return "no equilibrium, but the printed equation has a root";
    const bool at_fold = judge.T < contact.last_load() * (1 + 1e-6);
    const auto fold = at_fold ? judge.fold_near(contact.branches().back().y_bottom) : std::nullopt;
    return fold && fold->beyond < -1 ? "no equilibrium, but the fold lies at a larger T" : "";
  }
  const ContactState state = contact_state(judge.P, judge.T, found.y);
  for (const double value : {state.y, state.a, state.A, state.u, state.psi, state.f})
    if (!std::isfinite(value)) return "not finite";
  if (!judge.nothing_above(found.y)) return "a root lies above";
  const auto quick = judge.error_at(found.y);
  if (quick) error = *quick;
  if (quick && *quick <= 4e-15) return "";
  const double condition = found.y > 0 ? judge.condition(found.y) : 1;
  const double at_fold = Model::info.key == "a" ? 2e-5 : 3e-7;
  const double tolerance = condition < 3 ? 4e-15 : std::min(4e-15 + 8e-16 * condition, at_fold);
  if (quick && *quick <= tolerance) return "";
  error = 0;
  if (judge.root_within(state.A, tolerance)) return "";
  const auto fold = judge.fold_near(found.y);
  const bool is_fold =
      fold && std::abs(fold->beyond) <= 1 && std::abs(found.y - fold->y) <= at_fold * (state.y + std::abs(judge.P));
  return is_fold ? "" : "no root within the tolerance";
}

template <class Model>
std::string wrong_with_area(const LoadedContact<Model>& contact, const Judge<Model>& judge, double& error) {
  return wrong_with_area(contact, judge, contact.at(judge.T), error);
}

}  // namespace mixity
