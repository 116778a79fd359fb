// Coefficient of determination, RMS and largest residual.
#pragma once

#include <cmath>
#include <optional>
#include <span>

namespace mixity {

struct Goodness {
  std::optional<double> r2;  // null if the targets do not vary or are fewer than two
  double rmse = 0, max_abs_residual = 0;
};

/// residuals, targets and weights (1/standard error, or empty: 1) of equal length > 0; residuals and targets are the
/// weighted ones. R^2 = 1 - SS_res/SS_tot about the weighted mean of the data.
inline Goodness goodness(std::span<const double> residuals, std::span<const double> targets,
                         std::span<const double> weights = {}) {
  double sum = 0, weight = 0, squares = 0, scatter = 0;
  Goodness result;
  const auto weight_of = [&](std::size_t i) { return weights.empty() ? 1.0 : weights[i]; };
  for (std::size_t i = 0; i < targets.size(); ++i) {
    sum += weight_of(i) * targets[i];
    weight += weight_of(i) * weight_of(i);
  }
  const double mean = sum / weight;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    const double off = targets[i] - weight_of(i) * mean;
    squares += residuals[i] * residuals[i];
    scatter += off * off;
    result.max_abs_residual = std::fmax(result.max_abs_residual, std::abs(residuals[i]));
  }
  result.rmse = std::sqrt(squares / static_cast<double>(residuals.size()));
  if (targets.size() >= 2 && scatter > 0) result.r2 = 1 - squares / scatter;
  return result;
}

}  // namespace mixity
