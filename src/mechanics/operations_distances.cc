#include <cmath>

#include "mechanics/curve_distance.h"
#include "mechanics/energy_plane.h"
#include "mechanics/operations.h"
#include "mechanics/sensitivity.h"

namespace mixity {
namespace {

template <class Law>
class DistancesOf final : public DistanceOperations {
 public:
  explicit DistancesOf(const ExpressionLaw* law) : held_(law) {}

  void make_continuous([[maybe_unused]] std::span<double> p) const override {
    if constexpr (requires(const Law& law, Parameters<Law> at) { law.continuous(at); }) {
      const auto next = held_.use().law.continuous(parameters_from<Law>(p));
      std::copy(next.begin(), next.end(), p.begin());
    }
  }

  /// From the equilibrium condition F of sensitivity.h: -ln((y^2 + tau^2)/(6 pi (y + P))).
  bool toughness_residuals(ParameterSpan parameters, std::span<const double> P, std::span<const double> T,
                           std::span<const double> A, const ToughnessResiduals& out) const override {
    const auto use = held_.use();
    const auto p = parameters_from<Law>(parameters);
    for (std::size_t i = 0; i < P.size(); ++i) {
      if (!(A[i] > 0)) return false;
      const double a = radius_from_area(A[i]), y = edge_load(a, P[i]), sum = y + P[i];
      if (!(y > 0)) return false;
      const EquilibriumGradient<Law> F = equilibrium_gradient(use.law, p, P[i], std::abs(T[i]), y);
      out.value[i] = -std::log(F.held / (6 * pi<double>() * sum));
      for (std::size_t k = 0; k < p.size(); ++k) out.parameters[i * p.size() + k] = -F.parameters[k] / F.held;
      // F = held - 6 pi sum, and dsum/dA = 2 a/pi
      const double growth = 2 * a / pi<double>();
      out.A[i] = growth / sum - (F.A + 6 * pi<double>() * growth) / F.held;
      out.T[i] = -std::copysign(F.T, T[i]) / F.held;
      out.P[i] = -F.P / F.held;
    }
    return true;
  }

  bool curve_distances(ParameterSpan p, const PlanePoints& points, Search search, bool derivatives,
                       CurveDistances& out) const override {
    const auto use = held_.use();
    return mixity::curve_distances(use.law, parameters_from<Law>(p), points, search, derivatives, out);
  }

  void energy_distances(ParameterSpan parameters, const EnergyPoints& points,
                        const EnergyDistances& out) const override {
    const auto use = held_.use();
    const EnergyLaw law(use.law, parameters_from<Law>(parameters));
    for (std::size_t i = 0; i < points.G_I.size(); ++i) {
      const EnergyDistance<Law> r = law.distance(points.G_I[i], points.G_II[i], points.sigma_I[i], points.sigma_II[i],
                                                 points.G_Ic[i], !out.parameters.empty());
      out.value[i] = r.value;
      out.log_toughness[i] = r.log_toughness;
      if (out.parameters.empty()) continue;
      const std::size_t n = r.parameters.size();
      std::copy(r.parameters.begin(), r.parameters.end(), out.parameters.begin() + static_cast<std::ptrdiff_t>(i * n));
    }
  }

  void rough_energy_distances(ParameterSpan parameters, const EnergyPoints& points,
                              std::span<double> out) const override {
    const auto use = held_.use();
    const EnergyPolygon law(use.law, parameters_from<Law>(parameters));
    for (std::size_t i = 0; i < points.G_I.size(); ++i)
      out[i] = law.distance(points.G_I[i], points.G_II[i], points.sigma_I[i], points.sigma_II[i], points.G_Ic[i]);
  }

 private:
  HeldLaw<Law> held_;
};

}  // namespace

template <class Law>
std::unique_ptr<const DistanceOperations> distance_operations(const ExpressionLaw* law) {
  return std::make_unique<DistancesOf<Law>>(law);
}

namespace {
[[gnu::used]] const auto distance_instances = each_law([]<class Law>() { return &distance_operations<Law>; });
}  // namespace

}  // namespace mixity
