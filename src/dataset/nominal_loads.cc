#include "dataset/nominal_loads.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "dataset/number_text.h"

namespace mixity {
namespace {

/// Standard deviation of readings about their levels, by the median of the steps between successive ones: few of these
/// lead to another level. Where half of them are 0, the smallest that is not.
double scatter(const std::vector<double>& readings, const std::vector<double>& distinct) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < readings.size(); ++i) steps.push_back(std::abs(readings[i] - readings[i - 1]));
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  constexpr double kMedianOfSteps = 0.9539;  // of the difference of two normal numbers, in standard deviations of one
  if (*middle > 0) return *middle / kMedianOfSteps;
  double least = distinct.back() - distinct.front();
  for (std::size_t i = 1; i < distinct.size(); ++i) least = std::min(least, distinct[i] - distinct[i - 1]);
  return least;
}

/// What lies above each gap of so much between distinct readings.
std::vector<double> behind_gaps(const std::vector<double>& distinct, double gap) {
  std::vector<double> ends;
  for (std::size_t i = 1; i < distinct.size(); ++i)
    if (distinct[i] - distinct[i - 1] > gap) ends.push_back(distinct[i]);
  return ends;
}

/// Whether readings of one level come as loads that were set do: all of one value, then all of another.
bool comes_in_blocks(const std::vector<double>& readings) {
  std::size_t changes = 0;
  for (std::size_t i = 1; i < readings.size(); ++i) changes += readings[i] != readings[i - 1];
  return changes + 1 == std::set<double>(readings.begin(), readings.end()).size() &&
         readings.size() >= 2 * (changes + 1);
}

/// Mean square of successive differences over the variance: 2 for noise, near 0 for a ramp.
double von_neumann_ratio(const std::vector<double>& readings) {
  const double n = static_cast<double>(readings.size());
  const double mean = std::accumulate(readings.begin(), readings.end(), 0.0) / n;
  double steps = 0, squares = 0;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    squares += (readings[i] - mean) * (readings[i] - mean);
    if (i > 0) steps += (readings[i] - readings[i - 1]) * (readings[i] - readings[i - 1]);
  }
  return steps / squares;
}

}  // namespace

std::vector<std::size_t> nominal_levels(const std::vector<double>& readings) {
  constexpr std::size_t kFewSet = 12, kOfEach = 5;
  constexpr double kOneLoad = 0.05, kGap = 6;
  const std::set<double> sorted(readings.begin(), readings.end());
  const std::vector<double> distinct(sorted.begin(), sorted.end());
  if (distinct.size() < 2) return {};
  const double range = distinct.back() - distinct.front();
  const bool one_load = range <= kOneLoad * std::abs(distinct.back() + distinct.front()) / 2;
  // a few loads that come again and again were set
  if (!one_load &&
      (distinct.size() <= 4 || (distinct.size() <= kFewSet && readings.size() >= kOfEach * distinct.size())))
    return {};
  std::vector<double> ends = behind_gaps(distinct, kGap * scatter(readings, distinct));
  const auto level_of = [&](double reading) {
    return static_cast<std::size_t>(std::upper_bound(ends.begin(), ends.end(), reading) - ends.begin());
  };
  std::vector<std::vector<double>> levels(ends.size() + 1);
  for (const double reading : readings) levels[level_of(reading)].push_back(reading);
  // a reading far from the others is no load by itself where all are nearly one
  if (one_load && std::any_of(levels.begin(), levels.end(), [](const auto& level) { return level.size() < kOfEach; })) {
    ends.clear();
    levels = {readings};
  }
  bool scatters = false;
  for (const auto& level : levels) {
    if (std::all_of(level.begin(), level.end(), [&](double one) { return one == level[0]; })) continue;
    if (comes_in_blocks(level)) return {};
    scatters = true;
  }
  if (!scatters) return {};
  if (!one_load && readings.size() < kOfEach * levels.size()) return {};
  // readings that know nothing of each other lie about 2
  if (ends.empty() && !one_load && !(von_neumann_ratio(readings) > 1)) return {};
  std::vector<std::size_t> numbered;
  std::map<std::size_t, std::size_t> number;
  for (const double reading : readings)
    numbered.push_back(number.try_emplace(level_of(reading), number.size()).first->second);
  return numbered;
}

void join_noisy_loads(Dataset& data) {
  std::vector<double> readings;
  for (const Point& point : data.points) readings.push_back(point.P);
  const std::vector<std::size_t> levels = nominal_levels(readings);
  if (levels.empty()) return;
  const std::size_t before = data.curves.size(), count = *std::max_element(levels.begin(), levels.end()) + 1;
  if (count >= before) return;
  std::vector<std::vector<double>> loads(count);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    data.points[i].curve = levels[i];
    loads[levels[i]].push_back(readings[i]);
  }
  data.curves.clear();
  data.curve_loads.clear();
  double scatter = 0;
  const DisplayUnits& units = data.display;
  for (std::vector<double>& level : loads) {
    const double n = static_cast<double>(level.size()), mean = std::accumulate(level.begin(), level.end(), 0.0) / n;
    double squares = 0;
    for (const double load : level) squares += (load - mean) * (load - mean);
    const double deviation = n > 1 ? std::sqrt(squares / (n - 1)) : 0;
    scatter = std::max(scatter, deviation);
    // as many digits as the mean of so many readings has
    const double error = std::max(deviation / std::sqrt(n), 1e-4 * std::abs(mean));
    const int digits = error > 0 && mean != 0 ? static_cast<int>(std::floor(std::log10(std::abs(mean) / error))) : 1;
    std::string name = "P=" + rounded(mean * units.force_scale, std::clamp(digits, 1, 6)) +
                       (units.force.empty() ? "" : " " + units.force);
    for (int same = 2; std::find(data.curves.begin(), data.curves.end(), name) != data.curves.end(); ++same)
      name = name.substr(0, name.find(" (")) + " (" + std::to_string(same) + ")";
    data.curves.push_back(name);
    data.curve_loads.push_back(mean);
  }
  if (count == 1) return;
  data.notes.push_back("readings of P scatter by up to " + rounded(scatter * units.force_scale, 2) +
                       (units.force.empty() ? "" : " " + units.force) + ": taken for " + std::to_string(count) +
                       " runs by their level, each point with the load that was read");
}

void take_mean_loads(Dataset& data) {
  const auto by_run = points_by_curve(data);
  for (std::size_t run = 0; run < by_run.size(); ++run) {
    double sum = 0;
    bool varies = false;
    for (const std::size_t i : by_run[run]) {
      sum += data.points[i].P;
      varies |= data.points[i].P != data.points[by_run[run].front()].P;
    }
    if (varies) data.curve_loads[run] = sum / static_cast<double>(by_run[run].size());
  }
}

}  // namespace mixity
