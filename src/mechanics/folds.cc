#include "mechanics/folds.h"

#include <algorithm>

#include "mechanics/fold_search.h"
#include "mechanics/roots.h"

namespace mixity {

namespace {

/// A part of a piece on which the contact is stable, in logistic coordinates.
struct Stretch {
  std::size_t piece;
  double from, to;
};

/// The stable parts between the folds. The top of the curve is stable; that of a second piece, from an asymptote, is
/// not.
template <class Law>
std::vector<Stretch> stable_stretches(const std::vector<FoldPlace>& folds, std::size_t pieces) {
  std::vector<Stretch> stable;
  for (std::size_t i = 0; i < pieces; ++i) {
    bool is_stable = i == 0;
    double from = kFirstCoordinate;
    for (const FoldPlace& fold : folds) {
      if (fold.piece != i) continue;
      if (fold.maximum) stable.push_back({i, from, fold.coordinate});
      is_stable = !fold.maximum;
      from = fold.coordinate;
    }
    if (is_stable) stable.push_back({i, from, kLastCoordinate<Law>});
  }
  return stable;
}

}  // namespace

template <class Law>
std::vector<Fold> find_folds(const EquilibriumCurve<Law>& curve, Control control) {
  const Driven<Law> driven{curve, control};
  const std::vector<FoldPlace> places = locate_folds(curve, control);
  const std::vector<Stretch> stable = stable_stretches<Law>(places, curve.pieces().size());
  std::vector<Fold> folds;
  for (const FoldPlace& place : places) {
    const double T = place.T, a = driven.radius(place.position);
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
      // the logarithm, since the value grows without bound towards an asymptote; finite where it is 0
      const auto excess = [&](double v) {
        return std::max(std::log(driven.value(curve.position(piece, v)) / value), -1000.0);
      };
      if (!(excess(s.from) <= 0 && excess(s.to) >= 0)) continue;
      fold.jumps_to = place.maximum ? Jump::lower_branch : Jump::upper_branch;
      fold.area_after = area_from_radius(driven.radius(curve.position(piece, root_between(excess, s.from, s.to))));
      if (place.maximum) break;  // downwards the first stretch is the nearest, upwards the last
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

namespace {
[[gnu::used]] const auto fold_instances = each_law([]<class Law>() { return &find_folds<Law>; });
}  // namespace

}  // namespace mixity
