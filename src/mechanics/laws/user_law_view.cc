#include "mechanics/laws/user_law_view.h"

#include <cmath>
#include <limits>

namespace mixity {

ShearTerm<double> UserLawView::shear_term(const Parameters& p, double y, double T) const {
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
  const double squares = y * y + T * T, r = squares > 1e-280 ? std::sqrt(squares) : std::hypot(y, T);
  const ShearTerm<double> reduced =
      reduced_shear(*workspace_, p, T / r, y / r, workspace_->law().form().equation ? &traits(p) : nullptr);
  return {r * r * reduced.value, r * reduced.d1, reduced.d2};
}

}  // namespace mixity
