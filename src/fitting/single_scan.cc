#include "fitting/single_scan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace mixity {
namespace {

struct Place {
  double x;
  CostValue cost;
};

/// Fractions of the range: few where intervals are halved as needed, else enough to do without. Over a factor of 1000
/// slopes, curvatures and values may agree by chance, with two basins in between. Towards the upper bound, too: with
/// psi next to pi/2 model a has basins at 1 - lambda of some cot^2 psi, too narrow for eight halvings.
constexpr double kCoarse[] = {1e-12, 1e-6, 3e-5, 1e-3, 0.05, 0.3, 0.7, 1 - 1e-3, 1 - 1e-6};
constexpr double kFine[] = {1e-12, 1e-9, 1e-7, 1e-6, 1e-5, 1e-4, 3e-4, 1e-3, 3e-3, 0.01, 0.02, 0.04, 0.07,
                            0.12,  0.2,  0.3,  0.4,  0.5,  0.6,  0.7,  0.8,  0.88, 0.94, 0.97, 0.99};

/// Intervals over a larger factor are looked at in ln x, towards a bound of 0.
bool logarithmic(double low, double high) { return low > 0 && high > 4 * low; }

/// True if the cubic through slopes and curvatures of both ends gives the rise of the cost to a tenth of its size, and
/// changes sign no more often than the slopes at the ends show.
bool understood(const Place& left, const Place& right, bool in_logarithm) {
  const double h = in_logarithm ? std::log(right.x / left.x) : right.x - left.x;
  const auto derivatives = [&](const Place& place) {  // slope, and curvature times h
    const double dx = in_logarithm ? place.x : 1, slope = place.cost.slope * dx;
    return std::pair(slope, (place.cost.curvature * dx * dx + (in_logarithm ? slope : 0)) * h);
  };
  const auto [s0, c0] = derivatives(left);
  const auto [s1, c1] = derivatives(right);
  const double rise = (right.cost.value - left.cost.value) / h, expected = 0.5 * (s0 + s1) + (c0 - c1) / 12;
  const double rounding = 1e-13 * (left.cost.value + right.cost.value) / h;
  if (std::abs(rise - expected) > 0.1 * std::max(std::abs(s0), std::abs(s1)) + rounding) return false;
  int changes = 0;
  bool up = s0 > 0;
  for (int i = 1; i <= 8; ++i) {
    const double t = i / 8.0, u = 1 - t;
    const double slope = u * u * ((1 + 2 * t) * s0 + t * c0) + t * t * ((1 + 2 * u) * s1 - u * c1);
    changes += (slope > 0) != up;
    up = slope > 0;
  }
  return changes <= 1;
}

/// In x, or where the interval spans a larger factor, in ln x.
bool understood(const Place& left, const Place& right) {
  return !left.cost.finite || !right.cost.finite || understood(left, right, false) ||
         (logarithmic(left.x, right.x) && understood(left, right, true));
}

double between(double low, double high) { return logarithmic(low, high) ? std::sqrt(low * high) : 0.5 * (low + high); }

}  // namespace

bool lowest_at_bound(SingleCost& cost, const FreeParameter& parameter, double bound) {
  const auto at_bound = cost.value(bound);
  if (!at_bound) return false;
  const double inwards = (bound == parameter.lower ? 1 : -1) * (parameter.upper - parameter.lower);
  for (const double share : {1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2})
    if (const auto inside = cost.value(bound + share * inwards); inside && *inside < *at_bound * (1 - 1e-13))
      return false;
  return true;
}

SingleScan scan_basins(SingleCost& cost, const FreeParameter& parameter) {
  std::vector<Place> places;
  const auto add = [&](double x) { places.push_back({x, cost.at(x, {})}); };
  // appends what lies between the last place and `right`, and that
  const auto refine = [&](auto&& self, const Place& right, int depth) -> void {
    if (depth > 0 && !understood(places.back(), right)) {
      const double x = between(places.back().x, right.x);
      self(self, {x, cost.at(x, {})}, depth - 1);
      self(self, right, depth - 1);
    } else {
      places.push_back(right);
    }
  };
  const double width = parameter.upper - parameter.lower;
  add(parameter.lower);
  const auto go_on = [&](double x) { refine(refine, {x, cost.at(x, {})}, cost.exact_curvature() ? 8 : 0); };
  if (cost.exact_curvature())
    for (const double share : kCoarse) go_on(parameter.lower + share * width);
  else
    for (const double share : kFine) go_on(parameter.lower + share * width);
  go_on(parameter.upper);

  SingleScan scan{{}, std::numeric_limits<double>::infinity(), 0};
  for (const Place& place : places) {
    if (!place.cost.finite) continue;
    scan.lowest = std::min(scan.lowest, place.cost.value);
    scan.highest = std::max(scan.highest, place.cost.value);
  }
  // Outwards, or not to be told from zero
  const auto falls_to = [&](const Place& end, double direction) {
    const CostValue& at = end.cost;
    const double zero = 1e-8 * at.slope_size * std::sqrt(at.value);
    const bool highest = cost.exact_curvature() && std::abs(at.slope) <= zero && at.curvature < 0;
    return at.finite && !highest && at.slope * direction <= zero;
  };
  for (const auto& [end, direction] : {std::pair(&places.front(), -1.0), std::pair(&places.back(), 1.0)})
    if (falls_to(*end, direction) && lowest_at_bound(cost, parameter, end->x))
      scan.basins.push_back({end->x, end->x, end->x, end->cost.value});
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const Place &left = places[i], &right = places[i + 1];
    const bool falls = left.cost.finite ? left.cost.slope < 0 : right.cost.finite;
    if (!falls || !right.cost.finite || right.cost.slope < 0) continue;
    const Place& better = left.cost.finite && left.cost.value < right.cost.value ? left : right;
    const bool at_bound = better.x <= parameter.lower || better.x >= parameter.upper;
    scan.basins.push_back({left.x, right.x, at_bound ? between(left.x, right.x) : better.x, better.cost.value});
  }
  if (scan.basins.empty() && std::isfinite(scan.lowest)) {
    // Where the cost is hardly more than rounding, its slopes and values may contradict each other.
    const auto lowest = std::find_if(places.begin(), places.end(), [&](const Place& place) {
      return place.cost.finite && place.cost.value == scan.lowest;
    });
    const double low = lowest == places.begin() ? lowest->x : (lowest - 1)->x;
    const double high = lowest + 1 == places.end() ? lowest->x : (lowest + 1)->x;
    const bool at_bound = low == lowest->x || high == lowest->x;
    scan.basins.push_back({at_bound ? lowest->x : low, at_bound ? lowest->x : high, lowest->x, scan.lowest});
  }
  std::sort(scan.basins.begin(), scan.basins.end(),
            [](const Basin& one, const Basin& other) { return one.cost < other.cost; });
  return scan;
}

}  // namespace mixity
