#include "dataset/logs/cycles.h"

#include <algorithm>
#include <cmath>

#include "dataset/logs/onset.h"
#include "statistics/change_points.h"
#include "statistics/drops.h"
#include "statistics/noise.h"
#include "statistics/readings.h"

namespace mixity {
namespace {

constexpr double kPeak = 0.1;  // of the largest T; sliding does not stay below it

/// The lowest reading of a drop, which ends where readings rise by more than `least` again, or do not fall further for
/// twice its duration: T of steady sliding is a minimum, too.
std::size_t end_of_drop(const std::vector<double>& T, const Drop& drop, std::size_t end, double least) {
  constexpr std::size_t kFew = 12;
  std::size_t low = drop.seen, lower = drop.seen;  // `lower`: where the last step down of `least` was seen
  for (std::size_t i = drop.seen; i < end && !(T[i] - T[low] > least); ++i) {
    if (T[i] < T[low]) low = i;
    if (T[i] < T[lower] - least) lower = i;
    if (i - lower > std::max(kFew, 2 * (lower - drop.top))) break;
  }
  return low;
}

/// All drops; the last may be the unloading.
std::vector<Drop> all_drops(const std::vector<double>& T, std::size_t begin, std::size_t end, double least) {
  std::vector<Drop> found;
  for (auto drop = first_drop(T, begin, end, least, kLeastDrop); drop;
       drop = first_drop(T, drop->low, end, least, kLeastDrop)) {
    drop->low = end_of_drop(T, *drop, end, least);
    found.push_back(*drop);
  }
  return found;
}

/// What maxima and minima are read from: the samples of the force, or frames.
class Source {
 public:
  Source(const Frames& frames, const Shear& shear, std::size_t begin, std::size_t end) : frames_(frames) {
    constexpr double kEnough = 4;  // samples in a frame
    if (frames.samples < kEnough) {
      from_ = begin;
      T_ = part_of(shear.T, begin, end);
      time_ = part_of(frames.time, begin, end);
      noise_ = shear.noise;
      return;
    }
    by_frame_ = false;
    const auto first = sample(frames.time[begin] - frames.interval / 2),
               last = sample(frames.time[end - 1] + frames.interval / 2);
    from_ = first;
    time_ = part_of(frames.force_time, first, last);
    T_ = part_of(frames.force_T, first, last);
    for (double& one : T_) one = shear.direction * one - shear.start;
    // noise with a memory is less in second differences of samples than in those of their means
    noise_ = std::max(noise_of(T_), shear.noise * std::sqrt(frames.samples));
  }

  /// The first reading of a frame, and the last one.
  std::size_t first_of(std::size_t frame) const { return by_frame_ ? frame - from_ : within(frame, -0.5); }
  std::size_t end_of(std::size_t frame) const { return by_frame_ ? frame - from_ : within(frame, 0.5); }
  bool by_frame() const { return by_frame_; }
  Course course() const { return {&T_, noise_}; }
  std::size_t size() const { return T_.size(); }
  /// Between readings, as ends_of_drop counts.
  double time(double at) const {
    const auto i = std::min(static_cast<std::size_t>(at), T_.size() - 2);
    return time_[i] + (at - static_cast<double>(i)) * (time_[i + 1] - time_[i]);
  }

 private:
  std::size_t within(std::size_t frame, double frames) const {
    return std::clamp(sample(frames_.time[frame] + frames * frames_.interval), from_, from_ + T_.size()) - from_;
  }
  std::size_t sample(double time) const {
    return static_cast<std::size_t>(std::lower_bound(frames_.force_time.begin(), frames_.force_time.end(), time) -
                                    frames_.force_time.begin());
  }
  const Frames& frames_;
  bool by_frame_ = true;
  std::size_t from_ = 0;
  std::vector<double> time_, T_;
  double noise_ = 0;
};

/// How many readings of a line of this length give its end: over a tenth of it T bends little.
std::size_t readings_for(std::size_t length) {
  constexpr std::size_t kShare = 10, kFew = 24;
  return std::min(length, std::max(length / kShare, kFew));
}

}  // namespace

std::vector<Cycle> slip_cycles(const Frames& frames, const Shear& shear, std::size_t begin, std::size_t end) {
  const std::vector<double>& T = shear.T;
  const std::vector<Drop> drops = all_drops(T, begin, end, kDropOfNoise * shear.noise);
  std::vector<Cycle> cycles;
  if (drops.empty()) return cycles;
  const auto all = [&](std::size_t from, auto holds) {
    return std::all_of(T.begin() + static_cast<std::ptrdiff_t>(from), T.begin() + static_cast<std::ptrdiff_t>(end),
                       holds);
  };
  const double least = kPeak * *std::max_element(T.begin() + static_cast<std::ptrdiff_t>(begin),
                                                 T.begin() + static_cast<std::ptrdiff_t>(end));
  const Source source(frames, shear, begin, end);
  std::size_t low = source.first_of(begin);  // where the last drop ended
  for (std::size_t k = 0; k < drops.size(); ++k) {
    const Drop& drop = drops[k];
    const bool ends = drop.low + 1 < end;
    if (all(drop.low, [&](double one) { return one < least; }) || (!ends && k > 0)) break;  // unloading
    const DropSpan span{source.first_of(drop.top) + (source.by_frame() ? 1 : 0), source.end_of(drop.seen),
                        source.end_of(drop.low)};
    const std::size_t next = k + 1 < drops.size() ? source.first_of(drops[k + 1].top) : source.size();
    const std::size_t from = span.first > low ? span.first - readings_for(span.first - low) : low,
                      to = next > span.last ? span.last + readings_for(next - span.last) : span.last;
    Cycle cycle{frames.time[drop.top], T[drop.top], shear.noise, frames.time[drop.low], {}, 0};
    if (ends) {
      cycle.T_min = T[drop.low];
      cycle.error_min = shear.noise;
    }
    low = span.last;
    if (const auto found = ends ? ends_of_drop(source.course(), from, to, span) : std::nullopt) {
      cycle.time = source.time(found->top.at);
      cycle.T_peak = found->top.value;
      cycle.error_peak = found->top.error;
      cycle.time_min = source.time(found->bottom.at);
      cycle.T_min = found->bottom.value;
      cycle.error_min = found->bottom.error;
      low = static_cast<std::size_t>(std::ceil(found->bottom.at));
    }
    cycles.push_back(cycle);
  }
  return cycles;
}

}  // namespace mixity
