// Objective `toughness` in ln f on packed arrays: one vectorised sweep gives the cost and both derivatives.
#pragma once

#include "fitting/single_cost.h"
#include "mechanics/lanes.h"

namespace mixity {

template <class Model>
class PackedToughness final : public SingleCost {
 public:
  /// `targets`: weights times ln f of the points; `weights`: 1/standard error, as ToughnessObjective has them.
  PackedToughness(const std::vector<Mixity<double>>& points, const std::vector<double>& targets,
                  const std::vector<double>& weights)
      : targets_(targets), weights_(weights), value_(points.size()), slope_(points.size()), curvature_(points.size()) {
    for (const Mixity<double>& mixity : points) {
      const LanePoint point = Model::lane_point(mixity);
      first_.push_back(point.first);
      second_.push_back(point.second);
    }
  }

  CostValue at(double x, std::span<const double> weights) override {
    const std::size_t n = value_.size();
    log_toughness_lanes<Model>(x, first_.data(), second_.data(), n, value_.data(), slope_.data(), curvature_.data());
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
    cost.exact_curvature = true;
    cost.finite = std::isfinite(cost.value) && std::isfinite(cost.slope) && std::isfinite(cost.curvature);
    return cost;
  }

 private:
  std::vector<double> first_, second_, targets_, weights_, value_, slope_, curvature_;
};

}  // namespace mixity
