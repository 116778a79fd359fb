#include "mechanics/held_approach.h"

#include <algorithm>
#include <cmath>

#include "mechanics/contact.h"
#include "mechanics/roots.h"

namespace mixity {
namespace {

/// The curve by s, with a = a0 - s^2 below the radius at T = 0: T grows in proportion to s at first.
class Curve {
 public:
  Curve(const ContactModel& model, std::span<const double> p, const HeldApproach& held, double a0)
      : model_(model), held_(held), a0_(a0) {
    for (const double& one : p) p_.push_back({&one, 0});
  }

  double radius(double s) const { return a0_ - s * s; }
  double load(double s) const {
    const double a = radius(s);
    // 4/3 a^3 - y
    return (held_.approach - a * a / 3) / (held_.compliance + 0.5 / a);
  }
  /// NaN beyond the end of the branch.
  double tangential_load(double s) const {
    // closer to a0 than its rounding
    if (s * s <= 4 * std::numeric_limits<double>::epsilon() * a0_) return 0;
    if (!(radius(s) > 0)) return std::numeric_limits<double>::quiet_NaN();
    const double P = load(s), A = area_from_radius(radius(s));
    double T = std::numeric_limits<double>::quiet_NaN();
    model_.tangential_loads(p_, {&P, 0}, {&A, 0}, {&T, 1});
    return T;
  }

 private:
  const ContactModel& model_;
  HeldApproach held_;
  double a0_;
  std::vector<Values> p_;
};

/// The stable radius at T = 0: the larger root of y = sqrt(8 pi a^3), a polynomial in sqrt(a) that falls and then
/// rises. Null below pull-off.
std::optional<double> radius_without_shear(const HeldApproach& held) {
  const double m = held.compliance, root = std::sqrt(8 * pi<double>());
  const auto excess = [&](double v) {
    return 4.0 / 3 * m * std::pow(v, 6) + std::pow(v, 4) - held.approach - root * (m * v * v * v + 0.5 * v);
  };
  const auto slope = [&](double v) { return 8 * m * std::pow(v, 5) + 4 * v * v * v - root * (3 * m * v * v + 0.5); };
  double high = 1;
  while (slope(high) < 0 || excess(high) < 0) high *= 2;
  const double least = root_between(slope, 0, high);
  if (excess(least) > 0) return std::nullopt;
  const double v = root_between(excess, least, high);
  return v * v;
}

}  // namespace

ApproachStates under_held_approach(const ContactModel& model, std::span<const double> p, const HeldApproach& held,
                                   std::span<const double> T) {
  constexpr double kMost = 1e50;  // of the approach and the compliance: powers of the radius then do not overflow
  constexpr int kSteps = 64;
  ApproachStates result{std::vector<ApproachState>(T.size())};
  if (!model.problem(p).empty() || !(std::abs(held.approach) <= kMost) ||
      !(held.compliance >= 0 && held.compliance <= kMost))
    return result;
  const auto a0 = radius_without_shear(held);
  if (!a0) {
    for (ApproachState& state : result.at) state.status = EquilibriumStatus::no_equilibrium;
    return result;
  }
  const Curve curve(model, p, held, *a0);
  const auto T_at = [&](double s) { return curve.tangential_load(s); };
  double most = 0;
  for (const double one : T)
    if (one >= 0 && one <= kLargestLoad) most = std::max(most, one);
  // marks along the branch, as far as they are needed
  std::vector<std::pair<double, double>> marks{{0, 0}};  // s and T
  const double step = std::sqrt(*a0) / kSteps;
  while (!result.end && marks.back().second < most) {
    const auto [s, last] = marks.back();
    const double next = T_at(s + step);
    if (next > last) {
      marks.emplace_back(s + step, next);
      continue;
    }
    double end = s + step;
    const bool fold = next <= last;
    if (fold) {
      end = minimum_between([&](double x) { return -T_at(x); }, std::max(s - step, 0.0), s + step, 50).at;
    } else {  // the last s at which there is a T
      double without = end;
      end = s;
      for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (end + without);
        (std::isnan(T_at(middle)) ? without : end) = middle;
      }
    }
    while (marks.size() > 1 && marks.back().first >= end) marks.pop_back();
    const double T_end = T_at(end);
    if (T_end > marks.back().second) marks.emplace_back(end, T_end);
    if (!fold && T_end > kLargestLoad) break;
    result.end = ApproachEnd{fold, T_end, curve.load(end), curve.radius(end)};
  }
  for (std::size_t i = 0; i < T.size(); ++i) {
    if (!(T[i] >= 0 && T[i] <= kLargestLoad)) continue;
    if (T[i] > marks.back().second) {
      result.at[i].status = EquilibriumStatus::no_equilibrium;
      continue;
    }
    const auto after =
        std::lower_bound(marks.begin(), marks.end(), T[i], [](const auto& mark, double t) { return mark.second < t; });
    const double s = after == marks.begin()
                         ? 0
                         : root_between([&](double x) { return T_at(x) - T[i]; }, (after - 1)->first, after->first);
    result.at[i] = {EquilibriumStatus::ok, curve.load(s), curve.radius(s)};
  }
  return result;
}

}  // namespace mixity
