// Where the folds are: locate_folds of folds.h. Included by it only.
#pragma once

#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <optional>

#include "mechanics/load_folds_impl.h"

namespace mixity {

namespace folds_detail {

// Logistic coordinate: e^-42 = 6e-19 of the piece.
constexpr double kFirst = -20, kStep = 0.25, kLast = 42;

template <class F>
double root_between(F f, double low, double high) {
  std::uintmax_t evaluations = 200;
  const auto bracket =
      boost::math::tools::toms748_solve(f, low, high, boost::math::tools::eps_tolerance<double>(52), evaluations);
  return 0.5 * (bracket.first + bracket.second);
}

/// A pair of folds shallower than this cannot be told from none: the contact does not jump by more than rounding.
constexpr double kRounding = 2e-15;

/// Calls found(v, falls) for the sign changes of f on [from, last], in order, until it returns false; falls: from > 0.
/// step(v), asked after f(v), is how far the next sample may lie.
template <class F, class Step, class Found>
void for_sign_changes(F f, double from, double last, Step step, Found found) {
  double v_before = from, before = 0, v = from, here = f(from);
  bool has_before = false;
  while (v < last) {
    const double v_next = std::min(v + step(v), last), next = f(v_next);
    const bool crosses = (here > 0) != (next > 0);
    const double sign = here > 0 ? 1 : -1;
    if (crosses) {
      if (!found(root_between(f, v, v_next), here > 0)) return;
    } else if (has_before && sign * before > sign * here && sign * next > sign * here) {
      const auto dip =
          boost::math::tools::brent_find_minima([&](double x) { return sign * f(x); }, v_before, v_next, 50);
      if (dip.second < -kRounding) {
        if (!found(root_between(f, v_before, dip.first), here > 0)) return;
        if (!found(root_between(f, dip.first, v_next), here <= 0)) return;
      }
    }
    has_before = !crosses;
    v_before = v;
    before = here;
    v = v_next;
    here = next;
  }
}

/// State of the curve at a position, and what drives it.
template <class Model>
struct Driven {
  const EquilibriumCurve<Model>& curve;
  Control control;

  double radius(const CurvePosition& at) const { return radius_from_edge_load(at.y, curve.load()); }

  /// Share of u in what drives the contact, w u + (1 - w) T: 0 load, 1 displacement, k/(1 + k) a spring. The rest,
  /// 1 - w, is kept beside it for the sake of a stiff spring.
  double share() const {
    if (control.kind == Control::Kind::stiffness) return control.stiffness / (1 + control.stiffness);
    return control.kind == Control::Kind::displacement ? 1 : 0;
  }
  double rest() const { return control.kind == Control::Kind::stiffness ? 1 / (1 + control.stiffness) : 1 - share(); }

  /// w u + (1 - w) T, up to kFar.
  double value(const CurvePosition& at) const {
    const double T = std::min(curve.tangential_load(at), kFar);
    return share() * std::min(0.75 * T / radius(at), kFar) + rest() * T;
  }

  /// > 0 where the value grows as y falls (stable), 0 at a fold. Relative to the size of its terms, so that what is
  /// within a few eps of 0 is 0 as far as doubles can tell.
  double slope(const CurvePosition& at) const {
    // At the last digits before an asymptote T comes out infinite; tau^2 there is that of any large T.
    const double tau2 = curve.tau_squared(at), T = std::min(curve.tangential_load(at), kFar);
    const double d1 = Model::shear_term(curve.parameters(), at.y, T).d1;
    const double twice = 2 * curve.offset(at), R_y = twice + d1, size = std::abs(twice) + std::abs(d1);
    const double load = (3 * share() + 4 * radius(at) * rest()) * (at.y + curve.load());
    const double all = size * load + share() * (2 * tau2 + std::abs(at.y * d1));
    return all > 0 ? (R_y * load + share() * (2 * tau2 - at.y * d1)) / all : 0;
  }
};

template <class Model>
FoldPlace place_at_offset(const EquilibriumCurve<Model>& curve, double offset) {
  const CurvePosition at = curve.position_at_offset(offset);
  return {0, curve.coordinate(curve.pieces()[0], at), at, curve.tangential_load(at), true};
}

template <class Model>
FoldPlace place_at_coordinate(const EquilibriumCurve<Model>& curve, std::size_t piece, double v, bool maximum) {
  const CurvePosition at = curve.position(curve.pieces()[piece], v);
  return {piece, v, at, curve.tangential_load(at), maximum};
}

/// The fold under load control of a model with one at most. R is convex in y and grows with T: the y with R <= 0 are an
/// interval that shrinks as T rises, and folds where its ends meet. A second piece is the lower end alone.
template <class Model>
std::optional<FoldPlace> only_fold(const EquilibriumCurve<Model>& curve) {
  if constexpr (!requires { Model::tangential_load(curve.parameters(), 1.0, 1.0); }) {
    // T of each place costs a search of its own
    const double T = circle_radius(curve.load()) / std::sqrt(Model::small_shear(curve.parameters()));
    if (const auto fold = newton_fold<Model>(curve.parameters(), curve.load(), 0, T))
      return place_at_offset(curve, fold->v);
  }
  const Driven<Model> driven{curve, {Control::Kind::load}};
  const CurvePiece& piece = curve.pieces().front();
  const auto slope = [&](double v) { return driven.slope(curve.position(piece, v)); };
  if (slope(kLast) > 0) return std::nullopt;
  // R_y > 0 above the centre if tau grows with y: no fold there
  const bool simple_top = Model::tau_grows_with_edge_load(curve.parameters()) && piece.y_end < 3 * pi<double>();
  double low = simple_top ? std::max(curve.coordinate(piece, curve.position_at_offset(0)) - kStep, kFirst) : kFirst;
  double high = low;
  for (double step = kStep; high < kLast && slope(high) > 0; step *= 2) {
    low = high;
    high = std::min(high + step, kLast);
  }
  if (!(low < high)) return std::nullopt;
  const double v = root_between(slope, low, high);
  return place_at_coordinate(curve, 0, v, true);
}

/// Under load control: calls found(place) for the folds in order until it returns false. False, without any, if the
/// first lies at less shear than doubles resolve.
template <class Model, class Found>
bool folds_by_angle(const EquilibriumCurve<Model>& curve, Found found) {
  const CurveByAngle<Model> by_angle(curve);
  double x_last = std::numeric_limits<double>::quiet_NaN();
  typename CurveByAngle<Model>::Place last{};
  const auto at = [&](double x) -> const auto& {
    if (x != x_last) last = by_angle.at(x_last = x);
    return last;
  };
  const double from = by_angle.first();
  if (!(at(from).slope > 0)) return false;
  for_sign_changes([&](double x) { return at(x).slope; }, from, CurveByAngle<Model>::kLast,
                   [&](double x) { return CurveByAngle<Model>::step(x, at(x)); },
                   [&](double x, bool maximum) { return found(by_angle.fold(curve, x, maximum)); });
  return true;
}

/// The same under any control, along each piece of the curve; T of each place costs a search of its own.
template <class Model, class Found>
void folds_by_position(const EquilibriumCurve<Model>& curve, Control control, Found found) {
  const Driven<Model> driven{curve, control};
  bool more = true;
  for (std::size_t i = 0; more && i < curve.pieces().size(); ++i) {
    const CurvePiece& piece = curve.pieces()[i];
    const auto slope = [&](double v) { return driven.slope(curve.position(piece, v)); };
    for_sign_changes(
        slope, kFirst, kLast, [](double) { return kStep; },
        [&](double v, bool maximum) { return more = found(place_at_coordinate(curve, i, v, maximum)); });
  }
}

}  // namespace folds_detail

template <class Model>
std::vector<FoldPlace> locate_folds(const EquilibriumCurve<Model>& curve, Control control, std::size_t at_most) {
  using namespace folds_detail;
  std::vector<FoldPlace> folds;
  if (curve.uncoupled()) return folds;
  const bool load = control.kind == Control::Kind::load;
  if constexpr (requires { Model::fold_offset(curve.parameters(), 0.0, true); }) {
    if (control.kind != Control::Kind::stiffness)
      return {place_at_offset(curve, Model::fold_offset(curve.parameters(), curve.load(), !load))};
  }
  // Beyond the largest load nothing is known but rounding.
  const auto add = [&](const FoldPlace& fold) {
    if (fold.T < 0.1 * kFar) folds.push_back(fold);
    return folds.size() < at_most;
  };
  if constexpr (requires { Model::one_fold_at_most(curve.parameters()); }) {
    if (load && Model::one_fold_at_most(curve.parameters())) {
      if (const auto fold = only_fold(curve)) add(*fold);
      return folds;
    }
  }
  if (!load || !folds_by_angle(curve, add)) folds_by_position(curve, control, add);
  return folds;
}

}  // namespace mixity
