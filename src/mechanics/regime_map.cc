#include "mechanics/regime_map.h"

#include <algorithm>
#include <list>

namespace mixity {
namespace {

constexpr std::size_t kRows = 64;
constexpr int kHalvings = 12;  // of a row: boundaries come out smooth

std::vector<RegimeExtent> extents(const std::function<Regime(double)>& classify_at) {
  std::vector<RegimeExtent> column{{classify_at(0), 0, 0}};
  for (std::size_t j = 1; j <= kRows; ++j) {
    const double part = static_cast<double>(j) / kRows;
    const Regime here = classify_at(part);
    if (here == column.back().regime) continue;
    double low = static_cast<double>(j - 1) / kRows, high = part;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (low + high);
      (classify_at(middle) == column.back().regime ? low : high) = middle;
    }
    column.back().to = high;
    column.push_back({here, high, 0});
  }
  column.back().to = 1;
  return column;
}

/// A region while it grows: its lower and upper boundary, from line to line.
struct Growing {
  std::optional<Regime> regime;
  std::vector<std::pair<double, double>> lower{}, upper{};  // (place of the line, place on it)
  RegimeExtent last{};
  bool open = true;

  void add(double place, const RegimeExtent& extent) {
    lower.emplace_back(place, extent.from);
    upper.emplace_back(place, extent.to);
    last = extent;
  }
};

bool overlap(const RegimeExtent& one, const RegimeExtent& other) { return one.from < other.to && other.from < one.to; }

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

std::vector<RegimeRegion> connected_regions(const std::vector<double>& places,
                                            const std::vector<std::vector<RegimeExtent>>& lines) {
  std::list<Growing> all;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double before = i > 0 ? 0.5 * (places[i - 1] + places[i]) : places[0];
    std::vector<Growing*> grown;
    for (const RegimeExtent& extent : lines[i]) {
      const auto found = std::find_if(all.begin(), all.end(), [&](const Growing& region) {
        return region.open && region.regime == extent.regime && overlap(region.last, extent) &&
               std::find(grown.begin(), grown.end(), &region) == grown.end();
      });
      Growing& region = found != all.end() ? *found : all.emplace_back(Growing{extent.regime});
      if (found == all.end() && i > 0) region.add(before, extent);  // begins between two lines
      region.add(places[i], extent);
      grown.push_back(&region);
    }
    for (Growing& region : all)
      if (region.open && std::find(grown.begin(), grown.end(), &region) == grown.end()) {
        region.open = false;
        region.add(before, region.last);
      }
  }
  std::vector<RegimeRegion> regions;
  for (Growing& region : all) {
    region.lower.insert(region.lower.end(), region.upper.rbegin(), region.upper.rend());
    regions.push_back({region.regime, std::move(region.lower)});
  }
  return regions;
}

std::vector<RegimeRegion> regime_regions(const std::vector<double>& loads,
                                         const std::function<Regime(double part, double load)>& at) {
  std::vector<std::vector<RegimeExtent>> columns;
  for (const double load : loads) columns.push_back(extents([&](double part) { return at(part, load); }));
  return connected_regions(loads, columns);
}

}  // namespace mixity
