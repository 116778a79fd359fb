// A closer look at the bottom of a basin of the cost.
#pragma once

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "fitting/single_cost.h"

namespace mixity {

/// The lowest place that finer scans find between `low` and `high`, `middle` among them. A cost with a bend for each
/// point that passes the fold of the model's curve has basins much narrower than its envelope, on whose bottom they
/// are. The second scan is wider than the first one's spacing, which may have missed the lowest; the third looks into
/// the lowest basins of the second.
inline double zoomed(SingleCost& cost, double low, double middle, double high, double least) {
  constexpr int kFirst = 64, kSecond = 128, kThird = 16, kReach = 8, kBasins = 4;
  double step = 0;
  const auto look = [&](double from, double to, int places) {
    std::vector<std::pair<double, double>> seen;  // cost, place
    step = (to - from) / (places + 1);
    for (int i = 1; i <= places; ++i) {
      const double x = from + i * step;
      seen.emplace_back(cost.value(x).value_or(std::numeric_limits<double>::infinity()), x);
      if (seen.back().first < least) std::tie(least, middle) = seen.back();
    }
    return seen;
  };
  look(low, high, kFirst);
  const double reach = kReach * step;
  const auto seen = look(std::max(low, middle - reach), std::min(high, middle + reach), kSecond);
  std::vector<std::pair<double, double>> basins;
  for (std::size_t i = 1; i + 1 < seen.size(); ++i)
    if (seen[i].first <= seen[i - 1].first && seen[i].first < seen[i + 1].first) basins.push_back(seen[i]);
  std::sort(basins.begin(), basins.end());
  if (basins.size() > kBasins) basins.resize(kBasins);
  const double width = step;
  for (const auto& [ignored, x] : basins) look(x - width, x + width, kThird);
  return middle;
}

}  // namespace mixity
