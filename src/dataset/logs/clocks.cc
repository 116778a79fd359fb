#include "dataset/logs/clocks.h"

#include <algorithm>
#include <cmath>

#include "base/input_error.h"
#include "base/number_text.h"
#include "dataset/logs/loading_runs.h"
#include "dataset/logs/onset.h"
#include "statistics/change_points.h"
#include "statistics/noise.h"
#include "statistics/readings.h"

namespace mixity {
namespace {

constexpr double kLongest = 30;             // s, the largest lag in either direction
constexpr double kNearLoad = 0.4;           // s, about the lag by the load
constexpr double kSure = 6, kSureNear = 4;  // standard deviations: of few shifts, fewer are high by chance
constexpr double kNearly = 0.85;            // of the best score: another shift with this score makes it ambiguous
constexpr double kApart = 3;                // frames

/// Means over steps of equal duration from the first reading on. A step without readings repeats the one before.
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

/// Times at which T changes suddenly: its means over `step` change within two steps by more than noise and the changes
/// nearby explain.
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

struct Lag {
  double value;
  std::size_t events;
  double sureness;  // the score in standard deviations of a score of noise
  double error;     // s
};

/// The shift, up to `longest` either way, at which sudden changes of T coincide with drops of A: the middle of those
/// with the largest score, a sum of drops. Null if that is less than `sure` standard deviations of a score of noise, or
/// another shift scores nearly as much.
std::optional<Lag> lag_of(const std::vector<double>& events, const Pictures& shown, double interval, double longest,
                          double sure) {
  constexpr double kMost = 15;     // standard deviations
  constexpr double kSteps = 20;    // of a frame
  constexpr double kLongRise = 2;  // s
  std::vector<double> touching;    // areas in contact: those out of contact have another noise, or none
  const double largest = *std::max_element(shown.A.begin(), shown.A.end());
  for (const double A : shown.A)
    if (A > 0.3 * largest) touching.push_back(A);
  const double noise = noise_of(touching);
  if (events.empty() || !(noise > 0)) return std::nullopt;
  // by how much more the area drops from one frame to the next than it changes before and after
  std::vector<double> drops(shown.A.size());
  double squares = 0;
  for (std::size_t i = 2; i + 1 < drops.size(); ++i) {
    const auto drop = [&](std::size_t k) { return shown.A[k - 1] - shown.A[k]; };
    const double more = drop(i) - std::max(std::abs(drop(i - 1)), std::abs(drop(i + 1)));
    if (shown.A[i - 1] > 0.3 * largest && shown.A[i] > 0)
      drops[i] = std::clamp(more / (std::sqrt(2.0) * noise), 0.0, kMost);
    squares += std::pow(std::min(drops[i], 3.0), 2);  // of noise
  }
  const double by_chance = std::sqrt(squares / static_cast<double>(touching.size()));
  const double step = interval / kSteps;
  const auto half = static_cast<std::ptrdiff_t>(longest / step);
  std::vector<double> scores(static_cast<std::size_t>(2 * half + 1));
  // At the drop that ends a long rise the contact loses area; later slips resemble each other.
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
  if (!(sureness > sure)) return std::nullopt;
  const auto apart = static_cast<std::ptrdiff_t>(kApart * kSteps);
  for (auto other = scores.begin(); other != scores.end(); ++other)
    if (std::abs(other - best) > apart && *other > kNearly * *best) return std::nullopt;
  // the interval of nearly the same score, as frames do not resolve more
  auto first = best, last = best;
  while (first != scores.begin() && *(first - 1) > 0.98 * *best) --first;
  while (last + 1 != scores.end() && *(last + 1) > 0.98 * *best) ++last;
  const double middle = 0.5 * static_cast<double>((first - scores.begin()) + (last - scores.begin()));
  return Lag{(middle - static_cast<double>(half)) * step, events.size(), sureness, interval / std::sqrt(12.0)};
}

/// The shift at which the area correlates best with P^(2/3); null if the correlation is weak. Accurate to a few tenths
/// of a second, as contact begins and ends with the load.
std::optional<double> lag_by_load(const std::vector<double>& time, const std::vector<double>& P, const Pictures& shown,
                                  double interval) {
  constexpr double kCorrelated = 0.6, kOutOfContact = 0.15;  // share of the time
  const double step = std::max(interval / 2, 0.01);
  std::vector<double> load = means_over(time, P, step), area = means_over(shown.time, shown.A, step), sorted = load;
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
  const double begin = time.front() - shown.time.front();
  const auto n = static_cast<std::ptrdiff_t>(area.size()), m = static_cast<std::ptrdiff_t>(load.size());
  double best = 0, lag = 0;
  for (auto k = static_cast<std::ptrdiff_t>((-kLongest - begin) / step);
       static_cast<double>(k) * step + begin <= kLongest; ++k) {  // where the first load is in the grid of the area
    double sum = 0;
    for (std::ptrdiff_t i = std::max<std::ptrdiff_t>(0, -k); i < std::min(m, n - k); ++i)
      sum += load[static_cast<std::size_t>(i)] * area[static_cast<std::size_t>(i + k)];
    if (sum > best) {
      best = sum;
      lag = -(begin - static_cast<double>(k) * step);
    }
  }
  return best > kCorrelated * scale ? std::optional(lag) : std::nullopt;
}

/// The shift, up to `longest` either way, at which the area drops from its course when T alone shows the onset of
/// sliding: for onsets without a drop of T. Null if the runs do not agree.
std::optional<Lag> lag_by_onsets(const Frames& frames, double longest) {
  constexpr double kAgree = 1.5;  // frames, standard error
  RunOptions alone;
  alone.by_shear_alone = true;
  const LoadingRuns found = find_loading_runs(frames, "N", 1, alone);
  std::vector<double> touching;
  for (const LoadingRun& run : found.runs)
    for (std::size_t i = run.begin; i < run.end; ++i) touching.push_back(frames.A[i]);
  const double noise = noise_of(touching);
  std::vector<double> shifts;
  for (const LoadingRun& run : found.runs) {
    if (!run.onset || !(noise > 0)) continue;
    const std::size_t before = index_of(run.onset->time - longest, frames.time);
    const auto broken = first_break_below({&frames.A, noise}, std::max(run.begin, before > 12 ? before - 12 : 0),
                                          std::min(run.last, index_of(run.onset->time + longest, frames.time)));
    if (broken) shifts.push_back(frames.time[broken->at] + frames.interval / 2 - run.onset->time);
  }
  if (shifts.empty()) return std::nullopt;
  const double middle = median(shifts);
  std::vector<double> apart;
  for (const double shift : shifts) apart.push_back(std::abs(shift - middle));
  // not divided by the root of their number: a delay of the area is the same each time
  const double error = std::max(kOfMedian * median(apart), frames.interval / 2);
  if (shifts.size() < 2 || error > kAgree * frames.interval) return std::nullopt;
  return Lag{frames.lag + middle, shifts.size(), 0, error};
}

}  // namespace

Frames on_one_clock(const Recording& forces, const Recording& areas, std::optional<double> lag) {
  if (&forces == &areas || lag) {
    Frames frames = make_frames(forces, areas, lag.value_or(0));
    frames.lag_source = lag ? "stated" : "one clock";
    // the picture was taken up to a sample before its row
    if (!lag && frames.samples > 1) frames.lag_error = 0.5 * typical_step(forces.time);
    return frames;
  }
  const Pictures shown = pictures(areas);
  const auto near = lag_by_load(forces.time, forces.P, shown, typical_step(shown.time));
  const Frames rough = make_frames(forces, areas, near.value_or(0));
  const double longest = near ? std::max(kNearLoad, 4 * rough.interval) : kLongest;
  // by means over a fifth of a frame, or if noise hides a drop, over half a frame or a whole one
  std::optional<Lag> found;
  for (const double share : {0.2, 0.5, 1.0}) {
    const double step = std::max(share * rough.interval, typical_step(forces.time));
    const auto one = lag_of(sudden_changes(rough, step), shown, rough.interval, longest, near ? kSureNear : kSure);
    if (one && (!found || one->sureness > 1.3 * found->sureness)) found = one;
  }
  std::string source;
  if (found) {
    found->value += rough.lag;
    source = "from " + std::to_string(found->events) + " sudden changes of T";
  } else if (near && (found = lag_by_onsets(rough, longest))) {
    source = "from " + std::to_string(found->events) + " onsets of sliding";
  }
  if (!found)
    throw InputError(areas.path, "no sudden change that it shares with " + forces.path +
                                     " tells the lag between their clocks; state it: " +
                                     Remedy::set("lag", near ? rounded(*near, 3) + " s" : "0 s") +
                                     (near ? " is where the area follows the load, to some tenths" : ""));
  Frames frames = make_frames(forces, areas, found->value);
  frames.lag_error = found->error;
  frames.lag_source = source;
  return frames;
}

}  // namespace mixity
