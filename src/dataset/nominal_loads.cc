#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/number_text.h"
#include "dataset/unnamed_runs.h"
#include "statistics/change_points.h"
#include "statistics/readings.h"

namespace mixity {
namespace {

constexpr std::size_t kFewest = 5;  // readings in a group

/// Standard deviation of readings about their nominal loads, from the median of successive differences, few of which
/// are steps to another load. If half of them are 0, the smallest other difference between readings.
double scatter(const std::vector<double>& readings, const std::vector<double>& distinct) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < readings.size(); ++i) steps.push_back(std::abs(readings[i] - readings[i - 1]));
  constexpr double kMedianOfSteps = 0.9539;  // median of |x - y| for normal x and y, in standard deviations
  if (const double middle = median(std::move(steps)); middle > 0) return middle / kMedianOfSteps;
  double least = distinct.back() - distinct.front();
  for (std::size_t i = 1; i < distinct.size(); ++i) least = std::min(least, distinct[i] - distinct[i - 1]);
  return least;
}

using Limits = std::vector<double>;  // the smallest reading of each group but the first, ascending

std::size_t group_of(double reading, const Limits& limits) {
  return static_cast<std::size_t>(std::upper_bound(limits.begin(), limits.end(), reading) - limits.begin());
}

/// Separates sorted readings into groups at gaps of more than three standard deviations within the groups. With a few
/// normal readings, one in a thousand is so far from the next.
Limits gaps(const std::vector<double>& sorted) {
  constexpr double kGap = 3;
  constexpr std::size_t kMostGroups = 200;
  const std::size_t n = sorted.size();
  std::vector<double> y(n + 1), yy(n + 1);  // sums of readings and of squares
  for (std::size_t i = 0; i < n; ++i) {
    const double one = sorted[i] - sorted[n / 2];
    y[i + 1] = y[i] + one;
    yy[i + 1] = yy[i] + one * one;
  }
  const auto squares = [&](std::size_t i, std::size_t j) {
    return yy[j] - yy[i] - (y[j] - y[i]) * (y[j] - y[i]) / static_cast<double>(j - i);
  };
  std::vector<std::size_t> widest;
  for (std::size_t i = 1; i < n; ++i)
    if (sorted[i] > sorted[i - 1]) widest.push_back(i);
  const auto gap = [&](std::size_t i) { return sorted[i] - sorted[i - 1]; };
  const std::size_t most = std::min({widest.size(), n / kFewest, kMostGroups});
  std::partial_sort(widest.begin(), widest.begin() + static_cast<std::ptrdiff_t>(most), widest.end(),
                    [&](std::size_t one, std::size_t other) { return gap(one) > gap(other); });
  double step = sorted.back() - sorted.front();  // of rounded readings
  for (const std::size_t i : widest) step = std::min(step, gap(i));
  std::set<std::size_t> cuts{0, n};
  double within = squares(0, n);
  std::size_t few = 0;  // groups with too few readings
  std::set<std::size_t> best;
  for (std::size_t k = 0; k < most && few <= 2; ++k) {
    const auto behind = cuts.insert(widest[k]).first;
    const std::size_t at = *behind, from = *std::prev(behind), to = *std::next(behind);
    within += squares(from, at) + squares(at, to) - squares(from, to);
    few += (at - from < kFewest) + (to - at < kFewest) - (to - from < kFewest);
    const double deviation = std::sqrt(std::max(0.0, within) / static_cast<double>(n + 1 - cuts.size()));
    if (few == 0 && gap(at) > kGap * std::max(deviation, step)) best = cuts;
  }
  Limits limits;
  for (const std::size_t at : best)
    if (at > 0 && at < n) limits.push_back(sorted[at]);
  return limits;
}

/// The first reading, and those where the mean changes suddenly by nearly four standard deviations of a reading.
std::vector<std::size_t> sudden_changes(const std::vector<double>& readings, double noise) {
  constexpr std::size_t kMost = 4000, kBeside = 3;
  constexpr double kStep = 3.75;
  const std::size_t n = readings.size(), each = (n + kMost - 1) / kMost;  // readings per mean
  std::vector<double> means;
  for (std::size_t i = 0; i < n; i += each) means.push_back(mean_of(readings, i, std::min(n, i + each)));
  std::vector<std::size_t> changes =
      mean_changes(means, noise * noise / static_cast<double>(each), 4 * std::log(static_cast<double>(n)));
  for (std::size_t& at : changes) at *= each;
  for (std::size_t k = 1; k < changes.size() && each > 1; ++k) {  // refines to a single reading, by least squares
    const std::size_t block = changes[k] / each, from = changes[k] - each, to = std::min(n, changes[k] + each);
    const double one = means[block - std::min<std::size_t>(block, 2)],
                 other = means[std::min(block + 1, means.size() - 1)];
    double sum = 0, least = 0;
    changes[k] = from;
    for (std::size_t i = from; i < to; ++i) {
      sum += (readings[i] - one) * (readings[i] - one) - (readings[i] - other) * (readings[i] - other);
      if (sum < least) {
        least = sum;
        changes[k] = i + 1;
      }
    }
  }
  changes.push_back(n);
  std::vector<std::size_t> sudden{0};
  for (std::size_t k = 1; k + 1 < changes.size(); ++k) {
    const std::size_t at = changes[k];
    if (at - sudden.back() < kBeside || changes[k + 1] - at < kBeside) continue;  // one or two outliers are not a group
    if (std::abs(mean_of(readings, at, at + kBeside) - mean_of(readings, at - kBeside, at)) > kStep * noise)
      sudden.push_back(at);
  }
  return sudden;
}

/// The group of each reading: a segment that begins at one of `begins`, or all segments with equal mean.
std::vector<std::size_t> join_equal(const std::vector<double>& readings, const std::vector<std::size_t>& begins,
                                    double noise) {
  constexpr double kSame = 4;
  std::vector<std::size_t> groups;
  std::vector<double> means;
  for (std::size_t k = 0; k < begins.size(); ++k) {
    const std::size_t end = k + 1 < begins.size() ? begins[k + 1] : readings.size();
    const double mean = mean_of(readings, begins[k], end);
    const auto same =
        std::find_if(means.begin(), means.end(), [&](double one) { return std::abs(one - mean) <= kSame * noise; });
    groups.resize(end, static_cast<std::size_t>(same - means.begin()));
    if (same == means.end()) means.push_back(mean);
  }
  return groups;
}

/// Whether the readings of a group are loads that were set: blocks of equal, all different values.
bool comes_in_blocks(const std::vector<double>& readings) {
  std::size_t changes = 0;
  for (std::size_t i = 1; i < readings.size(); ++i) changes += readings[i] != readings[i - 1];
  return readings.size() >= 2 * (changes + 1) &&
         changes + 1 == std::set<double>(readings.begin(), readings.end()).size();
}

/// Mean square of successive differences over the variance: 2 for noise, near 0 for a ramp.
double von_neumann_ratio(const std::vector<double>& readings) {
  const double mean = mean_of(readings, 0, readings.size());
  double steps = 0, squares = 0;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    squares += (readings[i] - mean) * (readings[i] - mean);
    if (i > 0) steps += (readings[i] - readings[i - 1]) * (readings[i] - readings[i - 1]);
  }
  return steps / squares;
}

}  // namespace

std::vector<std::size_t> group_by_nominal_load(const std::vector<double>& readings) {
  constexpr std::size_t kFewSet = 12;
  constexpr double kOneLoad = 0.05, kDrift = 0.25;  // range of the readings at one load, and its drift, over the mean
  std::vector<double> sorted = readings;
  std::sort(sorted.begin(), sorted.end());
  std::vector<double> distinct = sorted;
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  if (distinct.size() < 2) return {};
  const double range = distinct.back() - distinct.front(), middle = std::abs(distinct.back() + distinct.front()) / 2;
  const bool one_load = range <= kOneLoad * middle;
  // a few recurring loads were set
  if (!one_load &&
      (distinct.size() <= 4 || (distinct.size() <= kFewSet && readings.size() >= kFewest * distinct.size())))
    return {};
  const Limits limits = gaps(sorted);
  std::size_t changes = 0;  // number of changes between groups
  for (std::size_t i = 1; i < readings.size(); ++i)
    changes += group_of(readings[i], limits) != group_of(readings[i - 1], limits);
  std::vector<std::size_t> numbered;
  if (kFewest * changes > readings.size()) {  // the rows are not in order of measurement
    std::map<std::size_t, std::size_t> number;
    for (const double reading : readings)
      numbered.push_back(number.try_emplace(group_of(reading, limits), number.size()).first->second);
  } else {
    const double noise = scatter(readings, distinct);
    numbered = join_equal(readings, sudden_changes(readings, noise), noise);
  }
  std::vector<std::vector<double>> groups(*std::max_element(numbered.begin(), numbered.end()) + 1);
  for (std::size_t i = 0; i < readings.size(); ++i) groups[numbered[i]].push_back(readings[i]);
  bool scatters = false;
  for (const auto& group : groups) {
    if (std::all_of(group.begin(), group.end(), [&](double one) { return one == group[0]; })) continue;
    if (comes_in_blocks(group)) return {};
    scatters = true;
  }
  if (!scatters) return {};
  if (!one_load && readings.size() < kFewest * groups.size()) return {};
  if (groups.size() == 1 && range > kDrift * middle && !(von_neumann_ratio(readings) > 1)) return {};
  return numbered;
}

void join_noisy_loads(Dataset& data) {
  std::vector<double> readings;
  for (const Point& point : data.points) readings.push_back(point.P);
  const std::vector<std::size_t> groups = group_by_nominal_load(readings);
  if (groups.empty()) return;
  const std::size_t before = data.curves.size(), count = *std::max_element(groups.begin(), groups.end()) + 1;
  if (count >= before) return;
  std::vector<std::vector<double>> loads(count);
  for (std::size_t i = 0; i < groups.size(); ++i) {
    data.points[i].curve = static_cast<Point::Index>(groups[i]);
    loads[groups[i]].push_back(readings[i]);
  }
  data.curves.clear();
  data.curve_loads.clear();
  double scatter = 0;
  const DisplayUnits& units = data.display;
  DistinctNames names;
  for (const std::vector<double>& group : loads) {
    const double n = static_cast<double>(group.size()), mean = mean_of(group, 0, group.size());
    double squares = 0;
    for (const double load : group) squares += (load - mean) * (load - mean);
    const double deviation = n > 1 ? std::sqrt(squares / (n - 1)) : 0;
    scatter = std::max(scatter, deviation);
    // only the certain digits of the mean
    const double error = std::max(deviation / std::sqrt(n), 1e-4 * std::abs(mean));
    const int digits = error > 0 && mean != 0 ? static_cast<int>(std::floor(std::log10(std::abs(mean) / error))) : 1;
    const std::string name =
        "P=" + rounded(mean * units.force_scale, std::clamp(digits, 1, 6)) + unit_text(units.force);
    data.curves.push_back(names.free_name(name));
    names.take(data.curves.back());
    data.curve_loads.push_back(mean);
  }
  if (count == 1) return;
  data.notes.push_back("readings of P scatter by up to " + rounded(scatter * units.force_scale, 2) +
                       unit_text(units.force) + ": taken for " + std::to_string(count) +
                       " runs by their level, each point with the load that was read");
}

}  // namespace mixity
