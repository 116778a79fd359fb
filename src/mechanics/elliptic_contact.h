// The equilibrium of an elliptic contact (ellipse.h) under one normal load, and its stable branch from T = 0.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "mechanics/elliptic_equations.h"
#include "mechanics/roots.h"

namespace mixity {

/// The branch as marks, found as far as it is asked for.
template <class Law>
class EllipticContact : private EllipticEquations<Law> {
  using Equations = EllipticEquations<Law>;
  using Equations::edge_load_at, Equations::state, Equations::residuals, Equations::mark_at, Equations::next_from;
  using Equations::newton_at, Equations::uncoupled, Equations::P_, Equations::S0_, Equations::poisson_ratio_;
  using typename Equations::Mark, typename Equations::Residuals;

 public:
  using Equations::Equations, Equations::far_shear;

  EllipseState at(double T) {
    if (uncoupled() || T == 0) return state(edge_load_at(0) + P_, 0, T);
    while (marks_.back().T < T && !end_) walk(T);
    if (marks_.back().T < T) return {EquilibriumStatus::no_equilibrium};
    const auto after =
        std::lower_bound(marks_.begin() + 1, marks_.end(), T, [](const Mark& mark, double t) { return mark.T < t; });
    return between(*(after - 1), *after, T);
  }

  /// Writes the derivatives of ln a and ln b (EllipseSlopes) at a state on the curve.
  void slopes(double T, double a, double b, double* of_a, double* of_b) const {
    const double y = edge_load(std::sqrt(a * b), P_), w = y + P_, q = std::log(a / b);
    const Residuals r = residuals(y, q, T * T);
    const auto write = [&](double first, double second) {
      const auto [dw, dq] = Equations::solved_at_S(r, {-first, -second});
      *of_a++ = dw / (3 * w) + 0.5 * dq;
      *of_b++ = dw / (3 * w) - 0.5 * dq;
    };
    write(2 * T * r.S[0], 2 * T * r.S[1]);
    Equations::each_derivative(w, q, T, write);
  }

  /// Null if the branch reaches T_most.
  std::optional<EllipseBranchEnd> end(double T_most) {
    while (!uncoupled() && marks_.back().T < T_most && !end_) walk(T_most);
    return end_;
  }

  /// The end of the branch that is stable under this control; null as for `end`.
  std::optional<EllipseBranchEnd> end_under(Control control, double T_most) {
    std::optional<EllipseBranchEnd> found = end(T_most);
    // u grows as long as T does
    if (control.kind == Control::Kind::load || !found || found->kind != EllipseEnd::fold) return found;
    const auto slope = [&](const Mark& mark) { return driving_slope(mark, control); };
    Mark last = marks_.back();
    for (found.reset(); !found;)
      if (const auto next = beyond(last, slope, found)) last = *next;
    return found;
  }

 private:
  /// d(u)/d(phi), or that of u + T/k weighted by k/(1 + k), which is finite for any k.
  double driving_slope(const Mark& mark, Control control) const {
    const double w = edge_load_at(mark.phi) + P_, w_slope = -S0_ * std::sin(mark.phi);
    const EllipseCompliance unit = ellipse_compliance(mark.q, poisson_ratio_);
    const double of_u =
        (mark.T_slope * unit.value + mark.T * (unit.slope * mark.q_slope - unit.value * w_slope / (3 * w))) /
        std::cbrt(0.75 * w);
    if (control.kind == Control::Kind::displacement) return of_u;
    return (control.stiffness * of_u + mark.T_slope) / (1 + control.stiffness);
  }

  EllipseBranchEnd end_at(EllipseEnd kind, const Mark& mark) const {
    const EllipseState at = state(edge_load_at(mark.phi) + P_, mark.q, mark.T);
    return {kind, mark.T, mark.T * ellipse_compliance(mark.q, poisson_ratio_).value / std::sqrt(at.a * at.b), at.a,
            at.b};
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
    marks_.push_back({from.phi, found->second, T, 0, std::numeric_limits<double>::infinity(), from.least});
    return true;
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
    const double nearly = edge_load_at(phi);
    if (const auto found = newton_at(T, nearly, q); found && on_branch(found->first, low, high))
      return state(found->first + P_, found->second, T);
    // near the end Newton's method may leave the branch
    const auto excess = [&](double at) {
      const auto mark = at > low.phi ? mark_at(at, q, std::max(T, 0.5 * low.T), low.least) : std::optional(low);
      return mark ? mark->T - T : high.T - T;
    };
    if (!(excess(high.phi) > 0)) return state(edge_load_at(high.phi) + P_, high.q, T);  // on the fold, but for rounding
    const double root = root_between(excess, low.phi, high.phi);
    const auto mark = mark_at(root, q, T, low.least);
    return mark ? state(edge_load_at(root) + P_, mark->q, T) : state(edge_load_at(high.phi) + P_, high.q, T);
  }

  bool on_branch(double y, const Mark& low, const Mark& high) const {
    const double slack = 1e-9 * S0_;
    return y <= edge_load_at(low.phi) + slack && y >= edge_load_at(high.phi) - slack;
  }

  std::vector<Mark> marks_{Equations::first_mark()};
  std::optional<EllipseBranchEnd> end_{};
};

}  // namespace mixity
