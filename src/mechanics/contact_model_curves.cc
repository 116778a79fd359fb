#include "mechanics/any_law.h"
#include "mechanics/constant_shear.h"
#include "mechanics/contact_model.h"
#include "mechanics/elliptic_model.h"
#include "mechanics/equilibrium.h"
#include "mechanics/held_model.h"
#include "mechanics/limits.h"
#include "mechanics/regimes.h"
#include "mechanics/sampling.h"

namespace mixity {

double ContactModel::first_stable_end(ParameterSpan p, double P) const {
  if (law_->held) return held::first_stable_end(*law_, p, P);
  if (law_->ellipse) return elliptic::first_stable_end(*law_->ellipse, p, P);
  return with_contact(*law_, p, P, 0.0, [&](const auto& law, const auto& values) {
    return LoadedContact(law, values, P).branches().front().T_bottom;
  });
}

std::vector<Fold> ContactModel::folds(ParameterSpan p, double P, Control control) const {
  if (law_->held) return held::folds(*law_, p, P, control);
  if (law_->ellipse) return elliptic::folds(*law_->ellipse, p, P, control);
  return with_contact(*law_, p, P, std::vector<Fold>(), [&](const auto& law, const auto& values) {
    return find_folds(EquilibriumCurve(law, values, P), control);
  });
}

std::optional<EllipseBranchEnd> ContactModel::closing(ParameterSpan p, double P, Control control) const {
  return law_->ellipse ? elliptic::closing(*law_->ellipse, p, P, control) : std::nullopt;
}

std::optional<RegimeReport> ContactModel::regime(ParameterSpan p, double P, std::optional<double> tau0) const {
  if (law_->ellipse || law_->held) return std::nullopt;
  return with_contact(*law_, p, P, std::optional<RegimeReport>(),
                      [&](const auto& law, const auto& values) { return classify(law, values, P, tau0); });
}

SampledCurve ContactModel::curve(ParameterSpan p, double P, const CurveSampling& sampling) const {
  if (law_->held) return held::curve(*law_, p, P, sampling);
  if (law_->ellipse) return elliptic::curve(*law_->ellipse, p, P, sampling);
  return with_contact(*law_, p, P, SampledCurve{{}, false}, [&](const auto& law, const auto& values) -> SampledCurve {
    const EquilibriumCurve curve(law, values, P);
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
  });
}

std::vector<ConstantShearPoint> ContactModel::at_constant_shear(ParameterSpan p, double T,
                                                                std::span<const double> y) const {
  if (law_->ellipse) return {};
  if (law_->held) return held::at_constant_shear(*law_, p, T, y);
  return with_law(*law_, p, [&](const auto& law, const auto& values) {
    std::vector<ConstantShearPoint> points;
    points.reserve(y.size());
    for (const double edge_load : y) points.push_back(constant_shear_point(law, values, T, edge_load));
    return points;
  });
}

std::optional<double> ContactModel::critical_load(ParameterSpan p) const {
  if (law_->ellipse || law_->held || !obstacle(p).empty()) return std::nullopt;
  return with_law(*law_, p, [](const auto& law, const auto& values) { return mixity::critical_load(law, values); });
}

std::optional<std::span<const RegimeBoundary>> ContactModel::regime_boundaries() const {
  return mixity::regime_boundaries(info().key);
}

std::optional<double> ContactModel::shear_sensitivity(ParameterSpan p, double A0) const {
  if (law_->held) return held::shear_sensitivity(*law_, p, A0);
  const std::optional<double> P = jkr_load(A0);
  if (!P) return std::nullopt;
  if (law_->ellipse) return elliptic::shear_sensitivity(*law_->ellipse, p, *P);
  return with_law(*law_, p,
                  [&](const auto& law, const auto& values) { return mixity::shear_sensitivity(law, values, *P); });
}

}  // namespace mixity
