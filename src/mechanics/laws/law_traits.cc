#include "mechanics/laws/law_traits.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/constants.h"
#include "mechanics/laws/law_bend.h"
#include "mechanics/laws/law_growth.h"
#include "mechanics/laws/law_workspace.h"

namespace mixity {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// 1 - f''/2 at psi = 0.
double limit_of_small_shear(LawWorkspace& law, std::span<const Taylor> p, const Taylor& f) {
  if (std::abs(f.first) > 1e-12) return f.first > 0 ? -kInfinity : kInfinity;
  if (!std::isnan(f.second)) return 1 - 0.5 * f.second;
  // No second derivative, such as that of an equation in powers: from shears that are small. What is left of the limit
  // there goes with a power of T, whose sum to infinity Aitken's formula gives.
  constexpr double kNone = 1e-5;
  const auto share = [&](double t) { return reduced_shear(law, p, t, 1).value / (t * t); };
  const double first = share(1e-2), second = share(1e-3), third = share(kSmallShear);
  const double before = second - first, last = third - second;
  if (std::abs(last) <= 1e-6) return std::abs(third) <= kNone ? 0 : third;  // rounding
  if (std::abs(last) > std::abs(before)) return std::copysign(kInfinity, last);
  const double limit = third - last * last / (last - before);
  return std::abs(limit) <= kNone ? 0 : limit;
}

/// Where tau^2 is small_shear T^2 to rounding. Of a law that leaves f = 1 with a slope or a root, the power of T that
/// it has between tau^2/y^2 = 1e-8 and 1e-12, below which rounding would show.
void set_small_power(LawWorkspace& law, std::span<const Taylor> p, LawTraits& traits) {
  const auto at = [&](double t) { return reduced_shear(law, p, t, 1).value; };
  constexpr double kRounding = 1e-15, kFirst = 1e-8, kLast = 1e-12, kLeast = 1e-140;
  double& t = traits.small_t;
  if (std::isfinite(traits.small_shear)) {
    while (std::abs(at(t) - traits.small_shear * t * t) > kRounding && t > kLast) t *= 0.1;
    traits.small_value = traits.small_shear * t * t;
    return;
  }
  double first = 0;
  for (; std::abs(at(t)) > kLast && t > kLeast; t *= 0.1)
    if (std::abs(at(t)) > kFirst || first == 0) first = t;
  traits.small_value = at(t);
  if (first > 0) traits.small_power = std::log(at(first) / traits.small_value) / std::log(first / t);
}

}  // namespace

double LawTraits::angle(std::size_t i) {
  static const std::array<double, kAngles + 1> all = [] {
    std::array<double, kAngles + 1> list;
    for (std::size_t k = 0; k < list.size(); ++k)
      list[k] = 0.25 * pi<double>() * (1 - std::cos(pi<double>() * static_cast<double>(k) / kAngles));
    return list;
  }();
  return all[i];
}

std::optional<Taylor> LawTraits::about(const Taylor& psi) const {
  const double share = std::acos(std::clamp(1 - 4 * psi.value / pi<double>(), -1.0, 1.0)) / pi<double>();
  const std::size_t i = std::min(static_cast<std::size_t>(share * kAngles), kAngles - 1);
  const double length = angle(i + 1) - angle(i);
  const auto over = [&](const Taylor& f) {  // derivatives in the share of the way, the second halved
    return Taylor{f.value, f.first * length, 0.5 * f.second * length * length};
  };
  const Taylor from = over(log_f[i]), to = over(log_f[i + 1]);
  const double value = to.value - from.value - from.first - from.second;
  const double slope = to.first - from.first - 2 * from.second, curve = to.second - from.second;
  if (!(std::abs(value) + std::abs(slope) + std::abs(curve) <= 10)) return std::nullopt;  // or NaN
  const Taylor u{(psi.value - angle(i)) / length, psi.first / length, psi.second / length};
  const Taylor rest = u * (u * Taylor(6 * value - 3 * slope + curve) + Taylor(-15 * value + 7 * slope - 2 * curve)) +
                      Taylor(10 * value - 4 * slope + curve);
  return Taylor(from.value) + u * (Taylor(from.first) + u * (Taylor(from.second) + u * rest));
}

LawState along_angle(double s, double c) { return {{std::atan2(s, c), 1, 0}, {s, c, -s}, {c, -s, -c}}; }

ShearTerm<double> reduced_shear(LawWorkspace& law, std::span<const Taylor> p, double s, double c,
                                const LawTraits* known) {
  c = std::max(c, kLeastCosine);
  const double turn = -s, bend = 2 * s * c;  // of psi in y/r
  const Taylor psi{law.law().form().uses_psi || known ? std::atan2(s, c) : 0, turn, bend};
  const LawState state{psi,
                       {s, c * turn, c * bend - s * turn * turn},
                       {c, -s * turn, -s * bend - c * turn * turn},
                       known ? known->about(psi) : std::nullopt};
  const Taylor y{c, 1, 0}, square = y * y, sum = square + Taylor(s * s);
  const Taylor tau2 = sum / law.toughness(state, p) - square;
  return {tau2.value, tau2.first, tau2.second};
}

std::string_view LawTraits::obstacle() const {
  if (undefined_at) return "the law is not a positive number at every phase angle, with these parameters";
  return {};
}

LawTraits traits_of(LawWorkspace& law, std::span<const double> parameters, bool with_rounding) {
  LawTraits traits;
  traits.p = ParameterValues(parameters);
  traits.log_f.fill(std::numeric_limits<double>::quiet_NaN());
  std::array<Taylor, ExpressionLaw::kMostParameters> numbers;
  std::copy(parameters.begin(), parameters.end(), numbers.begin());
  const std::span<const Taylor> p(numbers.data(), parameters.size());
  const bool equation = law.law().form().equation;
  const Taylor start = law.toughness(along_angle(0, 1), p);
  traits.f0 = start.value;
  if (equation) traits.log_f[0] = log(start);
  traits.small_shear = limit_of_small_shear(law, p, start);
  // where f has grown beyond measure, as tan^2 psi, tau/y has come to a limit
  const Taylor end = law.toughness(along_angle(1, kLeastCosine), p);
  if (equation) traits.log_f[LawTraits::kAngles] = log(end);
  if (end.value > 1e30)
    traits.shear_limit = reduced_shear(law, p, 1, kLeastCosine).value / (kLeastCosine * kLeastCosine);
  set_small_power(law, p, traits);
  const SampledLaw* const sampled = law.sampled(parameters);
  const double slope_rounding = sampled ? 1e-7 : 1e-11;
  std::array<LawBend, LawTraits::kAngles - 1> bends;
  Growth before{};
  for (std::size_t i = 1; i < LawTraits::kAngles; ++i) {
    const double psi = LawTraits::angle(i);
    const double s = std::sin(psi), c = std::cos(psi);
    const Taylor f = law.toughness(along_angle(s, c), p);
    if (!(f.value > 0 && f.value < kInfinity)) {
      traits.undefined_at = sampled ? sampled->undefined_at() : psi;
      return traits;
    }
    if (equation) traits.log_f[i] = log(f);
    const Growth growth = growth_of(psi, f, slope_rounding);
    if (!traits.falls_at) {
      const auto growth_at = [&](double x) {
        return growth_of(x, law.toughness(along_angle(std::sin(x), std::cos(x)), p), slope_rounding);
      };
      if (growth.falls)
        traits.falls_at = psi;
      else if (i > 1)
        traits.falls_at = falls_between(growth_at, LawTraits::angle(i - 1), before, psi, growth);
      if (const auto x = traits.falls_at) {
        const double secant = 1 / std::cos(*x);
        traits.falling_g = secant * secant / law.toughness(along_angle(std::sin(*x), std::cos(*x)), p).value;
      }
    }
    before = growth;
    // d(tau^2)/dy = 2 y (1/f - 1) + (y^2 + T^2) f' sin psi/(f^2 r)
    if (!(2 * c * (1 / f.value - 1) + s * f.first / (f.value * f.value) >= -0.1 * slope_rounding))
      traits.tau_grows = false;
    bends[i - 1] = bend_of(f, psi, s, c);
    if (!with_rounding || sampled) continue;  // of a function, check_law reports the error of sampling
    const Taylor of_psi = law.toughness({{psi, 1, 0}, Taylor(s), Taylor(c)}, p);
    const double rounding = std::abs(of_psi.first / f.value) * psi * 0.5 * std::numeric_limits<double>::epsilon();
    if (rounding > traits.rounding) {
      traits.rounding = rounding;
      traits.rounding_at = psi;
    }
  }
  if (traits.non_monotone()) {
    traits.tau_grows = false;
    traits.shear_limit = kInfinity;  // nothing that T tends to while tau/y does
    return traits;
  }
  traits.reach = reach_of(bends);
  traits.bend = bend_everywhere(bends);
  return traits;
}

}  // namespace mixity
