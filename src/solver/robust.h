// Robust losses: large residuals count less. A problem with the cost sum rho(r^2) is a least-squares problem in the
// residuals sign(r) sqrt(rho(r^2)), so the rest of the solver needs no special case. With `t` the cost is -2 ln L of
// Student's distribution up to a constant: (nu + 1) ln(1 + r^2/scale^2), scale^2 = nu times its scale squared.
#pragma once

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "solver/options.h"
#include "solver/problem.h"
#include "statistics/readings.h"

namespace mixity {

class RobustProblem final : public WrappedProblem {
 public:
  /// `scale` > 0 in units of the residuals of `problem`, which must outlive this object. `freedom`: nu, for `t`.
  RobustProblem(const Problem& problem, Loss loss, double scale, double freedom = 0)
      : WrappedProblem(problem), loss_(loss), scale_(scale), root_(loss == Loss::t ? std::sqrt(freedom + 1) : scale) {}

  /// A likelihood does not depend on the unit of the residuals.
  bool known_errors() const override { return loss_ == Loss::t || problem_.known_errors(); }

  /// The loss may have basins of a standard error's width, narrower than the usual steps.
  std::size_t scan_density(std::size_t searched) const override { return searched == 1 ? 512 : searched == 2 ? 16 : 8; }

  std::size_t parts() const override { return problem_.parts(); }
  std::size_t memory_of_parts() const override { return problem_.memory_of_parts(); }
  bool evaluate_part(std::size_t part, std::span<const double> x, std::vector<double>& residuals,
                     std::vector<double>& jacobian) const override {
    if (!problem_.evaluate_part(part, x, residuals, jacobian)) return false;
    change(x, residuals, jacobian);
    return true;
  }
  bool evaluate_part_again(std::size_t part, std::span<const double> x, std::vector<double>& residuals,
                           std::vector<double>& jacobian, std::span<double> memory) const override {
    if (!problem_.evaluate_part_again(part, x, residuals, jacobian, memory)) return false;
    change(x, residuals, jacobian);
    return true;
  }

  /// d^2(rho/2)/dr^2 divided by the squared slope of the new residual; 0 for Huber's outliers, negative for Cauchy's.
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
  void change(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian) const override {
    for (std::size_t i = 0; i < residuals.size(); ++i) {
      const double r = residuals[i], size = std::abs(r) / scale_;
      const bool outlier = loss_ != Loss::huber || size > 1;
      if (!outlier || r == 0) continue;
      const double rho = loss_ == Loss::huber ? 2 * size - 1 : std::log1p(size * size);
      const double slope = loss_ == Loss::huber ? 1 / size : 1 / (1 + size * size);  // d rho/d(size^2)
      residuals[i] = std::copysign(root_ * std::sqrt(rho), r);
      const double factor = root_ / scale_ * slope * size / std::sqrt(rho);
      if (jacobian.empty()) continue;
      for (double& one : jacobian.subspan(i * x.size(), x.size())) one *= factor;
    }
  }

  Loss loss_;
  double scale_, root_;  // where the loss bends; the residual where rho is 1
};

/// Standard error of residuals of unknown size (at least one), from the median of their absolute values.
inline double spread(std::vector<double> residuals) {
  for (double& r : residuals) r = std::abs(r);
  return kOfMedian * median(std::move(residuals));
}
/// The same for the residuals at x; 0 if there are none, or if one is not finite.
inline double spread(const Problem& problem, const std::vector<double>& x) {
  std::vector<double> residuals(problem.residual_count());
  if (residuals.empty() || !problem.evaluate(x, residuals, {})) return 0;
  return spread(std::move(residuals));
}

/// The value of the only parameter with the smallest spread: outliers may hide every minimum of the squares.
inline std::vector<double> value_of_least_spread(const Problem& problem) {
  if (problem.parameters().size() != 1) return {};
  const FreeParameter& parameter = problem.parameters()[0];
  const double width = parameter.upper - parameter.lower;
  std::vector<double> best;
  double least = std::numeric_limits<double>::infinity();
  constexpr int kValues = 100;
  for (int i = 1; i < kValues; ++i)
    for (const double share : {i / double{kValues}, std::pow(10.0, -8.0 * i / kValues)}) {
      const std::vector<double> x{parameter.lower + share * width};
      const double here = spread(problem, x);
      if (!(here > 0 && here < least)) continue;
      least = here;
      best = x;
    }
  return best;
}

}  // namespace mixity
