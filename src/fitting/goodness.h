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

/// residuals and targets of equal length > 0. R^2 = 1 - SS_res/SS_tot about the mean of the targets.
inline Goodness goodness(std::span<const double> residuals, std::span<const double> targets) {
  double mean = 0, squares = 0, scatter = 0;
  Goodness result;
  for (const double target : targets) mean += target;
  mean /= static_cast<double>(targets.size());
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    squares += residuals[i] * residuals[i];
    scatter += (targets[i] - mean) * (targets[i] - mean);
    result.max_abs_residual = std::fmax(result.max_abs_residual, std::abs(residuals[i]));
  }
  result.rmse = std::sqrt(squares / static_cast<double>(residuals.size()));
  if (targets.size() >= 2 && scatter > 0) result.r2 = 1 - squares / scatter;
  return result;
}

}  // namespace mixity
