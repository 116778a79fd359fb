// Boxes that contain an equilibrium curve: where else a point of it may be nearer to a measured one.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "mechanics/vector_math.h"

namespace mixity {

/// A point in the plane of T and A.
struct PlanePlace {
  double T, A;
};

/// A node of a curve's outline. T/y is infinite at Hertz.
struct OutlineNode {
  double ray, y, A;  // ray = T/y
};

/// One box for each segment of an outline. From node to node T/y grows and y falls, so that T = (T/y) y lies between the
/// products of the ends.
class OutlineBoxes {
 public:
  void clear() { low_T_.clear(), high_T_.clear(), low_A_.clear(), high_A_.clear(); }
  bool empty() const { return low_T_.empty(); }

  /// The nodes from T = 0 on, and the area at which the curve ends.
  void set(const std::vector<OutlineNode>& nodes, double A_end) {
    clear();
    const double infinite = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
      const OutlineNode &from = nodes[i], &to = nodes[i + 1];
      add(from.ray * to.y, std::isfinite(to.ray) ? to.ray * from.y : infinite, to.A, from.A);
    }
    if (const OutlineNode& last = nodes.back(); std::isfinite(last.ray)) add(0, infinite, A_end, last.A);
    far_.resize(low_T_.size());
  }

  /// No point of the curve farther from `place` than this is nearer to `point` than `place` is. Distances are in units
  /// of 1/per_T and 1/per_A.
  double reach(PlanePlace point, PlanePlace place, double per_T, double per_A) {
    const double x = (place.T - point.T) * per_T, z = (place.A - point.A) * per_A;
    measure(point, place, per_T, per_A, (x * x + z * z) * (1 + kRounding), far_.size());
    return std::sqrt(*std::max_element(far_.begin(), far_.end()));
  }

 private:
  static constexpr double kRounding = 1e-10;  // far above that of a node, far below the size of a box that matters

  void add(double low_T, double high_T, double low_A, double high_A) {
    low_T_.push_back(low_T * (1 - kRounding));
    high_T_.push_back(high_T * (1 + kRounding));
    low_A_.push_back(low_A * (1 - kRounding));
    high_A_.push_back(high_A * (1 + kRounding));
  }

  /// far_ = the square of the distance of each box's farthest corner from `place`; 0 where the box is at least `nearest`,
  /// a squared distance, away from the point. Without branches, so that the loop is vectorised.
  MIXITY_LOOP void measure(PlanePlace point, PlanePlace place, double per_T, double per_A, double nearest, std::size_t n) {
    const double *const low_T = low_T_.data(), *const high_T = high_T_.data();
    const double *const low_A = low_A_.data(), *const high_A = high_A_.data();
    double* const __restrict far = far_.data();
    const auto larger = [](double a, double b) { return a > b ? a : b; };
    for (std::size_t i = 0; i < n; ++i) {
      const double x = larger(larger(low_T[i] - point.T, point.T - high_T[i]), 0.0) * per_T;
      const double z = larger(larger(low_A[i] - point.A, point.A - high_A[i]), 0.0) * per_A;
      const double T = larger(place.T - low_T[i], high_T[i] - place.T) * per_T;
      const double A = larger(place.A - low_A[i], high_A[i] - place.A) * per_A;
      far[i] = x * x + z * z < nearest ? T * T + A * A : 0.0;
    }
  }

  std::vector<double> low_T_, high_T_, low_A_, high_A_, far_;
};

}  // namespace mixity
