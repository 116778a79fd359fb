#include <cmath>

#include "mechanics/equilibrium.h"
#include "mechanics/operations.h"
#include "mechanics/packed_toughness.h"

namespace mixity {
namespace {

template <class Law>
class ToughnessOf final : public ToughnessOperations {
 public:
  explicit ToughnessOf(const ExpressionLaw* law) : held_(law) {}

  void toughness_ratios(std::span<const Values> parameters, Values psi, std::span<double> f) const override {
    const auto use = held_.use();
    for (std::size_t i = 0; i < f.size(); ++i) {
      const auto p = parameters_at<Law>(parameters, i);
      if (!(psi[i] >= 0 && psi[i] <= kLargestPhaseAngle) || !in_bounds(use.law, p)) continue;
      f[i] = std::exp(log_toughness_alone(use.law, p, mixity_from_angle(psi[i])));
    }
  }

  void log_toughness(ParameterSpan parameters, std::span<const Mixity<double>> at, std::span<double> value,
                     std::span<double> gradient) const override {
    const auto use = held_.use();
    const auto p = parameters_from<Law>(parameters);
    for (std::size_t i = 0; i < at.size(); ++i) {
      if (gradient.empty()) {
        value[i] = log_toughness_alone(use.law, p, at[i]);
        continue;
      }
      const auto log_f = use.law.log_toughness(p, at[i]);
      value[i] = log_f.value;
      std::copy(log_f.gradient.begin(), log_f.gradient.end(),
                gradient.begin() + static_cast<std::ptrdiff_t>(i * p.size()));
    }
  }

  bool has_packed_form() const override { return HasPackedForm<Law>; }

  PackedMixities packed(std::span<const Mixity<double>> at) const override {
    PackedMixities points;
    if constexpr (HasPackedForm<Law>) {
      points.first.reserve(at.size());
      points.second.reserve(at.size());
      for (const Mixity<double>& mixity : at) {
        const PackedPoint<double> point = held_.use().law.packed_point(mixity);
        points.first.push_back(point.first);
        points.second.push_back(point.second);
      }
    }
    return points;
  }

  void packed_log_toughness([[maybe_unused]] double parameter, [[maybe_unused]] const double* first,
                            [[maybe_unused]] const double* second, [[maybe_unused]] std::size_t n,
                            [[maybe_unused]] double* value, [[maybe_unused]] double* slope,
                            [[maybe_unused]] double* curvature) const override {
    if constexpr (HasPackedForm<Law>)
      mixity::packed_log_toughness(held_.use().law, parameter, first, second, n, value, slope, curvature);
  }

 private:
  HeldLaw<Law> held_;
};

}  // namespace

template <class Law>
std::unique_ptr<const ToughnessOperations> toughness_operations(const ExpressionLaw* law) {
  return std::make_unique<ToughnessOf<Law>>(law);
}

namespace {
[[gnu::used]] const auto toughness_instances = each_law([]<class Law>() { return &toughness_operations<Law>; });
}  // namespace

}  // namespace mixity
