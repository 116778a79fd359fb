// The equilibrium curve parametrised by the phase angle, for laws whose g = (1 + tan^2 psi)/f does not always grow with
// psi. Several T may then have the same area, and the circle is of no use: the curve covers it more than once or leaves
// it (g < 1), and tau does not determine T. In psi the curve is still explicit: y is a root of
//
//     g y^2 = 6 pi (y + P),
//
// the larger one up to psi_c, where the two meet (P < 0, g = -3 pi/(2 P)), then the smaller one on the way back. Where
// g falls towards 0, the contact grows without bound; the curve ends where g = 1e-8.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "mechanics/base/law.h"
#include "mechanics/contact.h"
#include "mechanics/registry.h"

namespace mixity {

template <class Law>
class NonMonotoneCurve {
 public:
  NonMonotoneCurve(const Law& law, const Parameters<Law>& p, double P) : law_(law), p_(p), P_(P) {
    if (P < 0) close();
    if (!closed() && ratio(std::exp(kLast)) < kLeastRatio) cut();
  }

  /// Whether the curve returns to T = 0, at the unstable JKR state; otherwise it continues to psi = pi/2.
  bool closed() const { return sin_c_ > 0; }
  /// Whether the curve ends at g = 1e-8.
  bool grows_over_all_bounds() const { return psi_end_ < 0.5 * pi<double>(); }

  /// The parameter s runs from 0 to this: psi = s, or sin psi = sin psi_c sin s on a closed curve.
  double length() const { return closed() ? pi<double>() : psi_end_; }

  struct Place {
    double psi, t, y;   // t = T/y
    double dpsi, root;  // dpsi/ds; root = g y - 3 pi, negative on the way back
    double growth;      // dg/d ln t
    double pace;        // dt/ds divided by root, finite at psi_c, too
  };

  /// The place at s. rest = length() - s is passed separately to keep its digits.
  Place at(double s, double rest) const {
    Place q{};
    if (closed()) {
      // sin psi = sin psi_c sin s
      const double near = std::max(std::min(s, rest), 0.0), cosine = std::copysign(std::cos(near), rest - s);
      const double sin_psi = sin_c_ * std::sin(near), cos_psi = std::hypot(cos_c_, sin_c_ * cosine);
      q.psi = std::atan2(sin_psi, cos_psi);
      q.dpsi = sin_c_ * cosine / cos_psi;
      q.t = sin_psi / cos_psi;
    } else {
      q.psi = s;
      q.dpsi = 1;
      q.t = s < rest || grows_over_all_bounds() ? std::tan(s) : 1 / std::tan(std::max(rest, kLeastRest));
    }
    const ShearTerm<double> excess = law_.shear_term(p_, 1.0, q.t);  // g - 1, and d1 = 2 (g - 1) - dg/d ln t
    q.growth = 2 * excess.value - excess.d1;
    q.root = std::copysign(std::sqrt(std::max(square(excess.value), 0.0)), q.dpsi);
    const double per_t = 1 + q.t * q.t;
    q.pace = per_t * q.dpsi / q.root;
    if (closed()) {
      // near psi_c the square would cancel; here it is its slope times the distance in ln t
      const double cos_s = q.dpsi / sin_c_ / std::sqrt(per_t), squared = cos_s * cos_s, t_c = sin_c_ / cos_c_;
      const double way = 0.5 * (std::log1p(t_c * t_c * squared) - std::log1p(-squared));
      if (way < kBeside) {
        const ShearTerm<double> between = law_.shear_term(p_, 1.0, std::sqrt(q.t * t_c));
        const double slope = -6 * pi<double>() * P_ * (2 * between.value - between.d1);
        const double per_square = squared > 0 ? way / squared : 0.5 / (cos_c_ * cos_c_);
        const double scale = std::sqrt(slope * per_square);
        q.root = cos_s * scale;
        q.pace = per_t * std::sqrt(per_t) * sin_c_ / scale;
      }
    }
    const double centre = 3 * pi<double>();
    q.y = q.root < 0 ? -2 * centre * P_ / (centre - q.root) : (centre + q.root) / ratio(q.t, excess.value);
    return q;
  }

  /// y of the larger root at T/y = t; null beyond psi_c.
  std::optional<double> upper_edge_load(double t) const {
    const double excess = law_.shear_term(p_, 1.0, t).value, squared = square(excess);
    if (!(squared >= 0) || (closed() && t > sin_c_ / cos_c_)) return std::nullopt;
    return (3 * pi<double>() + std::sqrt(squared)) / ratio(t, excess);
  }

 private:
  static constexpr double kLeastRest = 1e-18, kBeside = 1e-5, kLeastRatio = 1e-8;
  static constexpr double kFirst = -40, kLast = 42, kStep = 0.125;  // for ln t

  /// g; for small g, `excess` = g - 1 has lost its digits.
  double ratio(double t, double excess) const {
    if (excess > -0.5) return 1 + excess;
    return (1 + t * t) * std::exp(-law_.log_toughness(p_, mixity_from_loads(1.0, t)).value);
  }
  double ratio(double t) const { return ratio(t, law_.shear_term(p_, 1.0, t).value); }

  /// Finds the first place with g = 1e-8.
  void cut() {
    double low = kFirst, high = kFirst;
    while (ratio(std::exp(high)) > kLeastRatio) low = high, high += kStep;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (ratio(std::exp(middle)) > kLeastRatio ? low : high) = middle;
    }
    psi_end_ = std::atan(std::exp(low));
  }

  /// (g y - 3 pi)^2 = 9 pi^2 + 6 pi P g.
  double square(double excess) const { return 6 * pi<double>() * (above_pull_off(P_) + P_ * excess); }

  /// Finds psi_c.
  void close() {
    const auto open = [&](double x) { return square(law_.shear_term(p_, 1.0, std::exp(x)).value) > 0; };
    double low = kFirst, high = kFirst;
    while (high < kLast && open(high)) low = high, high += kStep;
    if (high >= kLast) return;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (open(middle) ? low : high) = middle;
    }
    const double t = std::exp(low);
    cos_c_ = 1 / std::sqrt(1 + t * t);
    sin_c_ = t * cos_c_;
  }

  [[no_unique_address]] Law law_;
  Parameters<Law> p_;
  double P_, sin_c_ = 0, cos_c_ = 1, psi_end_ = 0.5 * pi<double>();
};

/// Whether g may fail to grow with psi under a law of this type.
template <class Law>
inline constexpr bool kMayBeNonMonotone = requires(const Law& law, const Parameters<Law>& p) {
  law.non_monotone(p);
};

/// Whether g does so with these parameters (base/law.h).
template <class Law>
bool is_non_monotone(const Law& law, const Parameters<Law>& p) {
  if constexpr (kMayBeNonMonotone<Law>)
    return law.non_monotone(p);
  else
    return false;
}

}  // namespace mixity
