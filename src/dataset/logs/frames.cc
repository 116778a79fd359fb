#include "dataset/logs/frames.h"

#include <algorithm>
#include <cmath>

#include "base/input_error.h"
#include "statistics/noise.h"
#include "statistics/readings.h"

namespace mixity {
namespace {

/// Means of samples over intervals of time.
class Means {
 public:
  Means(const std::vector<double>& time, const std::vector<double>& values)
      : time_(time), values_(values), sums_(values.size() + 1) {
    for (std::size_t i = 0; i < values.size(); ++i) sums_[i + 1] = sums_[i] + values[i];
  }
  /// Interpolates at the middle of the interval if it contains no sample. NaN outside the recording.
  double over(double begin, double end) const {
    const std::size_t i = index_of(begin, time_), j = index_of(end, time_);
    if (j > i) return (sums_[j] - sums_[i]) / static_cast<double>(j - i);
    if (i == 0 || i == time_.size()) return std::nan("");
    const double middle = 0.5 * (begin + end), share = (middle - time_[i - 1]) / (time_[i] - time_[i - 1]);
    return values_[i - 1] + share * (values_[i] - values_[i - 1]);
  }

 private:
  const std::vector<double>&time_, &values_;
  std::vector<double> sums_;
};

}  // namespace

double typical_step(const std::vector<double>& time) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < time.size(); ++i) steps.push_back(time[i] - time[i - 1]);
  return median(steps);
}

std::size_t index_of(double time, const std::vector<double>& times) {
  return static_cast<std::size_t>(std::lower_bound(times.begin(), times.end(), time) - times.begin());
}

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
    if (!recording.q.empty()) all.q.push_back(recording.q[i]);
  }
  // If rows repeat an area until the next picture, it changes in few rows, at equal intervals.
  if (changed.A.size() < 3 || 3 * changed.A.size() > all.A.size()) return all;
  const double step = typical_step(changed.time);
  Pictures held;
  for (std::size_t i = 0, k = 0; i < all.time.size(); ++i) {
    const bool change = k < changed.time.size() && all.time[i] == changed.time[k];
    if (!change && !held.time.empty() && all.time[i] < held.time.back() + 0.999 * step) continue;
    // the picture that is due is the change right after this row
    if (!change && k < changed.time.size() && changed.time[k] - all.time[i] < 0.5 * step) continue;
    held.time.push_back(all.time[i]);
    held.A.push_back(all.A[i]);
    if (!all.q.empty()) held.q.push_back(all.q[i]);
    k += change;
  }
  return held;
}

Frames make_frames(const Recording& forces, const Recording& areas, double lag) {
  const Pictures shown = pictures(areas);
  if (shown.time.size() < 3) throw InputError(areas.path, "holds fewer than three areas");
  Frames frames;
  frames.interval = typical_step(shown.time);
  frames.lag = lag;
  std::vector<double> loads = forces.P;
  frames.force_T = forces.T;
  frames.spikes = remove_spikes(loads) + remove_spikes(frames.force_T);
  frames.load_is_stated = forces.load_is_stated;
  frames.noise_P = noise_of(loads);
  frames.samples = std::max(1.0, frames.interval / typical_step(forces.time));
  const Means P_means(forces.time, loads), T_means(forces.time, frames.force_T);
  for (std::size_t i = 0; i < shown.time.size(); ++i) {
    const double middle = shown.time[i] - lag, begin = middle - frames.interval / 2, end = middle + frames.interval / 2;
    const double P = P_means.over(begin, end), T = T_means.over(begin, end);
    if (!std::isfinite(P) || !std::isfinite(T)) continue;
    frames.time.push_back(shown.time[i]);
    frames.P.push_back(P);
    frames.T.push_back(T);
    frames.A.push_back(shown.A[i]);
    if (!shown.q.empty()) frames.q.push_back(shown.q[i]);
  }
  if (frames.time.size() < 3) throw InputError(areas.path, "shares no time with " + forces.path);
  for (const double time : forces.time) frames.force_time.push_back(time + lag);
  return frames;
}

}  // namespace mixity
