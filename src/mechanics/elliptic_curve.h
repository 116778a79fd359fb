// The whole curve of states of an elliptic contact under one normal load, from JKR through the folds to its end, and
// the points of it that are nearest to measured ones, in the space of T, A = pi a b and q = ln(a/b).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "mechanics/elliptic_equations.h"
#include "mechanics/states.h"

namespace mixity {

/// A measured point with its standard errors. The third coordinate is q - slant A/A_measured; without axes its error is
/// infinite.
struct EllipticReading {
  double T, A, q, sigma_T, sigma_A, sigma_q, slant;
};

template <class Law>
class EllipticCurve : private EllipticEquations<Law> {
  using Equations = EllipticEquations<Law>;
  using Equations::edge_load_at, Equations::residuals, Equations::mark_at, Equations::newton_at, Equations::P_;
  using Equations::S0_;
  using typename Equations::Mark, typename Equations::Residuals;

 public:
  using Vector = std::array<double, 3>;  // in standard errors of T, A and q

  /// A state on the curve, with its derivatives along the curve's parameter: phi, or T towards an asymptote.
  struct Spot {
    double at, w, q, T, A, dT, dA, dq, ddA;
    bool by_T;
  };

  /// The curve up to T_most, beyond which no point is nearest.
  EllipticCurve(const Law& law, const Parameters<Law>& mode_II, const Parameters<Law>& mode_III, double poisson_ratio,
                double P, double T_most)
      : Equations(law, mode_II, mode_III, poisson_ratio, P) {
    spots_.push_back(spot_of(Equations::first_mark()));
    if (!Equations::uncoupled()) walk(T_most);
  }

  /// The nearest state, and whether it is the end of the curve.
  struct Nearest {
    Spot spot;
    bool at_end;
    double square;
  };
  Nearest nearest(const EllipticReading& to) const {
    if (Equations::uncoupled()) {
      Spot spot = spots_[0];
      spot.T = to.T;
      spot.dT = 1;
      return {spot, false, square_of(offset(spot, to))};
    }
    std::array<double, 3> squares{};  // to the chords before, at and after the one in question
    Nearest best{spots_[0], false, square_of(offset(spots_[0], to))};
    const std::size_t chords = spots_.size() - 1;
    for (std::size_t i = 0; i <= chords; ++i) {
      squares = {squares[1], squares[2], i < chords ? chord_square(i, to) : std::numeric_limits<double>::infinity()};
      if (i == 0 || squares[1] > squares[2] || (i > 1 && squares[1] > squares[0])) continue;
      const Nearest found = refined(i - 1, to);
      if (found.square < best.square) best = found;
    }
    return best;
  }

  /// The T at which the curve first has this area; NaN if it never does.
  double shear_at(double A) const {
    for (std::size_t i = 0; i + 1 < spots_.size() && !spots_[i + 1].by_T; ++i) {
      const Spot &low = spots_[i], &high = spots_[i + 1];
      if (A > low.A || A < high.A) continue;
      const double w = 4.0 / 3 * std::pow(A / pi<double>(), 1.5);
      const double phi =
          std::clamp(std::acos(std::clamp((w - P_ - 3 * pi<double>()) / S0_, -1.0, 1.0)), low.at, high.at);
      const auto mark = between(low, high, phi);
      return mark ? mark->T : std::numeric_limits<double>::quiet_NaN();
    }
    return std::numeric_limits<double>::quiet_NaN();
  }

  /// States for drawing, up to T_most.
  std::vector<CurvePoint> sampled(double T_most) const {
    constexpr int kParts = 6;
    std::vector<CurvePoint> points;
    const auto add = [&](const Spot& s) {
      const double y = s.w - P_, a = std::sqrt(s.A / pi<double>()), da = s.dA / (2 * pi<double>() * a);
      const double unit = ellipse_compliance(s.q, Equations::poisson_ratio_), u = unit * s.T / a;
      const double square = y * y + s.T * s.T, dy = 2 * a * s.dA / pi<double>();
      points.push_back({s.at, y, s.T, a, s.A, u, std::atan2(s.T, y), square / (6 * pi<double>() * s.w), dy, s.dT, da,
                        s.dA, unit * (s.dT - s.T * da / a) / a, (y * s.dT - s.T * dy) / square, 0});
    };
    add(spots_[0]);
    for (std::size_t i = 0; i + 1 < spots_.size(); ++i) {
      const Spot &low = spots_[i], &high = spots_[i + 1];
      for (int k = 1; k < kParts && !high.by_T; ++k)
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

  /// Writes the residuals of a reading at its nearest state, and their derivatives, in P and in the parameters of mode
  /// II, mode III and Poisson's ratio. The first residual is the distance along the normal in the plane of T and A, the
  /// second that along the normal perpendicular to it; the sum of their squares is that of the distance. The basis of
  /// the normals turns along the curve, which the derivatives leave out: in those of the sum of squares it cancels.
  struct Residual {
    double r[2], dT[2], dA[2];  // dT, dA: in the reading
  };
  template <class Write>
  Residual residual(const Nearest& near, const EllipticReading& to, const Write& write) const {
    const Spot& s = near.spot;
    const Vector x = offset(s, to);
    const Residuals F = residuals(s.w - P_, s.q, s.T * s.T);
    const double w_A = w_of_A(s.A), turn = to.slant / to.A;
    const double sigma_q = std::isfinite(to.sigma_q) ? to.sigma_q : 1;
    // rows: the gradients of both equations in the space of standard errors
    double g[2][3];
    for (int k = 0; k < 2; ++k) {
      g[k][0] = F.S[k] * 2 * s.T * to.sigma_T;
      g[k][1] = (F.w[k] * w_A + F.q[k] * turn) * to.sigma_A;
      g[k][2] = F.q[k] * sigma_q;
    }
    Vector t{g[0][1] * g[1][2] - g[0][2] * g[1][1], g[0][2] * g[1][0] - g[0][0] * g[1][2],
             g[0][0] * g[1][1] - g[0][1] * g[1][0]};
    const double sign = t[1] > 0 || (t[1] == 0 && t[0] < 0) ? -1 : 1;  // towards smaller areas
    for (double& one : t) one *= sign;
    const double plane = std::hypot(t[0], t[1]), size = std::hypot(plane, t[2]);
    const Vector n1{-t[1] / plane, t[0] / plane, 0},
        n2{-t[0] * t[2] / (plane * size), -t[1] * t[2] / (plane * size), plane / size};
    Residual out{};
    const double on_plane = std::hypot(x[0], x[1]);
    out.r[0] = near.at_end ? std::copysign(on_plane, dot(n1, x)) : dot(n1, x);
    out.r[1] = near.at_end ? x[2] : dot(n2, x);
    const Vector e1 = near.at_end ? Vector{x[0] / out.r[0], x[1] / out.r[0], 0} : n1,
                 e2 = near.at_end ? Vector{0, 0, 1} : n2;
    for (int j = 0; j < 2; ++j) {
      const Vector& e = j == 0 ? e1 : e2;
      out.dT[j] = -e[0] / to.sigma_T;
      out.dA[j] = -e[1] / to.sigma_A + e[2] * turn * s.A / (to.A * sigma_q);
    }
    const std::array<double, 2> of_n{g[0][0] * n1[0] + g[0][1] * n1[1], g[1][0] * n1[0] + g[1][1] * n1[1]};
    const std::array<double, 2> of_m{g[0][0] * n2[0] + g[0][1] * n2[1] + g[0][2] * n2[2],
                                     g[1][0] * n2[0] + g[1][1] * n2[1] + g[1][2] * n2[2]};
    const double determinant = of_n[0] * of_m[1] - of_n[1] * of_m[0];
    const auto end_moves = end_of(near, F);
    std::size_t k = 0;
    Equations::each_derivative(s.w, s.q, s.T, [&](double first, double second) {
      // k = 0 is P, at fixed w
      if (near.at_end) {
        const auto [dw, dq, dS] = end_moves(first, second, k == 0 ? 1.0 : 0.0);
        const Vector d{s.T > 0 ? dS / (2 * s.T * to.sigma_T) : 0, dw / w_A / to.sigma_A,
                       (dq - turn * dw / w_A) / sigma_q};
        write(k++, dot(e1, d), dot(e2, d));
        return;
      }
      write(k++, -(first * of_m[1] - second * of_m[0]) / determinant,
            -(of_n[0] * second - of_n[1] * first) / determinant);
    });
    return out;
  }

 private:
  static double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static double square_of(const Vector& v) { return dot(v, v); }
  static double area_of(double w) {
    const double c = std::cbrt(0.75 * w);
    return pi<double>() * c * c;
  }
  static double w_of_A(double A) { return 2 * std::sqrt(A / pi<double>()) / pi<double>(); }  // dw/dA

  Spot spot_of(const Mark& mark) const {
    const double y = edge_load_at(mark.phi), w = y + P_, A = area_of(w);
    const double w_slope = -S0_ * std::sin(mark.phi), w_bend = -S0_ * std::cos(mark.phi), per = 2 * A / (3 * w);
    return {mark.phi,
            w,
            mark.q,
            mark.T,
            A,
            mark.T_slope,
            per * w_slope,
            mark.q_slope,
            per * w_bend - per / (3 * w) * w_slope * w_slope,
            false};
  }

  /// By T, near (w, q). Null if Newton's method does not arrive.
  std::optional<Spot> spot_at_T(double T, double w, double q) const {
    const auto found = newton_at(T, w - P_, q);
    if (!found) return std::nullopt;
    const auto [y, there] = *found;
    const Residuals r = residuals(y, there, T * T);
    const double determinant = r.w[0] * r.q[1] - r.w[1] * r.q[0], A = area_of(y + P_);
    const double dw = -2 * T * (r.S[0] * r.q[1] - r.S[1] * r.q[0]) / determinant,
                 dq = -2 * T * (r.w[0] * r.S[1] - r.w[1] * r.S[0]) / determinant;
    return Spot{T, y + P_, there, T, A, 1, 2 * A / (3 * (y + P_)) * dw, dq, 0, true};
  }

  /// At phi between two spots.
  std::optional<Spot> between(const Spot& low, const Spot& high, double phi) const {
    const double width = high.at - low.at, x = (phi - low.at) / width;
    if (!(phi > 1e-9)) return spots_[0];
    const auto mark = mark_at(phi, cubic(x, width, low.q, low.dq, high.q, high.dq),
                              std::max(cubic(x, width, low.T, low.dT, high.T, high.dT), 0.25 * high.T));
    return mark ? std::optional(spot_of(*mark)) : std::nullopt;
  }

  void walk(double T_most) {
    constexpr double kStep = 0.12, kLeast = 1e-9, kFarther = 0.2,
                     kLast = 3.08;  // before T = 0 of the unstable JKR state
    constexpr double kSteep = 1e3;
    while (true) {
      const Spot from = spots_.back();
      std::optional<Mark> to;
      double step = std::min(kStep, kLast - from.at);
      for (; step > kLeast; step *= 0.5) {
        to = mark_at(from.at + step, from.q + step * from.dq, std::max(from.T + step * from.dT, 0.5 * from.T));
        if (to && std::abs(to->q - from.q) < kFarther) break;
        to.reset();
      }
      if (!to) {
        if (from.dT > kSteep * from.T && from.T < T_most) walk_in_T(T_most);
        return;
      }
      spots_.push_back(spot_of(*to));
      if (to->T > T_most && to->T_slope > 0) return;
    }
  }

  void walk_in_T(double T_most) {
    while (spots_.back().T < T_most) {
      const Spot& from = spots_.back();
      const auto to = spot_at_T(std::max(2 * from.T, 1e-3), from.w, from.q);
      if (!to) return;
      if (!from.by_T)
        if (const auto again = spot_at_T(from.T, from.w, from.q)) spots_.push_back(*again);
      spots_.push_back(*to);
    }
  }

  double chord_square(std::size_t i, const EllipticReading& to) const {
    const Vector a = offset(spots_[i], to), b = offset(spots_[i + 1], to);
    const Vector d{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    const double length = square_of(d), x = length > 0 ? std::clamp(-dot(a, d) / length, 0.0, 1.0) : 0.0;
    return square_of({a[0] + x * d[0], a[1] + x * d[1], a[2] + x * d[2]});
  }

  static double cubic(double x, double h, double f0, double d0, double f1, double d1) {
    const double rest = 1 - x;
    return f0 * rest * rest * (1 + 2 * x) + f1 * x * x * (3 - 2 * x) + h * x * rest * (d0 * rest - d1 * x);
  }

  /// Newton's method for the place where the offset is perpendicular to the curve, from a chord; secants after the
  /// first step. Stays within the chord and its neighbours.
  Nearest refined(std::size_t i, const EllipticReading& to) const {
    constexpr int kMost = 30;
    constexpr double kNear = 1e-9;  // in standard errors along the curve: the distance is exact to its square
    const Spot &low = spots_[i], &high = spots_[i + 1];
    const bool by_T = high.by_T;
    const std::size_t first = i > 0 && spots_[i].by_T == by_T ? i - 1 : i,
                      last = i + 2 < spots_.size() && spots_[i + 2].by_T == by_T ? i + 2 : i + 1;
    const double least = spots_[first].at, most = spots_[last].at, width = high.at - low.at;
    const Vector a = offset(low, to), b = offset(high, to), d{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    const double length = square_of(d), part = length > 0 ? std::clamp(-dot(a, d) / length, 0.0, 1.0) : 0.0;
    if (!(width > 0)) return {low, false, square_of(a)};
    const auto solved = [&](double at, double w, double q, double T) -> std::optional<Spot> {
      if (by_T) return spot_at_T(at, w, q);
      if (at <= 1e-9) return spots_[0];
      const auto mark = mark_at(at, q, T);
      return mark ? std::optional(spot_of(*mark)) : std::nullopt;
    };
    double at = low.at + part * width;
    std::optional<Spot> spot =
        solved(at, low.w + part * (high.w - low.w), cubic(part, width, low.q, low.dq, high.q, high.dq),
               std::max(cubic(part, width, low.T, low.dT, high.T, high.dT), 0.5 * std::min(low.T, high.T)));
    if (!spot) {  // beside the end of the curve
      spot = part < 0.5 ? low : high;
      at = spot->at;
    }
    double last_at = 0, last_h = 0;
    for (int k = 0; k < kMost; ++k) {
      const Vector x = offset(*spot, to), along{spot->dT / to.sigma_T, spot->dA / to.sigma_A,
                                                (spot->dq - to.slant * spot->dA / to.A) / to.sigma_q};
      const double h = dot(x, along), speed = square_of(along);
      if (std::abs(h) <= kNear * std::sqrt(speed)) break;
      double bend = speed + x[1] * spot->ddA / to.sigma_A;
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
    const bool at_end = at == spots_.back().at && by_T == spots_.back().by_T && !by_T && at < 3.0;
    if (!at_end || !pushes_on(*spot, to)) return {*spot, false, square_of(offset(*spot, to))};
    const Spot end = closed_end();
    return {end, true, square_of(offset(end, to))};
  }

  /// The end of the curve to rounding. Its last spot is within 1e-9 of it.
  Spot closed_end() const {
    Spot end = spots_.back();
    for (double step = 1e-9; step > 1e-16; step *= 0.5)
      if (const auto mark = mark_at(end.at + step, end.q + step * end.dq, end.T + step * end.dT)) end = spot_of(*mark);
    return end;
  }

  /// Whether the reading lies beyond the end of the curve.
  bool pushes_on(const Spot& end, const EllipticReading& to) const {
    const Vector x = offset(end, to);
    return x[0] * end.dT / to.sigma_T + x[1] * end.dA / to.sigma_A +
               x[2] * (end.dq - to.slant * end.dA / to.A) / to.sigma_q <
           0;
  }

  /// How the end, where K_I reaches 0 at one axis, moves with a change of the residuals and of P.
  auto end_of(const Nearest& near, const Residuals& F) const {
    double inverse[3][3]{};
    if (near.at_end) {
      const EllipsePressure g = ellipse_pressure(near.spot.q);
      const bool along = near.spot.w * g.along < near.spot.w * g.across;
      const double m[3][3]{{F.w[0], F.q[0], F.S[0]},
                           {F.w[1], F.q[1], F.S[1]},
                           {along ? g.along : g.across, near.spot.w * (along ? g.along_slope : g.across_slope), 0}};
      const auto cofactor = [&](int r, int c) {
        const int r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = (c + 1) % 3, c2 = (c + 2) % 3;
        return m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
      };
      const double determinant = m[0][0] * cofactor(0, 0) + m[0][1] * cofactor(0, 1) + m[0][2] * cofactor(0, 2);
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) inverse[c][r] = cofactor(r, c) / determinant;
    }
    return [inverse](double first, double second, double of_P) {
      std::array<double, 3> d{};
      for (int r = 0; r < 3; ++r)
        d[static_cast<std::size_t>(r)] = -inverse[r][0] * first - inverse[r][1] * second + inverse[r][2] * of_P;
      return d;
    };
  }

  std::vector<Spot> spots_;
};

}  // namespace mixity
