// Definitions of folds.h. Included by it only.
#pragma once

#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>

namespace mixity {

inline std::string_view to_string(Control::Kind kind) {
  switch (kind) {
    case Control::Kind::load:
      return "load";
    case Control::Kind::displacement:
      return "displacement";
    case Control::Kind::stiffness:
      break;
  }
  return "stiffness";
}

inline std::string_view to_string(Jump jump) {
  switch (jump) {
    case Jump::hertz:
      return "hertz";
    case Jump::lower_branch:
      return "lower_branch";
    case Jump::upper_branch:
      return "upper_branch";
    case Jump::off_contact:
      break;
  }
  return "off_contact";
}

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
  for (double v = from; v < kLast; v += kStep) {
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

/// Part of a piece on which the contact is stable, in logistic coordinates.
struct Stretch {
  std::size_t piece;
  double from, to;
};

/// What lies between the folds and is stable. The top of the curve is; a second piece, from an asymptote, is not.
inline std::vector<Stretch> stable_stretches(const std::vector<FoldPlace>& folds, std::size_t pieces) {
  std::vector<Stretch> stable;
  for (std::size_t i = 0; i < pieces; ++i) {
    bool is_stable = i == 0;
    double from = kFirst;
    for (const FoldPlace& fold : folds) {
      if (fold.piece != i) continue;
      if (fold.maximum) stable.push_back({i, from, fold.coordinate});
      is_stable = !fold.maximum;
      from = fold.coordinate;
    }
    if (is_stable) stable.push_back({i, from, kLast});
  }
  return stable;
}

}  // namespace folds_detail

template <class Model>
std::vector<FoldPlace> locate_folds(const EquilibriumCurve<Model>& curve, Control control, std::size_t at_most) {
  using namespace folds_detail;
  std::vector<FoldPlace> folds;
  const Driven<Model> driven{curve, control};
  for (std::size_t i = 0; i < curve.pieces().size(); ++i) {
    const CurvePiece& piece = curve.pieces()[i];
    if constexpr (requires { Model::fold_offset(curve.parameters(), 0.0, true); }) {
      if (control.kind != Control::Kind::stiffness) {
        const bool displacement = control.kind == Control::Kind::displacement;
        const CurvePosition at =
            curve.position_at_offset(Model::fold_offset(curve.parameters(), curve.load(), displacement));
        folds.push_back({i, curve.coordinate(piece, at), at, true});
        continue;
      }
    }
    const auto add = [&](double v, bool maximum) {
      const CurvePosition at = curve.position(piece, v);
      // Beyond the largest load nothing is known but rounding.
      if (curve.tangential_load(at) < 0.1 * kFar) folds.push_back({i, v, at, maximum});
    };
    const auto slope = [&](double v) { return driven.slope(curve.position(piece, v)); };
    // R_y > 0 above the centre if tau grows with y: no fold under load control there.
    const bool simple_top = control.kind == Control::Kind::load && i == 0 &&
                            Model::tau_grows_with_edge_load(curve.parameters()) && piece.y_end < 3 * pi<double>();
    const double from =
        simple_top ? std::max(curve.coordinate(piece, curve.position_at_offset(0)) - kStep, kFirst) : kFirst;
    if constexpr (requires { Model::one_fold_at_most(curve.parameters()); }) {
      // R is then convex in y and grows with T: the y with R <= 0 are an interval that shrinks as T rises, and the one
      // place where its ends meet is the only fold. A second piece is the lower end alone.
      if (control.kind == Control::Kind::load && Model::one_fold_at_most(curve.parameters())) {
        if (slope(from) > 0 && slope(kLast) <= 0) add(root_between(slope, from, kLast), true);
        break;
      }
    }
    bool stable = slope(from) > 0;
    for_sign_changes(slope, from, [&](double v) {
      add(v, stable);
      stable = !stable;
      return folds.size() < at_most;
    });
    if (folds.size() >= at_most) break;
  }
  return folds;
}

template <class Model>
std::vector<Fold> find_folds(const EquilibriumCurve<Model>& curve, Control control) {
  using namespace folds_detail;
  const Driven<Model> driven{curve, control};
  const std::vector<FoldPlace> places = locate_folds(curve, control);
  const std::vector<Stretch> stable = stable_stretches(places, curve.pieces().size());
  std::vector<Fold> folds;
  for (const FoldPlace& place : places) {
    const double T = curve.tangential_load(place.position), a = driven.radius(place.position);
    Fold fold{control,
              place,
              T,
              0.75 * T / a,
              area_from_radius(a),
              phase_angle(mixity_from_loads(place.position.y, T)),
              Jump::off_contact,
              0,
              0};
    const double value = driven.value(place.position);
    for (const Stretch& s : stable) {
      const bool beyond = place.maximum ? s.piece > place.piece || s.from >= place.coordinate
                                        : s.piece == place.piece && s.to <= place.coordinate;
      if (!beyond) continue;
      const CurvePiece& piece = curve.pieces()[s.piece];
      // in the logarithm, since towards an asymptote the value grows over all bounds; finite where it is 0
      const auto excess = [&](double v) {
        return std::max(std::log(driven.value(curve.position(piece, v)) / value), -1000.0);
      };
      if (!(excess(s.from) <= 0 && excess(s.to) >= 0)) continue;
      fold.jumps_to = place.maximum ? Jump::lower_branch : Jump::upper_branch;
      fold.area_after = area_from_radius(driven.radius(curve.position(piece, root_between(excess, s.from, s.to))));
      if (place.maximum) break;  // the first met going down; going up, the last, which lies nearest
    }
    if (fold.jumps_to == Jump::off_contact && curve.load() > 0) {
      fold.jumps_to = Jump::hertz;
      fold.area_after = area_from_radius(hertz_radius(curve.load()));
    }
    fold.area_lost = fold.A - fold.area_after;
    folds.push_back(fold);
  }
  return folds;
}

}  // namespace mixity
