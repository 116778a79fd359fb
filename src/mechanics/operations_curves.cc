#include "mechanics/constant_shear.h"
#include "mechanics/equilibrium.h"
#include "mechanics/limits.h"
#include "mechanics/operations.h"
#include "mechanics/regimes.h"
#include "mechanics/sampling.h"

namespace mixity {
namespace {

template <class Law>
class CurvesOf final : public CurveOperations {
 public:
  explicit CurvesOf(const ExpressionLaw* law) : held_(law) {}

  double first_stable_end(ParameterSpan p, double P) const override {
    const auto use = held_.use();
    return LoadedContact(use.law, parameters_from<Law>(p), P).branches().front().T_bottom;
  }

  std::vector<Fold> folds(ParameterSpan p, double P, Control control) const override {
    const auto use = held_.use();
    return find_folds(EquilibriumCurve(use.law, parameters_from<Law>(p), P), control);
  }

  RegimeReport regime(ParameterSpan p, double P, std::optional<double> tau0) const override {
    const auto use = held_.use();
    return classify(use.law, parameters_from<Law>(p), P, tau0);
  }

  SampledCurve curve(ParameterSpan p, double P, const CurveSampling& sampling) const override {
    const auto use = held_.use();
    const EquilibriumCurve curve(use.law, parameters_from<Law>(p), P);
    if (curve.uncoupled()) return {{curve.point(0)}, true};
    auto ranges = drawable_ranges(curve, sampling.T_most ? *sampling.T_most : kFarthestDrawn * shear_scale(curve));
    if (sampling.first_range_only) ranges.resize(1);
    switch (sampling.rule) {
      case CurveSampling::Rule::even:
        return {sample_uniform(curve, ranges, std::max<std::size_t>(sampling.points, 2)), false};
      case CurveSampling::Rule::fewest:
        return {sample_adaptive(curve, ranges, sampling.chord), false};
      case CurveSampling::Rule::soonest:
        break;
    }
    return {sample_halved(curve, ranges, sampling.chord), false};
  }

  std::vector<ConstantShearPoint> at_constant_shear(ParameterSpan p, double T,
                                                    std::span<const double> y) const override {
    const auto use = held_.use();
    std::vector<ConstantShearPoint> points;
    points.reserve(y.size());
    for (const double edge_load : y)
      points.push_back(constant_shear_point(use.law, parameters_from<Law>(p), T, edge_load));
    return points;
  }

  double critical_load(ParameterSpan p) const override {
    const auto use = held_.use();
    return mixity::critical_load(use.law, parameters_from<Law>(p));
  }

  std::optional<double> shear_sensitivity(ParameterSpan p, double A0) const override {
    const auto use = held_.use();
    return shear_sensitivity_at_area(use.law, parameters_from<Law>(p), A0);
  }

 private:
  HeldLaw<Law> held_;
};

}  // namespace

template <class Law>
std::unique_ptr<const CurveOperations> curve_operations(const ExpressionLaw* law) {
  return std::make_unique<CurvesOf<Law>>(law);
}

namespace {
[[gnu::used]] const auto curve_instances = each_law([]<class Law>() { return &curve_operations<Law>; });
}  // namespace

}  // namespace mixity
