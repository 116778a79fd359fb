// Objective `toughness` in ln f on packed arrays: one vectorised sweep gives the cost and both derivatives.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "mechanics/lanes.h"
#include "solver/problem.h"

namespace mixity {

/// The points of a one-parameter law as its loops take them.
template <class Model>
class ToughnessLanes {
 public:
  void add(const Mixity<double>& mixity) {
    const LanePoint<double> point = Model::lane_point(mixity);
    first_.push_back(point.first);
    second_.push_back(point.second);
  }
  void reserve(std::size_t n) {
    first_.reserve(n);
    second_.reserve(n);
  }
  /// Calls use(begin, n, value, slope, curvature) for the points begin..begin + n - 1, all in order: ln f and its
  /// derivatives in the parameter, in chunks that stay in the processor's cache. Each begins at a multiple of four.
  template <class Use>
  void log_toughness(double parameter, const Use& use) const {
    constexpr std::size_t kChunk = 512;
    std::array<double, kChunk> value, slope, curvature;
    for (std::size_t begin = 0; begin < first_.size(); begin += kChunk) {
      const std::size_t n = std::min(kChunk, first_.size() - begin);
      log_toughness_lanes<Model>(parameter, first_.data() + begin, second_.data() + begin, n, value.data(),
                                 slope.data(), curvature.data());
      use(begin, n, value.data(), slope.data(), curvature.data());
    }
  }

 private:
  std::vector<double> first_, second_;
};

template <class Model>
class PackedToughness final : public Cost {
 public:
  /// `targets`: weights times ln f of the points; `weights`: 1/standard error, as ToughnessObjective has them. All
  /// three must outlive this.
  PackedToughness(const ToughnessLanes<Model>& lanes, const std::vector<double>& targets,
                  const std::vector<double>& weights)
      : lanes_(lanes), targets_(targets), weights_(weights) {}

  bool exact_curvature() const override { return true; }
  void at(std::span<const double> x, std::span<const double> weights, CostValue& cost) override {
    // Four sums of each kind, which compilers keep in vector registers; the order is fixed, so is the result.
    double value[4]{}, slope[4]{}, square[4]{}, bend[4]{};
    lanes_.log_toughness(x[0],
                         [&](std::size_t begin, std::size_t n, const double* f, const double* f1, const double* f2) {
                           for (std::size_t j = 0; j < n; ++j) {
                             const std::size_t i = begin + j, k = j % 4;
                             const double w = weights.empty() ? 1 : weights[i];
                             const double r = weights_[i] * f[j] - targets_[i], d = weights_[i] * f1[j];
                             value[k] += w * r * r;
                             slope[k] += w * r * d;
                             square[k] += w * d * d;
                             bend[k] += w * r * weights_[i] * f2[j];
                           }
                         });
    const auto sum = [](const double* s) { return (s[0] + s[1]) + (s[2] + s[3]); };
    cost.value = sum(value);
    cost.gradient.setConstant(1, sum(slope));
    cost.hessian.setConstant(1, 1, sum(square) + sum(bend));
    cost.slope_size.setConstant(1, std::sqrt(sum(square)));
    cost.finite = std::isfinite(cost.value) && std::isfinite(cost.gradient[0]) && std::isfinite(cost.hessian(0, 0));
  }

 private:
  const ToughnessLanes<Model>& lanes_;
  const std::vector<double>&targets_, &weights_;
};

}  // namespace mixity
