// Roots of functions of one variable, to their last digits.
#pragma once

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cstdint>

namespace mixity {

/// The root of f between low and high, at which f has different signs or is 0.
template <class F>
double root_between(F f, double low, double high) {
  std::uintmax_t evaluations = 200;
  const auto bracket =
      boost::math::tools::toms748_solve(f, low, high, boost::math::tools::eps_tolerance<double>(52), evaluations);
  return 0.5 * (bracket.first + bracket.second);
}

/// Calls found(v, falls) for the sign changes of f on [from, last], in order, until it returns false; falls: from > 0.
/// step(v), asked after f(v), is how far the next sample may lie. A dip between two samples is followed to its bottom;
/// a pair of roots about a bottom above -rounding is passed over.
template <class F, class Step, class Found>
void for_sign_changes(F f, double from, double last, double rounding, Step step, Found found) {
  double v_before = from, before = 0, v = from, here = f(from);
  bool has_before = false;
  while (v < last) {
    const double v_next = std::min(v + step(v), last), next = f(v_next);
    const bool crosses = (here > 0) != (next > 0);
    const double sign = here > 0 ? 1 : -1;
    if (crosses) {
      if (!found(root_between(f, v, v_next), here > 0)) return;
    } else if (has_before && sign * before > sign * here && sign * next > sign * here) {
      const auto dip =
          boost::math::tools::brent_find_minima([&](double x) { return sign * f(x); }, v_before, v_next, 50);
      // noise may put the bottom at an end
      if (dip.second < -rounding && v_before < dip.first && dip.first < v_next) {
        if (!found(root_between(f, v_before, dip.first), here > 0)) return;
        if (!found(root_between(f, dip.first, v_next), here <= 0)) return;
      }
    }
    has_before = !crosses;
    v_before = v;
    before = here;
    v = v_next;
    here = next;
  }
}

}  // namespace mixity
