#include "mechanics/laws/law_traits.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "mechanics/constants.h"

namespace mixity {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLost = 1e-12, kMostLost = 1e-6;  // of f: what is told, and what is too much

std::string shown(double value, int digits = 3) {
  if (std::isnan(value)) return "not a number";
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits).ptr};
}

std::string degrees(double psi) { return shown(psi * 180 / pi<double>(), 4) + " deg"; }

std::string shown(const LawTraits& traits) {
  std::string text;
  for (std::size_t i = 0; i < traits.count; ++i)
    text += (i == 0 ? "" : ", ") + traits.law->definition().parameters[i].name + " = " + shown(traits.p[i]);
  return text;
}

/// 1 - f''/2 at psi = 0.
double limit_of_small_shear(const ExpressionLaw& law, std::span<const Taylor> p, const Taylor& f) {
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
void set_small_power(const ExpressionLaw& law, std::span<const Taylor> p, LawTraits& traits) {
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

/// Logarithms of the sums of moduli of tau^2's second derivatives that curve_distance takes (nearest_proof.h), on the
/// unit circle in y and T.
struct Bend {
  double psi = 0, TT = 0, yT = 0, yy = 0;
};

Bend bend_of(const Taylor& f, double psi, double s, double c) {
  // along y at fixed T: psi' = -s, psi'' = 2 s c
  const Taylor along{f.value, -s * f.first, s * s * f.second + 2 * s * c * f.first}, y{c, 1, 0};
  const Taylor tau2 = (y * y + Taylor(s * s)) / along - y * y;
  const double m1 = std::abs(tau2.first), m2 = std::abs(tau2.second);
  // what is far less than the others is rounding, and does not count beside them
  const double TT = (2 * (tau2.value + c * m1) + c * c * m2) / (s * s), least = 1e-3 * (TT + 1e-3);
  return {psi, std::log(TT), std::log(std::max((m1 + c * m2) / s, least)),
          std::log(std::max(m2 + m1 / (c + s), least))};
}

/// Twice the largest of them; infinite where one rises towards an end.
ShearBend bend_everywhere(std::span<const Bend> bends) {
  const auto bound = [&](double Bend::*sum) {
    const Bend &first = bends[0], &second = bends[1], &last = bends.back(), &before = bends[bends.size() - 2];
    if (!(first.*sum <= second.*sum + 0.01 && last.*sum <= before.*sum + 0.01)) return kInfinity;
    double most = -kInfinity;
    for (const Bend& one : bends) most = std::max(most, one.*sum);
    return 2 * std::exp(most);
  };
  return {bound(&Bend::TT), bound(&Bend::yT), bound(&Bend::yy)};
}

/// How fast the sums change with dT/(T + T_part y) where T < y, and with dy/(y + y_part T) where y < T: the larger the
/// part, the further a step reaches.
ShearReach reach_of(std::span<const Bend> bends) {
  constexpr double kAllowed = 4.4;  // of d ln(sum) for a way of 1: (1 + 8 w)^2 is exp(2 * 4.4 w) at w = 1/4
  ShearReach reach{1, 0, 0};
  for (const bool steep : {false, true}) {
    double& chosen = steep ? reach.y_part : reach.T_part;
    for (const double part : {1.0, 0.3, 0.1, 0.03, 0.01, 0.0}) {
      double fastest = 0;
      for (std::size_t i = 0; i + 1 < bends.size(); ++i) {
        const Bend &one = bends[i], &next = bends[i + 1];
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

/// Place i of LawTraits [rad].
double place(std::size_t i) {
  static const std::array<double, LawTraits::kPlaces + 1> all = [] {
    std::array<double, LawTraits::kPlaces + 1> list;
    for (std::size_t k = 0; k < list.size(); ++k)
      list[k] = 0.25 * pi<double>() * (1 - std::cos(pi<double>() * static_cast<double>(k) / LawTraits::kPlaces));
    return list;
  }();
  return all[i];
}

/// Of ln((1 + tan^2 psi)/f) at an angle: its slope, whether that is below zero by more than rounding, and how it
/// changes.
struct Growth {
  double value, slope;
  bool falls;
};

Growth growth_of(double psi, const Taylor& f, double rounding) {
  const double t = std::tan(psi), growth = 2 * t, decline = f.first / f.value, value = growth - decline;
  return {value, 2 * (1 + t * t) - f.second / f.value + decline * decline,
          !(value >= -rounding * (growth + std::abs(decline)))};
}

/// Whether a dip or a hump of the growth shows at both ends of a stretch that holds it.
bool shows_between(const Growth& one, const Growth& other) {
  return one.falls ? one.slope > 0 && other.slope < 0 : one.slope < 0 && other.slope > 0;
}

/// An angle between low and high at which (1 + tan^2 psi)/f falls, though it grows at both; null where none shows.
template <class At>
std::optional<double> falls_between(const At& growth_at, double low, Growth at_low, double high, Growth at_high) {
  constexpr int kSteps = 8;
  const double depth = 0.5 * (high - low) * std::max(-at_low.slope, at_high.slope);
  if (!shows_between(at_low, at_high) || std::min(at_low.value, at_high.value) > depth) return std::nullopt;
  for (int i = 0; i < kSteps; ++i) {
    const double x = low + (high - low) * at_low.slope / (at_low.slope - at_high.slope);
    const Growth here = growth_at(x);
    if (here.falls) return x;
    (here.slope < 0 ? low : high) = x;
    (here.slope < 0 ? at_low : at_high) = here;
  }
  return std::nullopt;
}

/// An angle between two places at which f does what is not seen from them: (1 + tan^2 psi)/f turns twice, f is no
/// positive number, or has a pole or a zero; null where there is none.
std::optional<double> unseen(const ExpressionLaw& law, std::span<const double> parameters) {
  constexpr std::size_t kBetween = 12;
  constexpr double kRounding = 1e-6, kBeyond = 3;  // of a slope; of ln f
  std::array<Taylor, ExpressionLaw::kMostParameters> numbers;
  std::copy(parameters.begin(), parameters.end(), numbers.begin());
  const auto at = [&](double psi) {
    return law.toughness(along_angle(std::sin(psi), std::cos(psi)), {numbers.data(), parameters.size()});
  };
  double before_psi = place(1);
  Taylor before = at(before_psi);
  Growth growth = growth_of(before_psi, before, kRounding);
  for (std::size_t i = 1; i + 1 < LawTraits::kPlaces; ++i) {
    std::size_t turns = 0;
    const Growth begins = growth;
    Growth half_way{};
    for (std::size_t k = 1; k <= kBetween; ++k) {
      const double share = static_cast<double>(k) / kBetween, psi = place(i) + share * (place(i + 1) - place(i));
      const Taylor f = at(psi);
      if (!(f.value > 0 && f.value < kInfinity)) return psi;
      const Growth next = growth_of(psi, f, kRounding);
      turns += growth.falls != next.falls;
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
    // a dip that its ends foretell is followed, as traits tell of it
    const double dip = 0.125 * (place(i + 1) - place(i)) * (begins.slope - growth.slope);
    const double mean = 0.5 * (begins.value + growth.value);
    const bool foretold =
        turns == 2 && shows_between(begins, growth) && std::abs(half_way.value - mean - dip) <= std::abs(dip);
    if (turns > 1 && !foretold) return place(i);
  }
  return std::nullopt;
}

}  // namespace

std::optional<Taylor> LawTraits::about(const Taylor& psi) const {
  const double share = std::acos(std::clamp(1 - 4 * psi.value / pi<double>(), -1.0, 1.0)) / pi<double>();
  const std::size_t i = std::min(static_cast<std::size_t>(share * kPlaces), kPlaces - 1);
  const double length = place(i + 1) - place(i);
  const auto over = [&](const Taylor& f) {  // derivatives in the share of the way, the second halved
    return Taylor{f.value, f.first * length, 0.5 * f.second * length * length};
  };
  const Taylor from = over(log_f[i]), to = over(log_f[i + 1]);
  const double value = to.value - from.value - from.first - from.second;
  const double slope = to.first - from.first - 2 * from.second, curve = to.second - from.second;
  if (!(std::abs(value) + std::abs(slope) + std::abs(curve) <= 10)) return std::nullopt;  // or NaN
  const Taylor u{(psi.value - place(i)) / length, psi.first / length, psi.second / length};
  const Taylor rest = u * (u * Taylor(6 * value - 3 * slope + curve) + Taylor(-15 * value + 7 * slope - 2 * curve)) +
                      Taylor(10 * value - 4 * slope + curve);
  return Taylor(from.value) + u * (Taylor(from.first) + u * (Taylor(from.second) + u * rest));
}

ExpressionLaw::State along_angle(double s, double c) { return {{std::atan2(s, c), 1, 0}, {s, c, -s}, {c, -s, -c}}; }

ShearTerm<double> reduced_shear(const ExpressionLaw& law, std::span<const Taylor> p, double s, double c,
                                const LawTraits* known) {
  c = std::max(c, kLeastCosine);
  const double turn = -s, bend = 2 * s * c;  // of psi in y/r
  const Taylor psi{law.uses_psi() || known ? std::atan2(s, c) : 0, turn, bend};
  const ExpressionLaw::State state{psi,
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

LawTraits traits_of(const ExpressionLaw& law, std::span<const double> parameters, bool with_rounding) {
  LawTraits traits;
  traits.law = &law;
  traits.count = parameters.size();
  traits.log_f.fill(std::numeric_limits<double>::quiet_NaN());
  std::copy(parameters.begin(), parameters.end(), traits.p.begin());
  std::array<Taylor, ExpressionLaw::kMostParameters> numbers;
  std::copy(parameters.begin(), parameters.end(), numbers.begin());
  const std::span<const Taylor> p(numbers.data(), parameters.size());
  const Taylor start = law.toughness(along_angle(0, 1), p);
  traits.f0 = start.value;
  if (law.is_equation()) traits.log_f[0] = log(start);
  traits.small_shear = limit_of_small_shear(law, p, start);
  // where f has grown beyond measure, as tan^2 psi, tau/y has come to a limit
  const Taylor end = law.toughness(along_angle(1, kLeastCosine), p);
  if (law.is_equation()) traits.log_f[LawTraits::kPlaces] = log(end);
  if (end.value > 1e30)
    traits.shear_limit = reduced_shear(law, p, 1, kLeastCosine).value / (kLeastCosine * kLeastCosine);
  set_small_power(law, p, traits);
  const SampledLaw* const sampled = law.sampled(parameters);
  const double slope_rounding = sampled ? 1e-7 : 1e-11;
  std::array<Bend, LawTraits::kPlaces - 1> bends;
  Growth before{};
  for (std::size_t i = 1; i < LawTraits::kPlaces; ++i) {
    const double psi = place(i);
    const double s = std::sin(psi), c = std::cos(psi);
    const Taylor f = law.toughness(along_angle(s, c), p);
    if (!(f.value > 0 && f.value < kInfinity)) {
      traits.undefined_at = sampled ? sampled->undefined_at() : psi;
      return traits;
    }
    if (law.is_equation()) traits.log_f[i] = log(f);
    const Growth growth = growth_of(psi, f, slope_rounding);
    if (!traits.turned_at) {
      const auto growth_at = [&](double x) {
        return growth_of(x, law.toughness(along_angle(std::sin(x), std::cos(x)), p), slope_rounding);
      };
      if (growth.falls)
        traits.turned_at = psi;
      else if (i > 1)
        traits.turned_at = falls_between(growth_at, place(i - 1), before, psi, growth);
      if (const auto x = traits.turned_at) {
        const double secant = 1 / std::cos(*x);
        traits.turned_g = secant * secant / law.toughness(along_angle(std::sin(*x), std::cos(*x)), p).value;
      }
    }
    before = growth;
    // d(tau^2)/dy = 2 y (1/f - 1) + (y^2 + T^2) f' sin psi/(f^2 r)
    if (!(2 * c * (1 / f.value - 1) + s * f.first / (f.value * f.value) >= -0.1 * slope_rounding))
      traits.tau_grows = false;
    bends[i - 1] = bend_of(f, psi, s, c);
    if (!with_rounding || sampled) continue;  // samples tell what the function loses
    const Taylor of_psi = law.toughness({{psi, 1, 0}, Taylor(s), Taylor(c)}, p);
    const double rounding = std::abs(of_psi.first / f.value) * psi * 0.5 * std::numeric_limits<double>::epsilon();
    if (rounding > traits.rounding) {
      traits.rounding = rounding;
      traits.rounding_at = psi;
    }
  }
  if (traits.turns()) {
    traits.tau_grows = false;
    traits.shear_limit = kInfinity;  // nothing that T tends to while tau/y does
    return traits;
  }
  traits.reach = reach_of(bends);
  traits.bend = bend_everywhere(bends);
  return traits;
}

LawCheck check_law(const ExpressionLaw& law) {
  LawCheck check;
  const std::vector<LawParameter>& parameters = law.definition().parameters;
  const std::size_t n = parameters.size(), each = n == 1 ? 17 : n == 2 ? 7 : 5;
  std::size_t tried = 0, turned = 0;
  std::optional<LawTraits> first_turn;
  LawTraits roundest;
  double lost = 0, lost_at = 0;  // by sampling
  std::string lost_with;
  const std::size_t count = static_cast<std::size_t>(std::pow(each, n));
  for (std::size_t k = 0; k <= count; ++k) {
    std::vector<double> p;
    for (std::size_t i = 0, rest = k; i < n; ++i, rest /= each) {
      const double share = static_cast<double>(rest % each) / static_cast<double>(each - 1);
      p.push_back(k == count ? parameters[i].start
                             : parameters[i].lower + share * (parameters[i].upper - parameters[i].lower));
    }
    const LawTraits traits = traits_of(law, p, true);
    const std::string there = " with " + shown(traits);
    if (const SampledLaw* sampled = law.sampled(p); sampled && sampled->error() > lost) {
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
                    (law.is_equation() && law.definition().text.find('=') == std::string::npos
                         ? ": an equation in K_I and K_II says what they are equal to, such as = 1"
                         : ": narrow the ranges of the parameters, or mend the law");
      return check;
    }
    if (const auto psi = unseen(law, p)) {
      check.error = "f turns, or is no positive and finite number, within less than 3 deg near psi = " + degrees(*psi) +
                    there +
                    ", which is too narrow to be followed: narrow the ranges of the parameters, or mend the law";
      return check;
    }
    ++tried;
    if (traits.turns()) {
      ++turned;
      if (!first_turn) first_turn = traits;
    }
    if (traits.rounding > roundest.rounding) roundest = traits;
  }
  if (first_turn) {
    // tau/y is at most S0/sqrt(-6 pi P) on the circle of a load P < 0
    const double psi = first_turn->turned_at.value_or(0), g = first_turn->turned_g;
    check.warnings.push_back(
        "one area stands for several T in " + std::to_string(turned) + " of " + std::to_string(tried) +
        " parts of the parameters' ranges, where (1 + tan^2 psi)/f falls " +
        "and shear enlarges the contact: first with " + shown(*first_turn) + ", near psi = " + degrees(psi) + ", at " +
        (g > 1 ? "loads above P = " + shown(-1.5 * pi<double>() / g) + " R G_Ic" : "every load") +
        "; areas are those met from T = 0 on");
  }
  if (lost > kMostLost) {
    check.error = "f cannot be sampled near psi = " + degrees(lost_at) + lost_with +
                  ": it jumps or scatters there by " + shown(lost);
    return check;
  }
  if (lost > kLost)
    check.warnings.push_back("near psi = " + degrees(lost_at) + lost_with + " f is known to " + shown(lost) +
                             ": it bends or scatters there more than samples tell");
  if (roundest.rounding > 1e-13)
    check.warnings.push_back("near psi = " + degrees(roundest.rounding_at) + " f is known to " +
                             shown(roundest.rounding) + " of itself, as it is computed from psi, which is rounded: t " +
                             "for tan psi and B for sin^2 psi are exact");
  return check;
}

}  // namespace mixity
