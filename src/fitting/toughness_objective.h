// Objective `toughness`, as in the paper: ln f (or f) of the model minus that of the points, at the points' psi.
#pragma once

#include <memory>
#include <vector>

#include "fitting/model_problem.h"
#include "fitting/options.h"
#include "mechanics/measurement.h"

namespace mixity {

class ToughnessObjective final : public WeightedProblem {
 public:
  /// `weights`: 1/standard error of each point's target, or empty: 1. The only constant that can be fitted is the
  /// toughness, in ln f.
  ToughnessObjective(const std::vector<ToughnessPoint>& points, Scale scale, FreeChoice choice,
                     std::vector<double> weights = {});

  /// The rounding error of ln f is at least that of f, one eps, however small ln f is.
  double data_norm() const override;
  bool evaluate(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian) const override;
  /// Uses a sample of the points, spread evenly over the file.
  bool evaluate_roughly(std::span<const double> x, std::span<double> residuals) const override;
  std::unique_ptr<Cost> cost() const override;

 private:
  bool is_packed() const { return packed_.size() > 0; }
  double residual(std::size_t i, double log_f) const;

  Scale scale_;
  PackedMixities packed_;                 // if the model has a packed form; else empty
  std::vector<Mixity<double>> mixities_;  // empty if the points are packed
};

/// The same in ln f with free constants of the experiment, on which psi and f of the points depend.
class ToughnessOfLoads final : public WeightedProblem {
 public:
  /// `weights`: 1/standard error of each point's ln f, or empty: 1. Targets are computed with the constants that are
  /// not free.
  ToughnessOfLoads(MeasuredPoints points, FreeChoice choice, std::vector<double> weights = {});

  double data_norm() const override;
  bool evaluate(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian) const override;

 private:
  MeasuredPoints points_;
};

}  // namespace mixity
