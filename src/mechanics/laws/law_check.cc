#include "mechanics/laws/law_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "base/number_text.h"
#include "mechanics/base/constants.h"
#include "mechanics/laws/law_growth.h"
#include "mechanics/laws/law_workspace.h"

namespace mixity {
namespace {

constexpr double kLost = 1e-12, kMostLost = 1e-6;  // errors of f for a warning, and for an error

std::string shown(double value, int digits = 3) { return std::isnan(value) ? "not a number" : rounded(value, digits); }

std::string degrees(double psi) { return shown(psi * 180 / pi<double>(), 4) + " deg"; }

std::string shown(const std::vector<LawParameter>& parameters, std::span<const double> values) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i)
    text += (i == 0 ? "" : ", ") + parameters[i].name + " = " + shown(values[i]);
  return text;
}

/// An angle at which f has a feature too narrow for the angles of LawTraits: g = (1 + tan^2 psi)/f rises and falls
/// between two of them, f is not a positive number, or f has a pole or a zero. Null if there is none.
std::optional<double> unseen(LawWorkspace& law, std::span<const double> parameters) {
  constexpr std::size_t kBetween = 12;
  constexpr double kRounding = 1e-6, kBeyond = 3;  // of a slope; of ln f
  const auto at = [&](double psi) { return law.toughness(along_angle(std::sin(psi), std::cos(psi)), parameters); };
  double before_psi = LawTraits::angle(1);
  Taylor before = at(before_psi);
  Growth growth = growth_of(before_psi, before, kRounding);
  for (std::size_t i = 1; i + 1 < LawTraits::kAngles; ++i) {
    std::size_t changes = 0;  // number of sign changes of the growth
    const Growth begins = growth;
    Growth half_way{};
    for (std::size_t k = 1; k <= kBetween; ++k) {
      const double share = static_cast<double>(k) / kBetween,
                   psi = LawTraits::angle(i) + share * (LawTraits::angle(i + 1) - LawTraits::angle(i));
      const Taylor f = at(psi);
      if (!(f.value > 0 && std::isfinite(f.value))) return psi;
      const Growth next = growth_of(psi, f, kRounding);
      changes += growth.falls != next.falls;
      growth = next;
      if (2 * k == kBetween) half_way = next;
      if (before.first * f.first < 0) {  // an extremum of f between them, which may be a pole or a zero
        double low = before_psi, high = psi;
        for (int step = 0; step < 40; ++step) {
          const double middle = 0.5 * (low + high);
          (at(middle).first * f.first < 0 ? low : high) = middle;
        }
        const double there = at(low).value;
        if (!(std::abs(std::log(there / f.value)) < kBeyond && std::abs(std::log(there / before.value)) < kBeyond))
          return low;
      }
      before_psi = psi;
      before = f;
    }
    // traits_of detects a dip that shows at both ends
    const double dip = 0.125 * (LawTraits::angle(i + 1) - LawTraits::angle(i)) * (begins.slope - growth.slope);
    const double mean = 0.5 * (begins.value + growth.value);
    const bool shows =
        changes == 2 && shows_between(begins, growth) && std::abs(half_way.value - mean - dip) <= std::abs(dip);
    if (changes > 1 && !shows) return LawTraits::angle(i);
  }
  return std::nullopt;
}

}  // namespace

LawCheck check_law(const UserLaw& law) {
  LawCheck check;
  const LawLease lease(law);
  LawWorkspace& workspace = lease.workspace();
  const std::vector<LawParameter>& parameters = law.definition().parameters;
  const std::size_t n = parameters.size(), each = n == 1 ? 17 : n == 2 ? 7 : 5;
  std::size_t tried = 0, falling = 0;
  std::optional<LawTraits> first_falling;
  LawTraits roundest;
  double lost = 0, lost_at = 0;  // in the sampling of a function
  std::string lost_with;
  const std::size_t count = static_cast<std::size_t>(std::pow(each, n));
  for (std::size_t k = 0; k <= count; ++k) {
    std::vector<double> p;
    for (std::size_t i = 0, rest = k; i < n; ++i, rest /= each) {
      const double share = static_cast<double>(rest % each) / static_cast<double>(each - 1);
      p.push_back(k == count ? parameters[i].start
                             : parameters[i].lower + share * (parameters[i].upper - parameters[i].lower));
    }
    const LawTraits traits = traits_of(workspace, p, true);
    const std::string there = " with " + shown(parameters, p);
    if (const SampledToughness* sampled = workspace.sampled(p); sampled && sampled->error() > lost) {
      lost = sampled->error();
      lost_at = sampled->error_at();
      lost_with = there;
    }
    if (!(std::abs(traits.f0 - 1) <= 1e-9)) {
      check.error = "f at psi = 0 is " + shown(traits.f0) + there +
                    (std::isnan(traits.f0) ? "; it must be 1" : ", not 1") +
                    (std::isfinite(traits.f0) && traits.f0 > 0 ? "; normalised = true divides f by it" : "");
      return check;
    }
    if (traits.undefined_at) {
      check.error = "f is not a positive number at psi = " + degrees(*traits.undefined_at) + there +
                    (law.form().equation && law.definition().text.find('=') == std::string::npos
                         ? ": an equation in K_I and K_II says what they are equal to, such as = 1"
                         : ": narrow the ranges of the parameters, or correct the expression");
      return check;
    }
    if (const auto psi = unseen(workspace, p)) {
      check.error = "f has a feature narrower than 3 deg, or is not positive and finite, near psi = " + degrees(*psi) +
                    there + ": narrow the ranges of the parameters, or correct the expression";
      return check;
    }
    ++tried;
    if (traits.non_monotone()) {
      ++falling;
      if (!first_falling) first_falling = traits;
    }
    if (traits.rounding > roundest.rounding) roundest = traits;
  }
  if (first_falling) {
    // tau/y is at most S0/sqrt(-6 pi P) on the circle of a load P < 0
    const double psi = first_falling->falls_at.value_or(0), g = first_falling->falling_g;
    check.warnings.push_back("several T have the same area in " + std::to_string(falling) + " of " +
                             std::to_string(tried) +
                             " parts of the parameters' ranges, where (1 + tan^2 psi)/f falls " +
                             "and shear enlarges the contact: first with " + shown(parameters, first_falling->p) +
                             ", near psi = " + degrees(psi) + ", at " +
                             (g > 1 ? "loads above P = " + shown(-1.5 * pi<double>() / g) + " R G_Ic" : "every load") +
                             "; areas are those met from T = 0 on");
  }
  if (lost > kMostLost) {
    check.error = "f cannot be sampled near psi = " + degrees(lost_at) + lost_with +
                  ": it jumps or scatters there by " + shown(lost);
    return check;
  }
  if (lost > kLost)
    check.warnings.push_back("near psi = " + degrees(lost_at) + lost_with + ", f is known only to " + shown(lost) +
                             ": it has a kink or noise there that further samples do not resolve");
  if (roundest.rounding > 1e-13)
    check.warnings.push_back("near psi = " + degrees(roundest.rounding_at) + ", f has a relative error of " +
                             shown(roundest.rounding) +
                             ", because psi is rounded; use t for tan psi and B for sin^2 psi");
  return check;
}

}  // namespace mixity
