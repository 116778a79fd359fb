#include "mechanics/roots.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cstdint>

namespace mixity {

double root_between(RealFunction f, double low, double high, int bits) {
  std::uintmax_t evaluations = 200;
  const auto ends = boost::math::tools::toms748_solve(
      f, low, high, boost::math::tools::eps_tolerance<double>(static_cast<unsigned>(bits)), evaluations);
  return 0.5 * (ends.first + ends.second);
}

Minimum minimum_between(RealFunction f, double low, double high, int bits) {
  const auto [at, value] = boost::math::tools::brent_find_minima(f, low, high, bits);
  return {at, value};
}

void for_sign_changes(RealFunction f, double from, double last, double rounding, RealFunction step,
                      FunctionRef<bool(double, bool)> found) {
  double v_before = from, before = 0, v = from, here = f(from);
  bool has_before = false;
  while (v < last) {
    const double v_next = std::min(v + step(v), last), next = f(v_next);
    const bool crosses = (here > 0) != (next > 0);
    const double sign = here > 0 ? 1 : -1;
    if (crosses) {
      if (!found(root_between(f, v, v_next), here > 0)) return;
    } else if (has_before && sign * before > sign * here && sign * next > sign * here) {
      const Minimum dip = minimum_between([&](double x) { return sign * f(x); }, v_before, v_next, 50);
      // noise may put the bottom at an end
      if (dip.value < -rounding && v_before < dip.at && dip.at < v_next) {
        if (!found(root_between(f, v_before, dip.at), here > 0)) return;
        if (!found(root_between(f, dip.at, v_next), here <= 0)) return;
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
