#include "dataset/logs/frames.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/input_error.h"
#include "base/number_text.h"
#include "statistics/noise.h"
#include "statistics/readings.h"

namespace mixity {
double typical_step(const std::vector<double>& time) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < time.size(); ++i) steps.push_back(time[i] - time[i - 1]);
  return median(steps);
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
  }
  // An area that is held until the next picture changes in few rows, and there in steps of one length.
  if (changed.A.size() < 3 || 3 * changed.A.size() > all.A.size()) return all;
  const double step = typical_step(changed.time);
  Pictures held;
  for (std::size_t i = 0, k = 0; i < all.time.size(); ++i) {
    const bool change = k < changed.time.size() && all.time[i] == changed.time[k];
    if (!change && !held.time.empty() && all.time[i] < held.time.back() + 0.999 * step) continue;
    // a change that comes right behind is the picture that was due
    if (!change && k < changed.time.size() && changed.time[k] - all.time[i] < 0.5 * step) continue;
    held.time.push_back(all.time[i]);
    held.A.push_back(all.A[i]);
    k += change;
  }
  return held;
}

namespace {

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

}  // namespace

Frames make_frames(const Recording& forces, const Recording& areas, double lag) {
  const Pictures shown = pictures(areas);
  if (shown.time.size() < 3) throw InputError(areas.path, "holds fewer than three areas");
  Frames frames;
  frames.interval = typical_step(shown.time);
  frames.lag = lag;
  std::vector<double> loads = forces.P;
  frames.force_T = forces.T;
  frames.spikes = remove_spikes(loads) + remove_spikes(frames.force_T);
  frames.noise_P = noise_of(loads);
  frames.samples = std::max(1.0, frames.interval / typical_step(forces.time));
  Means means(forces.time);
  means.add(loads);
  means.add(frames.force_T);
  for (std::size_t i = 0; i < shown.time.size(); ++i) {
    const double middle = shown.time[i] - lag, begin = middle - frames.interval / 2, end = middle + frames.interval / 2;
    const double P = means.mean(0, begin, end), T = means.mean(1, begin, end);
    if (!std::isfinite(P) || !std::isfinite(T)) continue;
    frames.time.push_back(shown.time[i]);
    frames.P.push_back(P);
    frames.T.push_back(T);
    frames.A.push_back(shown.A[i]);
  }
  if (frames.time.size() < 3) throw InputError(areas.path, "shares no time with " + forces.path);
  for (const double time : forces.time) frames.force_time.push_back(time + lag);
  return frames;
}

}  // namespace mixity
