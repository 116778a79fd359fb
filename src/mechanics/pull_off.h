// The pull-off load of a sheared contact: the lowest normal load at which it is in adhesive equilibrium while its
// tangential load T, or its tangential displacement u = 3/4 T/a, is held.
//
// With t = T/y and g = (1 + t^2)/f = 1 + tau^2(1, t), equilibrium y^2 g = 6 pi (y + P) = 8 pi a^3 is explicit in t
// under both controls:
//
//     held T:  y = T/t,                 P = y^2 g/(6 pi) - y
//     held u:  a = 2 u^2 g/(9 pi t^2),  y = 4 u a/(3 t),        P = 4/3 a^3 - y
//
// tau^2 is homogeneous of degree 2, so t dg/dt = 2 (g - 1) - d with d = dtau^2/dy at (1, t). With D = (2 + d)/g,
//
//     held T:  dP/d ln t = y - D (y + P)          held u:  dP/d ln t = (1 + D) y - 3 D (y + P)
//
// The zero at which P is least is a fold, where the contact jumps. For model c, d = 0 and P = -3 pi/2 + lambda
// T^2/(6 pi). Without such a zero P is least at y = 0: the contact reaches Hertz, and adhesion ends without a jump. In
// both cases t need not be followed (envelope theorem): at fixed t, d ln g/dp = -d ln f/dp gives the derivatives.
#pragma once

#include <cmath>

#include "mechanics/equilibrium.h"
#include "mechanics/registry.h"
#include "mechanics/roots.h"
#include "mechanics/states.h"

namespace mixity {

template <class Law>
class PullOffSearch {
 public:
  /// Parameters without obstacle.
  PullOffSearch(const Law& law, const Parameters<Law>& p, HeldShear held) : law_(law), p_(p), held_(held) {}

  /// `shear`: T or u, 0 <= shear <= kMostPullOffShear.
  PullOff at(double shear) const {
    if (shear == 0) return {-1.5 * pi<double>(), 3 * pi<double>(), std::cbrt(1.125 * pi<double>()), 0, 0};
    // t of a contact far above pull-off, where P falls with t, and of one with hardly any edge load
    double first = std::log(shear / 100);
    for (int i = 0; i < 200 && !(state(shear, first).slope < 0); ++i) first -= 1;
    const double last = std::log(shear * 1e8 + 1e8);
    PullOff best = end(shear);
    for_sign_changes([&](double x) { return state(shear, x).slope; }, first, last, 0, [](double) { return kStep; },
                     [&](double x, bool falls) {
                       if (const PullOff found = of(shear, x); !falls && found.P < best.P) best = found;
                       return true;
                     });
    return best;
  }

  /// Derivatives of P in the parameters.
  Parameters<Law> gradient(const PullOff& at) const {
    if (at.T == 0) return Parameters<Law>(parameters_of(0));
    auto gradient = law_.log_toughness(p_, mixity_from_loads(at.y, at.T)).gradient;
    const double sum = at.y + at.P, factor = held_ == HeldShear::load ? -sum : at.y - 3 * sum;
    for (double& slope : gradient) slope *= factor;
    return gradient;
  }

 private:
  static constexpr double kStep = 0.2;  // of ln t: laws have no features narrower than 3 degrees

  struct State {
    double y, sum, slope;  // sum = y + P; slope = dP/d ln t
  };

  Parameters<Law> parameters_of(double value) const {
    Parameters<Law> all = p_;
    for (double& one : all) one = value;
    return all;
  }

  State state(double shear, double ln_t) const {
    const double t = std::exp(ln_t);
    const ShearTerm<double> tau2 = law_.shear_term(p_, 1.0, t);
    const double g = 1 + tau2.value, D = (2 + tau2.d1) / g;
    if (held_ == HeldShear::load) {
      const double y = shear / t, sum = y * y * g / (6 * pi<double>());
      return {y, sum, y - D * sum};
    }
    const double a = 2 * (shear / t) * (shear / t) * g / (9 * pi<double>()), y = 4.0 / 3 * shear * a / t,
                 sum = 4.0 / 3 * a * a * a;
    return {y, sum, (1 + D) * y - 3 * D * sum};
  }

  PullOff of(double shear, double ln_t) const {
    const State at = state(shear, ln_t);
    return made(shear, at.y, at.sum, false);
  }
  /// The state at y = 0.
  PullOff end(double shear) const {
    const double limit = law_.shear_term(p_, 0.0, 1.0).value;  // tau^2/T^2
    if (held_ == HeldShear::load) return made(shear, 0, shear * shear * limit / (6 * pi<double>()), true);
    const double a = 2 * shear * shear * limit / (9 * pi<double>());
    return made(shear, 0, 4.0 / 3 * a * a * a, true);
  }

  PullOff made(double shear, double y, double sum, bool smooth) const {
    PullOff found{sum - y, y, std::cbrt(0.75 * sum), shear, 0, smooth};
    if (held_ == HeldShear::displacement) {
      found.T = 4.0 / 3 * shear * found.a;
      found.slope = (6 * sum - 3 * y) / shear;
    } else if (y > 0) {
      const ShearTerm<double> tau2 = law_.shear_term(p_, y, shear);
      found.slope = (2 * tau2.value - y * tau2.d1) / (6 * pi<double>() * shear);
    } else {
      found.slope = 2 * sum / shear;
    }
    return found;
  }

  [[no_unique_address]] Law law_;
  Parameters<Law> p_;
  HeldShear held_;
};

/// Signed distances of measured points from P(held shear), positive where the model's P is the larger. The nearest
/// point is found for each point.
template <class Law>
bool pull_off_distances(const Law& law, const Parameters<Law>& p, const PullOffPoints& points,
                        const PullOffDistances& out) {
  const std::size_t parameters = points.P.empty() ? 0 : out.parameters.size() / points.P.size();
  for (std::size_t i = 0; i < points.P.size(); ++i) {
    const PullOffSearch search(law, p, points.held[i]);
    const double shear = std::abs(points.shear[i]), P = points.P[i], sigma = points.sigma_P[i],
                 ratio = points.sigma_shear[i] / sigma;
    if (!(shear <= kMostPullOffShear) || !std::isfinite(P)) return false;
    PullOff at = search.at(shear);
    double place = shear;
    if (ratio > 0) {
      // half the slope of the squared distance along the curve, times sigma_shear^2
      const auto slope = [&](double x) {
        const PullOff here = search.at(x);
        return (x - shear) + ratio * ratio * here.slope * (here.P - P);
      };
      const bool below = slope(shear) > 0;
      double low = 0, high = shear;
      if (!below) {
        low = shear;
        double step = std::fmax(std::abs(at.P - P) * ratio, 1e-9);
        for (high = shear + step; slope(high) < 0 && high < kMostPullOffShear; high += step *= 2) low = high;
      }
      // the distance is stationary here: its error is the square of this one
      if (low < high) place = root_between(slope, low, high, 30);
      at = search.at(std::fmin(place, kMostPullOffShear));
    }
    const double steepness = at.slope * ratio, length = std::sqrt(1 + steepness * steepness);
    const double across = (at.P - P) / sigma / length,
                 along = ratio > 0 ? steepness * (shear - place) / points.sigma_shear[i] / length : 0;
    out.r[i] = across + along;
    if (!std::isfinite(out.r[i])) return false;
    if (out.parameters.empty()) continue;
    out.normal_P[i] = 1 / length;
    const double of_P = 1 / (sigma * length);
    const auto gradient = search.gradient(at);
    for (std::size_t k = 0; k < parameters; ++k) out.parameters[i * parameters + k] = of_P * gradient[k];
    out.dP[i] = -of_P;
    out.dshear[i] = std::copysign(of_P * at.slope, points.shear[i]);
  }
  return true;
}

}  // namespace mixity
