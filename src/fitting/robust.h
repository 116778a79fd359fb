// Robust losses: large residuals count less. The problem with cost sum rho(r^2) is again one of least squares, in the
// residuals sign(r) sqrt(rho(r^2)), so that scan, solver and verdict need not know.
#pragma once

#include <string_view>

#include "fitting/least_squares.h"

namespace mixity {

enum class Loss { none, huber, cauchy };
constexpr std::string_view to_string(Loss loss) {
  return loss == Loss::none ? "none" : loss == Loss::huber ? "huber" : "cauchy";
}

/// Scales, in standard errors, at which the loss keeps 95 % efficiency for Gaussian errors (Huber 1964; Holland &
/// Welsch 1977).
constexpr double usual_scale(Loss loss) { return loss == Loss::cauchy ? 2.3849 : 1.345; }

class RobustProblem final : public WrappedProblem {
 public:
  /// `scale` > 0 in units of the residuals of `problem`, which must outlive this.
  RobustProblem(const LeastSquares& problem, Loss loss, double scale)
      : WrappedProblem(problem), loss_(loss), scale_(scale) {}

  /// The loss bends within a standard error: its basins may be narrower than the usual steps.
  std::size_t scan_density() const override { return 512; }
  std::size_t bends_passed(std::span<const double> x) const override { return problem_.bends_passed(x); }
  std::vector<LoadEnds> load_ends() const override { return problem_.load_ends(); }

  bool evaluate(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian) const override {
    if (!problem_.evaluate(x, residuals, jacobian)) return false;
    const std::size_t p = parameters().size();
    for (std::size_t i = 0; i < residuals.size(); ++i) {
      const double r = residuals[i], size = std::abs(r) / scale_;
      const bool outlier = loss_ == Loss::cauchy || size > 1;
      if (!outlier || r == 0) continue;
      const double rho = loss_ == Loss::huber ? 2 * size - 1 : std::log1p(size * size);
      const double slope = loss_ == Loss::huber ? 1 / size : 1 / (1 + size * size);  // d rho/d(size^2)
      residuals[i] = std::copysign(scale_ * std::sqrt(rho), r);
      const double factor = slope * size / std::sqrt(rho);
      if (!jacobian.empty())
        for (std::size_t k = 0; k < p; ++k) jacobian[i * p + k] *= factor;
    }
    return true;
  }

  /// d^2(rho/2)/dr^2 over the square of the residual's own slope; 0 for Huber's outliers, negative for Cauchy's.
  std::vector<double> curvatures(std::span<const double> x) const override {
    std::vector<double> values(residual_count(), 1.0);
    if (!problem_.evaluate(x, values, {})) return {};
    for (double& value : values) {
      const double square = std::pow(value / scale_, 2);
      if (loss_ == Loss::huber)
        value = square > 1 ? 0 : 1;
      else
        value = square > 0 ? (1 - square) * std::log1p(square) / square : 1;
    }
    return values;
  }

 private:
  Loss loss_;
  double scale_;
};

}  // namespace mixity
