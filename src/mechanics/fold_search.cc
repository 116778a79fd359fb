#include "mechanics/fold_search.h"

#include <cmath>
#include <limits>
#include <tuple>

#include "mechanics/roots.h"

namespace mixity {
namespace {

// Steps of the logistic coordinate. The fine one, for non-monotone laws, is about 2 degrees of psi.
constexpr double kStep = 0.25, kFineStep = 0.0625;

template <class Law>
FoldPlace place_at_offset(const EquilibriumCurve<Law>& curve, double offset) {
  const CurvePosition at = curve.position_at_offset(offset);
  return {0, curve.coordinate(curve.pieces()[0], at), at, curve.tangential_load(at), true};
}

template <class Law>
FoldPlace place_at_coordinate(const EquilibriumCurve<Law>& curve, std::size_t piece, double v, bool maximum) {
  const CurvePosition at = curve.position(curve.pieces()[piece], v);
  return {piece, v, at, curve.tangential_load(at), maximum};
}

/// The fold under load control for a model with at most one. R is convex in y and grows with T: the y with R <= 0 form
/// an interval that shrinks as T rises; the fold is where its ends meet. A second piece is only the lower end.
template <class Law>
std::optional<FoldPlace> only_fold(const EquilibriumCurve<Law>& curve) {
  if constexpr (!requires { curve.law().tangential_load(curve.parameters(), 1.0, 1.0); }) {
    // T of each position needs an iteration
    const double T = circle_radius(curve.load()) / std::sqrt(curve.law().small_shear(curve.parameters()));
    if (const auto fold = newton_fold(curve.law(), curve.parameters(), curve.load(), 0, T))
      return place_at_offset(curve, fold->v);
  }
  const Driven<Law> driven{curve, {Control::Kind::load}};
  const CurvePiece& piece = curve.pieces().front();
  const auto slope = [&](double v) { return driven.slope(curve.position(piece, v)); };
  if (slope(kLastCoordinate<Law>) > 0) return std::nullopt;
  // R_y > 0 above the centre if tau grows with y: no fold there
  const bool simple_top = curve.law().tau_grows_with_edge_load(curve.parameters()) && piece.y_end < 3 * pi<double>();
  double low = simple_top ? std::max(curve.coordinate(piece, curve.position_at_offset(0)) - kStep, kFirstCoordinate)
                          : kFirstCoordinate;
  double high = low;
  for (double step = kStep; high < kLastCoordinate<Law> && slope(high) > 0; step *= 2) {
    low = high;
    high = std::min(high + step, kLastCoordinate<Law>);
  }
  if (!(low < high)) return std::nullopt;
  const double v = root_between(slope, low, high);
  return place_at_coordinate(curve, 0, v, true);
}

}  // namespace

template <class Law>
void folds_by_position(const EquilibriumCurve<Law>& curve, Control control, FoundFolds& found) {
  const Driven<Law> driven{curve, control};
  bool more = true;
  for (std::size_t i = 0; more && i < curve.pieces().size(); ++i) {
    const CurvePiece& piece = curve.pieces()[i];
    const auto slope = [&](double v) { return driven.slope(curve.position(piece, v)); };
    for_sign_changes(
        slope, kFirstCoordinate, kLastCoordinate<Law>, kShallow,
        [&](double) { return curve.non_monotone() ? kFineStep : kStep; },
        [&](double v, bool maximum) { return more = found.add(place_at_coordinate(curve, i, v, maximum)); });
  }
}

template <class Law>
std::vector<FoldPlace> locate_folds(const EquilibriumCurve<Law>& curve, Control control, std::size_t at_most) {
  if (curve.uncoupled()) return {};
  const bool load = control.kind == Control::Kind::load;
  if constexpr (requires { curve.law().fold_offset(curve.parameters(), 0.0, true); }) {
    if (control.kind != Control::Kind::stiffness)
      return {place_at_offset(curve, curve.law().fold_offset(curve.parameters(), curve.load(), !load))};
  }
  FoundFolds found{at_most};
  if constexpr (requires { curve.law().one_fold_at_most(curve.parameters()); }) {
    if (load && curve.law().one_fold_at_most(curve.parameters())) {
      if (const auto fold = only_fold(curve)) found.add(*fold);
      return found.places;
    }
  }
  if (!load || curve.non_monotone() || !folds_by_angle(curve, found)) folds_by_position(curve, control, found);
  if constexpr (kMayBeNonMonotone<Law>) {
    // pairs of folds at the same T are rounding, where T approaches a constant
    constexpr double kSame = 1e-12;
    std::vector<FoldPlace> apart;
    for (const FoldPlace& place : found.places) {
      if (load && !apart.empty() && apart.back().maximum != place.maximum &&
          std::abs(apart.back().T - place.T) <= kSame * place.T)
        apart.pop_back();
      else
        apart.push_back(place);
    }
    found.places = std::move(apart);
  }
  return found.places;
}

namespace {
[[gnu::used]] const auto search_instances =
    each_law([]<class Law>() { return std::tuple(&locate_folds<Law>, &folds_by_position<Law>); });
}  // namespace

}  // namespace mixity
