// Judges a predicted area by the printed equation in 50 digits.
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include "mechanics/equilibrium.h"
#include "mechanics/prediction.h"
#include "mechanics/printed_equation.h"

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
  /// The printed residual in double at places above y: positive if no root lies there, as must be on the upper branch.
  bool nothing_above(double y) const {
    const double top = 3 * pi<double>() + circle_radius(P);
    for (int i = 1; i < 40; ++i) {
      const double z = y + (top - y) * (1e-4 + (1 - 2e-4) * i / 40);
      if (residual(z, T) < 0) return false;
    }
    return true;
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

/// What is wrong with the area found at T, empty if nothing; `error` is its relative error where that is known.
///
/// Within a few roundings away from folds; towards one, what the condition number leaves of a double, and at the fold
/// itself (where it is infinite) sqrt(eps), or at the cusp of model a, where three states meet, its cube root.
template <class Model>
std::string wrong_with_area(const LoadedContact<Model>& contact, const Judge<Model>& judge, double& error) {
  error = 0;
  const Equilibrium found = contact.at(judge.T);
  if (found.status == EquilibriumStatus::invalid) return "invalid";
  if (found.status == EquilibriumStatus::no_equilibrium)
    return judge.T > contact.last_load() ? "" : "no equilibrium, but the contact lasts to a larger T";
  const ContactState state = contact_state(judge.P, judge.T, found.y);
  for (const double value : {state.y, state.a, state.A, state.u, state.psi, state.f})
    if (!std::isfinite(value)) return "not finite";
  const auto quick = judge.error_at(found.y);
  if (quick) error = *quick;
  if (quick && *quick <= 4e-15) return "";
  const double condition = found.y > 0 ? judge.condition(found.y) : 1;
  const double at_fold = Model::info.key == "a" ? 2e-5 : 3e-7;
  const double tolerance = condition < 3 ? 4e-15 : std::min(4e-15 + 8e-16 * condition, at_fold);
  if (quick && *quick <= tolerance) return "";
  // At the fold to the last digit the equation may have no root for this double T: the fold's own area is right then.
  const StableBranch& first = contact.branches().front();
  if (std::abs(judge.T / first.T_bottom - 1) < 4e-15)
    return std::abs(state.y - first.y_bottom) <= at_fold * (state.y + std::abs(judge.P)) ? "" : "not the fold's area";
  error = 0;
  return judge.root_within(state.A, tolerance) ? "" : "no root within the tolerance";
}

}  // namespace mixity
