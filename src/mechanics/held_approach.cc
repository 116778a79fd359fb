#include "mechanics/held_approach.h"

#include <algorithm>
#include <cmath>

#include "mechanics/contact.h"
#include "mechanics/roots.h"

namespace mixity {

bool HeldApproach::in_range() const {
  constexpr double kMost = 1e50;  // powers of the radius then do not overflow
  return std::abs(approach) <= kMost && compliance >= 0 && compliance <= kMost;
}

double HeldApproach::radius(double y) const {
  const auto excess = [&](double a) {
    return a * (compliance * (4.0 / 3 * a * a * a - y) + (a * a - approach)) - 0.5 * y;
  };
  if (y == 0 && !(approach > 0)) return 0;
  double high = 1;
  while (!(excess(high) > 0)) high *= 2;
  double low = high;
  while (low > 1e-100 && !(excess(low) < 0)) low /= 2;
  return root_between(excess, low, high);
}

/// y = sqrt(8 pi a^3) is a polynomial in sqrt(a) that falls and then rises.
std::optional<HeldApproach::Unsheared> HeldApproach::unsheared() const {
  if (!in_range()) return std::nullopt;
  const double m = compliance, root = std::sqrt(8 * pi<double>());
  const auto excess = [&](double v) {
    const double square = v * v, cube = square * v;
    return m * cube * (4.0 / 3 * cube - root) + (square * square - 0.5 * root * v) - approach;
  };
  const auto slope = [&](double v) { return 8 * m * v * v * v * v * v + 4 * v * v * v - root * (3 * m * v * v + 0.5); };
  double high = 1;
  while (slope(high) < 0 || excess(high) < 0) high *= 2;
  const double least = root_between(slope, 0, high);
  if (excess(least) > 0) return std::nullopt;
  const double v = root_between(excess, least, high), w = approach < 0 ? root_between(excess, 0, least) : 0;
  return Unsheared{v * v, w * w};
}

}  // namespace mixity
