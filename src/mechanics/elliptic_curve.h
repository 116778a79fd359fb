// The whole curve of states of an elliptic contact under one normal load, from JKR through the folds to its end, and
// the points of it that are nearest to measured ones, in the space of T, A = pi a b and q = ln(a/b).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "mechanics/elliptic_equations.h"
#include "mechanics/roots.h"
#include "mechanics/states.h"

namespace mixity {

/// A measured point with its standard errors. The third coordinate is q - slant A/A_measured; without axes its error is
/// infinite.
struct EllipticReading {
  double T, A, q, sigma_T, sigma_A, sigma_q, slant;
};

template <class Law>
class EllipticCurve : public EllipticEquations<Law> {
  using Equations = EllipticEquations<Law>;
  using Equations::P_, Equations::S0_;

 public:
  using Equations::edge_load_at, Equations::residuals, Equations::mark_at, Equations::newton_at;
  using typename Equations::Mark, typename Equations::Residuals;
  using Vector = std::array<double, 3>;  // in standard errors of T, A and q

  static double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

  /// A state on the curve, with its derivatives along the curve's parameter: phi, or T towards an asymptote.
  struct Spot {
    double at, w, q, T, A, dT, dA, dq, ddA;
    double least;  // the smaller Y over w
    bool by_T;
  };

  /// The curve up to T_most, beyond which no point is nearest. It is followed as far as it is asked for.
  EllipticCurve(const Law& law, const Parameters<Law>& mode_II, const Parameters<Law>& mode_III, double poisson_ratio,
                double P, double T_most)
      : Equations(law, mode_II, mode_III, poisson_ratio, P), T_most_(T_most) {
    spots_.push_back(spot_of(Equations::first_mark()));
    whole_ = Equations::uncoupled() || !begin();
  }

  /// The nearest state, and whether it is the end of the curve.
  struct Nearest {
    Spot spot;
    bool at_end;
    double square;
  };
  Nearest nearest(const EllipticReading& to) {
    if (Equations::uncoupled()) {
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

  /// The T at which the curve first has this area; NaN if it never does.
  double shear_at(double A) {
    walk_to_the_end();
    for (std::size_t i = 0; i + 1 < spots_.size(); ++i) {
      const Spot &low = spots_[i], &high = spots_[i + 1];
      if (low.by_T != high.by_T || A > low.A || A < high.A) continue;
      if (A == low.A) return low.T;
      const double at =
          root_between([&](double x) { return x < high.at ? between(low, high, x).value_or(low).A - A : high.A - A; },
                       low.at, high.at);
      const auto spot = between(low, high, at);
      return spot ? spot->T : std::numeric_limits<double>::quiet_NaN();
    }
    return std::numeric_limits<double>::quiet_NaN();
  }

  /// States for drawing, up to T_most.
  std::vector<CurvePoint> sampled(double T_most) {
    walk_to_the_end();
    constexpr int kParts = 6;
    std::vector<CurvePoint> points;
    const auto add = [&](const Spot& s) {
      const double y = s.w - P_, a = std::sqrt(s.A / pi<double>()), da = s.dA / (2 * pi<double>() * a);
      const double unit = ellipse_compliance(s.q, Equations::poisson_ratio_).value, u = unit * s.T / a;
      const double square = y * y + s.T * s.T, dy = 2 * a * s.dA / pi<double>();
      const double phi = std::acos(std::clamp((y - 3 * pi<double>()) / S0_, -1.0, 1.0));
      points.push_back({phi, y, s.T, a, s.A, u, std::atan2(s.T, y), square / (6 * pi<double>() * s.w), dy, s.dT, da,
                        s.dA, unit * (s.dT - s.T * da / a) / a, (y * s.dT - s.T * dy) / square, 0});
    };
    add(spots_[0]);
    for (std::size_t i = 0; i + 1 < spots_.size(); ++i) {
      const Spot &low = spots_[i], &high = spots_[i + 1];
      if (low.by_T != high.by_T) continue;
      for (int k = 1; k < kParts; ++k)
        if (const auto at = between(low, high, low.at + (high.at - low.at) * k / kParts); at && at->T <= T_most)
          add(*at);
      if (high.T <= T_most) add(high);
    }
    return points;
  }

  Vector offset(const Spot& spot, const EllipticReading& from) const {
    return {(spot.T - from.T) / from.sigma_T, (spot.A - from.A) / from.sigma_A,
            (spot.q - from.q - from.slant * (spot.A / from.A - 1)) / from.sigma_q};
  }

  /// The state at another value of the parameter, beside one. Null where there is none.
  std::optional<Spot> beside(const Spot& spot, double step) const {
    if (spot.by_T) return spot_at_T(spot.at + step, spot.w, spot.q + step * spot.dq);
    const auto mark = mark_at(spot.at + step, spot.q + step * spot.dq, spot.T + step * spot.dT, spot.least);
    return mark ? std::optional(spot_of(*mark)) : std::nullopt;
  }
  /// A step of the parameter over which the curve hardly bends.
  double short_step(const Spot& spot) const {
    return 1e-3 * (spot.by_T ? std::max(spot.T, spots_.size() > 1 ? spots_[1].T : 1.0) : 1.0);
  }
  /// dw/dA
  static double load_per_area(double A) { return 2 * std::sqrt(A / pi<double>()) / pi<double>(); }

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

  Spot spot_of(const Mark& mark) const {
    const double y = mark.y, w = y + P_, A = area_from_edge_load(y, P_);
    const double w_slope = mark.y_slope, w_bend = 3 * pi<double>() - y, per = 2 * A / (3 * w);
    return {mark.phi,
            w,
            mark.q,
            mark.T,
            A,
            mark.T_slope,
            per * w_slope,
            mark.q_slope,
            per * w_bend - per / (3 * w) * w_slope * w_slope,
            mark.least,
            false};
  }

  /// By T, near (w, q). Null if Newton's method does not arrive.
  std::optional<Spot> spot_at_T(double T, double w, double q) const {
    const auto found = newton_at(T, w - P_, q);
    if (!found) return std::nullopt;
    const auto [y, there] = *found;
    const Residuals r = residuals(y, there, T * T);
    const auto [w_S, q_S] = Equations::solved_at_S(r, r.S);
    const double A = area_from_edge_load(y, P_), dw = -2 * T * w_S, dq = -2 * T * q_S;
    return Spot{T, y + P_, there, T, A, 1, 2 * A / (3 * (y + P_)) * dw, dq, 0, r.least, true};
  }

  /// Between two spots.
  std::optional<Spot> between(const Spot& low, const Spot& high, double at) const {
    const double width = high.at - low.at, x = (at - low.at) / width,
                 q = cubic(x, width, low.q, low.dq, high.q, high.dq);
    if (high.by_T) return spot_at_T(at, low.w + x * (high.w - low.w), q);
    const auto mark =
        mark_at(at, q, std::max(cubic(x, width, low.T, low.dT, high.T, high.dT), 0.25 * high.T), low.least);
    return mark ? std::optional(spot_of(*mark)) : std::nullopt;
  }

  /// The first chord has the parameter T: at small phi, T is determined poorly by w. False if there is none.
  bool begin() {
    constexpr double kFirst = 0.12;
    const Mark first = Equations::first_mark();
    for (double phi = kFirst; phi > 1e-3; phi *= 0.5) {
      const auto mark = mark_at(phi, 0, phi * first.T_slope, first.least);
      const auto start = mark && mark->T_slope > 0 ? spot_at_T(0, spots_[0].w, 0) : std::nullopt,
                 end = start ? spot_at_T(mark->T, edge_load_at(phi) + P_, mark->q) : std::nullopt;
      if (!end) continue;
      spots_ = {*start, *end, spot_of(*mark)};
      return true;
    }
    return false;
  }

  void walk_to_the_end() {
    while (!whole_) walk();
  }

  /// As far as areas below this one. Whether anything was added.
  bool walk_below(double A) {
    const std::size_t before = spots_.size();
    while (!whole_ && !(spots_.back().A < A)) walk();
    return spots_.size() > before;
  }

  /// One spot further, or the rest of the curve.
  void walk() {
    constexpr double kLeast = 1e-9, kFarther = 0.2, kLast = 3.08;  // before T = 0 of the unstable JKR state
    // towards an asymptote cubics fail on chords along which the slope grows more; T is not resolved by finer ones
    constexpr double kSteep = 1e3, kSteeper = 3, kFine = 1e-4;
    const Spot from = spots_.back();
    std::optional<Mark> to;
    double step = std::min({4 * step_, kStep, kLast - from.at});  // where steps must be short, the next one must, too
    for (; step > kLeast; step *= 0.5) {
      const auto [q, T] = continued(from, step);
      to = mark_at(from.at + step, q, std::max(T, 0.5 * from.T), from.least);
      const bool bends = to && from.dT > 0 && to->T_slope > kSteeper * from.dT && step > kFine;
      if (to && std::abs(to->q - from.q) < kFarther && !bends) break;
      to.reset();
    }
    step_ = step;
    whole_ = !to || (to->T > T_most_ && to->T_slope > 0);
    if (to)
      spots_.push_back(spot_of(*to));
    else if (from.dT > kSteep * from.T && from.T < T_most_)
      walk_in_T();
  }

  /// q and T a step beyond the last spot, on the cubics of its chord.
  std::pair<double, double> continued(const Spot& from, double step) const {
    const Spot& before = spots_[spots_.size() - 2];
    const double width = from.at - before.at;
    if (before.by_T || !(width > 0) || step < 0.99 * width || step > 1.01 * width)
      return {from.q + step * from.dq, from.T + step * from.dT};
    const double x = 1 + step / width;
    return {cubic(x, width, before.q, before.dq, from.q, from.dq),
            cubic(x, width, before.T, before.dT, from.T, from.dT)};
  }

  void walk_in_T() {
    while (spots_.back().T < T_most_) {
      const Spot& from = spots_.back();
      const auto to = spot_at_T(std::max(2 * from.T, 1e-3), from.w, from.q);
      if (!to) return;
      if (!from.by_T)
        if (const auto again = spot_at_T(from.T, from.w, from.q)) spots_.push_back(*again);
      spots_.push_back(*to);
    }
  }

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

  static double cubic(double x, double h, double f0, double d0, double f1, double d1) {
    const double rest = 1 - x;
    return f0 * rest * rest * (1 + 2 * x) + f1 * x * x * (3 - 2 * x) + h * x * rest * (d0 * rest - d1 * x);
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
      const auto at = [&](double x) { return between(low, high, x).value_or(high); };
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

  static constexpr double kStep = 0.12;

  double T_most_, step_ = kStep;
  bool whole_ = false;  // no more spots follow
  std::vector<Spot> spots_;
  std::vector<double> squares_;  // of the distances from the chords, with infinity at both ends
};

}  // namespace mixity
