// The residuals of a measured point at the nearest state of an elliptic contact, and their derivatives.
//
// The offset of the state from the reading, in standard errors of T, A and q, is perpendicular to the curve. The first
// residual is its part along the normal n1 in the plane of T and A, the second that along n2, perpendicular to n1 and
// to the curve: mostly the difference of q. The sum of their squares is that of the offset.
//
// With the curve c(u, p), the offset x = c - m obeys c_u x = 0, so that du/dp = -(c_up x + c_u c_p)/(c_uu x + c_u^2).
// n1 turns with the direction of c_u in the plane of T and A, whose angle changes by d theta: the pair of residuals
// turns by omega = d theta t_q/|t| with the tangent t, and
//
//     dr1/dp = n1 c_p + omega r2        dr2/dp = n2 c_p - omega r1
//
// c_uu and c_up are central differences over a short step: omega is a small correction, and exact to 1e-6 of itself.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "mechanics/elliptic_nearest.h"

namespace mixity {

template <class Law>
class EllipticResidual {
  using Curve = EllipticNearest<Law>;
  using Spot = typename Curve::Spot;
  using Vector = typename Curve::Vector;
  using Nearest = typename Curve::Nearest;
  static constexpr std::size_t kMost = 2 * parameter_count<Law> + 2;
  using Moves = std::array<Vector, kMost>;  // by P, the parameters of mode II, of mode III, and Poisson's ratio

 public:
  /// Derivatives of both residuals.
  using Pair = std::array<double, 2>;

  EllipticResidual(const Curve& curve, double P, const Nearest& near, const EllipticReading& to)
      : curve_(curve),
        P_(P),
        near_(near),
        to_(to),
        axes_(std::isfinite(to.sigma_q)),
        x_(curve.offset(near.spot, to)),
        t_(along(near.spot)) {
    const double sign = t_[1] > 0 || (t_[1] == 0 && t_[0] < 0) ? -1 : 1;  // towards smaller areas
    const double plane = std::hypot(t_[0], t_[1]);
    size_ = std::hypot(plane, t_[2]);
    n1_ = {-sign * t_[1] / plane, sign * t_[0] / plane, 0};
    n2_ = {-t_[0] * t_[2] / (plane * size_), -t_[1] * t_[2] / (plane * size_), plane / size_};
    part_of_q_ = sign * t_[2] / size_;
    r_ = {Curve::dot(n1_, x_), Curve::dot(n2_, x_)};
    if (near.at_end) {
      const double on_plane = std::hypot(x_[0], x_[1]);
      r_ = {std::copysign(on_plane, r_[0]), x_[2]};
      n1_ = {x_[0] / r_[0], x_[1] / r_[0], 0};
      n2_ = {0, 0, 1};
    }
  }

  const Pair& value() const { return r_; }

  /// Computes the derivatives that follow.
  void differentiate() {
    moves_ = moves_at(near_.spot);
    if (!axes_ || near_.at_end) return;
    const double step = curve_.short_step(near_.spot);
    const auto after = curve_.beside(near_.spot, step), before = curve_.beside(near_.spot, -step);
    if (!after && !before) return;
    const Spot &high = after ? *after : near_.spot, &low = before ? *before : near_.spot;
    const double width = step * ((after ? 1 : 0) + (before ? 1 : 0));
    bend_ = difference(along(high), along(low), width);
    const Moves above = moves_at(high), below = moves_at(low);
    for (std::size_t k = 0; k < count_; ++k) turns_[k] = difference(above[k], below[k], width);
    curved_ = true;
  }
  std::size_t count() const { return count_; }
  /// In P (k = 0), the parameters of mode II, those of mode III, and Poisson's ratio.
  Pair by(std::size_t k) const { return total(moves_[k], turns_[k]); }
  Pair by_T() const { return total({-1 / to_.sigma_T, 0, 0}, {}); }
  Pair by_A() const {
    const double slant = axes_ ? to_.slant / (to_.A * to_.A * to_.sigma_q) : 0;
    return total({0, -1 / to_.sigma_A, slant * near_.spot.A}, {0, 0, slant * near_.spot.dA});
  }
  /// In the logarithms of the standard errors.
  Pair by_sigma_T() const { return total({-x_[0], 0, 0}, {-t_[0], 0, 0}); }
  Pair by_sigma_A() const { return total({0, -x_[1], 0}, {0, -t_[1], 0}); }

 private:
  Vector scaled(double T, double A, double q) const {
    return {T / to_.sigma_T, A / to_.sigma_A, axes_ ? (q - to_.slant * A / to_.A) / to_.sigma_q : 0};
  }
  Vector along(const Spot& spot) const { return scaled(spot.dT, spot.dA, spot.dq); }
  static Vector difference(const Vector& a, const Vector& b, double width) {
    return {(a[0] - b[0]) / width, (a[1] - b[1]) / width, (a[2] - b[2]) / width};
  }

  /// How a state moves at a fixed parameter of the curve, T or w; at the end of the curve, how that moves.
  Moves moves_at(const Spot& s) {
    const auto F = curve_.residuals(s.w - P_, s.q, s.T * s.T);
    const double w_A = Curve::load_per_area(s.A);
    Moves moves{};
    std::size_t k = 0;
    curve_.each_derivative(s.w, s.q, s.T, [&](double first, double second) {
      if (near_.at_end) {
        const auto [dw, dq, dS] = move_of_end(F, first, second, k == 0 ? 1 : 0);
        moves[k++] = scaled(s.T > 0 ? dS / (2 * s.T) : 0, dw / w_A, dq);
      } else if (s.by_T) {
        const auto [dw, dq] = Curve::solved_at_S(F, {-first, -second});
        moves[k++] = scaled(0, dw / w_A, dq);
      } else {
        const auto [dq, dS] = Curve::solved_at_w(F, {-first, -second});
        moves[k++] = scaled(dS / (2 * s.T), 0, dq);
      }
    });
    count_ = k;
    return moves;
  }

  /// The end, where K_I reaches 0 at one axis: changes of w, q and T^2 with those of both equations and of P.
  std::array<double, 3> move_of_end(const typename Curve::Residuals& F, double first, double second,
                                    double of_P) const {
    const EllipsePressure g = ellipse_pressure(near_.spot.q);
    const double w = near_.spot.w;
    const bool along = g.along < g.across;
    const double m[3][3]{{F.w[0], F.q[0], F.S[0]},
                         {F.w[1], F.q[1], F.S[1]},
                         {along ? g.along : g.across, w * (along ? g.along_slope : g.across_slope), 0}};
    const double right[3]{-first, -second, of_P};
    const auto minor = [&](int r, int c) {
      const int r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = (c + 1) % 3, c2 = (c + 2) % 3;
      return m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
    };
    const double determinant = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
    std::array<double, 3> d{};
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) d[static_cast<std::size_t>(c)] += minor(r, c) * right[r] / determinant;
    return d;
  }

  /// The residuals' derivatives where a state moves by `move`, and the curve's direction by `turn`, at a fixed
  /// parameter.
  Pair total(const Vector& move, const Vector& turn) const {
    Pair d{Curve::dot(n1_, move), Curve::dot(n2_, move)};
    if (!curved_) return d;
    const double shift = -(Curve::dot(turn, x_) + Curve::dot(t_, move)) / (Curve::dot(bend_, x_) + size_ * size_);
    const double T = bend_[0] * shift + turn[0], A = bend_[1] * shift + turn[1];
    const double omega = (t_[0] * A - t_[1] * T) / (t_[0] * t_[0] + t_[1] * t_[1]) * part_of_q_;
    return {d[0] + omega * r_[1], d[1] - omega * r_[0]};
  }

  const Curve& curve_;
  double P_;
  const Nearest& near_;
  const EllipticReading& to_;
  bool axes_, curved_ = false;
  Vector x_, t_, n1_{}, n2_{}, bend_{};  // offset, tangent, normals
  double size_ = 0, part_of_q_ = 0;      // of the tangent: its length, and its part along q
  Pair r_{};
  Moves moves_{}, turns_{};
  std::size_t count_ = 0;
};

}  // namespace mixity
