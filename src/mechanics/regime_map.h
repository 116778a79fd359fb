// The map of what becomes of a contact, as regions with outlines.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "mechanics/states.h"

namespace mixity {

/// "3 jumps"
const char* regime_text(Regime regime);

/// A regime along one line of a map; null: the law defines no unique equilibrium there.
struct RegimeExtent {
  std::optional<Regime> regime;
  double from, to;
};

/// A connected region of one regime: its outline, closed, as (place of the line, place on it).
struct RegimeRegion {
  std::optional<Regime> regime;
  std::vector<std::pair<double, double>> outline;
};

/// From lines at these coordinates in ascending order, two at least, each filled by its extents in order.
std::vector<RegimeRegion> connected_regions(const std::vector<double>& places,
                                            const std::vector<std::vector<RegimeExtent>>& lines);

/// Lines at the loads, along the parts 0..1 of an axis of lambda. `at` is asked for the regime at a part and a load.
std::vector<RegimeRegion> regime_regions(const std::vector<double>& loads,
                                         const std::function<Regime(double part, double load)>& at);

}  // namespace mixity
