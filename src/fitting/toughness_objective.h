// Objective `toughness`, the paper's: ln f (or f) of the model minus that of the points, at the points' psi.
#pragma once

#include <cmath>
#include <string_view>
#include <utility>

#include "fitting/model_problem.h"
#include "fitting/packed_toughness.h"
#include "mechanics/measurement.h"

namespace mixity {

enum class Scale { log, linear };
constexpr std::string_view to_string(Scale scale) { return scale == Scale::log ? "log" : "linear"; }

template <class Model>
class ToughnessObjective final : public ModelProblem<Model> {
 public:
  /// `weights`: 1/standard error of each point's target, or empty: 1.
  ToughnessObjective(std::vector<ToughnessPoint> points, Scale scale, FreeChoice<Model> choice,
                     std::vector<double> weights = {})
      : points_(std::move(points)), scale_(scale), choice_(std::move(choice)), weights_(std::move(weights)) {
    weights_.resize(points_.size(), 1.0);
    targets_.reserve(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i)
      targets_.push_back(weights_[i] * (scale_ == Scale::log ? std::log(points_[i].ratio) : points_[i].ratio));
    if constexpr (HasLanes<Model>) {
      lanes_.reserve(points_.size());
      for (const ToughnessPoint& point : points_) lanes_.add(point.mixity);
    }
  }

  std::size_t residual_count() const override { return points_.size(); }
  const std::vector<FreeParameter>& parameters() const override { return choice_.parameters(); }
  const std::vector<double>& targets() const override { return targets_; }
  const std::vector<double>& weights() const override { return weights_; }
  Trial<Model> trial(std::span<const double> x) const override { return choice_.trial(x); }
  /// ln f inherits the rounding of f, an eps however small ln f is.
  double data_norm() const override {
    double square = std::pow(ModelProblem<Model>::data_norm(), 2);
    if (scale_ == Scale::log)
      for (const double weight : weights_) square += weight * weight;
    return std::sqrt(square);
  }

  bool evaluate(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian) const override {
    const Parameters<Model> p = trial(x).parameters;
    const std::vector<std::size_t>& free = choice_.model();
    bool finite = true;
    if constexpr (HasLanes<Model>) {
      if (scale_ == Scale::log) {
        const bool slopes = !jacobian.empty() && !free.empty();
        lanes_.log_toughness(
            p[0], [&](std::size_t begin, std::size_t n, const double* value, const double* slope, const double*) {
              for (std::size_t j = 0; j < n; ++j) {
                const std::size_t i = begin + j;
                residuals[i] = weights_[i] * value[j] - targets_[i];
                finite &= std::isfinite(residuals[i]);
                if (!slopes) continue;
                jacobian[i] = weights_[i] * slope[j];
                finite &= std::isfinite(jacobian[i]);
              }
            });
        return finite;
      }
    }
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const auto log_f = Model::log_toughness(p, points_[i].mixity);
      const double f = scale_ == Scale::log ? 1 : std::exp(log_f.value);  // df = f d(ln f)
      residuals[i] = weights_[i] * (scale_ == Scale::log ? log_f.value : f) - targets_[i];
      finite &= std::isfinite(residuals[i]);
      if (jacobian.empty()) continue;
      for (std::size_t k = 0; k < free.size(); ++k) {
        const double slope = weights_[i] * f * log_f.gradient[free[k]];
        jacobian[i * free.size() + k] = slope;
        finite &= std::isfinite(slope);
      }
    }
    return finite;
  }

  std::unique_ptr<SingleCost> single_cost() const override {
    if constexpr (HasLanes<Model>) {
      if (scale_ == Scale::log) return std::make_unique<PackedToughness<Model>>(lanes_, targets_, weights_);
    }
    return LeastSquares::single_cost();
  }

 private:
  std::vector<ToughnessPoint> points_;
  Scale scale_;
  FreeChoice<Model> choice_;
  std::vector<double> weights_, targets_;
  ToughnessLanes<Model> lanes_;
};

}  // namespace mixity
