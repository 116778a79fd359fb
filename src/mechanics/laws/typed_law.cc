// The general route of mechanics for typed laws: tau^2 = y^2 ((1 + tan^2 psi)/f - 1) and what is asked of f.
#include "mechanics/laws/typed_law.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/laws/law_traits.h"

namespace mixity::typed {
namespace {

using Numbers = std::array<Taylor, ExpressionLaw::kMostParameters>;

std::span<const Taylor> constants(std::span<const double> p, Numbers& numbers) {
  for (std::size_t i = 0; i < p.size(); ++i) numbers[i] = Taylor(p[i]);
  return {numbers.data(), p.size()};
}

/// Of the current law; remembered, as one set of parameters is asked about many times.
const LawTraits& traits(std::span<const double> p) {
  thread_local LawTraits last;
  const ExpressionLaw* law = current_law();
  if (last.law != law || last.count != p.size() || !std::equal(p.begin(), p.end(), last.p.begin()))
    last = traits_of(*law, p);
  return last;
}

}  // namespace

ShearTerm<double> shear_term(std::span<const double> p, double y, double T) {
  if (!(T > 0)) return {0, 0, 0};
  if (T < kSmallShear * y) {
    if (const LawTraits& known = traits(p); T < known.small_t * y) {
      const double k = known.small_power, t = T / (known.small_t * y);
      const double value = known.small_value * y * y * (k == 2 ? t * t : std::pow(t, k));
      return {value, (2 - k) * value / y, (2 - k) * (1 - k) * value / (y * y)};
    }
  }
  if (y < kLeastCosine * T) {
    const double limit = traits(p).shear_limit;
    if (limit < std::numeric_limits<double>::infinity()) return {limit * y * y, 2 * limit * y, 2 * limit};
  }
  Numbers numbers;
  const double squares = y * y + T * T, r = squares > 1e-280 ? std::sqrt(squares) : std::hypot(y, T);
  const ExpressionLaw& law = *current_law();
  const ShearTerm<double> reduced =
      reduced_shear(law, constants(p, numbers), T / r, y / r, law.is_equation() ? &traits(p) : nullptr);
  return {r * r * reduced.value, r * reduced.d1, reduced.d2};
}

double log_toughness(std::span<const double> p, const Mixity<double>& mixity, std::span<double> gradient) {
  return current_law()->log_toughness(mixity, p, gradient);
}

ShearBend shear_bend(std::span<const double> p) { return traits(p).bend; }
ShearReach shear_reach(std::span<const double> p) { return traits(p).reach; }
double shear_limit(std::span<const double> p) { return traits(p).shear_limit; }
double small_shear(std::span<const double> p) { return traits(p).small_shear; }
bool tau_grows_with_edge_load(std::span<const double> p) { return traits(p).tau_grows; }
bool turns(std::span<const double> p) { return traits(p).turns(); }
std::string_view equilibrium_domain(std::span<const double> p) { return traits(p).obstacle(); }

}  // namespace mixity::typed
