// How g = (1 + tan^2 psi)/f grows with psi under a law that is defined at run time.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "mechanics/laws/taylor.h"

namespace mixity {

/// d ln g/d psi at an angle, and its derivative.
struct Growth {
  double value, slope;  // `slope`: the derivative of `value` in psi
  bool falls;           // value < 0 by more than rounding
};

/// `f` carries its derivatives in psi. `rounding`: relative error of its slope.
inline Growth growth_of(double psi, const Taylor& f, double rounding) {
  const double t = std::tan(psi), growth = 2 * t, decline = f.first / f.value, value = growth - decline;
  return {value, 2 * (1 + t * t) - f.second / f.value + decline * decline,
          !(value >= -rounding * (growth + std::abs(decline)))};
}

/// Whether the two ends of an interval imply that the growth has a dip or a hump between them.
inline bool shows_between(const Growth& one, const Growth& other) {
  return one.falls ? one.slope > 0 && other.slope < 0 : one.slope < 0 && other.slope > 0;
}

/// An angle between low and high at which g falls although it grows at both ends; null if none is found.
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

}  // namespace mixity
