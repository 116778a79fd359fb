// The point of an equilibrium curve nearest to a measured one, in the plane of T and A, each in units of its standard
// error. Regular at a fold, where A at given T is not.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "mechanics/sampling.h"

namespace mixity {

template <class Model>
class Projection {
 public:
  /// The curve that starts from JKR, down to its end or to where T first reaches T_most. Keeps a polyline of it, from
  /// which each search starts.
  Projection(const EquilibriumCurve<Model>& curve, double T_most) : curve_(curve) {
    PhiRange range = drawable_ranges(curve_, T_most).front();
    for (int i = 1; i <= kNodes; ++i) {
      const double phi = at(range, i);
      if (curve_.point(phi).T <= T_most) continue;
      double low = at(range, i - 1), high = phi;
      for (int j = 0; j < 40; ++j) {
        const double middle = 0.5 * (low + high);
        (curve_.point(middle).T <= T_most ? low : high) = middle;
      }
      range.to = low;
      break;
    }
    nodes_.push_back(curve_.point(range.from));
    const double A_step = 4 * nodes_.front().A / kNodes;
    for (int i = 1; i <= kNodes; ++i) add(curve_.point(at(range, i)), 4 * T_most / kNodes, A_step, 6);
  }

  /// The nearest point. T >= 0, A > 0, standard errors > 0.
  CurvePoint nearest(double T, double A, double sigma_T, double sigma_A) const {
    const auto offset = [&](const CurvePoint& q) { return std::pair{(q.T - T) / sigma_T, (q.A - A) / sigma_A}; };
    const auto distance = [&](const CurvePoint& q) {
      const auto [x, y] = offset(q);
      return x * x + y * y;
    };
    const auto closest = std::min_element(nodes_.begin(), nodes_.end(), [&](const CurvePoint& p, const CurvePoint& q) {
      return distance(p) < distance(q);
    });
    if (curve_.uncoupled()) return *closest;
    const auto index = static_cast<std::size_t>(closest - nodes_.begin());
    double low = nodes_[index > 0 ? index - 1 : 0].phi, high = nodes_[std::min(index + 1, nodes_.size() - 1)].phi;
    // Half the slope of the squared distance, and its Gauss-Newton derivative; the bracket is the safeguard.
    CurvePoint q = *closest;
    double last_phi = 0, last_slope = 0;
    for (int i = 0; i < 60; ++i) {
      const auto [x, y] = offset(q);
      const double dx = q.dT / sigma_T, dy = q.dA / sigma_A;
      const double slope = x * dx + y * dy, size = std::hypot(dx, dy);
      if (!(std::abs(slope) > 1e-11 * size * std::hypot(x, y))) break;  // moves the distance by 1e-22 of itself
      (slope > 0 ? high : low) = q.phi;
      // Secant through the last two slopes takes the curvature that Gauss-Newton leaves out.
      double next = q.phi - slope / (size * size);
      if (i > 0 && slope != last_slope) {
        const double secant = q.phi - slope * (q.phi - last_phi) / (slope - last_slope);
        if (secant > low && secant < high) next = secant;
      }
      last_phi = q.phi;
      last_slope = slope;
      if (!(next >= low && next <= high)) next = 0.5 * (low + high);
      if (std::abs(next - q.phi) <= 4e-16 * q.phi) break;
      q = curve_.point(next);
    }
    return q;
  }

 private:
  static constexpr int kNodes = 24;

  static double at(const PhiRange& range, int i) {
    return i == kNodes ? range.to : range.from + (range.to - range.from) * i / kNodes;
  }

  /// Appends q, and before it what keeps the steps of the polyline short where phi alone leaves them long.
  void add(const CurvePoint& q, double T_step, double A_step, int depth) {
    const CurvePoint before = nodes_.back();
    const bool far = std::abs(q.T - before.T) > T_step || std::abs(q.A - before.A) > A_step;
    if (far && depth > 0) {
      add(curve_.point(0.5 * (before.phi + q.phi)), T_step, A_step, depth - 1);
      add(q, T_step, A_step, depth - 1);
    } else {
      nodes_.push_back(q);
    }
  }

  EquilibriumCurve<Model> curve_;
  std::vector<CurvePoint> nodes_;
};

}  // namespace mixity
