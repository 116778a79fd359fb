#include "dataset/logs/lag_events.h"

#include <algorithm>
#include <cmath>

#include "dataset/logs/contacts.h"
#include "dataset/logs/loading_runs.h"
#include "statistics/noise.h"
#include "statistics/readings.h"

namespace mixity {
namespace {

constexpr double kSteps = 20, kMost = 600;  // of a frame; of the range tried, if frames are short

double step_of(LagRange range, double interval) {
  return std::max(interval / kSteps, (range.last - range.first) / kMost);
}

/// Readings of a course between two times.
struct Readings {
  std::vector<double> time, values;

  void add(const std::vector<double>& times, const std::vector<double>& all, std::size_t begin, std::size_t end) {
    time.assign(times.begin() + static_cast<std::ptrdiff_t>(begin), times.begin() + static_cast<std::ptrdiff_t>(end));
    values = part_of(all, begin, end);
  }
  /// Reverses the order, with negative times.
  void reverse() {
    std::reverse(time.begin(), time.end());
    std::reverse(values.begin(), values.end());
    for (double& one : time) one = -one;
  }
  /// Means over `width` readings.
  Readings in_blocks(std::size_t width) const {
    Readings means;
    for (std::size_t i = 0; i + width <= time.size(); i += width) {
      means.time.push_back(mean_of(time, i, i + width));
      means.values.push_back(mean_of(values, i, i + width));
    }
    return means;
  }
};

/// A contact that is made, or, with reversed time, lost.
class ContactEvents {
 public:
  ContactEvents(const Recording& forces, const Frames& rough, LagRange range)
      : forces_(forces), frames_(rough), range_(range), noise_A_(noise_of(rough.A)), noise_P_(noise_of(rough.P)) {}

  std::vector<LagEvent> find() {
    const auto touching = contacts(frames_, noise_A_);
    const auto [least, most] = std::minmax_element(frames_.P.begin(), frames_.P.end());
    for (std::size_t k = 0; k < touching.size(); ++k) {
      const FrameRange& contact = touching[k];
      const auto steps = load_steps(frames_, contact, std::max(noise_P_, 1e-3 * (*most - *least)), *most - *least);
      if (steps.empty()) continue;
      add(k > 0 ? touching[k - 1].end : 0, contact.begin, steps.front().begin, false);
      add(steps.back().end, contact.end, k + 1 < touching.size() ? touching[k + 1].begin : frames_.time.size(), true);
    }
    return std::move(events_);
  }

 private:
  static constexpr std::size_t kFew = 3;

  /// A contact made at frame `at` (or lost, in reverse): out of contact from frame `begin` on, and held before frame
  /// `end`.
  void add(std::size_t begin, std::size_t at, std::size_t end, bool lost) {
    if (at < begin + kFew || end < at + kFew || end > frames_.time.size()) return;
    const TimeDensity of_A = in_areas(begin, at, end, lost), of_P = in_loads(begin, at, end, lost);
    if (!of_A.p.empty() && !of_P.p.empty())
      events_.push_back({lost ? LagEvent::Kind::lost : LagEvent::Kind::made, of_P, of_A});
  }

  /// Searches near the frame at which contact is seen.
  TimeDensity in_areas(std::size_t begin, std::size_t at, std::size_t end, bool lost) const {
    constexpr std::size_t kMany = 12;
    Readings area;
    area.add(frames_.time, frames_.A, at - std::min(kMany, at - begin), std::min(end, at + kMany));
    const double near = 3 * frames_.interval;
    return beginning(area, noise_A_, frames_.time[at] - near, frames_.time[at] + near, frames_.interval / kSteps, lost);
  }

  /// Searches as far away as the range of lags allows.
  TimeDensity in_loads(std::size_t begin, std::size_t at, std::size_t end, bool lost) const {
    constexpr std::size_t kBlocks = 150;
    constexpr double kOut = 0.5, kShare = 0.6;  // s; of the ramp of the load
    const double middle = frames_.time[at], before = middle - frames_.time[begin],
                 behind = frames_.time[end - 1] - middle;
    const double half = std::max(range_.last - frames_.lag, frames_.lag - range_.first);
    const double out = std::min(half + kOut, lost ? behind : before), in = kShare * (lost ? before : behind);
    const double from = middle - frames_.lag - (lost ? in : out), to = middle - frames_.lag + (lost ? out : in);
    Readings load;
    load.add(forces_.time, forces_.P, index_of(from, forces_.time), index_of(to, forces_.time));
    load = load.in_blocks(std::max<std::size_t>(1, load.time.size() / kBlocks));
    const std::size_t n = load.time.size();
    if (n < 4 * kFew) return {};
    const double fine = (load.time.back() - load.time.front()) / (4 * static_cast<double>(n));
    // there must be readings on either side
    const std::size_t first = lost ? kFew - 1 : kFew, last = lost ? n - 1 - kFew : n - kFew;
    return beginning(load, noise_of(load.values), load.time[first], load.time[last], fine, lost);
  }

  /// When a contact begins, or, with reversed time, ends.
  static TimeDensity beginning(Readings readings, double noise, double first, double last, double step, bool lost) {
    const BreakShape shape{0, 0, true, 0, false};
    if (!lost) return break_times(readings.time, readings.values, noise, first, last, step, shape);
    readings.reverse();
    TimeDensity found = break_times(readings.time, readings.values, noise, -last, -first, step, shape);
    if (found.p.empty()) return found;
    found.begin = -found.time(found.p.size() - 1);
    std::reverse(found.p.begin(), found.p.end());
    return found;
  }

  const Recording& forces_;
  const Frames& frames_;
  LagRange range_;
  double noise_A_, noise_P_;
  std::vector<LagEvent> events_;
};

/// When T begins to fall by the forces' clock, its standard error, and the duration of the fall.
struct Fall {
  double time, error, lasts;
  std::size_t first, last;  // frames between the end of the last fall, or of the contact, and the next fall
};

std::vector<Fall> falls_of(const Frames& frames, const LoadingRun& run) {
  const double sample = frames.samples > 1 ? typical_step(frames.force_time) : frames.interval;
  std::vector<Fall> falls;
  double free = run.shear.time;  // from when the area may follow its trend
  if (run.onset && (run.cycles.empty() || run.onset->time < run.cycles.front().time - 3 * frames.interval))
    falls.push_back({run.onset->time, (run.onset->high - run.onset->low) / 3.92, 0, run.begin, run.last});
  for (const Cycle& cycle : run.cycles) {
    if (!cycle.T_min) break;
    const double lasts = std::max(cycle.time_min - cycle.time, sample), fall = cycle.T_peak - *cycle.T_min;
    const double noise = run.noise_T * std::sqrt(frames.samples), error = std::hypot(sample / 2, noise / fall * lasts);
    if (!falls.empty()) falls.back().last = index_of(cycle.time, frames.time);
    falls.push_back({cycle.time, error, lasts, index_of(free, frames.time), run.last});
    free = cycle.time_min;
  }
  for (Fall& fall : falls) fall.time -= frames.lag;
  return falls;
}

}  // namespace

TimeDensity lag_by(const LagEvent& event, LagRange range, double interval) {
  constexpr double kOther = 0.02;
  const double step = step_of(range, interval);
  const auto count = static_cast<std::size_t>((range.last - range.first) / step) + 1;
  TimeDensity lag{range.first, step, std::vector<double>(count)};
  add_differences(event.in_forces, event.in_areas, lag);
  for (double& one : lag.p) one = (1 - kOther) * one + kOther / static_cast<double>(count);
  return lag;
}

std::vector<LagEvent> contact_events(const Recording& forces, const Frames& rough, LagRange range) {
  return ContactEvents(forces, rough, range).find();
}

std::vector<LagEvent> fall_events(const Frames& rough, LagRange range) {
  constexpr std::size_t kBefore = 40, kParabola = 12, kBehind = 12, kFew = 4;  // frames
  constexpr double kSudden = 0.05;                                             // of a frame
  constexpr double kOfRun = 0.35;  // of the shear: this much of the course before a fall is fitted by a polynomial
  RunOptions alone;
  alone.by_shear_alone = true;
  const double step = step_of(range, rough.interval);
  std::vector<LagEvent> events;
  for (const LoadingRun& run : find_loading_runs(rough, "N", 1, alone).runs) {
    const double noise = noise_of(part_of(rough.A, run.contact, run.last));
    for (const Fall& fall : falls_of(rough, run)) {
      const double first = fall.time + range.first, last = fall.time + range.last;
      const std::size_t from = index_of(first, rough.time), to = index_of(last, rough.time);
      const std::size_t course = from > fall.first ? from - fall.first : 0,
                        share = static_cast<std::size_t>(kOfRun * static_cast<double>(course)),
                        before = std::min({kBefore, course, std::max(kParabola, share)});
      const std::size_t next = fall.last - std::min(fall.last, (to - from) / 2), end = std::min(to + kBehind, next);
      if (before < kFew || end < to + kFew) continue;
      Readings area;
      area.add(rough.time, rough.A, from - before, end);
      BreakShape shape;
      shape.knee = fall.lasts > kSudden * rough.interval ? fall.lasts : 0;
      shape.most_degree = before >= kParabola ? 3 : 1;
      const TimeDensity of_A = break_times(area.time, area.values, noise, first, last, step, shape);
      if (!of_A.p.empty()) events.push_back({LagEvent::Kind::fall, normal_times(fall.time, fall.error, step), of_A});
    }
  }
  return events;
}

}  // namespace mixity
