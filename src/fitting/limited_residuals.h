// Residuals of which single ones that lie far off are limited.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "dataset/dataset.h"
#include "fitting/point_indices.h"
#include "solver/robust.h"

namespace mixity {

/// Residuals limited to a few times their usual size. A few points far off look like a large part of the noise wherever
/// they happen to lie, or like a memory: the parts of the errors and their correlation are found without their excess,
/// by which all of them are then larger. A run of which several points are far off on one side is not limited: it may
/// differ from the others. Computed on demand: of millions of points a list would count.
class LimitedResiduals {
 public:
  /// All arguments must outlive this object.
  LimitedResiduals(const Dataset& data, const PointIndices& used, std::span<const double> residuals)
      : data_(data), used_(used), residuals_(residuals) {
    constexpr double kBend = 5;  // times the usual size: one of two million normal deviations is larger
    constexpr double kSeveral = 2, kShare = 0.06;  // points of a run on one side, and their share of it
    constexpr double kOfUnsheared = 0.3;
    constexpr std::size_t kSome = 20'000;  // residuals whose median tells the usual size
    std::vector<double> sizes;
    const std::size_t n = residuals.size(), step = n / kSome + 1;
    for (std::size_t i = 0; i < n; i += step) sizes.push_back(residuals[i]);
    const double most = kBend * spread(sizes);
    const auto is_far = [&](double r) { return std::abs(r) > most; };
    if (!(most > 0) || std::none_of(residuals.begin(), residuals.end(), is_far)) return;
    struct Counts {
      double points = 0, above = 0, below = 0;
    };
    std::vector<Counts> runs(data.curves.size());
    Counts unsheared;
    const PointPlaces places(data);
    for (std::size_t i = 0; i < n; ++i) {
      const Point& point = data.points[used[i]];
      const auto count = [&](Counts& these) {
        ++these.points;
        if (is_far(residuals[i])) ++(residuals[i] > 0 ? these.above : these.below);
      };
      count(runs[point.curve]);
      if (places.at(used[i]).unsheared) count(unsheared);
    }
    // Areas without shear may have a toughness of their own.
    if (std::max(unsheared.above, unsheared.below) > std::max(kSeveral, kOfUnsheared * unsheared.points)) return;
    const auto limit = [&](double far, double points) {
      return far <= std::max(kSeveral, kShare * points) ? most : std::numeric_limits<double>::infinity();
    };
    for (const Counts& run : runs) limits_.push_back({limit(run.above, run.points), limit(run.below, run.points)});
    most_ = most;
    double before = 0, after = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double r = residuals[i], limited = (*this)[i];
      before += r * r;
      after += limited * limited;
    }
    inflation_ = before / after;
  }

  double operator[](std::size_t i) const {
    const double r = residuals_[i];
    if (!(std::abs(r) > most_)) return r;
    const Limits& limits = limits_[data_.points[used_[i]].curve];
    return std::copysign(std::min(std::abs(r), r > 0 ? limits.above : limits.below), r);
  }
  std::size_t size() const { return residuals_.size(); }
  /// The ratio of the sums of squares, without limits over with them.
  double inflation() const { return inflation_; }
  bool any() const { return !limits_.empty(); }

 private:
  struct Limits {
    double above, below;
  };
  const Dataset& data_;
  const PointIndices& used_;
  std::span<const double> residuals_;
  double most_ = std::numeric_limits<double>::infinity(), inflation_ = 1;
  std::vector<Limits> limits_;  // by run; empty if no residual is beyond
};

}  // namespace mixity
