// Areas looked up in a table of the stable branch, tabulated uniformly in phi.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "mechanics/curve.h"
#include "mechanics/equilibrium.h"

namespace mixity::precision {

/// phi of the place of the curve with edge load y.
template <class Model>
double phi_of(const EquilibriumCurve<Model>& curve, double y) {
  const CurvePosition at = curve.position_at_offset(y - 3 * pi<double>());
  return 2 * std::atan2(std::sqrt(at.sin2), std::sqrt(at.cos2));
}

class Table {
 public:
  /// n points from JKR down to the edge load y_last, T rising.
  template <class Model>
  Table(const EquilibriumCurve<Model>& curve, double y_last, std::size_t n) : T_(n), A_(n) {
    const double last = phi_of(curve, y_last);
    for (std::size_t i = 0; i < n; ++i) {
      const CurvePoint p = curve.point(last * static_cast<double>(i) / static_cast<double>(n - 1));
      T_[i] = p.T;
      A_[i] = p.A;
    }
  }

  double linear(double T) const {
    const std::size_t i = interval(T);
    return A_[i] + (A_[i + 1] - A_[i]) * ((T - T_[i]) / (T_[i + 1] - T_[i]));
  }

  /// The cubic through the four points around T: at a fold, unlike one with slopes, nothing is infinite.
  double cubic(double T) const {
    const std::size_t from = std::min(std::max<std::size_t>(interval(T), 1) - 1, T_.size() - 4);
    double sum = 0;
    for (std::size_t i = from; i < from + 4; ++i) {
      double weight = A_[i];
      for (std::size_t j = from; j < from + 4; ++j)
        if (j != i) weight *= (T - T_[j]) / (T_[i] - T_[j]);
      sum += weight;
    }
    return sum;
  }

 private:
  std::size_t interval(double T) const {
    const auto above = std::upper_bound(T_.begin() + 1, T_.end() - 1, T);
    return static_cast<std::size_t>(above - T_.begin()) - 1;
  }

  std::vector<double> T_, A_;
};

}  // namespace mixity::precision
