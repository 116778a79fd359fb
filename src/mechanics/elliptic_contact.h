// The equilibrium of an elliptic contact (ellipse.h) under one normal load, and its stable branch from T = 0.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "mechanics/base/law.h"
#include "mechanics/contact.h"
#include "mechanics/ellipse.h"
#include "mechanics/ellipse_pressure.h"
#include "mechanics/roots.h"

namespace mixity {

/// Marks on the branch are found at given w = 4/3 (a b)^(3/2), which falls from JKR's on: w = P + 3 pi + S0 cos phi, as
/// on the circle of circular contacts. The unknowns are then q = ln(a/b) and T^2.
template <class Law>
class EllipticContact {
 public:
  EllipticContact(const Law& law, const Parameters<Law>& mode_II, const Parameters<Law>& mode_III, double poisson_ratio,
                  double P)
      : law_(law),
        p_{&mode_II, &mode_III},
        P_(P),
        S0_(circle_radius(P)),
        poisson_ratio_(poisson_ratio),
        per_square_{1, 1 / (1 - poisson_ratio)},
        small_{law.small_shear(mode_II), law.small_shear(mode_III)} {
    Mark first{0, 0, 0, 0, 0};
    if (small_[0] == 0 && small_[1] == 0) {
      uncoupled_ = true;
    } else {
      const Residuals r = residuals(edge_load_at(0), 0, 0);
      first.T_slope = std::sqrt(std::max(0.5 * S0_ * solved(r, r.w).second, 0.0));
    }
    marks_.push_back(first);
  }

  EllipseState at(double T) {
    if (uncoupled_ || T == 0) return state(edge_load_at(0) + P_, 0, T);
    while (marks_.back().T < T && !end_) walk(T);
    if (marks_.back().T < T) return {EquilibriumStatus::no_equilibrium};
    const auto after =
        std::lower_bound(marks_.begin() + 1, marks_.end(), T, [](const Mark& mark, double t) { return mark.T < t; });
    return between(*(after - 1), *after, T);
  }

  /// Writes the derivatives of ln a and ln b (EllipseSlopes) at a state on the curve.
  void slopes(double T, double a, double b, double* of_a, double* of_b) const {
    const double w = 4.0 / 3 * std::pow(a * b, 1.5), q = std::log(a / b), unit = 1 / (6 * pi<double>() * w);
    const Residuals r = residuals(w - P_, q, T * T);
    const EllipsePressure g = ellipse_pressure(q);
    const double Y[2]{w * g.along - P_, w * g.across - P_}, determinant = r.w[0] * r.q[1] - r.w[1] * r.q[0];
    // what a change of the residuals does to w and q
    const auto write = [&](double first, double second) {
      const double dw = -(first * r.q[1] - second * r.q[0]) / determinant,
                   dq = -(r.w[0] * second - r.w[1] * first) / determinant;
      *of_a++ = dw / (3 * w) + 0.5 * dq;
      *of_b++ = dw / (3 * w) - 0.5 * dq;
    };
    write(2 * T * r.S[0], 2 * T * r.S[1]);
    double of_P[2];
    std::vector<double> of_law[2];
    for (int k = 0; k < 2; ++k) {
      const double t = T * std::sqrt(per_square_[k]);
      const ShearTerm<double> tau2 = t > 0 ? law_.shear_term(*p_[k], Y[k], t) : ShearTerm<double>{0, 0, 0};
      of_P[k] = -(2 * Y[k] + tau2.d1) * unit;
      // tau^2 = (Y^2 + T^2)/f - Y^2
      const auto log_f = law_.log_toughness(*p_[k], mixity_from_loads(Y[k], t));
      for (const double slope : log_f.gradient) of_law[k].push_back(-(Y[k] * Y[k] + tau2.value) * slope * unit);
    }
    write(of_P[0], of_P[1]);
    for (const double slope : of_law[0]) write(slope, 0);
    for (const double slope : of_law[1]) write(0, slope);
    write(0, T * T * r.S[1] * per_square_[1]);
  }

  /// Null if the branch reaches T_most.
  std::optional<EllipseBranchEnd> end(double T_most) {
    while (!uncoupled_ && marks_.back().T < T_most && !end_) walk(T_most);
    return end_;
  }

  EllipseEnds ends(double T_most) {
    EllipseEnds found{end(T_most), {}};
    if (!found.load || found.load->kind != EllipseEnd::fold) {  // u grows as long as T does
      found.displacement = found.load;
      return found;
    }
    Mark last = marks_.back();
    while (!found.displacement)
      if (const auto next = beyond(
              last, [this](const Mark& mark) { return displacement_slope(mark); }, found.displacement))
        last = *next;
    return found;
  }

 private:
  struct Mark {
    double phi, q, T, q_slope, T_slope;  // slopes: per phi
  };
  /// The left sides of the criterion minus the right ones, over 6 pi w, and their derivatives; S = T^2.
  struct Residuals {
    double value[2], w[2], q[2], S[2];
    double least;  // the smaller Y over w
  };

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
    Residuals r{};
    r.least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 2; ++k) {
      const double sign = k == 0 ? -1 : 1, right = 6 * pi<double>() * std::exp(0.5 * sign * q);  // over w
      const double Y = y + w * (shape[k] - 1), T = std::sqrt(S * per_square_[k]);
      ShearTerm<double> tau2{0, 0, 0};
      double of_S = small_[k];
      if (T > 0 && Y > 0) {
        tau2 = law_.shear_term(*p_[k], Y, T);
        of_S = (2 * tau2.value - Y * tau2.d1) / (2 * T * T);  // tau^2 is homogeneous of degree 2
      }
      const double of_Y = 2 * Y + tau2.d1, unit = 1 / (6 * pi<double>() * w);
      r.value[k] = (Y * Y + tau2.value - right * w) * unit;
      r.w[k] = (of_Y * shape[k] - right) * unit;
      r.q[k] = (of_Y * w * slope[k] - 0.5 * sign * right * w) * unit;
      r.S[k] = of_S * per_square_[k] * unit;
      r.least = std::min(r.least, Y / w);
    }
    return r;
  }

  /// (x, y) with x r.q + y r.S = right.
  static std::pair<double, double> solved(const Residuals& r, const double (&right)[2]) {
    const double determinant = r.q[0] * r.S[1] - r.q[1] * r.S[0];
    return {(right[0] * r.S[1] - right[1] * r.S[0]) / determinant,
            (r.q[0] * right[1] - r.q[1] * right[0]) / determinant};
  }

  /// The mark at phi > 0, from a guess. Null if Newton's method does not arrive, or where K_I < 0.
  std::optional<Mark> mark_at(double phi, double q, double T) const {
    constexpr int kMost = 25;
    constexpr double kRounding = 1e-15;
    const double y = edge_load_at(phi);
    double S = T * T, last = std::numeric_limits<double>::infinity();
    for (int i = 0; i < kMost; ++i) {
      const Residuals r = residuals(y, q, S);
      if (!(r.least > 0)) return std::nullopt;
      const auto [dq, dS] = solved(r, r.value);
      const double size = std::abs(dq) + std::abs(dS) / S;
      if (!std::isfinite(size)) return std::nullopt;
      q -= std::clamp(dq, -0.5, 0.5);
      S = std::max(S - dS, 0.25 * S);
      if (size <= kRounding || (size < 1e-9 && size >= 0.5 * last)) {
        const Residuals at = residuals(y, q, S);
        if (!(at.least > 0)) return std::nullopt;
        const auto [q_w, S_w] = solved(at, at.w);
        const double w_slope = -S0_ * std::sin(phi), root = std::sqrt(S);
        return Mark{phi, q, root, -q_w * w_slope, -S_w * w_slope / (2 * root)};
      }
      last = size;
    }
    return std::nullopt;
  }

  /// A guess at phi from the last mark.
  std::optional<Mark> next_from(const Mark& from, double phi) const {
    const double step = phi - from.phi;
    return mark_at(phi, from.q + step * from.q_slope, std::max(from.T + step * from.T_slope, 0.5 * from.T));
  }

  /// d(u)/d(phi), with the shape's derivative from differences: its error moves an extremum of u by 1e-9.
  double displacement_slope(const Mark& mark) const {
    constexpr double kStep = 1e-5;
    const double w = edge_load_at(mark.phi) + P_, w_slope = -S0_ * std::sin(mark.phi);
    const auto compliance = [&](double q) { return ellipse_compliance(q, poisson_ratio_); };
    const double at = compliance(mark.q),
                 of_q = (compliance(mark.q + kStep) - compliance(mark.q - kStep)) / (2 * kStep * at);
    return mark.T_slope / mark.T + of_q * mark.q_slope - w_slope / (3 * w);
  }

  EllipseBranchEnd end_at(EllipseEnd kind, const Mark& mark) const {
    const EllipseState at = state(edge_load_at(mark.phi) + P_, mark.q, mark.T);
    return {kind, mark.T, mark.T * ellipse_compliance(mark.q, poisson_ratio_) / std::sqrt(at.a * at.b), at.a, at.b};
  }

  /// The next mark on the curve as long as the controlled quantity, of which `slope_of` has the sign of the slope,
  /// grows; at the end the last mark, or null if it is `from`.
  template <class Slope>
  std::optional<Mark> beyond(const Mark& from, const Slope& slope_of, std::optional<EllipseBranchEnd>& end) const {
    constexpr double kStep = 0.05, kLeast = 1e-13, kFarther = 0.2;  // in phi; of q
    std::optional<Mark> to;
    for (double step = kStep; step > kLeast * std::max(from.phi, kStep); step *= 0.5) {
      to = next_from(from, from.phi + step);
      if (to && std::abs(to->q - from.q) < kFarther) break;
      to.reset();
    }
    if (!to) {
      const double w = edge_load_at(from.phi) + P_;
      const EllipsePressure g = ellipse_pressure(from.q);
      end = end_at(w * g.along < w * g.across ? EllipseEnd::closes_along : EllipseEnd::closes_across, from);
      return std::nullopt;
    }
    if (slope_of(*to) > 0) return to;
    const auto slope = [&](double phi) {
      const auto mark = phi > from.phi ? next_from(from, phi) : std::optional(from);
      return mark && mark->phi > 0 ? slope_of(*mark) : mark ? 1.0 : -1.0;
    };
    const double phi = root_between(slope, from.phi, to->phi);
    const auto fold = phi > from.phi ? next_from(from, phi) : std::nullopt;
    end = end_at(EllipseEnd::fold, fold.value_or(from));
    return fold;
  }

  /// Adds a mark, and the end if it lies before it.
  void walk(double T_most) {
    constexpr double kSteep = 1e3;
    const Mark from = marks_.back();
    std::optional<EllipseBranchEnd> end;
    if (const auto next = beyond(
            from, [](const Mark& mark) { return mark.T_slope; }, end))
      marks_.push_back(*next);
    // towards an asymptote T grows without bound; at an edge that closes it does not
    const bool may_go_on = end && end->kind != EllipseEnd::fold && from.T_slope > kSteep * from.T && from.T < T_most;
    if (!(may_go_on && walk_in_T(T_most))) end_ = end;
  }

  /// A mark at twice the last T, or at T_most, where w hardly changes. False if there is none.
  bool walk_in_T(double T_most) {
    const Mark& from = marks_.back();
    const double T = std::min(std::max(2 * from.T, 1e-3), T_most);
    const auto found = newton_at(T, edge_load_at(from.phi), from.q);
    if (!found) return false;
    marks_.push_back({from.phi, found->second, T, 0, std::numeric_limits<double>::infinity()});
    return true;
  }

  /// w - P and q at this T.
  std::optional<std::pair<double, double>> newton_at(double T, double y, double q) const {
    constexpr int kMost = 20;
    constexpr double kRounding = 1e-15;
    double last = std::numeric_limits<double>::infinity();
    for (int i = 0; i < kMost; ++i) {
      const Residuals r = residuals(y, q, T * T);
      if (!(r.least > 0)) return std::nullopt;
      const double determinant = r.w[0] * r.q[1] - r.w[1] * r.q[0];
      const double dw = (r.value[0] * r.q[1] - r.value[1] * r.q[0]) / determinant,
                   dq = (r.w[0] * r.value[1] - r.w[1] * r.value[0]) / determinant;
      const double size = std::abs(dw) / (y + P_) + std::abs(dq);
      if (!(size < 1)) return std::nullopt;
      y -= dw;
      q -= dq;
      if (size <= kRounding || (size < 1e-10 && size >= 0.5 * last)) return std::pair(y, q);
      last = size;
    }
    return std::nullopt;
  }

  EllipseState between(const Mark& low, const Mark& high, double T) const {
    if (!std::isfinite(high.T_slope)) {  // of walk_in_T
      const auto found = newton_at(T, edge_load_at(high.phi), high.q);
      return found ? state(found->first + P_, found->second, T) : EllipseState{EquilibriumStatus::invalid};
    }
    // Hermite's cubic of T in phi, solved for phi
    const double h = high.phi - low.phi;
    const auto cubic = [h](double x, double f0, double d0, double f1, double d1) {
      const double rest = 1 - x;
      return f0 * rest * rest * (1 + 2 * x) + f1 * x * x * (3 - 2 * x) + h * x * rest * (d0 * rest - d1 * x);
    };
    double below = 0, above = 1;
    for (int i = 0; i < 24; ++i) {
      const double x = 0.5 * (below + above);
      (cubic(x, low.T, low.T_slope, high.T, high.T_slope) < T ? below : above) = x;
    }
    const double x = 0.5 * (below + above), phi = low.phi + x * h,
                 q = cubic(x, low.q, low.q_slope, high.q, high.q_slope);
    const double nearly = 3 * pi<double>() + S0_ * std::cos(phi);
    if (const auto found = newton_at(T, nearly, q); found && on_branch(found->first, low, high))
      return state(found->first + P_, found->second, T);
    // near the end Newton's method may leave the branch
    const auto excess = [&](double at) {
      const auto mark = at > low.phi ? mark_at(at, q, std::max(T, 0.5 * low.T)) : std::optional(low);
      return mark ? mark->T - T : high.T - T;
    };
    const double root = root_between(excess, low.phi, high.phi);
    const auto mark = mark_at(root, q, T);
    return mark ? state(edge_load_at(root) + P_, mark->q, T) : state(edge_load_at(high.phi) + P_, high.q, T);
  }

  bool on_branch(double y, const Mark& low, const Mark& high) const {
    const double slack = 1e-9 * S0_;
    return y <= edge_load_at(low.phi) + slack && y >= edge_load_at(high.phi) - slack;
  }

  const Law& law_;
  const Parameters<Law>* p_[2];
  double P_, S0_, poisson_ratio_;
  double per_square_[2];  // T'^2 over T^2
  double small_[2];       // tau^2/T'^2 at T -> 0
  bool uncoupled_ = false;
  std::vector<Mark> marks_;
  std::optional<EllipseBranchEnd> end_{};
};

}  // namespace mixity
