// The residuals of a measured point at the nearest state of a contact whose approach is held, and their derivatives.
//
// In the plane of T and A the residual is the distance from G(a, T) = y^2 + tau^2(y, T) - 8 pi a^3 = 0, y = y(a), so
// that by the envelope theorem its derivatives are those of -G/|grad G| at the nearest state. Where the load P was
// measured, too, the offset x of the state from the reading is one in the space of T, A and P, in standard errors. It
// is perpendicular to the curve: S = x t = 0, with the tangent t in the direction of (da, dT) = (-G_T, G_a). The first
// residual is its part along the normal n1 in the plane of T and A, the second that along n2, perpendicular to n1 and
// to the curve, which mostly is the difference of P. The state moves with a parameter by
//
//     G_a da + G_T dT = -G_p,    S_a da + S_T dT = -S_p,
//
// and n1 turns with the tangent's direction in the plane, whose angle changes by d theta: with omega = d theta t_P/|t|,
//
//     dr1 = n1 dx + omega r2,    dr2 = n2 dx - omega r1.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "mechanics/held_curve.h"
#include "mechanics/sensitivity.h"

namespace mixity {

/// A measured point with its standard errors; that of P is infinite where P was not measured.
struct HeldReading {
  double T, A, P, sigma_T, sigma_A, sigma_P;
};

template <class Law>
class HeldResidual {
 public:
  using Curve = HeldCurve<Law>;
  using State = typename Curve::State;
  using Slopes = typename Curve::Slopes;
  using Vector = std::array<double, 3>;  // in standard errors of T, A and P
  using Pair = std::array<double, 2>;    // of both residuals

  HeldResidual(const Curve& curve, const HeldReading& to) : curve_(curve), to_(to), of_P_(std::isfinite(to.sigma_P)) {
    find();
    const Vector x = offset(state_);
    x_ = x;
    t_ = tangent(state_.a, slopes_);
    const double sign = t_[1] > 0 || (t_[1] == 0 && t_[0] < 0) ? -1 : 1;  // towards smaller areas
    plane_ = std::hypot(t_[0], t_[1]);
    size_ = std::hypot(plane_, t_[2]);
    n1_ = {-sign * t_[1] / plane_, sign * t_[0] / plane_, 0};
    n2_ = {-t_[0] * t_[2] / (plane_ * size_), -t_[1] * t_[2] / (plane_ * size_), plane_ / size_};
    part_of_P_ = sign * t_[2] / size_;
    r_ = {dot(n1_, x), dot(n2_, x)};
    if (!at_end_) return;
    const double in_plane = std::hypot(x[0], x[1]);
    r_ = {std::copysign(in_plane, r_[0]), x[2]};
    n1_ = {x[0] / r_[0], x[1] / r_[0], 0};
    n2_ = {0, 0, 1};
  }

  const State& state() const { return state_; }
  const Pair& value() const { return r_; }

  /// Computes the derivatives that follow.
  void differentiate() {
    const auto& law = curve_.law();
    const double y = Curve::positive(state_.y), T = state_.T;
    y_ = curve_.held().edge_load(state_.a);
    const ShearTerm<double> tau2 = law.shear_term(curve_.parameters(), y, T);
    G_y_ = 2 * y + tau2.d1;
    G_yy_ = 2 + tau2.d2;
    G_yT_ = T > 0 ? (tau2.d1 - y * tau2.d2) / T : 0;
    const double sheared = T > 0 ? (2 * (tau2.value - y * tau2.d1) + y * y * tau2.d2) / (T * T) : 0;
    G_TT_ = T > 1e-130 * y ? sheared : 2 * law.small_shear(curve_.parameters());
    G_aa_ = G_yy_ * y_.slope * y_.slope + G_y_ * y_.bend - 48 * pi<double>() * state_.a;
    G_aT_ = G_yT_ * y_.slope;
    by_law_ =
        equilibrium_gradient(law, curve_.parameters(), 4.0 / 3 * state_.a * state_.a * state_.a - y, T, y).parameters;
    if (!of_P_ || at_end_) return;
    // the derivatives of S in a and T, by those of the tangent and of the offset
    const Vector t_a = tangent_moves(1, 0, {G_aa_, G_aT_}), t_T = tangent_moves(0, 1, {G_aT_, G_TT_});
    S_ = {dot(t_a, x_) + dot(t_, moves(1, 0)), dot(t_T, x_) + dot(t_, moves(0, 1))};
  }

  Pair by_approach() const { return of_geometry(y_.by_approach, y_.slope_by_approach); }
  Pair by_compliance() const { return of_geometry(y_.by_compliance, y_.slope_by_compliance); }
  /// In a parameter of the law.
  Pair by_law(std::size_t k) const {
    const double of_G = by_law_[k];
    Change change{of_G, 0, 0, 0, 0};
    if (of_P_ && !at_end_) {
      // tau^2 is homogeneous of degree 2: T G_Tp = 2 G_p - y G_yp
      const double of_slope = mixed(k);
      change.a = of_slope * y_.slope;
      change.T = state_.T > 0 ? (2 * of_G - state_.y * of_slope) / state_.T : 0;
    }
    return total(change);
  }
  Pair by_T() const { return of_offset({-1 / to_.sigma_T, 0, 0}, {}); }
  Pair by_A() const { return of_offset({0, -1 / to_.sigma_A, 0}, {}); }
  Pair by_P() const { return of_P_ ? of_offset({0, 0, -1 / to_.sigma_P}, {}) : Pair{0, 0}; }
  /// In the logarithms of the standard errors.
  Pair by_sigma_T() const { return of_offset({-x_[0], 0, 0}, {-t_[0], 0, 0}); }
  Pair by_sigma_A() const { return of_offset({0, -x_[1], 0}, {0, -t_[1], 0}); }
  Pair by_sigma_P() const { return of_P_ ? of_offset({0, 0, -x_[2]}, {0, 0, -t_[2]}) : Pair{0, 0}; }

 private:
  /// How G, G_a, G_T, P and dP/da change with a parameter at a fixed state.
  struct Change {
    double G, a, T, P, P_slope;
  };

  static double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

  Vector offset(const State& s) const {
    return {(s.T - to_.T) / to_.sigma_T, (area_from_radius(s.a) - to_.A) / to_.sigma_A,
            of_P_ ? (curve_.held().load(s.a) - to_.P) / to_.sigma_P : 0};
  }
  double P_slope(double a) const { return 4 * a * a - curve_.held().edge_load(a).slope; }
  Vector scaled(double dT, double dA, double dP) const {
    return {dT / to_.sigma_T, dA / to_.sigma_A, of_P_ ? dP / to_.sigma_P : 0};
  }
  /// The offset's change with a and T.
  Vector moves(double da, double dT) const {
    return scaled(dT, 2 * pi<double>() * state_.a * da, of_P_ ? P_slope(state_.a) * da : 0);
  }
  Vector tangent(double a, const Slopes& G) const {
    return scaled(G.a, -2 * pi<double>() * a * G.T, of_P_ ? -P_slope(a) * G.T : 0);
  }
  /// The tangent's change with a and T, where the slopes of G change by dG.
  Vector tangent_moves(double da, double, const Slopes& dG) const {
    const double a = state_.a;
    return scaled(dG.a, -2 * pi<double>() * (a * dG.T + da * slopes_.T),
                  of_P_ ? -P_slope(a) * dG.T - (8 * a - y_.bend) * da * slopes_.T : 0);
  }

  /// The nearest state: of those at which the distance has a minimum along the curve, and of the ends.
  void find() {
    if (curve_.uncoupled()) {
      state_ = {curve_.top(), curve_.held().edge_load(curve_.top()).value, 0, to_.T};
      slopes_ = curve_.slopes(state_);
      slopes_.T = 0;
      return;
    }
    const auto& nodes = curve_.nodes();
    double best = std::numeric_limits<double>::infinity();
    const auto take = [&](const State& one, bool end) {
      const Vector x = offset(one);
      const double square = dot(x, x);
      if (!(square < best)) return;
      best = square;
      state_ = one;
      at_end_ = end;
    };
    const auto along = [&](const State& one, const Slopes& G) { return dot(offset(one), tangent(one.a, G)); };
    take(nodes.front().state, false);
    double before = along(nodes.front().state, nodes.front().slopes);
    for (std::size_t i = 1; i < nodes.size(); ++i) {
      const double here = along(nodes[i].state, nodes[i].slopes);
      if (before < 0 && here >= 0) {
        const auto slope = [&](double u) {
          const State one = curve_.at(u);
          return along(one, curve_.slopes(one));
        };
        take(curve_.at(root_between(slope, nodes[i - 1].u, nodes[i].u)), false);
      }
      before = here;
    }
    if (before < 0) take(nodes.back().state, curve_.ends_at_hertz());
    slopes_ = curve_.slopes(state_);
  }

  Pair of_geometry(double of_y, double of_slope) const {
    Change change{G_y_ * of_y, 0, 0, -of_y, -of_slope};
    change.a = G_yy_ * of_y * y_.slope + G_y_ * of_slope;
    change.T = G_yT_ * of_y;
    return at_end_ ? of_end(change, of_y) : total(change);
  }

  Pair total(const Change& change) const {
    if (at_end_) return of_end(change, 0);
    if (!of_P_) return {-change.G * signed_normal(), 0};
    return of_offset(scaled(0, 0, change.P),
                     scaled(change.a, -2 * pi<double>() * state_.a * change.T,
                            -P_slope(state_.a) * change.T - change.P_slope * slopes_.T),
                     change.G);
  }
  /// 1/|grad G| in the plane, with the sign of the residual.
  double signed_normal() const {
    const double T = slopes_.T * to_.sigma_T, A = slopes_.a * to_.sigma_A / (2 * pi<double>() * state_.a);
    const double size = std::hypot(T, A);
    return (n1_[0] * T + n1_[1] * A >= 0 ? 1 : -1) / size;
  }

  /// Where the offset changes by dx and the tangent by dt at a fixed state, and G by dG.
  Pair of_offset(const Vector& dx, const Vector& dt, double dG = 0) const {
    if (at_end_ || !of_P_) return {dot(n1_, dx), dot(n2_, dx)};
    const double S_p = dot(dt, x_) + dot(t_, dx), determinant = slopes_.a * S_[1] - slopes_.T * S_[0];
    const double da = -(dG * S_[1] - S_p * slopes_.T) / determinant, dT = -(slopes_.a * S_p - S_[0] * dG) / determinant;
    const Vector by_state = moves(da, dT),
                 turn = tangent_moves(da, dT, {G_aa_ * da + G_aT_ * dT, G_aT_ * da + G_TT_ * dT});
    Vector x{}, t{};
    for (std::size_t k = 0; k < 3; ++k) {
      x[k] = dx[k] + by_state[k];
      t[k] = dt[k] + turn[k];
    }
    const double omega = (t_[0] * t[1] - t_[1] * t[0]) / (plane_ * plane_) * part_of_P_;
    return {dot(n1_, x) + omega * r_[1], dot(n2_, x) - omega * r_[0]};
  }

  /// At Hertz, where y(a) = 0 stays so: da = -y_p/y_a, and T follows from tau^2(0, T) = 8 pi a^3.
  Pair of_end(const Change& change, double of_y) const {
    const double a = state_.a, da = -of_y / y_.slope;
    const double of_law = of_y == 0 ? change.G : 0, dT = (24 * pi<double>() * a * a * da - of_law) / slopes_.T;
    const Vector dx = scaled(dT, 2 * pi<double>() * a * da, change.P + P_slope(a) * da);
    return {dot(n1_, dx), dot(n2_, dx)};
  }

  /// d2 tau^2/(dy dp), as a central difference of the derivative in p.
  double mixed(std::size_t k) const {
    constexpr double kStep = 1e-5;
    const double step = kStep * std::max(state_.y, 1e-3 * state_.T), cube = 4.0 / 3 * state_.a * state_.a * state_.a;
    const auto at = [&](double y) {
      return equilibrium_gradient(curve_.law(), curve_.parameters(), cube - y, state_.T, y).parameters[k];
    };
    const double low = std::max(state_.y - step, 0.0);
    return (at(state_.y + step) - at(low)) / (state_.y + step - low);
  }

  const Curve& curve_;
  HeldReading to_;
  bool of_P_, at_end_ = false;
  State state_{};
  Slopes slopes_{};
  Vector x_{}, t_{}, n1_{}, n2_{};
  double plane_ = 0, size_ = 0, part_of_P_ = 0;
  Pair r_{};
  HeldApproach::EdgeLoad y_{};
  double G_y_ = 0, G_yy_ = 0, G_yT_ = 0, G_TT_ = 0, G_aa_ = 0, G_aT_ = 0;
  Pair S_{};
  Parameters<Law> by_law_{};
};

}  // namespace mixity
