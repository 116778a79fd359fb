#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/batch.h"
#include "mechanics/contact.h"
#include "mechanics/equilibrium.h"
#include "mechanics/non_monotone_curve.h"
#include "mechanics/operations.h"
#include "mechanics/roots.h"
#include "mechanics/sensitivity.h"

namespace mixity {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// T at which a contact under a non-monotone law first has the edge load y on its way from T = 0; NaN where it never
/// has.
template <class Law>
double first_tangential_load(const Law& law, const Parameters<Law>& p, double P, double y) {
  constexpr double kFirst = -40, kStep = 0.125, kLast = 42, kRounding = 8 * std::numeric_limits<double>::epsilon();
  const NonMonotoneCurve curve(law, p, P);
  const double half = 0.5 * curve.length();
  const double last = curve.closed() ? std::log(curve.at(half, half).t)
                                     : (curve.grows_over_all_bounds() ? std::log(std::tan(curve.length())) : kLast);
  // above y, by x = ln(T/y); on a curve that closes also on the way back, where the product of both y is -6 pi P/g
  const auto excess = [&](double x, bool back) {
    const double upper = curve.upper_edge_load(std::exp(std::min(x, last))).value_or(-2 * P);
    return std::log((back ? -P * upper / (upper + P) : upper) / y);
  };
  if (std::abs(excess(kFirst, false)) <= kRounding) return 0;
  double found = kNaN;
  const auto look = [&](bool back, double from, double to) {
    const double way = back ? -1 : 1;
    for_sign_changes([&](double v) { return excess(way * v, back); }, way * from, way * to, kRounding,
                     [&](double) { return kStep; },
                     [&](double v, bool) {
                       found = y * std::exp(way * v);
                       return false;
                     });
  };
  look(false, kFirst, last);
  if (std::isnan(found) && curve.closed()) look(true, last, kFirst);
  return found;
}

template <class Law>
class AreasOf final : public AreaOperations {
 public:
  explicit AreasOf(const ExpressionLaw* law) : held_(law) {}

  std::string_view obstacle(ParameterSpan p, double P) const override {
    const auto use = held_.use();
    return contact_obstacle(use.law, parameters_from<Law>(p), P);
  }

  void areas(std::span<const Values> parameters, Values P, Values T, std::span<double> A,
             std::span<EquilibriumStatus> status) const override {
    const auto use = held_.use();
    std::vector<double> positive;
    for (std::size_t begin = 0; begin < A.size();) {
      const Parameters<Law> p = parameters_at<Law>(parameters, begin);
      std::size_t end = begin + 1;
      while (end < A.size() && P[end] == P[begin] && parameters_at<Law>(parameters, end) == p) ++end;
      const LoadedContact contact(use.law, p, P[begin]);
      const std::span<double> found = A.subspan(begin, end - begin);
      std::span<const double> shears(T.first + static_cast<std::ptrdiff_t>(begin) * T.step,
                                     T.step == 1 ? end - begin : 0);
      if (T.step != 1 || std::any_of(shears.begin(), shears.end(), [](double t) { return t < 0; })) {
        positive.resize(end - begin);
        for (std::size_t i = begin; i < end; ++i) positive[i - begin] = std::abs(T[i]);
        shears = positive;
      }
      const std::size_t ok = predict_areas(contact, shears, found);
      std::fill_n(status.begin() + static_cast<std::ptrdiff_t>(begin), end - begin, EquilibriumStatus::ok);
      for (std::size_t i = begin; ok < found.size() && i < end; ++i) {
        if (A[i] != 0) continue;
        A[i] = kNaN;
        const bool valid = contact.obstacle().empty() && std::abs(T[i]) <= kLargestLoad;
        status[i] = valid ? EquilibriumStatus::no_equilibrium : EquilibriumStatus::invalid;
      }
      begin = end;
    }
  }

  void area_slopes(std::span<const Values> parameters, Values P, Values T, std::span<const double> A,
                   std::span<const std::span<double>> slopes) const override {
    const auto use = held_.use();
    for (std::size_t i = 0; i < A.size(); ++i) {
      const double y = edge_load(radius_from_area(A[i]), P[i]);
      if (!(y >= 0)) continue;
      const auto gradient = equilibrium_gradient(use.law, parameters_at<Law>(parameters, i), P[i], std::abs(T[i]), y);
      for (std::size_t k = 0; k < slopes.size(); ++k) slopes[k][i] = -gradient.parameters[k] / gradient.A;
    }
  }

  void tangential_loads(std::span<const Values> parameters, Values P, Values A, std::span<double> T) const override {
    const auto use = held_.use();
    for (std::size_t i = 0; i < T.size(); ++i) {
      const auto p = parameters_at<Law>(parameters, i);
      if (!contact_obstacle(use.law, p, P[i]).empty() || above_pull_off(P[i]) < 0 || !(A[i] > 0)) continue;
      const double y = edge_load(radius_from_area(A[i]), P[i]), S0 = circle_radius(P[i]), v = y - 3 * pi<double>();
      if constexpr (kMayBeNonMonotone<Law>) {
        if (is_non_monotone(use.law, p)) {
          if (y > 0) T[i] = first_tangential_load(use.law, p, P[i], y);
          continue;
        }
      }
      if (!(y > 0) || !(std::abs(v) <= S0 * (1 + 8 * std::numeric_limits<double>::epsilon()))) continue;
      const double found = tangential_load(use.law, p, y, std::sqrt(std::max(0.0, (S0 - v) * (S0 + v))));
      if (std::isfinite(found)) T[i] = found;
    }
  }

  Equilibria equilibria(ParameterSpan p, double P, std::span<const double> T) const override {
    const auto use = held_.use();
    const LoadedContact contact(use.law, parameters_from<Law>(p), P);
    Equilibria found;
    found.at.reserve(T.size());
    bool beyond = false;
    for (const double shear : T) {
      found.at.push_back(contact.at(shear));
      beyond |= found.at.back().status != EquilibriumStatus::ok;
    }
    if (beyond && contact.in_contact()) found.last = contact.branches().back();
    return found;
  }

 private:
  HeldLaw<Law> held_;
};

}  // namespace

template <class Law>
std::unique_ptr<const AreaOperations> area_operations(const ExpressionLaw* law) {
  return std::make_unique<AreasOf<Law>>(law);
}

namespace {
[[gnu::used]] const auto area_instances = each_law([]<class Law>() { return &area_operations<Law>; });
}  // namespace

}  // namespace mixity
