// The cost of a problem with one free parameter, as the batch engine sees it: with derivatives, and with a weight for
// each point, so that refits of resampled data share the arrays.
#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "fitting/least_squares.h"

namespace mixity {

/// sum of weight_i r_i^2 and its derivatives in the parameter.
struct CostValue {
  double value = 0, slope = 0, curvature = 0;
  double slope_size = 0;  // sqrt(sum w r'^2), for the scale-free test of the slope
  bool finite = false;
};

/// Not shared between threads: it owns its scratch arrays.
class SingleCost {
 public:
  virtual ~SingleCost() = default;
  /// False if the curvature is Gauss-Newton's, without r r''.
  virtual bool exact_curvature() const { return false; }
  /// Weights: one per point, or empty: 1.
  virtual CostValue at(double x, std::span<const double> weights) = 0;
  /// The cost alone, unweighted; null if it is not finite.
  virtual std::optional<double> value(double x) {
    const CostValue cost = at(x, {});
    return cost.finite ? std::optional(cost.value) : std::nullopt;
  }
};

/// For any problem with one free parameter, through its residuals and Jacobian.
class GeneralCost final : public SingleCost {
 public:
  explicit GeneralCost(const LeastSquares& problem)
      : problem_(problem), residuals_(problem.residual_count()), slopes_(problem.residual_count()) {}

  CostValue at(double x, std::span<const double> weights) override {
    CostValue cost;
    if (!problem_.evaluate({&x, 1}, residuals_, slopes_)) return cost;
    for (std::size_t i = 0; i < residuals_.size(); ++i) {
      const double w = weights.empty() ? 1 : weights[i];
      cost.value += w * residuals_[i] * residuals_[i];
      cost.slope += 2 * w * residuals_[i] * slopes_[i];
      cost.curvature += 2 * w * slopes_[i] * slopes_[i];
    }
    cost.slope_size = std::sqrt(0.5 * cost.curvature);
    cost.finite = std::isfinite(cost.value) && std::isfinite(cost.slope) && std::isfinite(cost.curvature);
    return cost;
  }

  std::optional<double> value(double x) override { return sum_of_squares(problem_, {&x, 1}, residuals_); }

 private:
  const LeastSquares& problem_;
  std::vector<double> residuals_, slopes_;
};

}  // namespace mixity
