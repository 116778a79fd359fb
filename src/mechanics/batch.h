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

namespace batch_detail {
/// pi (3/4 load[i])^(2/3) in place, load = y + P: as area_from_radius, vectorised. 0 stays 0.
void areas_from_loads(std::span<double> loads);

/// Guesses the next edge load of a rising sequence: (y - 3 pi)^2 is linear in T^2 for model c and close to it for the
/// others, so the cubic in T^2 through the last four points is continued (Newton's divided differences).
class Extrapolation {
 public:
  std::optional<double> guess(double T) const {
    const double x = T * T, ahead = x - x_[0];
    // not much further ahead than the points lie apart: else the cubic runs away
    if (count_ < 4 || !(ahead >= 0 && ahead <= 2 * (x_[0] - x_[2]))) return {};
    const double z = z_[0] + ahead * (z_[1] + (x - x_[1]) * (z_[2] + (x - x_[2]) * z_[3]));
    if (!(z > 0)) return {};
    return 3 * pi<double>() + std::sqrt(z);
  }

  void add(double T, double y) {
    const double x = T * T, offset = y - 3 * pi<double>();
    if (count_ > 0 && !(x > x_[0])) count_ = 0;  // starts again where T does not rise
    double difference = offset * offset;
    for (int level = 0; level < 4; ++level) {
      const double before = z_[level];
      z_[level] = difference;
      if (level < 3 && level < count_) difference = (difference - before) / (x - x_[level]);
    }
    x_[2] = x_[1];
    x_[1] = x_[0];
    x_[0] = x;
    if (count_ < 4) ++count_;
  }

 private:
  double x_[3]{}, z_[4]{};  // T^2 of the last three points, newest first; divided differences of order 0 to 3
  int count_ = 0;
};
}  // namespace batch_detail

/// Fills areas[i] with the area at T[i] (as LoadedContact::at, dimensionless, within 4e-15 of it) and returns how many
/// were found. Where no equilibrium exists, or T[i] is invalid, areas[i] is 0: no contact has that area. Sizes must
/// agree. Model c is vectorised; a, b and bk are solved point by point, each from a guess that the points before it
/// give where T rises.
template <class Model>
std::size_t predict_areas(const Parameters<Model>& p, double P, std::span<const double> T, std::span<double> areas) {
  assert(T.size() == areas.size());
  const LoadedContact<Model> contact(p, P);
  if constexpr (requires { Model::shear_on_circle(p, P); }) {
    if (contact.obstacle().empty() && contact.in_contact())
      return batch_detail::closed_form_areas(Model::shear_on_circle(p, 1.0), circle_radius(P), P, T, areas);
  }
  std::size_t found = 0;
  batch_detail::Extrapolation before;
  for (std::size_t i = 0; i < T.size(); ++i) {
    const Equilibrium equilibrium = contact.at(T[i], before.guess(T[i]));
    const bool ok = equilibrium.status == EquilibriumStatus::ok;
    areas[i] = ok ? equilibrium.y + P : 0.0;
    if (ok) before.add(T[i], equilibrium.y);
    found += ok;
  }
  batch_detail::areas_from_loads(areas);
  return found;
}

}  // namespace mixity
