// Contact area at given loads on the equilibrium circle
//
//     R(y; T) = (y - 3 pi)^2 + tau^2(y, T) - S0^2 = 0,        S0^2 = 9 pi^2 + 6 pi P,
//
// where the law enters through tau^2 = y^2 (g - 1) alone (base/law.h, shear_term). Equivalent to the printed
// y^2 + T^2 = 8 pi a^3 f(psi) for every law, see mechanics/README.md.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "mechanics/base/law.h"
#include "mechanics/folds.h"
#include "mechanics/registry.h"

namespace mixity {

/// R and its derivatives in y at fixed T. Computed about the centre of the circle near y = 3 pi and expanded near y = 0
/// (Hertz, large T), so that neither form cancels where it is used.
template <class Law, class S>
ShearTerm<S> circle_residual(const Law& law, const Parameters<Law, S>& p, const S& P, const S& y, const S& T) {
  const ShearTerm<S> tau2 = law.shear_term(p, y, T);
  const S three_pi = S(3) * pi<S>();
  const S v = y - three_pi;
  const S value = y > S(4) ? S((v * v - S(6) * pi<S>() * above_pull_off(P)) + tau2.value)
                           : S((y * (y - S(2) * three_pi) + tau2.value) - S(2) * three_pi * P);
  return {value, S(2) * v + tau2.d1, S(2) + tau2.d2};
}

/// Whether each parameter lies in the range of the published law.
template <class Law>
bool in_bounds(const Law& law, const Parameters<Law>& p) {
  for (std::size_t i = 0; i < p.size(); ++i)
    if (!(p[i] >= law.parameters[i].lower && p[i] <= law.parameters[i].upper)) return false;
  return true;
}

/// Empty if these values define a contact; else the reason: parameters out of range or outside the law's domain, or a
/// load that is not finite.
template <class Law>
std::string_view contact_obstacle(const Law& law, const Parameters<Law>& p, double P);

/// A law with its parameters at one normal load P (dimensionless). Cheap to construct: folds are searched for only when
/// a T lies beyond the part of the curve that is known to have none, and only as far as that T requires.
template <class Law>
class LoadedContact {
 public:
  LoadedContact(const Law& law, const Parameters<Law>& parameters, double P)
      : law_(law), p_(parameters), P_(P), obstacle_(contact_obstacle(law, parameters, P)) {
    if (!obstacle_.empty() || above_pull_off(P) < 0) return;
    in_contact_ = true;
    S0_ = circle_radius(P);
    y_jkr_ = 3 * pi<double>() + S0_;
    non_monotone_ = is_non_monotone(law_, p_);
    simple_top_ = !non_monotone_ && law_.tau_grows_with_edge_load(p_);
  }

  const Law& law() const { return law_; }
  const Parameters<Law>& parameters() const { return p_; }
  double load() const { return P_; }

  /// contact_obstacle; unless it is empty, at() returns `invalid`.
  std::string_view obstacle() const { return obstacle_; }

  /// False below the JKR pull-off load, where no contact exists: at() then returns `no_equilibrium`.
  bool in_contact() const { return in_contact_; }

  /// Edge load of the contact that is loaded from T = 0 and follows its stable branch, and after a jump the lower one
  /// if there is one. 0 <= T <= kLargestLoad. Relative error of the area below 4e-15 away from folds; towards a fold
  /// T_f it grows as eps/sqrt(1 - T/T_f).
  Equilibrium at(double T) const {
    if (!obstacle_.empty() || !(T >= 0 && T <= kLargestLoad)) return {EquilibriumStatus::invalid};
    if (!in_contact_) return {EquilibriumStatus::no_equilibrium};
    if constexpr (requires { law_.shear_on_circle(p_, T); }) {
      // Closed form: tau does not depend on y.
      const double tau = law_.shear_on_circle(p_, T);
      // Rounding of tau may put the fold itself beyond the circle.
      if (tau > S0_ * (1 + std::numeric_limits<double>::epsilon())) return {EquilibriumStatus::no_equilibrium};
      return {EquilibriumStatus::ok, 3 * pi<double>() + std::sqrt(std::max(S0_ - tau, 0.0) * (S0_ + tau))};
    } else {
      return follow(T);
    }
  }

  /// Like `at`, for a valid load and a law without a closed form.
  Equilibrium follow(double T) const;

  /// Stable branches from T = 0 downwards, at least one. Only if in_contact().
  const std::vector<StableBranch>& branches() const;

  /// The branch that starts from JKR. Only if in_contact().
  const StableBranch& first_branch() const;

  /// Largest T at which the contact has a stable equilibrium: infinite if it shrinks to an asymptote.
  double last_load() const { return branches().back().T_bottom; }  // only if in_contact()

  double jkr_edge_load() const { return y_jkr_; }

 private:
  Equilibrium solve(double T, double low, double high, double start) const;
  Equilibrium solve_non_monotone(double T, const StableBranch& branch) const;
  void find_branches(std::size_t folds) const;  // up to and including this number
  static constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();

  [[no_unique_address]] Law law_;
  Parameters<Law> p_;
  double P_, S0_ = 0, y_jkr_ = 0;
  bool in_contact_ = false;
  bool simple_top_ = false;  // R rises with y on [3 pi, y_jkr]
  bool non_monotone_ = false;
  std::string_view obstacle_;
  mutable std::vector<StableBranch> branches_;  // filled on first use: up to the first fold, or all of them
  mutable bool all_branches_ = false;
  mutable std::optional<EquilibriumCurve<Law>> curve_;  // only under a non-monotone law
};

}  // namespace mixity
