// The cost of the objective curve by brute force: the nearest of many places of each curve, refined. From
// EquilibriumCurve, which the tests of mechanics judge; nothing of the fitting, nor of the distances that it uses.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "dataset/dataset.h"
#include "mechanics/sampling.h"
#include "stress/golden.h"

namespace mixity::stress {

/// Where the curve first reaches T, or its end: what lies beyond is far from all points.
template <class Model>
double phi_of_shear(const EquilibriumCurve<Model>& curve, const PhiRange& range, double T) {
  constexpr int kPlaces = 60;
  for (int i = 1; i <= kPlaces; ++i) {
    double high = range.from + (range.to - range.from) * i / kPlaces;
    if (curve.point(high).T <= T) continue;
    double low = range.from + (range.to - range.from) * (i - 1) / kPlaces;
    for (int j = 0; j < 50; ++j) {
      const double middle = 0.5 * (low + high);
      (curve.point(middle).T <= T ? low : high) = middle;
    }
    return low;
  }
  return range.to;
}

/// The curve of one load, up to a shear that no point comes near.
template <class Model>
class ManyPlaces {
 public:
  ManyPlaces(const Parameters<Model>& p, double P, double T_most)
      : curve_(Model{}, p, P), level_(area_from_radius(jkr_radius(P))) {
    if (curve_.uncoupled()) return;
    PhiRange range = drawable_ranges(curve_, T_most).front();
    range.to = phi_of_shear(curve_, range, T_most);
    constexpr int kPlaces = 300;
    for (int i = 0; i <= kPlaces; ++i) {
      places_.push_back(curve_.point(range.from + (range.to - range.from) * i / kPlaces));
      if (i < 2) continue;
      // Where T turns is a place of its own: on either side of it a load is passed.
      const auto last = places_.end() - 1;
      const double before = last[-1].T - last[-2].T, now = last->T - last[-1].T;
      if (before * now >= 0) continue;
      const auto turned = [&](double phi) { return before > 0 ? -curve_.point(phi).T : curve_.point(phi).T; };
      const CurvePoint turn = curve_.point(golden(turned, last[-2].phi, last->phi, 60).x[0]);
      places_.insert(turn.phi < last[-1].phi ? last - 1 : last, turn);
    }
  }

  double distance(double T, double A, double sigma_T, double sigma_A) const {
    // where shear does not act, the area stays that of JKR
    if (curve_.uncoupled()) return std::abs(level_ - A) / sigma_A;
    const auto from = [&](const CurvePoint& q) { return std::hypot((q.T - T) / sigma_T, (q.A - A) / sigma_A); };
    double nearest = HUGE_VAL;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const double here = from(places_[i]);
      const std::size_t before = i ? i - 1 : 0, after = std::min(i + 1, places_.size() - 1);
      if (here > from(places_[before]) || here > from(places_[after])) continue;
      nearest = std::min(nearest, here);
      for (const std::size_t beside : {before, after}) {
        const auto at = [&](double phi) { return from(curve_.point(phi)); };
        const auto [low, high] = std::minmax(places_[i].phi, places_[beside].phi);
        nearest = std::min(nearest, golden(at, low, high, 55).cost);
      }
    }
    return nearest;
  }

 private:
  EquilibriumCurve<Model> curve_;
  double level_;  // the area without shear
  std::vector<CurvePoint> places_;
};

/// Sum of squares with the model's parameters and ln of a factor on the toughness. T of either sign.
template <class Model>
double curve_cost(const Dataset& data, const Parameters<Model>& p, double log_factor) {
  const double force = std::exp(-log_factor), area = std::exp(-2.0 / 3 * log_factor);
  double T_most = 0, sum = 0;
  for (std::size_t k = 0; k < data.points.size(); ++k)
    T_most = std::max(T_most, 2 * force * (std::abs(data.points[k].T) + 10 * data.errors[k].T));
  std::map<double, ManyPlaces<Model>> of_load;
  for (std::size_t k = 0; k < data.points.size(); ++k) {
    const Point& point = data.points[k];
    const double P = point.P * force;
    auto found = of_load.find(P);
    if (found == of_load.end()) {
      const LoadedContact contact(Model{}, p, P);
      if (!contact.obstacle().empty() || !contact.in_contact()) return HUGE_VAL;
      found = of_load.emplace(P, ManyPlaces<Model>(p, P, T_most)).first;
    }
    const double distance = found->second.distance(std::abs(point.T) * force, point.A * area, data.errors[k].T * force,
                                                   data.errors[k].A * area);
    sum += distance * distance;
  }
  return sum;
}

}  // namespace mixity::stress
