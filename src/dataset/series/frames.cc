#include "dataset/series/frames.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dataset/input_error.h"
#include "dataset/series/noise.h"

namespace mixity {
namespace {

double typical_step(const std::vector<double>& time) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < time.size(); ++i) steps.push_back(time[i] - time[i - 1]);
  return median(steps);
}

/// Times and areas of pictures: rows with an area, and of rows that repeat the last picture the first.
struct Pictures {
  std::vector<double> time, A;
};
Pictures pictures(const Recording& recording) {
  Pictures all, changed;
  for (std::size_t i = 0; i < recording.time.size(); ++i) {
    if (!std::isfinite(recording.A[i])) continue;
    if (all.A.empty() || recording.A[i] != all.A.back()) {
      changed.time.push_back(recording.time[i]);
      changed.A.push_back(recording.A[i]);
    }
    all.time.push_back(recording.time[i]);
    all.A.push_back(recording.A[i]);
  }
  // An area that is held until the next picture changes in few rows, and there in steps of one length.
  if (changed.A.size() < 3 || 3 * changed.A.size() > all.A.size()) return all;
  const double step = typical_step(changed.time);
  Pictures held;
  for (std::size_t i = 0, k = 0; i < all.time.size(); ++i) {
    const bool change = k < changed.time.size() && all.time[i] == changed.time[k];
    if (!change && !held.time.empty() && all.time[i] < held.time.back() + 0.999 * step) continue;
    held.time.push_back(all.time[i]);
    held.A.push_back(all.A[i]);
    k += change;
  }
  return held;
}

/// Mean of samples from `begin` to before `end`; between samples, if there are none. NaN outside the recording.
class Means {
 public:
  explicit Means(const std::vector<double>& time) : time_(time) {}
  void add(const std::vector<double>& values) {
    std::vector<double>& sum = sums_.emplace_back(values.size() + 1);
    values_.push_back(&values);
    for (std::size_t i = 0; i < values.size(); ++i) sum[i + 1] = sum[i] + values[i];
  }
  double mean(std::size_t which, double begin, double end) const {
    const auto first = std::lower_bound(time_.begin(), time_.end(), begin),
               last = std::lower_bound(first, time_.end(), end);
    const auto i = static_cast<std::size_t>(first - time_.begin()), j = static_cast<std::size_t>(last - time_.begin());
    if (j > i) return (sums_[which][j] - sums_[which][i]) / static_cast<double>(j - i);
    if (i == 0 || i == time_.size()) return std::nan("");
    const double middle = 0.5 * (begin + end), share = (middle - time_[i - 1]) / (time_[i] - time_[i - 1]);
    return (*values_[which])[i - 1] + share * ((*values_[which])[i] - (*values_[which])[i - 1]);
  }

 private:
  const std::vector<double>& time_;
  std::vector<std::vector<double>> sums_;
  std::vector<const std::vector<double>*> values_;
};

/// Times at which T changes suddenly: by more than noise and ramps change it in two steps.
std::vector<double> sudden_changes(const std::vector<double>& time, const std::vector<double>& T) {
  constexpr double kSudden = 6;  // standard deviations
  constexpr std::size_t kBeside = 10;
  std::vector<double> change(T.size());
  for (std::size_t k = 1; k + 1 < T.size(); ++k) change[k] = std::abs(T[k + 1] - T[k - 1]);
  const double noise = noise_of(T) * std::sqrt(2.0);
  std::vector<double> found;
  for (std::size_t k = kBeside; k + kBeside < T.size(); ++k) {
    if (!(change[k] > kSudden * noise)) continue;
    const auto first = change.begin() + static_cast<std::ptrdiff_t>(k - kBeside), behind = first + 2 * kBeside + 1;
    if (change[k] < *std::max_element(first, behind) || !(change[k] > 4 * median({first, behind}))) continue;
    if (found.empty() || time[k] > found.back() + 0.5 * static_cast<double>(kBeside) * (time[1] - time[0]))
      found.push_back(time[k]);
  }
  return found;
}

struct Lag {
  double value;
  std::size_t events;
  double sureness;  // standard deviations of what noise gives
};

/// The shift by which sudden changes of T fall together with falls of A: the middle of those that give the largest sum
/// of falls. Null if that is not five standard deviations of what noise gives.
std::optional<Lag> lag_of(const std::vector<double>& events, const Pictures& shown, double interval, double longest) {
  constexpr double kSure = 6, kMost = 15;  // standard deviations
  constexpr double kSteps = 20;            // of a frame
  constexpr double kLongRise = 2;          // s
  std::vector<double> touching;            // frames out of contact have another noise, or none
  const double largest = *std::max_element(shown.A.begin(), shown.A.end());
  for (const double A : shown.A)
    if (A > 0.3 * largest) touching.push_back(A);
  const double noise = noise_of(touching);
  if (events.empty() || !(noise > 0)) return std::nullopt;
  // how much more the area falls from one frame to the next than it changes before and after that
  std::vector<double> falls(shown.A.size());
  double squares = 0;
  for (std::size_t i = 2; i + 1 < falls.size(); ++i) {
    const auto fall = [&](std::size_t k) { return shown.A[k - 1] - shown.A[k]; };
    const double more = fall(i) - std::max(std::abs(fall(i - 1)), std::abs(fall(i + 1)));
    if (shown.A[i - 1] > 0.3 * largest && shown.A[i] > 0)
      falls[i] = std::clamp(more / (std::sqrt(2.0) * noise), 0.0, kMost);
    squares += std::pow(std::min(falls[i], 3.0), 2);  // of noise
  }
  const double by_chance = std::sqrt(squares / static_cast<double>(touching.size()));
  const double step = interval / kSteps;
  const auto half = static_cast<std::ptrdiff_t>(longest / step);
  std::vector<double> scores(static_cast<std::size_t>(2 * half + 1));
  // The fall that ends a long rise is the one at which the contact loses area; later slips resemble each other.
  std::vector<double> weights;
  double weighed = 0;
  for (std::size_t e = 0; e < events.size(); ++e) {
    weights.push_back(std::sqrt(std::min(1.0, e == 0 ? 1.0 : (events[e] - events[e - 1]) / kLongRise)));
    weighed += weights.back() * weights.back();
  }
  for (std::size_t e = 0; e < events.size(); ++e)
    for (std::ptrdiff_t k = -half; k <= half; ++k) {
      const double at = events[e] + static_cast<double>(k) * step;
      const auto next = std::lower_bound(shown.time.begin(), shown.time.end(), at);
      if (next == shown.time.begin() || next == shown.time.end()) continue;
      const auto i = static_cast<std::size_t>(next - shown.time.begin());
      scores[static_cast<std::size_t>(k + half)] += weights[e] * falls[i];
    }
  const auto best = std::max_element(scores.begin(), scores.end());
  const double sureness = *best / std::max(by_chance * std::sqrt(weighed), 1e-9);
  if (!(sureness > kSure)) return std::nullopt;
  // the stretch about it of nearly the same sum: a frame cannot tell more
  auto first = best, last = best;
  while (first != scores.begin() && *(first - 1) > 0.98 * *best) --first;
  while (last + 1 != scores.end() && *(last + 1) > 0.98 * *best) ++last;
  const double middle = 0.5 * static_cast<double>((first - scores.begin()) + (last - scores.begin()));
  return Lag{(middle - static_cast<double>(half)) * step, events.size(), sureness};
}

}  // namespace

Frames make_frames(const Recording& forces, const Recording& areas, const FrameOptions& options) {
  const Pictures shown = pictures(areas);
  if (shown.time.size() < 3) throw InputError(areas.path, "holds fewer than three areas");
  Frames frames;
  frames.interval = typical_step(shown.time);
  Means means(forces.time);
  means.add(forces.P);
  means.add(forces.T);
  frames.samples = std::max(1.0, frames.interval / typical_step(forces.time));
  if (&forces == &areas) {
    frames.lag_source = "one clock";
  } else if (options.lag) {
    frames.lag = *options.lag;
    frames.lag_source = "stated";
  } else {
    // of means over a fifth of a frame, or where noise hides a fall then, over half of one or all of it
    std::optional<Lag> found;
    for (const double share : {0.2, 0.5, 1.0}) {
      std::vector<double> time, T;
      const double step = std::max(share * frames.interval, typical_step(forces.time));
      for (double t = forces.time.front() + step; t < forces.time.back(); t += step) {
        time.push_back(t);
        T.push_back(means.mean(1, t - step / 2, t + step / 2));
      }
      const auto one = lag_of(sudden_changes(time, T), shown, frames.interval, options.longest_lag);
      if (one && (!found || one->sureness > 1.3 * found->sureness)) found = one;
    }
    if (!found)
      throw InputError(areas.path, "no sudden change that it shares with " + forces.path +
                                       " tells the lag between their clocks; state it: --lag=\"0 s\"");
    frames.lag = found->value;
    frames.lag_error = frames.interval / std::sqrt(12.0);
    frames.lag_source = "from " + std::to_string(found->events) + " sudden changes of T";
  }
  for (std::size_t i = 0; i < shown.time.size(); ++i) {
    const double middle = shown.time[i] - frames.lag, begin = middle - frames.interval / 2,
                 end = middle + frames.interval / 2;
    const double P = means.mean(0, begin, end), T = means.mean(1, begin, end);
    if (!std::isfinite(P) || !std::isfinite(T)) continue;
    frames.time.push_back(shown.time[i]);
    frames.P.push_back(P);
    frames.T.push_back(T);
    frames.A.push_back(shown.A[i]);
  }
  if (frames.time.size() < 3) throw InputError(areas.path, "shares no time with " + forces.path);
  return frames;
}

}  // namespace mixity
