// Areas for arrays of tangential loads at one normal load.
#pragma once

#include <algorithm>
#include <cassert>
#include <span>

#include "base/stop.h"
#include "mechanics/equilibrium.h"
#include "mechanics/packed_toughness.h"

namespace mixity {

namespace batch_detail {
/// Law c: areas[i] = pi (3/4 (3 pi + sqrt(S0^2 - (root_lambda T[i])^2) + P))^(2/3), 0 where T[i] is negative, not a
/// number or beyond the circle. One loop without branches; returns how many areas are not 0.
std::size_t closed_form_areas(double root_lambda, double S0, double P, std::span<const double> T,
                              std::span<double> areas);

/// Replaces each load = y + P by the area pi (3/4 load)^(2/3), vectorised. 0 stays 0.
void areas_from_loads(std::span<double> loads);

/// The part of the stable branch on which batches are solved: from JKR down to y = low, which is reached at T_last or
/// later. The first guess is y = low + (y_jkr - low) sqrt(1 - shrink T^2), exact for model c.
struct BranchPart {
  double y_jkr, low, T_last, shrink;
};

/// One-parameter laws: sets y[i] to the edge load at T[i] by a few Euler steps for all points at once; to 0 where these
/// do not converge (close to a fold) and where T[i] is beyond T_last or invalid.
template <class Law>
void settle_batch(Law law, double parameter, double P, const BranchPart& part, std::span<const double> T,
                  std::span<double> y);

/// The part above the centre of the circle if the contact stays there up to T_most, which one evaluation decides; else
/// the branch down to its fold.
template <class Law>
BranchPart branch_part(const LoadedContact<Law>& contact, double T_most) {
  const Law& law = contact.law();
  const Parameters<Law>& p = contact.parameters();
  const double P = contact.load(), centre = 3 * pi<double>(), S0 = circle_radius(P), jkr = contact.jkr_edge_load();
  if (law.tau_grows_with_edge_load(p) && circle_residual(law, p, P, centre, T_most).value <= 0) {
    const double tau2 = law.shear_term(p, centre, T_most).value;
    return {jkr, centre, T_most, T_most > 0 && S0 > 0 ? tau2 / (S0 * S0 * T_most * T_most) : 0.0};
  }
  const StableBranch& branch = contact.first_branch();
  const double last = std::min(branch.T_bottom, kLargestLoad);
  return {jkr, branch.y_bottom, last, branch.ends_in_fold && last > 0 ? 1 / (last * last) : 0.0};
}
}  // namespace batch_detail

/// Fills areas[i] with the area at T[i] (see LoadedContact::at; dimensionless, within 4e-15 of it) and returns how many
/// exist. Where there is no equilibrium, or T[i] is invalid, areas[i] is 0. Both spans have the same size. Models a, b
/// and c are vectorised; bk and points close to a fold are solved one by one.
template <class Law>
std::size_t predict_areas(const LoadedContact<Law>& contact, std::span<const double> T, std::span<double> areas) {
  assert(T.size() == areas.size());
  const Law& law = contact.law();
  const Parameters<Law>& p = contact.parameters();
  const double P = contact.load();
  const bool solvable = contact.obstacle().empty() && contact.in_contact();
  if constexpr (requires { law.shear_on_circle(p, P); }) {
    if (solvable) return batch_detail::closed_form_areas(law.shear_on_circle(p, 1.0), circle_radius(P), P, T, areas);
  }
  std::fill(areas.begin(), areas.end(), 0.0);
  if constexpr (HasPackedForm<Law>) {
    double T_most = 0;
    for (const double t : T)
      if (t <= kLargestLoad) T_most = std::max(T_most, t);
    if (solvable) {
      const batch_detail::BranchPart part = batch_detail::branch_part(contact, T_most);
      batch_detail::settle_batch(law, p[0], P, part, T, areas);
    }
  }
  std::size_t found = 0;
  for (std::size_t i = 0; i < T.size(); ++i) {
    double y = areas[i];
    bool ok = y > 0;
    if (!ok) {
      may_go_on();
      const Equilibrium equilibrium = contact.at(T[i]);
      ok = equilibrium.status == EquilibriumStatus::ok;
      y = equilibrium.y;
    }
    areas[i] = ok ? y + P : 0.0;
    found += ok;
  }
  batch_detail::areas_from_loads(areas);
  return found;
}

}  // namespace mixity
