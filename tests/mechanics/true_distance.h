// The distance of a point from the printed equilibrium curve by brute force: the curve is scanned in doubles, and the
// best stretches of it are searched in 50 digits. With T = t y the printed y^2 + T^2 = 6 pi (y + P) f is a quadratic in
// y, so that every t = tan psi gives the one or two states there.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "mechanics/printed_equation.h"

namespace mixity::truth {

template <class Number>
struct Measured {
  Number P, T, A, sigma_T, sigma_A;
};

/// The state at ln tan psi = s. upper: the larger y. Distance infinite where there is none.
template <class Number>
struct State {
  Number y, T, A;
  bool exists;
};

template <class Number>
State<Number> state(std::string_view model, const Number& p0, const Number& p1, const Number& P, const Number& s,
                    bool upper) {
  using std::exp, std::sqrt, std::cbrt;
  const Number pi_ = boost::math::constants::pi<Number>(), t = exp(s);
  const Number g = (1 + t * t) / printed_toughness<Number>(model, p0, p1, Number(1), t);
  const Number inside = 9 * pi_ * pi_ + 6 * pi_ * P * g;
  if (!(inside >= 0)) return {0, 0, 0, false};
  const Number y = upper ? Number((3 * pi_ + sqrt(inside)) / g) : Number(-6 * pi_ * P / (3 * pi_ + sqrt(inside)));
  if (!(y > 0)) return {0, 0, 0, false};
  const Number a = cbrt(Number(Number(3) / 4 * (y + P)));
  return {y, t * y, pi_ * a * a, true};
}

/// The curve of one load. Doubles see the stretches well enough where T/y times 1e-16 is far below sigma_T/T: an angle
/// near pi/2 tells T/y no better.
template <std::size_t N>
class Curve {
 public:
  Curve(std::string_view model, const std::array<double, N>& p, double P, bool upper_only)
      : model_(model), p0_(p[0]), p1_(p[N - 1]), P_(P) {
    constexpr int kSamples = 1600;
    for (const bool upper : {true, false}) {
      if (!upper && (upper_only || P >= 0)) break;
      for (int i = 0; i <= kSamples; ++i) {
        const double s = -40 + 64.0 * i / kSamples;
        const State<double> q = state<double>(model_, p0_, p1_, P_, s, upper);
        if (q.exists) samples_.push_back({s, q.T, q.A, upper});
      }
    }
  }

  /// Where on the curve the nearest place of a point lies; the distance from it is that of `distance`.
  struct Stretch {
    double low, high;
    bool upper;
  };
  Stretch nearest(const Measured<double>& m) const {
    std::vector<std::size_t> minima;
    const auto at = [&](std::size_t i) {
      return std::hypot((samples_[i].T - m.T) / m.sigma_T, (samples_[i].A - m.A) / m.sigma_A);
    };
    for (std::size_t i = 0; i < samples_.size(); ++i)
      if ((i == 0 || samples_[i - 1].upper != samples_[i].upper || at(i - 1) >= at(i)) &&
          (i + 1 == samples_.size() || samples_[i + 1].upper != samples_[i].upper || at(i + 1) >= at(i)))
        minima.push_back(i);
    Stretch best{};
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t i : minima) {
      const Stretch wide{samples_[i].s - kStep, samples_[i].s + kStep, samples_[i].upper};
      const double d = search<double>(model_, wide, m, p0_, p1_, 40);
      if (d < least) {
        least = d;
        best = wide;
      }
    }
    double s = 0;
    search<double>(model_, best, m, p0_, p1_, 12, &s);
    best.low = s - kNarrow;
    best.high = s + kNarrow;
    return best;
  }

  /// To 2 (0.618^steps)^2 of the distance or so, by golden section.
  template <class Number>
  static Number search(std::string_view model, const Stretch& stretch, const Measured<Number>& m, const Number& p0,
                       const Number& p1, int steps, Number* place = nullptr) {
    const auto distance = [&](const Number& s) -> Number {
      using std::sqrt;
      const State<Number> q = state<Number>(model, p0, p1, m.P, s, stretch.upper);
      if (!q.exists) return Number(1e300);
      const Number x = (q.T - m.T) / m.sigma_T, z = (q.A - m.A) / m.sigma_A;
      return sqrt(x * x + z * z);
    };
    using std::sqrt;
    const Number golden = (sqrt(Number(5)) - 1) / 2;
    Number low = stretch.low, high = stretch.high;
    Number one = high - golden * (high - low), other = low + golden * (high - low);
    Number at_one = distance(one), at_other = distance(other);
    for (int i = 0; i < steps; ++i) {
      if (at_one <= at_other) {  // where neither exists s is too large
        high = other;
        other = one;
        at_other = at_one;
        one = high - golden * (high - low);
        at_one = distance(one);
      } else {
        low = one;
        one = other;
        at_one = at_other;
        other = low + golden * (high - low);
        at_other = distance(other);
      }
    }
    if (place != nullptr) *place = at_one < at_other ? one : other;
    return std::min(at_one, at_other);
  }
  Digits50 distance(const Measured<double>& m) const { return distance(nearest(m), exact(m), p0_, p1_); }

  /// For a measured point or parameters beside those that the stretch was found for. Where standard errors are small
  /// the place has to be known the better, above all next to where the two states at one psi meet.
  Digits50 distance(const Stretch& stretch, const Measured<Digits50>& m, const Digits50& p0, const Digits50& p1,
                    int more_steps = 0) const {
    const Digits50 jkr = end(m, jkr_edge_load(m.P), p0, p1), hertz = m.P > 0 ? end(m, 0, p0, p1) : jkr;
    const double fine = static_cast<double>(Digits50(m.T / m.sigma_T));
    const int steps = more_steps + 36 + static_cast<int>(4 * std::log1p(fine));
    const Digits50 d = search<Digits50>(model_, stretch, m, p0, p1, steps);
    if (std::min(jkr, hertz) < d) return std::min(jkr, hertz);
    return d > 1e-3 ? d : search<Digits50>(model_, stretch, m, p0, p1, steps + 40);  // |r| is no parabola about 0
  }
  static Measured<Digits50> exact(const Measured<double>& m) { return {m.P, m.T, m.A, m.sigma_T, m.sigma_A}; }

  /// The distance from JKR, or from Hertz (y = 0), where tau^2 = T^2/f(pi/2) = 6 pi P.
  Digits50 end(const Measured<Digits50>& m, const Digits50& y, const Digits50& p0, const Digits50& p1) const {
    const Digits50 f = printed_toughness<Digits50>(model_, p0, p1, Digits50("1e-60"), 1);
    const Digits50 T = y > 0 ? Digits50(0) : f < 1e30 ? sqrt(Digits50(6 * kPi * m.P * f)) : Digits50(1e300);
    const Digits50 a = cbrt(Digits50(Digits50(3) / 4 * (y + m.P)));
    const Digits50 x = (T - m.T) / m.sigma_T, z = (kPi * a * a - m.A) / m.sigma_A;
    return sqrt(Digits50(x * x + z * z));
  }

  struct Sample {
    double s, T, A;
    bool upper;
  };
  const std::vector<Sample>& samples() const { return samples_; }

 private:
  static constexpr double kStep = 64.0 / 1600;
  static constexpr double kNarrow = 1e-3;  // several times what 12 steps leave of kStep
  std::string_view model_;
  double p0_, p1_, P_;
  std::vector<Sample> samples_;
};

}  // namespace mixity::truth
