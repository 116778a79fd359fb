// Objective `toughness` in ln f on packed arrays: one vectorised sweep gives the cost and both derivatives.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "mechanics/contact_model.h"
#include "solver/problem.h"

namespace mixity {

/// Calls use(begin, n, value, slope, curvature) for the points begin..begin + n - 1, all in order: ln f and its
/// derivatives in the parameter, in chunks that stay in the processor's cache. Each begins at a multiple of four.
template <class Use>
void sweep_log_toughness(const ContactModel& model, const PackedMixities& points, double parameter, const Use& use) {
  constexpr std::size_t kChunk = 512;
  std::array<double, kChunk> value, slope, curvature;
  for (std::size_t begin = 0; begin < points.size(); begin += kChunk) {
    const std::size_t n = std::min(kChunk, points.size() - begin);
    model.packed_log_toughness(parameter, points, begin, n, value.data(), slope.data(), curvature.data());
    use(begin, n, value.data(), slope.data(), curvature.data());
  }
}

/// Of a model with one parameter that has a packed form.
class PackedToughness final : public Cost {
 public:
  /// `targets`: weights times ln f of the points; `weights`: 1/standard error, as ToughnessObjective has them. All of
  /// these must outlive this.
  PackedToughness(const ContactModel& model, const PackedMixities& points, const std::vector<double>& targets,
                  const std::vector<double>& weights)
      : model_(model), points_(points), targets_(targets), weights_(weights) {}

  bool exact_curvature() const override { return true; }
  void at(std::span<const double> x, std::span<const double> weights, CostValue& cost) override;

 private:
  const ContactModel& model_;
  const PackedMixities& points_;
  const std::vector<double>&targets_, &weights_;
};

}  // namespace mixity
