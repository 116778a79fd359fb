// Areas for arrays of tangential loads at one normal load.
#pragma once

#include <cassert>
#include <span>

#include "mechanics/equilibrium.h"

namespace mixity {

namespace batch_detail {
/// Model c: areas[i] = pi (3/4 (3 pi + sqrt(S0^2 - (root_lambda T[i])^2) + P))^(2/3), 0 where T[i] is negative, not a
/// number or beyond the circle. One loop without branches; returns how many areas are not 0.
std::size_t closed_form_areas(double root_lambda, double S0, double P, std::span<const double> T,
                              std::span<double> areas);
}  // namespace batch_detail

/// Fills areas[i] with the area at T[i] (as LoadedContact::at, dimensionless, within 4e-15 of it) and returns how many
/// were found. Where no equilibrium exists, or T[i] is invalid, areas[i] is 0: no contact has that area. Sizes must
/// agree. Model c is vectorised; a, b and bk are solved point by point.
template <class Model>
std::size_t predict_areas(const Parameters<Model>& p, double P, std::span<const double> T, std::span<double> areas) {
  assert(T.size() == areas.size());
  const LoadedContact<Model> contact(p, P);
  if constexpr (requires { Model::shear_on_circle(p, P); }) {
    if (contact.obstacle().empty() && contact.in_contact())
      return batch_detail::closed_form_areas(Model::shear_on_circle(p, 1.0), circle_radius(P), P, T, areas);
  }
  std::size_t found = 0;
  for (std::size_t i = 0; i < T.size(); ++i) {
    const Equilibrium equilibrium = contact.at(T[i]);
    const bool ok = equilibrium.status == EquilibriumStatus::ok;
    areas[i] = ok ? area_from_radius(radius_from_edge_load(equilibrium.y, P)) : 0.0;
    found += ok;
  }
  return found;
}

}  // namespace mixity
