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

constexpr double kPeak = 0.1;  // of the largest T; T of a sliding contact is higher

/// The lowest reading of a drop. It ends where readings rise by more than `least` again, or where they do not fall
/// further for twice its duration, as in steady sliding.
std::size_t end_of_drop(const std::vector<double>& T, const Drop& drop, std::size_t end, double least) {
  constexpr std::size_t kFew = 12;
  std::size_t low = drop.seen, lower = drop.seen;  // `lower`: where readings last fell by `least`
  for (std::size_t i = drop.seen; i < end && !(T[i] - T[low] > least); ++i) {
    if (T[i] < T[low]) low = i;
    if (T[i] < T[lower] - least) lower = i;
    if (i - lower > std::max(kFew, 2 * (lower - drop.top))) break;
  }
  return low;
}

/// All drops; the last one may be the unloading.
std::vector<Drop> all_drops(const std::vector<double>& T, std::size_t begin, std::size_t end, double least) {
  std::vector<Drop> found;
  for (auto drop = first_drop(T, begin, end, least, kLeastDrop); drop;
       drop = first_drop(T, drop->low, end, least, kLeastDrop)) {
    drop->low = end_of_drop(T, *drop, end, least);
    found.push_back(*drop);
  }
  return found;
}

/// The readings of T in which maxima and minima are searched: samples of the force, or frames.
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
    from_ = index_of(frames.time[begin] - frames.interval / 2, frames.force_time);
    const std::size_t last = index_of(frames.time[end - 1] + frames.interval / 2, frames.force_time);
    time_ = part_of(frames.force_time, from_, last);
    T_ = part_of(frames.force_T, from_, last);
    for (double& one : T_) one = shear.direction * one - shear.start;
    // second differences of samples underestimate correlated noise more than those of their means
    noise_ = std::max(noise_of(T_), shear.noise * std::sqrt(frames.samples));
  }

  /// The first reading of a frame, and the last one.
  std::size_t first_of(std::size_t frame) const { return by_frame_ ? frame - from_ : within(frame, -0.5); }
  std::size_t end_of(std::size_t frame) const { return by_frame_ ? frame - from_ : within(frame, 0.5); }
  bool by_frame() const { return by_frame_; }
  Course course() const { return {&T_, noise_}; }
  std::size_t size() const { return T_.size(); }
  /// The time at a position between readings.
  double time(double at) const {
    const auto i = std::min(static_cast<std::size_t>(at), T_.size() - 2);
    return time_[i] + (at - static_cast<double>(i)) * (time_[i + 1] - time_[i]);
  }

 private:
  std::size_t within(std::size_t frame, double frames) const {
    const std::size_t sample = index_of(frames_.time[frame] + frames * frames_.interval, frames_.force_time);
    return std::clamp(sample, from_, from_ + T_.size()) - from_;
  }

  const Frames& frames_;
  bool by_frame_ = true;
  std::size_t from_ = 0;
  std::vector<double> time_, T_;
  double noise_ = 0;
};

/// The number of readings that determine the end of a line: over a tenth of its length T is nearly straight.
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
  const double least = kPeak * *std::max_element(T.data() + begin, T.data() + end);
  const Source source(frames, shear, begin, end);
  std::size_t low = source.first_of(begin);  // where the last drop ended
  for (std::size_t k = 0; k < drops.size(); ++k) {
    const Drop& drop = drops[k];
    const bool ends = drop.low + 1 < end;
    const bool unloads = *std::max_element(T.data() + drop.low, T.data() + end) < least;
    if (unloads || (!ends && k > 0)) break;
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
