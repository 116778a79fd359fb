// The states of an elliptic contact that are nearest to measured points, in the space of T, A = pi a b and q = ln(a/b).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "mechanics/elliptic_curve.h"
#include "mechanics/roots.h"

namespace mixity {

/// A measured point with its standard errors. The third coordinate is q - slant A/A_measured; without axes its error is
/// infinite.
struct EllipticReading {
  double T, A, q, sigma_T, sigma_A, sigma_q, slant;
};

/// The curve of states, followed only as far as its points need.
template <class Law>
class EllipticNearest : public EllipticCurve<Law> {
  using Curve = EllipticCurve<Law>;
  using Curve::between, Curve::cubic, Curve::mark_at, Curve::spot_at_T, Curve::spot_of, Curve::spots_,
      Curve::walk_below, Curve::whole_;

 public:
  using Curve::Curve;
  using typename Curve::Spot;
  using Vector = std::array<double, 3>;  // in standard errors of T, A and q

  static double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

  /// The nearest state, and whether it is the end of the curve.
  struct Nearest {
    Spot spot;
    bool at_end;
    double square;
  };

  Nearest nearest(const EllipticReading& to) {
    if (Curve::uncoupled()) {
      Spot spot = spots_[0];
      spot.at = spot.T = to.T;
      spot.dT = 1;
      spot.by_T = true;
      return {spot, false, square_of(offset(spot, to))};
    }
    walk_below(to.A - 2 * to.sigma_A);
    const Nearest best = nearest_so_far(to);
    // the area falls along the curve: what follows is no nearer than the area at which it begins
    return walk_below(to.A - std::sqrt(best.square) * to.sigma_A) ? nearest_so_far(to) : best;
  }

  Vector offset(const Spot& spot, const EllipticReading& from) const {
    return {(spot.T - from.T) / from.sigma_T, (spot.A - from.A) / from.sigma_A,
            (spot.q - from.q - from.slant * (spot.A / from.A - 1)) / from.sigma_q};
  }

 private:
  /// The nearest state of what is known of the curve.
  Nearest nearest_so_far(const EllipticReading& to) {
    // the nearest chord first; then those that are nearer than their neighbours and may hide a nearer state
    const std::size_t chords = spots_.size() - 1;
    squares_.resize(chords + 2);
    squares_[0] = squares_[chords + 1] = std::numeric_limits<double>::infinity();
    std::size_t first = 1;
    Vector at = offset(spots_[0], to);
    Nearest best{spots_[0], false, square_of(at)};
    for (std::size_t i = 1; i <= chords; ++i) {
      const Vector next = offset(spots_[i], to);
      squares_[i] =
          spots_[i - 1].by_T == spots_[i].by_T ? chord_square(at, next) : std::numeric_limits<double>::infinity();
      if (squares_[i] < squares_[first]) first = i;
      at = next;
    }
    if (chords == 0) return best;
    if (const Nearest found = refined(first - 1, to); found.square < best.square) best = found;
    for (std::size_t i = 1; i <= chords; ++i) {
      if (i == first || squares_[i] > squares_[i - 1] || squares_[i] > squares_[i + 1] || !std::isfinite(squares_[i]))
        continue;
      if (std::sqrt(squares_[i]) - sag(i - 1, to) > std::sqrt(best.square)) continue;
      if (const Nearest found = refined(i - 1, to); found.square < best.square) best = found;
    }
    return best;
  }

  static double square_of(const Vector& v) { return dot(v, v); }

  static double chord_square(const Vector& a, const Vector& b) {
    const Vector d{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    const double length = square_of(d), x = length > 0 ? std::clamp(-dot(a, d) / length, 0.0, 1.0) : 0.0;
    return square_of({a[0] + x * d[0], a[1] + x * d[1], a[2] + x * d[2]});
  }

  /// How far the curve may lie from its chord, in standard errors: twice what it does in the middle.
  double sag(std::size_t i, const EllipticReading& to) const {
    const Spot &low = spots_[i], &high = spots_[i + 1];
    const double eighth = (high.at - low.at) / 8;
    const Vector d{eighth * (low.dT - high.dT) / to.sigma_T, eighth * (low.dA - high.dA) / to.sigma_A,
                   eighth * (low.dq - high.dq - to.slant * (low.dA - high.dA) / to.A) / to.sigma_q};
    return 2 * std::sqrt(square_of(d));
  }

  /// The second derivative of the cubic.
  static double second(double x, double h, double f0, double d0, double f1, double d1) {
    return ((6 - 12 * x) * (f1 - f0) / h + (6 * x - 4) * d0 + (6 * x - 2) * d1) / h;
  }

  /// The nearest part of a chord on Hermite's cubics, as a start.
  double nearest_on_cubic(const Spot& low, const Spot& high, double h, double x, const EllipticReading& to) const {
    constexpr int kSteps = 5;
    const double per[3]{1 / to.sigma_T, 1 / to.sigma_A, 1 / to.sigma_q};
    const auto third = [&](const Spot& s) {
      return std::pair(s.q - to.q - to.slant * (s.A / to.A - 1), s.dq - to.slant * s.dA / to.A);
    };
    const auto [q0, dq0] = third(low);
    const auto [q1, dq1] = third(high);
    const double f0[3]{low.T - to.T, low.A - to.A, q0}, f1[3]{high.T - to.T, high.A - to.A, q1},
        d0[3]{low.dT, low.dA, dq0}, d1[3]{high.dT, high.dA, dq1};
    for (int k = 0; k < kSteps; ++k) {
      double slope = 0, bend = 0, speed = 0;
      for (int c = 0; c < 3; ++c) {
        const double rest = 1 - x, f = per[c] * cubic(x, h, f0[c], d0[c], f1[c], d1[c]),
                     d = per[c] *
                         (6 * x * rest * (f1[c] - f0[c]) / h + d0[c] * rest * (1 - 3 * x) + d1[c] * x * (3 * x - 2));
        slope += f * d;
        speed += d * d;
        bend += d * d + f * per[c] * second(x, h, f0[c], d0[c], f1[c], d1[c]);
      }
      if (!(speed > 0)) break;
      const double next = std::clamp(x - slope / ((bend > 0.1 * speed ? bend : speed) * h), 0.0, 1.0);
      const bool done = std::abs(next - x) < 1e-7;
      x = next;
      if (done) break;
    }
    return x;
  }

  /// Newton's method for the place where the offset is perpendicular to the curve, from a chord; secants after the
  /// first step. Stays within the chord and its neighbours.
  Nearest refined(std::size_t i, const EllipticReading& to) const {
    constexpr int kMost = 30;
    constexpr double kNear = 1e-12, kRounding = 1e-8;  // in standard errors along the curve
    const Spot &low = spots_[i], &high = spots_[i + 1];
    const bool by_T = high.by_T;
    const std::size_t first = i > 0 && spots_[i - 1].by_T == by_T ? i - 1 : i,
                      last = i + 2 < spots_.size() && spots_[i + 2].by_T == by_T ? i + 2 : i + 1;
    const double least = spots_[first].at, most = spots_[last].at, width = high.at - low.at;
    const Vector a = offset(low, to), b = offset(high, to), d{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    const double length = square_of(d), part = length > 0 ? std::clamp(-dot(a, d) / length, 0.0, 1.0) : 0.0;
    if (!(width > 0)) return {low, false, square_of(a)};
    const auto solved = [&](double at, double w, double q, double T) -> std::optional<Spot> {
      if (by_T) return spot_at_T(at, w, q);
      const auto mark = mark_at(at, q, T, low.least);
      return mark ? std::optional(spot_of(*mark)) : std::nullopt;
    };
    const double x0 = nearest_on_cubic(low, high, width, part, to);
    double at = low.at + x0 * width;
    std::optional<Spot> spot =
        solved(at, low.w + x0 * (high.w - low.w), cubic(x0, width, low.q, low.dq, high.q, high.dq),
               std::max(cubic(x0, width, low.T, low.dT, high.T, high.dT), 0.5 * std::min(low.T, high.T)));
    if (!spot) {  // beside the end of the curve
      spot = part < 0.5 ? low : high;
      at = spot->at;
    }
    double last_at = 0, last_h = 0;
    bool arrived = false;
    for (int k = 0; k < kMost; ++k) {
      const Vector x = offset(*spot, to), along = along_at(*spot, to);
      const double h = dot(x, along), speed = square_of(along);
      const bool stalls = k > 0 && std::abs(h) >= 0.5 * std::abs(last_h);
      arrived = std::abs(h) <= (stalls ? kRounding : kNear) * std::sqrt(speed);
      if (arrived) break;
      const double part_now = std::clamp((at - low.at) / width, 0.0, 1.0);
      const double ddA = by_T ? (high.dA - low.dA) / width : spot->ddA,
                   ddq = second(part_now, width, low.q, low.dq, high.q, high.dq) - to.slant * ddA / to.A;
      double bend = speed + x[1] * ddA / to.sigma_A + x[2] * ddq / to.sigma_q +
                    x[0] * second(part_now, width, low.T, low.dT, high.T, high.dT) / to.sigma_T;
      if (k > 0 && at != last_at) bend = (h - last_h) / (at - last_at);
      if (!(bend > 0.1 * speed)) bend = speed;
      const double next = std::clamp(at - h / bend, least, most);
      if (next == at) break;
      const double step = next - at;
      const std::optional<Spot> there =
          solved(next, spot->w, spot->q + step * spot->dq, std::max(spot->T + step * spot->dT, 0.25 * spot->T));
      if (!there) break;
      last_at = at;
      last_h = h;
      at = next;
      spot = there;
    }
    if (!arrived)
      if (const auto found = bracketed(first, last, to)) return {*found, false, square_of(offset(*found, to))};
    const bool at_end = whole_ && at == spots_.back().at && by_T == spots_.back().by_T && !by_T && at < 3.0;
    if (!at_end || !pushes_on(*spot, to)) return {*spot, false, square_of(offset(*spot, to))};
    const Spot end = closed_end();
    return {end, true, square_of(offset(end, to))};
  }

  Vector along_at(const Spot& spot, const EllipticReading& to) const {
    return {spot.dT / to.sigma_T, spot.dA / to.sigma_A, (spot.dq - to.slant * spot.dA / to.A) / to.sigma_q};
  }

  /// Where the distance begins to grow between two spots. Null if it does not.
  std::optional<Spot> bracketed(std::size_t first, std::size_t last, const EllipticReading& to) const {
    const auto growth = [&](const Spot& spot) { return dot(offset(spot, to), along_at(spot, to)); };
    for (std::size_t i = first; i < last; ++i) {
      const Spot &low = spots_[i], &high = spots_[i + 1];
      if (!(growth(low) < 0 && growth(high) > 0)) continue;
      const auto at = [&](double x) { return x < high.at ? between(low, high, x).value_or(high) : high; };
      const double root =
          root_between([&](double x) { return x > low.at ? growth(at(x)) : growth(low); }, low.at, high.at);
      return at(root);
    }
    return std::nullopt;
  }

  /// The end of the curve to rounding. Its last spot is within 1e-9 of it.
  Spot closed_end() const {
    Spot end = spots_.back();
    for (double step = 1e-9; step > 1e-16; step *= 0.5)
      if (const auto mark = mark_at(end.at + step, end.q + step * end.dq, end.T + step * end.dT, end.least))
        end = spot_of(*mark);
    return end;
  }

  /// Whether the reading lies beyond the end of the curve.
  bool pushes_on(const Spot& end, const EllipticReading& to) const {
    return dot(offset(end, to), along_at(end, to)) < 0;
  }

  std::vector<double> squares_;  // of the distances from the chords, with infinity at both ends
};

}  // namespace mixity
