// Objective `toughness`, the paper's: ln f (or f) of the model minus that of the points, at the points' psi.
#pragma once

#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "fitting/objective.h"
#include "fitting/options.h"
#include "fitting/packed_toughness.h"
#include "mechanics/measurement.h"
#include "mechanics/sensitivity.h"

namespace mixity {

/// ln f of the model minus ln f of the point, at the point's psi, with its derivatives in the model's parameters and in
/// what was measured. From the equilibrium condition F of mechanics/sensitivity.h: -ln((y^2 + tau^2)/(6 pi (y + P))).
template <class Model>
struct ToughnessResidual {
  double value;
  Parameters<Model> parameters;
  double P, T, A;
};

/// Null where the area does not exceed that of Hertz (y <= 0). T of either sign.
template <class Model>
std::optional<ToughnessResidual<Model>> toughness_residual(const Parameters<Model>& p, const MeasuredPoint& point) {
  const double a = radius_from_area(point.A), y = edge_load(a, point.P), sum = y + point.P;
  if (!(y > 0)) return std::nullopt;
  const EquilibriumGradient<Model> F = equilibrium_gradient<Model>(p, point.P, std::abs(point.T), y);
  ToughnessResidual<Model> r;
  r.value = -std::log(F.held / (6 * pi<double>() * sum));
  for (std::size_t k = 0; k < p.size(); ++k) r.parameters[k] = -F.parameters[k] / F.held;
  // F = held - 6 pi sum, and dsum/dA = 2 a/pi
  const double growth = 2 * a / pi<double>();
  r.A = growth / sum - (F.A + 6 * pi<double>() * growth) / F.held;
  r.T = -std::copysign(F.T, point.T) / F.held;
  r.P = -F.P / F.held;
  return r;
}

template <class Model>
class ToughnessObjective final : public ModelProblem<Model> {
 public:
  /// `weights`: 1/standard error of each point's target, or empty: 1. Of the constants the toughness alone may be
  /// fitted, in ln f.
  ToughnessObjective(std::vector<ToughnessPoint> points, Scale scale, FreeChoice<Model> choice,
                     std::vector<double> weights = {})
      : Base(std::move(choice)), points_(std::move(points)), scale_(scale) {
    weights_ = std::move(weights);
    weights_.resize(points_.size(), 1.0);
    targets_.reserve(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i)
      targets_.push_back(weights_[i] * (scale_ == Scale::log ? std::log(points_[i].ratio) : points_[i].ratio));
    if constexpr (HasLanes<Model>) {
      lanes_.reserve(points_.size());
      for (const ToughnessPoint& point : points_) lanes_.add(point.mixity);
    }
  }

  /// ln f inherits the rounding of f, an eps however small ln f is.
  double data_norm() const override {
    double square = std::pow(Base::data_norm(), 2);
    if (scale_ == Scale::log)
      for (const double weight : weights_) square += weight * weight;
    return std::sqrt(square);
  }

  bool evaluate(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian) const override {
    [[maybe_unused]] const auto entered = choice_.enter_model();
    const Candidate<Model> at = this->candidate(x);
    const Parameters<Model>& p = at.parameters;
    const std::vector<std::size_t>& free = choice_.model();
    const std::size_t width = choice_.size();
    const double toughness = at.constants[kToughness];  // of ln f: ln Gc/GIc is less by so much
    bool finite = true;
    if constexpr (HasLanes<Model>) {
      if (scale_ == Scale::log) {
        lanes_.log_toughness(
            p[0], [&](std::size_t begin, std::size_t n, const double* value, const double* slope, const double*) {
              for (std::size_t j = 0; j < n; ++j) {
                const std::size_t i = begin + j;
                residuals[i] = weights_[i] * (value[j] + toughness) - targets_[i];
                finite &= std::isfinite(residuals[i]);
                if (jacobian.empty()) continue;
                if (width > free.size()) jacobian[i * width + free.size()] = weights_[i];
                if (free.empty()) continue;
                jacobian[i * width] = weights_[i] * slope[j];
                finite &= std::isfinite(jacobian[i * width]);
              }
            });
        return finite;
      }
    }
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (jacobian.empty()) {
        residuals[i] = residual(i, log_toughness_alone<Model>(p, points_[i].mixity) + toughness);
        finite &= std::isfinite(residuals[i]);
        continue;
      }
      const auto log_f = Model::log_toughness(p, points_[i].mixity);
      residuals[i] = residual(i, log_f.value + toughness);
      finite &= std::isfinite(residuals[i]);
      const double f = scale_ == Scale::log ? 1 : std::exp(log_f.value + toughness);  // df = f d(ln f)
      for (std::size_t k = 0; k < free.size(); ++k) {
        const double slope = weights_[i] * f * log_f.gradient[free[k]];
        jacobian[i * width + k] = slope;
        finite &= std::isfinite(slope);
      }
      if (width > free.size()) jacobian[i * width + free.size()] = weights_[i] * f;
    }
    return finite;
  }

  /// At some of many points, evenly over the file.
  bool evaluate_roughly(std::span<const double> x, std::span<double> residuals) const override {
    if (HasLanes<Model> && scale_ == Scale::log) return evaluate(x, residuals, {});
    constexpr std::size_t kSample = 32;
    [[maybe_unused]] const auto entered = choice_.enter_model();
    const Candidate<Model> at = this->candidate(x);
    std::fill(residuals.begin(), residuals.end(), 0.0);
    for (std::size_t i = 0; i < points_.size(); i += std::max<std::size_t>(points_.size() / kSample, 1)) {
      residuals[i] =
          residual(i, log_toughness_alone<Model>(at.parameters, points_[i].mixity) + at.constants[kToughness]);
      if (!std::isfinite(residuals[i])) return false;
    }
    return true;
  }

  std::unique_ptr<Cost> cost() const override {
    if constexpr (HasLanes<Model>) {
      if (scale_ == Scale::log && choice_.size() == 1 && choice_.model().size() == 1)
        return std::make_unique<PackedToughness<Model>>(lanes_, targets_, weights_);
    }
    return Problem::cost();
  }

 private:
  using Base = ModelProblem<Model>;
  using Base::choice_, Base::targets_, Base::weights_;

  double residual(std::size_t i, double log_f) const {
    return weights_[i] * (scale_ == Scale::log ? log_f : std::exp(log_f)) - targets_[i];
  }

  std::vector<ToughnessPoint> points_;
  Scale scale_;
  ToughnessLanes<Model> lanes_;
};

/// The same in ln f, with constants of the experiment free: the points' psi and f follow from these.
template <class Model>
class ToughnessOfLoads final : public ModelProblem<Model> {
 public:
  /// `weights`: 1/standard error of each point's ln f, or empty: 1.
  ToughnessOfLoads(std::vector<MeasuredPoint> points, FreeChoice<Model> choice, std::vector<double> weights = {})
      : Base(std::move(choice)), points_(std::move(points)) {
    weights_ = std::move(weights);
    weights_.resize(points_.size(), 1.0);
    for (std::size_t i = 0; i < points_.size(); ++i)
      targets_.push_back(weights_[i] *
                         std::log(toughness_of_area(points_[i].P, std::abs(points_[i].T), points_[i].A)->ratio));
  }

  double data_norm() const override {
    return std::hypot(Base::data_norm(), std::sqrt(static_cast<double>(points_.size())));
  }

  bool evaluate(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian) const override {
    [[maybe_unused]] const auto entered = choice_.enter_model();
    const Candidate<Model> at = this->candidate(x);
    const ConstantsScale scale(at.constants);
    bool finite = true;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const MeasuredPoint scaled{scale.load(points_[i].P), scale.shear(points_[i].T), scale.true_area(points_[i].A), 0,
                                 0};
      const auto r = scaled.A > 0 ? toughness_residual<Model>(at.parameters, scaled) : std::nullopt;
      if (!r) return false;
      residuals[i] = weights_[i] * r->value;
      finite &= std::isfinite(residuals[i]);
      if (jacobian.empty()) continue;
      const std::span<double> row = jacobian.subspan(i * choice_.size(), choice_.size());
      choice_.fill_row(row, r->parameters.data(), {r->P, r->T, r->A}, scaled, scale);
      for (double& slope : row) {
        slope *= weights_[i];
        finite &= std::isfinite(slope);
      }
    }
    return finite;
  }

 private:
  using Base = ModelProblem<Model>;
  using Base::choice_, Base::targets_, Base::weights_;
  std::vector<MeasuredPoint> points_;
};

}  // namespace mixity
