// The law G_c(psi) = G_Ic f(psi) in the plane of the two energies G_I = G_c cos^2 psi and G_II = G_c sin^2 psi, and the
// point of it nearest to a measured one. With B = sin^2 psi and h = 1/f the law is the curve
//
//     G_I = G_Ic (1 - B)/h,   G_II = G_Ic B/h,      h = (1 - B) + tau^2(y = sqrt(1-B), T = sqrt(B)),
//
// regular in B for every model whose f is regular in psi^2; for model c it is the straight line G_I = G_Ic - lambda
// G_II.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "mechanics/base/law.h"
#include "mechanics/registry.h"

namespace mixity {

/// Signed distance of a measured point in units of its standard errors, positive where the law's energies are the
/// larger, with its derivatives in the law's parameters and in ln G_Ic.
template <class Law>
struct EnergyDistance {
  double value;
  Parameters<Law> parameters;
  double log_toughness;
};

template <class Law>
class EnergyCurve {
 public:
  EnergyCurve(const Law& law, const Parameters<Law>& p)
      : law_(law), p_(p), slope_at_mode_I_(-law.small_shear(p)), beside_corner_(has_tangent() ? 0 : beside_corner()) {}

  /// Distance of the point (G_I, G_II) from the law, with standard errors > 0 and `toughness` = G_Ic > 0, all in one
  /// unit of energy per area. A measured G_II < 0 is compared with the law's tangent at psi = 0. Derivatives in the
  /// parameters are computed only if `slopes`.
  EnergyDistance<Law> distance(double G_I, double G_II, double sigma_I, double sigma_II, double toughness,
                               bool slopes = true) const {
    const double by_I = toughness / sigma_I, by_II = toughness / sigma_II;
    const Target target{G_I / toughness,      G_II / toughness, sigma_I / toughness,
                        sigma_II / toughness, by_I * by_I,      by_II * by_II};
    const Nearest nearest = find(target);
    // along the normal, where rounding of the nearest point does not matter; at an end of the law, the plain offset
    double x = (nearest.G_I - target.G_I) / target.sigma_I, y = (nearest.G_II - target.G_II) / target.sigma_II;
    double n_I = nearest.d_II / target.sigma_II, n_II = -nearest.d_I / target.sigma_I;
    const double size = std::hypot(n_I, n_II), length = std::hypot(x, y);
    n_I /= size;
    n_II /= size;
    const double along = x * n_I + y * n_II;
    EnergyDistance<Law> r{along, {}, 0};
    if (nearest.at_end && length > 0) {
      r.value = std::copysign(length, along);
      n_I = x / r.value;
      n_II = y / r.value;
    }
    const double lever_I = n_I * nearest.G_I / target.sigma_I, lever_II = n_II * nearest.G_II / target.sigma_II;
    r.log_toughness = lever_I + lever_II;
    if (!slopes) return r;
    // at a fixed psi the law moves along its ray, by d ln f; at a corner it does not
    const bool at_corner = !has_tangent() && nearest.B == 0;
    const double B = has_tangent() || at_corner ? std::max(nearest.B, kTiny) : nearest.B;
    const double along_ray = at_corner ? 0 : r.log_toughness;
    r.parameters = law_.log_toughness(p_, mixity_from_mode_ratio(B)).gradient;
    for (double& slope : r.parameters)
      slope = nearest.on_tangent ? n_I / target.sigma_I * slope / kTiny * nearest.G_II : along_ray * slope;
    return r;
  }

 private:
  static constexpr double kTiny = 1e-18;  // the mode ratio at which the first term of ln f suffices
  static constexpr int kNodes = 48;
  static constexpr std::size_t kBesideCorner = 8;

  struct Target {
    double G_I, G_II, sigma_I, sigma_II, weight_I, weight_II;  // a weight is 1/sigma^2
  };
  struct Nearest {
    double B, G_I, G_II, d_I, d_II;  // energies and their derivatives in B, in units of G_Ic
    double dd_I = 0, dd_II = 0;      // second derivatives, which only steer the search
    bool at_end = false, on_tangent = false;
  };

  /// Otherwise the law has a corner at psi = 0, as bk with eta < 1 and powers below 1 have.
  bool has_tangent() const { return std::isfinite(slope_at_mode_I_); }
  /// Where the search begins at a corner: close to it, as f may go like B^0.01, and where f - 1 is no rounding yet.
  double beside_corner() const {
    constexpr double kResolved = 1e-8, kFirst = 1e-40, kLast = 1e-12;
    double B = kFirst;
    while (B < kLast && !(std::abs(law_.shear_term(p_, std::sqrt(1 - B), std::sqrt(B)).value) > kResolved)) B *= 1e4;
    return B;
  }

  Nearest at(double B) const {
    const double c = std::sqrt(1 - B), s = std::sqrt(B);
    const ShearTerm<double> tau2 = law_.shear_term(p_, c, s);
    const double h = (1 - B) + tau2.value;
    const bool in_limit = has_tangent() && B <= kTiny;
    const double slope = in_limit ? -1 - slope_at_mode_I_ : -1 + tau2.value / B - tau2.d1 / (2 * B * c);
    // tau^2 is homogeneous of degree 2, its derivatives in y of degrees 1 and 0
    const double Bc = B * c, of_d1 = 0.5 * (tau2.d1 / B - tau2.d2 / Bc);
    const double bend =
        (slope + 1) / B - tau2.value / (B * B) - 0.5 * of_d1 / Bc + 0.5 * tau2.d1 * (1 / (B * Bc) - 0.5 / (Bc * c * c));
    const double both = 2 * slope * slope / (h * h * h) - bend / (h * h);  // d^2(1/h)
    const double once = -2 * slope / (h * h);                              // 2 d(1/h)
    return {B,
            (1 - B) / h,
            B / h,
            (-h - (1 - B) * slope) / (h * h),
            (h - B * slope) / (h * h),
            (1 - B) * both - once,
            B * both + once};
  }
  static double half_slope(const Target& t, const Nearest& q) {
    return t.weight_I * (q.G_I - t.G_I) * q.d_I + t.weight_II * (q.G_II - t.G_II) * q.d_II;
  }
  static double half_bend(const Target& t, const Nearest& q) {
    return t.weight_I * (q.d_I * q.d_I + (q.G_I - t.G_I) * q.dd_I) +
           t.weight_II * (q.d_II * q.d_II + (q.G_II - t.G_II) * q.dd_II);
  }
  static double square(const Target& t, const Nearest& q) {
    return std::pow((q.G_I - t.G_I) / t.sigma_I, 2) + std::pow((q.G_II - t.G_II) / t.sigma_II, 2);
  }

  /// The nodes of every search, computed when first used.
  const Nearest& node(int i) const {
    for (; known_ <= i; ++known_)
      nodes_[static_cast<std::size_t>(known_)] =
          at(known_ < kNodes ? std::pow(std::sin(0.5 * pi<double>() * known_ / kNodes), 2) : 1 - 1e-12);
    return nodes_[static_cast<std::size_t>(i)];
  }

  /// The zero of the slope between two nodes, - at one and + at the other: by Newton's steps, or by halving where these
  /// do not shrink. Its error is the last step squared; the distance is stationary: its error is the square.
  Nearest between(const Target& target, const Nearest& one, const Nearest& other, double slope_of_one,
                  double slope_of_other) const {
    double low = one.B, high = other.B, before = high - low;
    double B = low + before * slope_of_one / (slope_of_one - slope_of_other);
    for (int i = 0; i < 100; ++i) {
      const Nearest here = at(B);
      const double slope = half_slope(target, here);
      if (slope == 0) return here;
      (slope < 0 ? low : high) = B;
      double next = B - slope / half_bend(target, here);
      if (!(next > low && next < high && std::abs(next - B) <= 0.5 * before))
        next = low > 0 && high > 100 * low ? std::sqrt(low * high) : 0.5 * (low + high);
      before = std::abs(next - B);
      B = next;
      if (before <= 1e-7 * std::min(B, 1 - B)) break;
    }
    return at(B);
  }

  Nearest find(const Target& target) const {
    // Nodes uniform in psi, up to where the energies are finite; each sign change of the slope from - to + is a
    // minimum.
    const Nearest first = has_tangent() ? node(0) : at(beside_corner_);
    const Nearest* before = &first;
    Nearest best = first;
    if (!has_tangent()) best.B = 0, best.G_I = 1, best.G_II = 0;
    best.at_end = true;
    double least = square(target, best), slope = half_slope(target, first);
    if (has_tangent() && slope > 0) {  // beyond psi = 0, on the tangent G_I = 1 + slope G_II
      const double m = slope_at_mode_I_, a = m / target.sigma_I, b = 1 / target.sigma_II;
      const double t = (a * (target.G_I - 1) / target.sigma_I + b * target.G_II / target.sigma_II) / (a * a + b * b);
      if (t <= 0) {
        best = {0, 1 + m * t, t, m, 1, 0, 0, false, true};
        least = square(target, best);
      }
    }
    const auto pass = [&](const Nearest& here) {  // to the next place
      const double next = half_slope(target, here);
      if (slope < 0 && next >= 0) {
        const Nearest inside = between(target, *before, here, slope, next);
        if (const double found = square(target, inside); found < least) {
          best = inside;
          least = found;
        }
      }
      before = &here;
      slope = next;
    };
    // From a corner the law may lead away and then along the point before the first node: twice the slope changes sign.
    std::array<Nearest, kBesideCorner> beside;
    if (!has_tangent()) {
      const double own = std::clamp(target.G_II / (std::abs(target.G_I) + std::abs(target.G_II)), 0.0, 1.0);
      for (Nearest& here : beside) {
        const auto share = static_cast<double>(&here - beside.data() + 1) / kBesideCorner;
        const double B = own * share * share;
        if (!(B > before->B && B < node(1).B)) continue;
        here = at(B);
        pass(here);
      }
    }
    for (int i = 1; i <= kNodes; ++i) {
      const Nearest& here = node(i);
      if (!std::isfinite(here.G_II + here.d_I + here.d_II)) break;
      pass(here);
      if (i == kNodes && slope < 0) {
        Nearest end = here;
        if (const double h = law_.shear_term(p_, 0.0, 1.0).value; h > 0) end.B = 1, end.G_I = 0, end.G_II = 1 / h;
        if (const double found = square(target, end); found < least) {
          best = end;
          best.at_end = true;
        }
      }
    }
    return best;
  }

  mutable std::array<Nearest, kNodes + 1> nodes_;
  mutable int known_ = 0;
  [[no_unique_address]] Law law_;
  Parameters<Law> p_;
  double slope_at_mode_I_;  // dG_I/dG_II there
  double beside_corner_;
};

/// The law as a polygon, for distances that are only accurate enough to separate basins of minima.
template <class Law>
class EnergyPolygon {
 public:
  EnergyPolygon(const Law& law, const Parameters<Law>& p) {
    for (int i = 0; i <= kSides; ++i) {
      const Mixity<double> mixity = mixity_from_angle(0.5 * pi<double>() * i / kSides);
      const double f = std::exp(log_toughness_alone(law, p, mixity));
      if (!std::isfinite(f)) break;
      corners_[count_++] = {f * mixity.cos * mixity.cos, f * mixity.sin * mixity.sin};
    }
  }

  /// Unsigned, to a thousandth of the size of the law's curve; infinite where the law is not a number.
  double distance(double G_I, double G_II, double sigma_I, double sigma_II, double toughness) const {
    double least = std::numeric_limits<double>::infinity();  // squared
    const double unit_I = toughness / sigma_I, unit_II = toughness / sigma_II, at_I = G_I / sigma_I,
                 at_II = G_II / sigma_II;
    const auto scaled = [&](const Corner& corner) {
      return Corner{unit_I * corner.G_I - at_I, unit_II * corner.G_II - at_II};
    };
    if (count_ == 0) return least;
    Corner to = scaled(corners_[0]);
    for (std::size_t i = 1; i < count_; ++i) {
      const Corner from = std::exchange(to, scaled(corners_[i]));
      const double I = to.G_I - from.G_I, II = to.G_II - from.G_II, length = I * I + II * II;
      const double along = length > 0 ? std::clamp(-(from.G_I * I + from.G_II * II) / length, 0.0, 1.0) : 0;
      const double x = from.G_I + along * I, y = from.G_II + along * II;
      least = std::min(least, x * x + y * y);
    }
    return std::sqrt(least);
  }

 private:
  static constexpr int kSides = 32;
  struct Corner {
    double G_I, G_II;
  };
  std::array<Corner, kSides + 1> corners_;
  std::size_t count_ = 0;
};

}  // namespace mixity
