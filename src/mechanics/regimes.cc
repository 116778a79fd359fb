#include "mechanics/regimes.h"

#include <algorithm>

#include "mechanics/roots.h"

namespace mixity {

template <class Model>
RegimeReport classify(const Parameters<Model>& p, double P, std::optional<double> tau0) {
  const LoadedContact<Model> contact(p, P);
  const StableBranch& branch = contact.branches().front();
  RegimeReport report{Regime::hertz, Regime::hertz, branch.T_bottom, {}, {}};
  if (branch.ends_in_fold) {
    report.fracture = Regime::jump;
    report.jumps_to = find_folds(EquilibriumCurve<Model>(p, P), {Control::Kind::load}).front().jumps_to;
  } else if (std::isinf(branch.T_bottom)) {
    report.fracture = Regime::asymptote;
  }
  report.regime = report.fracture;
  if (!tau0) return report;
  // T - tau0 A(T) rises along the branch, since A falls: one crossing at most.
  const auto area = [&](double T) { return area_from_radius(radius_from_edge_load(contact.at(T).y, P)); };
  const auto excess = [&](double T) { return T - *tau0 * area(T); };
  const double high = std::min({branch.T_bottom, *tau0 * area(0), kLargestLoad});
  if (!(excess(high) >= 0)) return report;
  report.T_strength = root_between(excess, 0.0, high);
  report.regime = Regime::strength;
  return report;
}

CuspPoint model_a_jump_boundary(double P) {
  constexpr double kLargestX = 0.5;
  if (P <= model_a_cusp(kLargestX).P) {
    const double lambda = model_a_closing_lambda(P);
    return {P, lambda, 1 - lambda};
  }
  // P is about 9 pi/(32 X) for small X
  const auto excess = [&](double X) { return model_a_cusp(X).P - P; };
  CuspPoint cusp = model_a_cusp(root_between(excess, 0.25 / (1 + std::max(P, 0.0)), kLargestX));
  cusp.P = P;
  return cusp;
}

namespace {
[[gnu::used]] const auto regime_instances = each_model([](auto model) { return &classify<decltype(model)>; });
}  // namespace

}  // namespace mixity
