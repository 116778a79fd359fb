#include "report/figures/regime_regions.h"

#include <algorithm>
#include <list>

namespace mixity {
namespace {

constexpr std::size_t kRows = 64;
constexpr int kHalvings = 12;  // of a row: boundaries come out smooth

/// A regime's extent at one load, as parts 0..1 of the axis of lambda.
struct Extent {
  Regime regime;
  double low, high;
};

std::vector<Extent> extents(const std::function<Regime(double)>& classify_at) {
  std::vector<Extent> column{{classify_at(0), 0, 0}};
  for (std::size_t j = 1; j <= kRows; ++j) {
    const double part = static_cast<double>(j) / kRows;
    const Regime here = classify_at(part);
    if (here == column.back().regime) continue;
    double low = static_cast<double>(j - 1) / kRows, high = part;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (low + high);
      (classify_at(middle) == column.back().regime ? low : high) = middle;
    }
    column.back().high = high;
    column.push_back({here, high, 0});
  }
  column.back().high = 1;
  return column;
}

/// One connected region of the map: its lower and upper boundary from left to right.
struct Region {
  Regime regime;
  std::vector<std::pair<double, double>> lower, upper;  // (load, part)
  Extent last;
  bool open = true;
};

/// Extents of neighbouring loads belong together where they overlap.
std::list<Region> connected(const std::vector<double>& loads, const std::vector<std::vector<Extent>>& columns) {
  std::list<Region> all;
  const double half = 0.5 * (loads[1] - loads[0]);
  for (std::size_t i = 0; i < loads.size(); ++i) {
    std::vector<Region*> grown;
    for (const Extent& extent : columns[i]) {
      const auto found = std::find_if(all.begin(), all.end(), [&](const Region& region) {
        return region.open && region.regime == extent.regime && region.last.low < extent.high &&
               extent.low < region.last.high && std::find(grown.begin(), grown.end(), &region) == grown.end();
      });
      Region& region = found != all.end() ? *found : all.emplace_back(Region{extent.regime, {}, {}, extent});
      if (region.lower.empty() && i > 0) {  // begins between two columns
        region.lower.emplace_back(loads[i] - half, extent.low);
        region.upper.emplace_back(loads[i] - half, extent.high);
      }
      region.lower.emplace_back(loads[i], extent.low);
      region.upper.emplace_back(loads[i], extent.high);
      region.last = extent;
      grown.push_back(&region);
    }
    for (Region& region : all)
      if (region.open && std::find(grown.begin(), grown.end(), &region) == grown.end()) {
        region.open = false;
        region.lower.emplace_back(loads[i] - half, region.last.low);
        region.upper.emplace_back(loads[i] - half, region.last.high);
      }
  }
  return all;
}

}  // namespace

const char* regime_text(Regime regime) {
  switch (regime) {
    case Regime::asymptote:
      return "1 shrinks, never to Hertz";
    case Regime::hertz:
      return "2 shrinks to Hertz";
    case Regime::jump:
      return "3 jumps";
    case Regime::strength:
      break;
  }
  return "4 slides first";
}

std::vector<RegimeRegion> regime_regions(const std::vector<double>& loads,
                                         const std::function<Regime(double part, double load)>& at) {
  std::vector<std::vector<Extent>> columns;
  for (const double load : loads) columns.push_back(extents([&](double part) { return at(part, load); }));
  std::vector<RegimeRegion> all;
  for (Region& region : connected(loads, columns)) {
    region.lower.insert(region.lower.end(), region.upper.rbegin(), region.upper.rend());
    all.push_back({region.regime, std::move(region.lower)});
  }
  return all;
}

}  // namespace mixity
