// Where the folds are: locate_folds of folds.h. Included by it only.
#pragma once

#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <optional>

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

/// Calls found(v) for the sign changes of f on [from, kLast], in order, until it returns false.
template <class F, class Found>
void for_sign_changes(F f, double from, Found found) {
  double before = 0, here = f(from);
  bool has_before = false;
  for (int i = 0; from + i * kStep < kLast; ++i) {
    const double v = from + i * kStep;
    const double next = f(v + kStep);
    const bool crosses = (here > 0) != (next > 0);
    const double sign = here > 0 ? 1 : -1;
    if (crosses) {
      if (!found(root_between(f, v, v + kStep))) return;
    } else if (has_before && sign * before > sign * here && sign * next > sign * here) {
      const auto dip =
          boost::math::tools::brent_find_minima([&](double x) { return sign * f(x); }, v - kStep, v + kStep, 50);
      if (dip.second < -kRounding) {
        if (!found(root_between(f, v - kStep, dip.first))) return;
        if (!found(root_between(f, dip.first, v + kStep))) return;
      }
    }
    has_before = !crosses;
    before = here;
    here = next;
  }
}

/// y - 3 pi at the fold under load control of a model with one at most: Newton's method on R = R_y = 0 in y and T, of
/// which R's derivatives in T follow from its homogeneity. Null if it leaves y > 0 (the curve may reach Hertz without a
/// fold) or does not settle.
template <class Model>
std::optional<double> newton_fold(const Parameters<Model>& p, double P) {
  constexpr double eps = std::numeric_limits<double>::epsilon();
  const double S0 = circle_radius(P), y_least = 1e-3 * std::abs(P);
  double v = 0, T = S0 / std::sqrt(Model::small_shear(p));
  for (int i = 0; i < 30; ++i) {
    const double y = 3 * pi<double>() + v;
    if (!(y > y_least && T > 0 && T < kFar)) return std::nullopt;
    const ShearTerm<double> tau2 = Model::shear_term(p, y, T);
    const double R = (v - S0) * (v + S0) + tau2.value, R_y = 2 * v + tau2.d1, R_yy = 2 + tau2.d2;
    const double R_T = (2 * tau2.value - y * tau2.d1) / T, R_yT = (tau2.d1 - y * tau2.d2) / T;
    const double determinant = R_y * R_yT - R_T * R_yy;
    const double dv = (R_y * R_T - R * R_yT) / determinant, dT = (R * R_yy - R_y * R_y) / determinant;
    v += dv;
    T += dT;
    if (std::abs(dv) <= 4 * eps * S0 && std::abs(dT) <= 1e-8 * T) return v;  // Newton squares what is left of T
  }
  return std::nullopt;
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

/// Under load control R_y > 0 above the centre if tau grows with y: no fold there. Else from the top.
template <class Model>
double first_coordinate(const EquilibriumCurve<Model>& curve, std::size_t piece, const Control& control) {
  const CurvePiece& part = curve.pieces()[piece];
  const bool simple_top = control.kind == Control::Kind::load && piece == 0 &&
                          Model::tau_grows_with_edge_load(curve.parameters()) && part.y_end < 3 * pi<double>();
  return simple_top ? std::max(curve.coordinate(part, curve.position_at_offset(0)) - kStep, kFirst) : kFirst;
}

template <class Model>
FoldPlace place_at_offset(const EquilibriumCurve<Model>& curve, std::size_t piece, double offset) {
  const CurvePosition at = curve.position_at_offset(offset);
  return {piece, curve.coordinate(curve.pieces()[piece], at), at, true};
}

/// The fold under load control of a model with one at most. R is convex in y and grows with T: the y with R <= 0 are an
/// interval that shrinks as T rises, and folds where its ends meet. A second piece is the lower end alone.
template <class Model>
std::optional<FoldPlace> only_fold(const EquilibriumCurve<Model>& curve) {
  if constexpr (!requires { Model::tangential_load(curve.parameters(), 1.0, 1.0); }) {
    // T of each place costs a search of its own
    if (const auto offset = newton_fold<Model>(curve.parameters(), curve.load()))
      return place_at_offset(curve, 0, *offset);
  }
  const Driven<Model> driven{curve, {Control::Kind::load}};
  const CurvePiece& piece = curve.pieces().front();
  const auto slope = [&](double v) { return driven.slope(curve.position(piece, v)); };
  if (slope(kLast) > 0) return std::nullopt;
  double low = first_coordinate(curve, 0, driven.control), high = low;
  for (double step = kStep; high < kLast && slope(high) > 0; step *= 2) {
    low = high;
    high = std::min(high + step, kLast);
  }
  if (!(low < high)) return std::nullopt;
  const double v = root_between(slope, low, high);
  return FoldPlace{0, v, curve.position(piece, v), true};
}

}  // namespace folds_detail

template <class Model>
std::vector<FoldPlace> locate_folds(const EquilibriumCurve<Model>& curve, Control control, std::size_t at_most) {
  using namespace folds_detail;
  std::vector<FoldPlace> folds;
  // Beyond the largest load nothing is known but rounding.
  const auto add = [&](const FoldPlace& fold) {
    if (curve.tangential_load(fold.position) < 0.1 * kFar) folds.push_back(fold);
  };
  if constexpr (requires { Model::one_fold_at_most(curve.parameters()); }) {
    if (control.kind == Control::Kind::load && Model::one_fold_at_most(curve.parameters())) {
      if (curve.pieces().empty()) return folds;
      if (const auto fold = only_fold(curve)) add(*fold);
      return folds;
    }
  }
  const Driven<Model> driven{curve, control};
  for (std::size_t i = 0; i < curve.pieces().size(); ++i) {
    const CurvePiece& piece = curve.pieces()[i];
    if constexpr (requires { Model::fold_offset(curve.parameters(), 0.0, true); }) {
      if (control.kind != Control::Kind::stiffness) {
        const bool displacement = control.kind == Control::Kind::displacement;
        folds.push_back(place_at_offset(curve, i, Model::fold_offset(curve.parameters(), curve.load(), displacement)));
        continue;
      }
    }
    const auto slope = [&](double v) { return driven.slope(curve.position(piece, v)); };
    const double from = first_coordinate(curve, i, control);
    bool stable = slope(from) > 0;
    for_sign_changes(slope, from, [&](double v) {
      add({i, v, curve.position(piece, v), stable});
      stable = !stable;
      return folds.size() < at_most;
    });
    if (folds.size() >= at_most) break;
  }
  return folds;
}

}  // namespace mixity
