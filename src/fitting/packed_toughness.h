// Objective `toughness` in ln f on packed arrays: one vectorised sweep gives the cost and both derivatives.
#pragma once

#include "fitting/single_cost.h"
#include "mechanics/lanes.h"

namespace mixity {

/// The points of a one-parameter law as its loops take them.
template <class Model>
class ToughnessLanes {
 public:
  void add(const Mixity<double>& mixity) {
    const LanePoint point = Model::lane_point(mixity);
    first_.push_back(point.first);
    second_.push_back(point.second);
  }
  std::size_t size() const { return first_.size(); }
  /// ln f and its derivatives in the parameter; sizes as added.
  void log_toughness(double parameter, std::span<double> value, std::span<double> slope,
                     std::span<double> curvature) const {
    log_toughness_lanes<Model>(parameter, first_.data(), second_.data(), first_.size(), value.data(), slope.data(),
                               curvature.data());
  }

 private:
  std::vector<double> first_, second_;
};

template <class Model>
class PackedToughness final : public SingleCost {
 public:
  /// `targets`: weights times ln f of the points; `weights`: 1/standard error, as ToughnessObjective has them. All
  /// three must outlive this.
  PackedToughness(const ToughnessLanes<Model>& lanes, const std::vector<double>& targets,
                  const std::vector<double>& weights)
      : lanes_(lanes), targets_(targets), weights_(weights), value_(lanes.size()), slope_(value_), curvature_(value_) {}

  bool exact_curvature() const override { return true; }
  CostValue at(double x, std::span<const double> weights) override {
    const std::size_t n = value_.size();
    lanes_.log_toughness(x, value_, slope_, curvature_);
    // Four sums of each kind, which compilers keep in vector registers; the order is fixed, so is the result.
    double value[4]{}, slope[4]{}, square[4]{}, bend[4]{};
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t k = i % 4;
      const double w = weights.empty() ? 1 : weights[i];
      const double r = weights_[i] * value_[i] - targets_[i], d = weights_[i] * slope_[i];
      value[k] += w * r * r;
      slope[k] += w * r * d;
      square[k] += w * d * d;
      bend[k] += w * r * weights_[i] * curvature_[i];
    }
    const auto sum = [](const double* s) { return (s[0] + s[1]) + (s[2] + s[3]); };
    CostValue cost;
    cost.value = sum(value);
    cost.slope = 2 * sum(slope);
    cost.curvature = 2 * (sum(square) + sum(bend));
    cost.slope_size = std::sqrt(sum(square));
    cost.finite = std::isfinite(cost.value) && std::isfinite(cost.slope) && std::isfinite(cost.curvature);
    return cost;
  }

 private:
  const ToughnessLanes<Model>& lanes_;
  const std::vector<double>&targets_, &weights_;
  std::vector<double> value_, slope_, curvature_;
};

}  // namespace mixity
