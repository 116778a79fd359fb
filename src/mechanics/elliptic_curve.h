// The whole curve of states of an elliptic contact under one normal load, from JKR through the folds to its end.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "mechanics/elliptic_equations.h"
#include "mechanics/roots.h"
#include "mechanics/states.h"

namespace mixity {

template <class Law>
class EllipticCurve : public EllipticEquations<Law> {
  using Equations = EllipticEquations<Law>;
  using Equations::P_, Equations::S0_;

 public:
  using Equations::edge_load_at, Equations::residuals, Equations::mark_at, Equations::newton_at;
  using typename Equations::Mark, typename Equations::Residuals;
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

 protected:
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

  static double cubic(double x, double h, double f0, double d0, double f1, double d1) {
    const double rest = 1 - x;
    return f0 * rest * rest * (1 + 2 * x) + f1 * x * x * (3 - 2 * x) + h * x * rest * (d0 * rest - d1 * x);
  }

  bool whole_ = false;  // no more spots follow
  std::vector<Spot> spots_;

 private:
  static constexpr double kStep = 0.12;

  double T_most_, step_ = kStep;
};

}  // namespace mixity
