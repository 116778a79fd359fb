#include "mechanics/regimes.h"

#include <algorithm>
#include <limits>
#include <tuple>

#include "mechanics/roots.h"

namespace mixity {

template <class Law>
RegimeReport classify(const Law& law, const Parameters<Law>& p, double P, std::optional<double> tau0) {
  const LoadedContact<Law> contact(law, p, P);
  const StableBranch branch = contact.first_branch();  // a copy: `excess` may add the other branches
  RegimeReport report{Regime::hertz, Regime::hertz, branch.T_bottom, {}, {}};
  if (branch.ends_in_fold) {
    report.fracture = Regime::jump;
    report.jumps_to = find_folds(EquilibriumCurve<Law>(law, p, P), {Control::Kind::load}).front().jumps_to;
  } else if (std::isinf(branch.T_bottom)) {
    report.fracture = Regime::asymptote;
  }
  report.regime = report.fracture;
  if (!tau0) return report;
  // T - tau0 A(T) rises along the branch, because A falls: there is at most one crossing.
  const auto area = [&](double T) { return area_from_edge_load(contact.at(T).y, P); };
  const auto excess = [&](double T) { return T - *tau0 * area(T); };
  const double high = std::min({branch.T_bottom, *tau0 * area(0), kLargestLoad});
  if (!(excess(high) >= 0)) return report;
  report.T_strength = root_between(excess, 0.0, high);
  report.regime = Regime::strength;
  return report;
}

template <class Law>
double critical_load(const Law& law, const Parameters<Law>& p) {
  constexpr double kLast = 42, kInfinity = std::numeric_limits<double>::infinity();   // tan psi up to 1e18
  const auto excess = [&](double x) { return law.shear_term(p, 1.0, std::exp(x)); };  // g - 1 and d
  const auto load = [&](double x) {
    const ShearTerm<double> at = excess(x);
    const double rest = 2 + at.d1, growth = 2 * at.value - at.d1;
    // where g falls (a non-monotone law) T rises; a g near 0 has lost its digits
    if (!(growth > 0) || at.value < -1 + 1e-8) return -1.5 * pi<double>();
    return rest > 0 ? 6 * pi<double>() * (at.value - 1 - at.d1) / (rest * rest) : kInfinity;
  };
  double first = -1;  // below, g is 1 to a millionth, and folds occur only near pull-off
  while (first > -700 && std::abs(excess(first).value) > 1e-6) first *= 1.5;
  double most = -1.5 * pi<double>(), x_before = first, before = most, x = first, here = load(first);
  while (x < kLast) {
    const double step = x < 6 ? 0.125 : x < 12 ? 0.25 : 0.5;  // as in the search for folds
    const double x_next = std::min(x + step, kLast), next = load(x_next);
    most = std::max({most, here, next});
    if (most == kInfinity) return most;
    if (here >= before && here >= next) {
      most = std::max(most, -minimum_between([&](double at) { return -load(at); }, x_before, x_next, 40).value);
    }
    x_before = x;
    before = here;
    x = x_next;
    here = next;
  }
  return most;
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

std::optional<std::span<const RegimeBoundary>> regime_boundaries(std::string_view key) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  static constexpr auto jump_of_a = [](double P) { return model_a_jump_boundary(P).lambda; };
  // No Hertz contact exists at P <= 0.
  static constexpr auto closing_of_a = [](double P) { return P <= 0 ? model_a_closing_lambda(P) : kNone; };
  static constexpr auto pull_off = [](double lambda) { return lambda > 0 ? 0 : kNone; };
  static constexpr RegimeBoundary kOfA[]{{"jump", true, jump_of_a}, {"off_contact", true, closing_of_a}};
  static constexpr RegimeBoundary kOfB[]{{"jump", false, model_b_critical_load}, {"off_contact", false, pull_off}};
  static constexpr RegimeBoundary kOfC[]{{"off_contact", false, pull_off}};
  if (key == Johnson::info.key) return kOfA;
  if (key == WatersGuduru::info.key) return kOfB;
  if (key == PapangeloCiavarella::info.key) return kOfC;
  return std::nullopt;
}

namespace {
[[gnu::used]] const auto regime_instances =
    each_law([]<class Law>() { return std::tuple(&classify<Law>, &critical_load<Law>); });
}  // namespace

}  // namespace mixity
