#include "solver/basins.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mixity {
namespace {

/// Fractions of the range at which intervals begin. Over a factor of 1000, slopes, curvatures and values may agree by
/// chance although two basins lie between. The same holds near the upper bound: with psi near pi/2 model a has basins
/// at 1 - lambda of about cot^2 psi, too narrow for eight halvings.
constexpr double kShares[] = {1e-12, 1e-6, 3e-5, 1e-3, 0.05, 0.3, 0.7, 1 - 1e-3, 1 - 1e-6};
constexpr int kHalvings = 8;

/// Whether to work in ln x: for intervals that span a large factor.
bool logarithmic(double low, double high) { return low > 0 && high > 4 * low; }

double between(double low, double high) { return logarithmic(low, high) ? std::sqrt(low * high) : 0.5 * (low + high); }

/// True if the cubic through slopes and curvatures at both ends predicts the rise of the cost to a tenth, and changes
/// sign no more often than the slopes at the ends imply.
bool understood(const CostSample& left, const CostSample& right, bool in_logarithm) {
  const double h = in_logarithm ? std::log(right.x / left.x) : right.x - left.x;
  const auto derivatives = [&](const CostSample& at) {  // slope, and curvature times h
    const double dx = in_logarithm ? at.x : 1, slope = at.slope * dx;
    return std::pair(slope, (at.curvature * dx * dx + (in_logarithm ? slope : 0)) * h);
  };
  const auto [s0, c0] = derivatives(left);
  const auto [s1, c1] = derivatives(right);
  const double rise = (right.value - left.value) / h, expected = 0.5 * (s0 + s1) + (c0 - c1) / 12;
  const double rounding = 1e-13 * (left.value + right.value) / h;
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

/// The same in x, or in ln x where the interval spans a large factor.
bool understood(const CostSample& left, const CostSample& right) {
  return !left.finite || !right.finite || understood(left, right, false) ||
         (logarithmic(left.x, right.x) && understood(left, right, true));
}

std::vector<CostSample> sample_range(const std::function<CostSample(double)>& look, double lower, double upper) {
  std::vector<CostSample> samples{look(lower)};
  // appends the samples between the last one and `right`, and then `right`
  const auto refine = [&](auto&& self, const CostSample& right, int depth) -> void {
    if (depth > 0 && !understood(samples.back(), right)) {
      self(self, look(between(samples.back().x, right.x)), depth - 1);
      self(self, right, depth - 1);
    } else {
      samples.push_back(right);
    }
  };
  for (const double share : kShares) refine(refine, look(lower + share * (upper - lower)), kHalvings);
  refine(refine, look(upper), kHalvings);
  return samples;
}

/// Whether the cost falls outwards to this end, or is flat there.
bool falls_to(const CostSample& end, double direction) {
  const double zero = 1e-8 * end.slope_size * std::sqrt(2 * end.value);
  const bool highest = std::abs(end.slope) <= zero && end.curvature < 0;
  return end.finite && !highest && end.slope * direction <= zero;
}

}  // namespace

Basins find_basins(const std::function<CostSample(double)>& look, double lower, double upper) {
  const std::vector<CostSample> samples = sample_range(look, lower, upper);
  std::vector<Basin> found;
  for (const auto& [end, direction] : {std::pair(&samples.front(), -1.0), std::pair(&samples.back(), 1.0)})
    if (falls_to(*end, direction)) found.push_back({end->value, end->x, end->x, end->x});
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    const CostSample &left = samples[i], &right = samples[i + 1];
    const bool falls = left.finite ? left.slope < 0 : right.finite;
    if (!falls || !right.finite || right.slope < 0) continue;
    const CostSample& better = left.finite && left.value < right.value ? left : right;
    const bool at_bound = better.x <= lower || better.x >= upper;
    found.push_back({better.value, at_bound ? between(left.x, right.x) : better.x, left.x, right.x});
  }
  std::vector<const CostSample*> finite;
  for (const CostSample& sample : samples)
    if (sample.finite) finite.push_back(&sample);
  std::sort(finite.begin(), finite.end(), [](auto* one, auto* other) { return one->value > other->value; });
  // If the cost is hardly more than rounding, slopes and values may contradict each other.
  if (found.empty() && !finite.empty()) found.push_back({finite.back()->value, finite.back()->x, lower, lower});
  std::sort(found.begin(), found.end(), [](const Basin& one, const Basin& other) { return one.cost < other.cost; });
  Basins basins{std::move(found), {}};
  for (const CostSample* sample : finite) basins.dearest.push_back(sample->x);
  return basins;
}

}  // namespace mixity
