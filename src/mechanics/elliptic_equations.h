// The equations of an elliptic contact (ellipse.h) under one normal load, and Newton's method for them.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "mechanics/base/law.h"
#include "mechanics/contact.h"
#include "mechanics/ellipse.h"
#include "mechanics/ellipse_pressure.h"

namespace mixity {

/// Marks on the curve of states are found at given w = 4/3 (a b)^(3/2), which falls from JKR's on: w = P + 3 pi + S0
/// cos phi, as on the circle of circular contacts. The unknowns are then q = ln(a/b) and T^2.
template <class Law>
class EllipticEquations {
 public:
  struct Mark {
    double phi, q, T, q_slope, T_slope;  // slopes: per phi
    double least;                        // the smaller Y over w
    double y = 0, y_slope = 0;           // w - P; of a mark at phi
  };
  /// The left sides of the criterion minus the right ones, over 6 pi w, and their derivatives; S = T^2.
  struct Residuals {
    double value[2], w[2], q[2], S[2];
    double least;  // the smaller Y over w
  };

  /// All arguments but the numbers must outlive this object.
  EllipticEquations(const Law& law, const Parameters<Law>& mode_II, const Parameters<Law>& mode_III,
                    double poisson_ratio, double P)
      : law_(law),
        p_{&mode_II, &mode_III},
        P_(P),
        S0_(circle_radius(P)),
        poisson_ratio_(poisson_ratio),
        per_square_{1, 1 / (1 - poisson_ratio)},
        small_{law.small_shear(mode_II), law.small_shear(mode_III)} {}

  /// Whether shear does not affect the contact.
  bool uncoupled() const { return small_[0] == 0 && small_[1] == 0; }

  /// Ten times the natural scale of T of the circle with the larger coupling: beyond it no end of a branch is looked
  /// for, and a curve that runs to infinite T is cut. Infinite if uncoupled.
  double far_shear() const { return 10 * S0_ / std::sqrt(std::max(small_[0], small_[1])); }

  Mark first_mark() const {
    const double y = edge_load_at(0);
    if (uncoupled()) return {0, 0, 0, 0, 0, 1, y};
    const Residuals r = residuals(y, 0, 0);
    return {0, 0, 0, 0, std::sqrt(std::max(0.5 * S0_ * solved_at_w(r, r.w).second, 0.0)), r.least, y};
  }

  double edge_load_at(double phi) const { return 3 * pi<double>() + S0_ * std::cos(phi); }  // of the circle: w - P

  EllipseState state(double w, double q, double T) const {
    const double c = std::cbrt(0.75 * w);
    const EllipsePressure g = ellipse_pressure(q);
    const auto psi = [&](double shape, double per_square) {
      return std::atan2(T * std::sqrt(per_square), w * shape - P_);
    };
    return {EquilibriumStatus::ok, c * std::exp(0.5 * q), c * std::exp(-0.5 * q), psi(g.along, per_square_[0]),
            psi(g.across, per_square_[1])};
  }

  /// y: w - P.
  Residuals residuals(double y, double q, double S) const {
    const EllipsePressure g = ellipse_pressure(q);
    const double w = y + P_, shape[2]{g.along, g.across}, slope[2]{g.along_slope, g.across_slope};
    const double root = std::exp(0.5 * q), six_pi = 6 * pi<double>(), unit = 1 / (six_pi * w);
    const double right[2]{six_pi / root, six_pi * root};  // over w
    Residuals r{};
    r.least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 2; ++k) {
      const double sign = k == 0 ? -1 : 1;
      const double Y = y + w * (shape[k] - 1), T = std::sqrt(S * per_square_[k]);
      ShearTerm<double> tau2{0, 0, 0};
      double of_S = small_[k];
      if (T > 0 && Y > 0) {
        tau2 = law_.shear_term(*p_[k], Y, T);
        of_S = (2 * tau2.value - Y * tau2.d1) / (2 * T * T);  // tau^2 is homogeneous of degree 2
      }
      const double of_Y = 2 * Y + tau2.d1;
      r.value[k] = (Y * Y + tau2.value - right[k] * w) * unit;
      r.w[k] = (of_Y * shape[k] - right[k]) * unit;
      r.q[k] = (of_Y * w * slope[k] - 0.5 * sign * right[k] * w) * unit;
      r.S[k] = of_S * per_square_[k] * unit;
      r.least = std::min(r.least, Y / w);
    }
    return r;
  }

  /// Steps of q and S at fixed w, (x, y) with x r.q + y r.S = right; and of w and q at fixed S, with x r.w + y r.q.
  static std::pair<double, double> solved_at_w(const Residuals& r, const double (&right)[2]) {
    return solved(r.q, r.S, right);
  }
  static std::pair<double, double> solved_at_S(const Residuals& r, const double (&right)[2]) {
    return solved(r.w, r.q, right);
  }

  /// The mark at phi > 0, from a guess and the least Y over w of a neighbour. Null if Newton's method does not arrive,
  /// or where K_I < 0.
  std::optional<Mark> mark_at(double phi, double q, double T, double least) const {
    constexpr int kMost = 25;
    constexpr double kNear = 1e-8, kThere = 1e-13;  // Newton's next step ends at rounding; so do the slopes
    constexpr double kClosed = 1e-3;
    const double y = edge_load_at(phi);
    double S = T * T;
    bool near = false;
    for (int i = 0; i < kMost; ++i) {
      Residuals r = residuals(y, q, S);
      if (i == 0 && least < kClosed && !(r.least > 0.5 * least && r.least < 2 * least)) {
        q = nearly_closed(y + P_, q, least);
        r = residuals(y, q, S);
      }
      if (!(r.least > 0)) return std::nullopt;
      const auto [dq, dS] = solved_at_w(r, r.value);
      const double size = std::abs(dq) + std::abs(dS) / S;
      if (!std::isfinite(size)) return std::nullopt;
      q -= std::clamp(dq, -0.5, 0.5);
      S = std::max(S - dS, 0.25 * S);
      if ((near && size <= kNear) || (size <= kThere && r.least > kClosed)) {
        const auto [q_w, S_w] = solved_at_w(r, r.w);
        const double w_slope = -S0_ * std::sin(phi), root = std::sqrt(S);
        return Mark{phi, q, root, -q_w * w_slope, -S_w * w_slope / (2 * root), r.least, y, w_slope};
      }
      near = size <= kNear;
    }
    return std::nullopt;
  }

  /// A guess at phi from the last mark.
  std::optional<Mark> next_from(const Mark& from, double phi) const {
    const double step = phi - from.phi;
    return mark_at(phi, from.q + step * from.q_slope, std::max(from.T + step * from.T_slope, 0.5 * from.T), from.least);
  }

  /// w - P and q at this T.
  std::optional<std::pair<double, double>> newton_at(double T, double y, double q) const {
    constexpr int kMost = 20;
    constexpr double kRounding = 1e-15;
    double last = std::numeric_limits<double>::infinity();
    for (int i = 0; i < kMost; ++i) {
      const Residuals r = residuals(y, q, T * T);
      if (!(r.least > 0)) return std::nullopt;
      const auto [dw, dq] = solved_at_S(r, r.value);
      const double size = std::abs(dw) / (y + P_) + std::abs(dq);
      if (!(size < 1)) return std::nullopt;
      y -= dw;
      q -= dq;
      if (size <= kRounding || (size < 1e-10 && size >= 0.5 * last)) return std::pair(y, q);
      last = size;
    }
    return std::nullopt;
  }

  /// Calls write(first, second) with the derivatives of both residuals in P at fixed w, in the parameters of mode II,
  /// in those of mode III, and in Poisson's ratio.
  template <class Write>
  void each_derivative(double w, double q, double T, const Write& write) const {
    const EllipsePressure g = ellipse_pressure(q);
    const double Y[2]{w * g.along - P_, w * g.across - P_}, unit = 1 / (6 * pi<double>() * w);
    double of_P[2], of_nu = 0;
    Differentiated<double, parameter_count<Law>> log_f[2];
    double held[2];
    std::size_t count = 0;
    for (int k = 0; k < 2; ++k) {
      const double t = T * std::sqrt(per_square_[k]);
      const ShearTerm<double> tau2 = t > 0 ? law_.shear_term(*p_[k], Y[k], t) : ShearTerm<double>{0, 0, 0};
      of_P[k] = -(2 * Y[k] + tau2.d1) * unit;
      held[k] = (Y[k] * Y[k] + tau2.value) * unit;  // tau^2 = (Y^2 + T^2)/f - Y^2
      const auto of_law = law_.log_toughness(*p_[k], mixity_from_loads(Y[k], t));
      std::copy(of_law.gradient.begin(), of_law.gradient.end(), log_f[k].gradient.begin());
      count = of_law.gradient.size();
      if (k == 1) of_nu = (tau2.value - 0.5 * Y[k] * tau2.d1) * per_square_[1] * unit;
    }
    write(of_P[0], of_P[1]);
    for (std::size_t i = 0; i < count; ++i) write(-held[0] * log_f[0].gradient[i], 0.0);
    for (std::size_t i = 0; i < count; ++i) write(0.0, -held[1] * log_f[1].gradient[i]);
    write(0.0, of_nu);
  }

 protected:
  /// Where an edge has nearly closed (law a beside lambda = 1), Y hardly changes along the curve, and is the difference
  /// of nearly equal numbers at a guess of q: the q at which the smaller Y over w is `least`.
  double nearly_closed(double w, double q, double least) const {
    constexpr int kSteps = 4;
    for (int i = 0; i < kSteps; ++i) {
      const EllipsePressure g = ellipse_pressure(q);
      const bool along = g.along < g.across;
      q -= ((along ? g.along : g.across) - P_ / w - least) / (along ? g.along_slope : g.across_slope);
    }
    return q;
  }

  static std::pair<double, double> solved(const double (&x)[2], const double (&y)[2], const double (&right)[2]) {
    const double determinant = x[0] * y[1] - x[1] * y[0];
    return {(right[0] * y[1] - right[1] * y[0]) / determinant, (x[0] * right[1] - x[1] * right[0]) / determinant};
  }

  const Law& law_;
  const Parameters<Law>* p_[2];
  double P_, S0_, poisson_ratio_;
  double per_square_[2];  // T'^2 over T^2
  double small_[2];       // tau^2/T'^2 at T -> 0
};

}  // namespace mixity
