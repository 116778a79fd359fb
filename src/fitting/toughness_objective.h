// Objective `toughness`, the paper's: ln f (or f) of the model minus that of the points, at the points' psi.
#pragma once

#include <cmath>
#include <string_view>
#include <utility>

#include "fitting/least_squares.h"
#include "mechanics/registry.h"

namespace mixity {

enum class Scale { log, linear };
constexpr std::string_view to_string(Scale scale) { return scale == Scale::log ? "log" : "linear"; }

/// What the objective needs of a point.
struct ToughnessPoint {
  Mixity<double> mixity;
  double ratio;  // G_c/G_Ic > 0
};

template <class Model>
class ToughnessObjective final : public LeastSquares {
 public:
  static constexpr std::size_t kAll = parameter_count<Model>;

  /// `held[i]` says which parameters keep their value in `base`; the others are free.
  ToughnessObjective(std::vector<ToughnessPoint> points, Scale scale, Parameters<Model> base,
                     const std::array<bool, kAll>& held)
      : points_(std::move(points)), scale_(scale), base_(base) {
    for (std::size_t i = 0; i < kAll; ++i)
      if (!held[i]) {
        const ParameterInfo& info = Model::parameters[i];
        free_.push_back(i);
        parameters_.push_back({std::string(info.name), info.lower, info.upper});
      }
    targets_.reserve(points_.size());
    for (const ToughnessPoint& point : points_)
      targets_.push_back(scale_ == Scale::log ? std::log(point.ratio) : point.ratio);
  }

  std::size_t residual_count() const override { return points_.size(); }
  const std::vector<FreeParameter>& parameters() const override { return parameters_; }
  const std::vector<double>& targets() const { return targets_; }  // ln f or f of the points

  Parameters<Model> all_parameters(std::span<const double> x) const {
    Parameters<Model> p = base_;
    for (std::size_t k = 0; k < free_.size(); ++k) p[free_[k]] = x[k];
    return p;
  }

  bool evaluate(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian) const override {
    const Parameters<Model> p = all_parameters(x);
    bool finite = true;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const auto log_f = Model::log_toughness(p, points_[i].mixity);
      const double f = scale_ == Scale::log ? 1 : std::exp(log_f.value);  // df = f d(ln f)
      residuals[i] = (scale_ == Scale::log ? log_f.value : f) - targets_[i];
      finite &= std::isfinite(residuals[i]);
      if (jacobian.empty()) continue;
      for (std::size_t k = 0; k < free_.size(); ++k) {
        const double slope = f * log_f.gradient[free_[k]];
        jacobian[i * free_.size() + k] = slope;
        finite &= std::isfinite(slope);
      }
    }
    return finite;
  }

  double data_norm() const override {
    double sum = 0;
    for (const double target : targets_) sum += target * target;
    return std::sqrt(sum);
  }

 private:
  std::vector<ToughnessPoint> points_;
  Scale scale_;
  Parameters<Model> base_;
  std::vector<std::size_t> free_;
  std::vector<FreeParameter> parameters_;
  std::vector<double> targets_;
};

}  // namespace mixity
