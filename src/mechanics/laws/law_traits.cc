#include "mechanics/laws/law_traits.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/base/constants.h"
#include "mechanics/laws/law_growth.h"
#include "mechanics/laws/law_workspace.h"

namespace mixity {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// small_shear: 1 - f''/2 at psi = 0.
double limit_of_small_shear(LawWorkspace& law, std::span<const double> p, const Taylor& f) {
  if (std::abs(f.first) > 1e-12) return f.first > 0 ? -kInfinity : kInfinity;
  if (!std::isnan(f.second)) return 1 - 0.5 * f.second;
  // Without a second derivative, as for an equation in powers: from small shears. There the error of the limit is a
  // power of T, which Aitken's formula extrapolates.
  constexpr double kNone = 1e-5;
  const auto share = [&](double t) { return reduced_shear(law, p, t, 1).value / (t * t); };
  const double first = share(1e-2), second = share(1e-3), third = share(kSmallShear);
  const double before = second - first, last = third - second;
  if (std::abs(last) <= 1e-6) return std::abs(third) <= kNone ? 0 : third;  // rounding
  if (std::abs(last) > std::abs(before)) return std::copysign(kInfinity, last);
  const double limit = third - last * last / (last - before);
  return std::abs(limit) <= kNone ? 0 : limit;
}

/// Finds T/y below which tau^2 is small_shear T^2 to rounding. If f leaves 1 with a slope or like a root, finds instead
/// the power of T between tau^2/y^2 = 1e-8 and 1e-12; below, rounding would show.
void set_small_power(LawWorkspace& law, std::span<const double> p, LawTraits& traits) {
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

/// The curvature of tau^2: logarithms of the sums of moduli of its second derivatives that nearest_proof.h uses, on the
/// unit circle in y and T.
struct LawBend {
  double psi = 0, TT = 0, yT = 0, yy = 0;
};

/// At psi with sine s and cosine c. `f` carries its derivatives in psi.
LawBend bend_of(const Taylor& f, double psi, double s, double c) {
  // along y at fixed T: psi' = -s, psi'' = 2 s c
  const Taylor along{f.value, -s * f.first, s * s * f.second + 2 * s * c * f.first}, y{c, 1, 0};
  const Taylor tau2 = (y * y + Taylor(s * s)) / along - y * y;
  const double m1 = std::abs(tau2.first), m2 = std::abs(tau2.second);
  // a term far smaller than the others is rounding
  const double TT = (2 * (tau2.value + c * m1) + c * c * m2) / (s * s), least = 1e-3 * (TT + 1e-3);
  return {psi, std::log(TT), std::log(std::max((m1 + c * m2) / s, least)),
          std::log(std::max(m2 + m1 / (c + s), least))};
}

/// Twice the largest of each sum; infinite where it rises towards an end.
ShearBend bend_everywhere(std::span<const LawBend> bends) {
  const auto bound = [&](double LawBend::*sum) {
    const LawBend &first = bends[0], &second = bends[1], &last = bends.back(), &before = bends[bends.size() - 2];
    if (!(first.*sum <= second.*sum + 0.01 && last.*sum <= before.*sum + 0.01)) return kInfinity;
    double most = -kInfinity;
    for (const LawBend& one : bends) most = std::max(most, one.*sum);
    return 2 * std::exp(most);
  };
  return {bound(&LawBend::TT), bound(&LawBend::yT), bound(&LawBend::yy)};
}

/// The rate of change of the sums between angles, with a margin of two: with dT/(T + T_part y) where T < y, and with
/// dy/(y + y_part T) where y < T. A larger part makes a step reach further.
ShearReach reach_of(std::span<const LawBend> bends) {
  constexpr double kAllowed = 4.4;  // largest d ln(sum) over a distance 1: (1 + 8 w)^2 is exp(2 * 4.4 w) at w = 1/4
  ShearReach reach{1, 0, 0};
  for (const bool steep : {false, true}) {
    double& chosen = steep ? reach.y_part : reach.T_part;
    for (const double part : {1.0, 0.3, 0.1, 0.03, 0.01, 0.0}) {
      double fastest = 0;
      for (std::size_t i = 0; i + 1 < bends.size(); ++i) {
        const LawBend &one = bends[i], &next = bends[i + 1];
        const double psi = 0.5 * (one.psi + next.psi);
        if ((psi > 0.25 * pi<double>()) != steep) continue;
        const double near = steep ? std::cos(psi) : std::sin(psi), far = steep ? std::sin(psi) : std::cos(psi);
        const double way = (next.psi - one.psi) / (far * (near + part * far));
        for (const double change : {next.TT - one.TT, next.yT - one.yT, next.yy - one.yy})
          if (!(std::abs(change) <= fastest * way)) fastest = std::abs(change) / way;
      }
      chosen = part;
      if (2 * fastest <= kAllowed) break;
      if (part == 0) reach.narrow = std::max(reach.narrow, 2 * fastest / kAllowed);
    }
  }
  return reach;
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
  const auto over = [&](const Taylor& f) {  // derivatives in the fraction of the interval, the second one halved
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

ShearTerm<double> reduced_shear(LawWorkspace& law, std::span<const double> p, double s, double c,
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

LawTraits traits_of(LawWorkspace& law, std::span<const double> p, bool with_rounding) {
  LawTraits traits;
  traits.p = ParameterValues(p);
  traits.log_f.fill(std::numeric_limits<double>::quiet_NaN());
  const bool equation = law.law().form().equation;
  const Taylor start = law.toughness(along_angle(0, 1), p);
  traits.f0 = start.value;
  if (equation) traits.log_f[0] = log(start);
  traits.small_shear = limit_of_small_shear(law, p, start);
  // where f grows as tan^2 psi, tau/y has a limit
  const Taylor end = law.toughness(along_angle(1, kLeastCosine), p);
  if (equation) traits.log_f[LawTraits::kAngles] = log(end);
  if (end.value > 1e30)
    traits.shear_limit = reduced_shear(law, p, 1, kLeastCosine).value / (kLeastCosine * kLeastCosine);
  set_small_power(law, p, traits);
  const SampledToughness* const sampled = law.sampled(p);
  const double slope_rounding = sampled ? 1e-7 : 1e-11;
  std::array<LawBend, LawTraits::kAngles - 1> bends;
  Growth before{};
  const auto f_at = [&](double x) { return law.toughness(along_angle(std::sin(x), std::cos(x)), p); };
  for (std::size_t i = 1; i < LawTraits::kAngles; ++i) {
    const double psi = LawTraits::angle(i), s = std::sin(psi), c = std::cos(psi);
    const Taylor f = f_at(psi);
    if (!(f.value > 0 && f.value < kInfinity)) {
      traits.undefined_at = sampled ? sampled->undefined_at() : psi;
      return traits;
    }
    if (equation) traits.log_f[i] = log(f);
    const Growth growth = growth_of(psi, f, slope_rounding);
    if (!traits.falls_at) {
      const auto growth_at = [&](double x) { return growth_of(x, f_at(x), slope_rounding); };
      if (growth.falls)
        traits.falls_at = psi;
      else if (i > 1)
        traits.falls_at = falls_between(growth_at, LawTraits::angle(i - 1), before, psi, growth);
      if (const auto x = traits.falls_at) {
        const double secant = 1 / std::cos(*x);
        traits.falling_g = secant * secant / f_at(*x).value;
      }
    }
    before = growth;
    // d(tau^2)/dy = 2 y (1/f - 1) + (y^2 + T^2) f' sin psi/(f^2 r)
    if (!(2 * c * (1 / f.value - 1) + s * f.first / (f.value * f.value) >= -0.1 * slope_rounding))
      traits.tau_grows = false;
    bends[i - 1] = bend_of(f, psi, s, c);
    if (!with_rounding || sampled) continue;  // for a function, check_law reports the error of sampling
    const Taylor of_psi = law.toughness({{psi, 1, 0}, Taylor(s), Taylor(c)}, p);
    const double rounding = std::abs(of_psi.first / f.value) * psi * 0.5 * std::numeric_limits<double>::epsilon();
    if (rounding > traits.rounding) {
      traits.rounding = rounding;
      traits.rounding_at = psi;
    }
  }
  if (traits.non_monotone()) {
    traits.tau_grows = false;
    traits.shear_limit = kInfinity;  // T has no limit where tau/y does
    return traits;
  }
  traits.reach = reach_of(bends);
  traits.bend = bend_everywhere(bends);
  return traits;
}

}  // namespace mixity
