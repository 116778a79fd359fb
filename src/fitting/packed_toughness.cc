#include "fitting/packed_toughness.h"

#include <cmath>

namespace mixity {

void PackedToughness::at(std::span<const double> x, std::span<const double> weights, CostValue& cost) {
  // Four sums of each kind, which compilers keep in vector registers; the order is fixed, so is the result.
  double value[4]{}, slope[4]{}, square[4]{}, bend[4]{};
  sweep_log_toughness(model_, points_, x[0],
                      [&](std::size_t begin, std::size_t n, const double* f, const double* f1, const double* f2) {
                        for (std::size_t j = 0; j < n; ++j) {
                          const std::size_t i = begin + j, k = j % 4;
                          const double w = weights.empty() ? 1 : weights[i];
                          const double r = weights_[i] * f[j] - targets_[i], d = weights_[i] * f1[j];
                          value[k] += w * r * r;
                          slope[k] += w * r * d;
                          square[k] += w * d * d;
                          bend[k] += w * r * weights_[i] * f2[j];
                        }
                      });
  const auto sum = [](const double* s) { return (s[0] + s[1]) + (s[2] + s[3]); };
  cost.value = sum(value);
  cost.gradient.setConstant(1, sum(slope));
  cost.hessian.setConstant(1, 1, sum(square) + sum(bend));
  cost.slope_size.setConstant(1, std::sqrt(sum(square)));
  cost.finite = std::isfinite(cost.value) && std::isfinite(cost.gradient[0]) && std::isfinite(cost.hessian(0, 0));
}

}  // namespace mixity
