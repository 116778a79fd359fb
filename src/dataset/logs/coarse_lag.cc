#include "dataset/logs/coarse_lag.h"

#include <algorithm>
#include <cmath>

#include "statistics/noise.h"
#include "statistics/readings.h"

namespace mixity {
namespace {

constexpr double kMostSteps = 1e7;  // of a log: one that pauses for years is not a series of equal steps
constexpr double kSure = 6;         // standard deviations
constexpr double kNearly = 0.85;    // of the best score: another shift with this score makes it ambiguous
constexpr double kApart = 3;        // frames

/// Means over steps of equal duration from the first reading on. A step without readings repeats the last one.
std::vector<double> means_over(const std::vector<double>& time, const std::vector<double>& values, double step) {
  std::vector<double> means;
  std::size_t i = 0;
  for (double t = time.front(); t < time.back(); t += step) {
    double sum = 0;
    std::size_t count = 0;
    for (; i < time.size() && time[i] < t + step; ++i, ++count) sum += values[i];
    means.push_back(count > 0 ? sum / static_cast<double>(count) : means.empty() ? values.front() : means.back());
  }
  return means;
}

/// Times at which T changes suddenly: its means over `step` change within two steps by more than noise and nearby
/// changes explain.
std::vector<double> sudden_changes(const Frames& frames, double step) {
  constexpr double kSudden = 6;  // standard deviations
  constexpr std::size_t kBeside = 10;
  const std::vector<double> T = means_over(frames.force_time, frames.force_T, step);
  std::vector<double> change(T.size());
  for (std::size_t k = 1; k + 1 < T.size(); ++k) change[k] = std::abs(T[k + 1] - T[k - 1]);
  const double noise = noise_of(T) * std::sqrt(2.0);
  std::vector<double> found;
  for (std::size_t k = kBeside; k + kBeside < T.size(); ++k) {
    if (!(change[k] > kSudden * noise)) continue;
    const std::vector<double> around = part_of(change, k - kBeside, k + kBeside + 1);
    if (change[k] < *std::max_element(around.begin(), around.end()) || !(change[k] > 4 * median(around))) continue;
    const double time = frames.force_time.front() + (static_cast<double>(k) + 0.5) * step;
    if (found.empty() || time > found.back() + 0.5 * static_cast<double>(kBeside) * step) found.push_back(time);
  }
  return found;
}

struct Found {
  double lag, sureness;  // s; the score in standard deviations of a score of noise
};

/// The shift, within kLongestLag either way, at which sudden changes of T coincide with drops of A: the middle of the
/// shifts with the largest score, a sum of drops. Null if that is below kSure standard deviations of a noise score, or
/// if another shift scores nearly as much.
std::optional<Found> lag_of(const std::vector<double>& events, const Pictures& shown, double interval) {
  constexpr double kMost = 15;     // standard deviations
  constexpr double kSteps = 20;    // of a frame
  constexpr double kLongRise = 2;  // s
  std::vector<double> touching;    // areas in contact; those out of contact have other noise, or none
  const double largest = *std::max_element(shown.A.begin(), shown.A.end());
  for (const double A : shown.A)
    if (A > 0.3 * largest) touching.push_back(A);
  const double noise = noise_of(touching);
  if (events.empty() || !(noise > 0)) return std::nullopt;
  // by how much the area drops between frames beyond its changes before and after
  std::vector<double> drops(shown.A.size());
  double squares = 0;
  for (std::size_t i = 2; i + 1 < drops.size(); ++i) {
    const auto drop = [&](std::size_t k) { return shown.A[k - 1] - shown.A[k]; };
    const double more = drop(i) - std::max(std::abs(drop(i - 1)), std::abs(drop(i + 1)));
    if (shown.A[i - 1] > 0.3 * largest && shown.A[i] > 0)
      drops[i] = std::clamp(more / (std::sqrt(2.0) * noise), 0.0, kMost);
    squares += std::pow(std::min(drops[i], 3.0), 2);  // limited, to measure noise
  }
  const double by_chance = std::sqrt(squares / static_cast<double>(touching.size()));
  const double step = interval / kSteps;
  const auto half = static_cast<std::ptrdiff_t>(kLongestLag / step);
  std::vector<double> scores(static_cast<std::size_t>(2 * half + 1));
  // The contact loses most area at the drop that ends a long rise; later slips resemble each other.
  std::vector<double> weights;
  double weighed = 0;
  for (std::size_t e = 0; e < events.size(); ++e) {
    weights.push_back(std::sqrt(std::min(1.0, e == 0 ? 1.0 : (events[e] - events[e - 1]) / kLongRise)));
    weighed += weights.back() * weights.back();
  }
  for (std::size_t e = 0; e < events.size(); ++e)
    for (std::ptrdiff_t k = -half; k <= half; ++k) {
      const std::size_t i = index_of(events[e] + static_cast<double>(k) * step, shown.time);
      if (i > 0 && i < shown.time.size()) scores[static_cast<std::size_t>(k + half)] += weights[e] * drops[i];
    }
  const auto best = std::max_element(scores.begin(), scores.end());
  const double sureness = *best / std::max(by_chance * std::sqrt(weighed), 1e-9);
  if (!(sureness > kSure)) return std::nullopt;
  const auto apart = static_cast<std::ptrdiff_t>(kApart * kSteps);
  for (auto other = scores.begin(); other != scores.end(); ++other)
    if (std::abs(other - best) > apart && *other > kNearly * *best) return std::nullopt;
  // the interval of nearly equal scores, since frames do not resolve more
  auto first = best, last = best;
  while (first != scores.begin() && *(first - 1) > 0.98 * *best) --first;
  while (last + 1 != scores.end() && *(last + 1) > 0.98 * *best) ++last;
  const double middle = 0.5 * static_cast<double>((first - scores.begin()) + (last - scores.begin()));
  return Found{(middle - static_cast<double>(half)) * step, sureness};
}

}  // namespace

std::optional<LagByLoad> lag_by_load(const Recording& forces, const Pictures& shown, bool negative) {
  constexpr double kCorrelated = 0.6, kOutOfContact = 0.15;  // share of the time
  constexpr double kCoarse = 0.1, kMany = 2e4;               // s; steps of a log, if that many are not coarser
  const double lasts = std::max(forces.time.back() - forces.time.front(), shown.time.back() - shown.time.front());
  const double step = std::max({typical_step(shown.time) / 2, 0.01, std::min(kCoarse, lasts / kMany)});
  if (lasts > kMostSteps * step) return std::nullopt;
  std::vector<double> load = means_over(forces.time, forces.P, step), area = means_over(shown.time, shown.A, step),
                      sorted = load;
  if (negative) {
    for (double& one : load) one = -one;
    sorted = load;
  }
  const auto zero = sorted.begin() + static_cast<std::ptrdiff_t>(kOutOfContact * static_cast<double>(sorted.size()));
  std::nth_element(sorted.begin(), zero, sorted.end());
  const double rest = *zero;
  for (double& one : load) one = std::copysign(std::cbrt((one - rest) * (one - rest)), one - rest);
  const auto centre = [](std::vector<double>& values) {
    const double middle = mean_of(values, 0, values.size());
    double squares = 0;
    for (double& one : values) {
      one -= middle;
      squares += one * one;
    }
    return std::sqrt(squares);
  };
  const double scale = centre(load) * centre(area);
  const double begin = forces.time.front() - shown.time.front();
  const auto n = static_cast<std::ptrdiff_t>(area.size()), m = static_cast<std::ptrdiff_t>(load.size());
  double best = 0, lag = 0;
  for (auto k = static_cast<std::ptrdiff_t>((-kLongestLag - begin) / step);
       static_cast<double>(k) * step + begin <= kLongestLag; ++k) {  // where the first load is in the grid of the area
    double sum = 0;
    for (std::ptrdiff_t i = std::max<std::ptrdiff_t>(0, -k); i < std::min(m, n - k); ++i)
      sum += load[static_cast<std::size_t>(i)] * area[static_cast<std::size_t>(i + k)];
    if (sum > best) {
      best = sum;
      lag = -(begin - static_cast<double>(k) * step);
    }
  }
  return best > kCorrelated * scale ? std::optional(LagByLoad{lag, best / scale}) : std::nullopt;
}

std::optional<double> lag_by_drops(const Recording& forces, const Recording& areas, const Pictures& shown) {
  const Frames rough = make_frames(forces, areas, 0);
  // by means over a fifth of a frame; if noise hides a drop, over half a frame or a whole one
  std::optional<Found> found;
  for (const double share : {0.2, 0.5, 1.0}) {
    const double step = std::max(share * rough.interval, typical_step(forces.time));
    if (forces.time.back() - forces.time.front() > kMostSteps * step) break;
    const auto one = lag_of(sudden_changes(rough, step), shown, rough.interval);
    if (one && (!found || one->sureness > 1.3 * found->sureness)) found = one;
  }
  return found ? std::optional(found->lag) : std::nullopt;
}

}  // namespace mixity
