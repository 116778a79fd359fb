// The whole curve of states of a contact whose approach is held (held_approach.h), from JKR through the folds to its
// end. It is explicit in a: tau^2 = 8 pi a^3 - y(a)^2, and T follows from tau/y by the law. Its parameter u runs from 0
// (JKR, T = 0) to 1. For Delta > 0 it ends at Hertz, y = 0, with a = a0 - (a0 - a_end) u^2; otherwise at the unstable
// JKR state, with a = a0 - (a0 - a_end) sin^2(pi u/2); before either at the asymptote of a law that has one.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "mechanics/curve.h"
#include "mechanics/held_approach.h"
#include "mechanics/roots.h"

namespace mixity {

template <class Law>
class HeldCurve {
 public:
  /// `of`: held.unsheared(). The law must not be non-monotone.
  HeldCurve(const Law& law, const Parameters<Law>& p, const HeldApproach& held, const HeldApproach::Unsheared& of)
      : law_(law), p_(p), held_(held), top_(of.stable), uncoupled_(!(law.shear_term(p, 1.0, 1.0).value > 0)) {
    hertz_ = held.approach > 0;
    bottom_ = hertz_ ? held.radius(0) : of.unstable;
    constexpr double kBeforeNothing = 1e-4;
    if (bottom_ == 0) last_ = 1 - kBeforeNothing;  // the contact vanishes: y, T and a are 0 there
    if (const double excess = shear_limit(law, p); std::isfinite(excess) && !uncoupled_) cut(excess);
    if (!uncoupled_) list_nodes();
  }

  const Law& law() const { return law_; }
  const Parameters<Law>& parameters() const { return p_; }
  const HeldApproach& held() const { return held_; }
  double top() const { return top_; }            // the radius at T = 0
  bool uncoupled() const { return uncoupled_; }  // shear does not affect the area
  double last() const { return last_; }          // the u at which the curve ends
  bool ends_at_hertz() const { return hertz_ && !asymptote_; }
  bool has_asymptote() const { return asymptote_; }

  struct State {
    double a, y, tau_squared, T;
  };
  State at(double u) const {
    // distances from both ends, each without cancellation
    const double width = top_ - bottom_, s = std::sin(0.5 * pi<double>() * u), c = std::cos(0.5 * pi<double>() * u);
    const double below = hertz_ ? width * u * u : width * s * s,
                 above = hertz_ ? width * (1 - u) * (1 + u) : width * c * c;
    const double a = below < above ? top_ - below : bottom_ + above, m = held_.compliance;
    State state{};
    state.a = a;
    if (!(a > 0)) return state;
    state.y = hertz_ ? above * (4.0 / 3 * m * (a * a + a * bottom_ + bottom_ * bottom_) + a + bottom_) / (m + 0.5 / a)
                     : held_.edge_load(a).value;
    const double whole = std::sqrt(8 * pi<double>() * a) * a;  // sqrt(8 pi a^3)
    const double gap = below < above            ? gap_from(top_, -below, a)
                       : hertz_ || bottom_ == 0 ? whole - state.y
                                                : gap_from(bottom_, above, a);
    state.tau_squared = std::max(gap * (whole + state.y), 0.0);
    state.T = tangential_load(law_, p_, state.y, std::sqrt(state.tau_squared));
    return state;
  }

  /// The gradient of G(a, T) = y(a)^2 + tau^2(y, T) - 8 pi a^3.
  struct Slopes {
    double a, T;
  };
  /// For derivatives, which model a may not have at y = 0.
  static double positive(double y) { return std::max(y, 1e-100); }
  Slopes slopes(const State& at) const {
    const ShearTerm<double> tau2 = law_.shear_term(p_, positive(at.y), at.T);
    return {(2 * at.y + tau2.d1) * held_.edge_load(at.a).slope - 24 * pi<double>() * at.a * at.a,
            at.T > 0 ? (2 * tau2.value - at.y * tau2.d1) / at.T : 0.0};
  }

  /// da/du
  double radius_per_u(double u) const {
    const double width = top_ - bottom_;
    return hertz_ ? -2 * width * u : -0.5 * pi<double>() * width * std::sin(pi<double>() * u);
  }

  struct Node {
    double u;
    State state;
    Slopes slopes;
  };
  /// Along the curve, both ends included unless it ends at an asymptote.
  const std::vector<Node>& nodes() const { return nodes_; }

  /// The u in (low, high) of the state with the tangential load T, between which T rises.
  double place(double T, double low, double high) const {
    return root_between([&](double u) { return u < last_ || !asymptote_ ? at(u).T - T : 1.0; }, low, high);
  }

 private:
  /// sqrt(8 pi a^3) - y(a) at a = end + by, where it is 0 at `end`.
  double gap_from(double end, double by, double a) const {
    const double v = std::sqrt(a), w = std::sqrt(end), m = held_.compliance;
    const double D = m + 0.5 / a, D_end = m + 0.5 / end,
                 N_end = m * (4.0 / 3 * end * end * end) + (end * end - held_.approach);
    const double N_more = by * (4.0 / 3 * m * (a * a + a * end + end * end) + a + end), D_more = -by / (2 * a * end);
    return std::sqrt(8 * pi<double>()) * by / (v + w) * (v * v + v * w + w * w) -
           (N_more * D_end - N_end * D_more) / (D * D_end);
  }

  /// Ends the curve where tau^2/y^2 reaches the law's limit.
  void cut(double excess) {
    const auto beyond = [&](double u) {
      const State state = ratio_at(u);
      return state.tau_squared - excess * state.y * state.y;
    };
    constexpr int kSamples = 512;
    for (int i = 1; i <= kSamples; ++i) {
      const double u = last_ * i / kSamples;
      if (!(beyond(u) >= 0)) continue;
      last_ = root_between(beyond, last_ * (i - 1) / kSamples, u);
      asymptote_ = true;
      return;
    }
  }
  /// at(u) without T.
  State ratio_at(double u) const {
    const double width = top_ - bottom_, s = std::sin(0.5 * pi<double>() * u);
    const double a = top_ - width * (hertz_ ? u * u : s * s);
    if (!(a > 0)) return {};
    const double y = held_.edge_load(a).value;
    return {a, y, 8 * pi<double>() * a * a * a - y * y, 0};
  }

  void list_nodes() {
    constexpr int kNodes = 64, kTowardsAsymptote = 40;
    const auto add = [&](double u) {
      const State state = at(u);
      if (std::isfinite(state.T)) nodes_.push_back({u, state, state.a > 0 ? slopes(state) : Slopes{0, 0}});
    };
    for (int i = 0; i < kNodes; ++i) add(last_ * i / kNodes);
    if (!asymptote_) return add(last_);
    for (int k = 1; k <= kTowardsAsymptote; ++k) add(last_ * (1 - std::ldexp(1.0 / kNodes, -k)));
  }

  [[no_unique_address]] Law law_;
  Parameters<Law> p_;
  HeldApproach held_;
  double top_, bottom_ = 0, last_ = 1;
  bool uncoupled_, hertz_ = false, asymptote_ = false;
  std::vector<Node> nodes_;
};

}  // namespace mixity
