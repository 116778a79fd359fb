// The map of what becomes of a contact, as regions with outlines.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "mechanics/regimes.h"

namespace mixity {

/// "3 jumps"
const char* regime_text(Regime regime);

/// A connected region of one regime, over loads and the parts 0..1 of an axis of lambda.
struct RegimeRegion {
  Regime regime;
  std::vector<std::pair<double, double>> outline;  // (load, part), closed
};

/// Loads evenly spaced, two at least. `at` is asked for the regime at a part and a load.
std::vector<RegimeRegion> regime_regions(const std::vector<double>& loads,
                                         const std::function<Regime(double part, double load)>& at);

}  // namespace mixity
