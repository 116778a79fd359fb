#include "dataset/logs/lag_events.h"

#include <algorithm>
#include <cmath>

#include "dataset/logs/contacts.h"
#include "dataset/logs/loading_runs.h"
#include "statistics/noise.h"
#include "statistics/readings.h"

namespace mixity {
namespace {

constexpr double kSteps = 30, kMost = 600;  // of a frame; of the range tried, if frames are short

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
  static constexpr double kShare = 0.6;  // of the ramp of the load
  static constexpr double kBeside = 3;   // frames beside another contact

  /// A contact made at frame `at` (or lost, in reverse): out of contact from frame `begin` on, and held before frame
  /// `end`.
  void add(std::size_t begin, std::size_t at, std::size_t end, bool lost) {
    if (at < begin + kFew || end < at + kFew || end > frames_.time.size()) return;
    const TimeDensity of_A = in_areas(begin, at, end, lost), of_P = in_loads(begin, at, end, lost);
    if (!of_A.p.empty() && !of_P.p.empty())
      events_.push_back({lost ? LagEvent::Kind::lost : LagEvent::Kind::made, of_P, of_A});
  }

  /// Searches near the frame at which contact is seen, in the first part of the ramp of the load. Where the ramp is too
  /// short for a course, contact may begin at any time in the two frames before the first that shows it.
  TimeDensity in_areas(std::size_t begin, std::size_t at, std::size_t end, bool lost) const {
    constexpr std::size_t kMany = 12;
    constexpr double kNear = 3,
                     kFaint = 0.3;  // frames; of the ramp, at whose end a small area does not count as contact
    const double interval = frames_.interval;
    const std::size_t ramp = lost ? at - begin : end - at, out = lost ? end - at : at - begin,
                      in = std::min(kMany, static_cast<std::size_t>(kShare * static_cast<double>(ramp)));
    const double near = std::max(kNear, kFaint * static_cast<double>(ramp));
    if (static_cast<double>(out) < near + kFew) return {};  // the record may end before contact does
    if (in <= kFew) return even_times(frames_.time[at] - interval, frames_.time[at] + (lost ? interval : 0));
    const std::size_t beyond = std::min(out, std::max(kMany, static_cast<std::size_t>(near) + kFew));
    Readings area;
    area.add(frames_.time, frames_.A, at - (lost ? in : beyond), at + (lost ? beyond : in));
    const double inside = kNear * interval, outside = near * interval;
    return beginning(area, noise_of(area.values), frames_.time[at] - (lost ? inside : outside),
                     frames_.time[at] + (lost ? outside : inside), interval / kSteps, lost);
  }

  /// Equal probabilities.
  TimeDensity even_times(double first, double last) const {
    TimeDensity even{first, frames_.interval / kSteps, {}};
    even.p.assign(static_cast<std::size_t>((last - first) / even.step) + 1, 0);
    for (double& one : even.p) one = 1 / static_cast<double>(even.p.size());
    return even;
  }

  /// Searches as far away as the range of lags allows.
  TimeDensity in_loads(std::size_t begin, std::size_t at, std::size_t end, bool lost) const {
    constexpr std::size_t kBlocks = 150;
    constexpr double kOut = 0.5, kFree = 0.5;  // s; of the time out of contact, at whose other end another may be
    const double middle = frames_.time[at], before = middle - frames_.time[begin],
                 behind = frames_.time[end - 1] - middle;
    const double half = std::max(range_.last - frames_.lag, frames_.lag - range_.first);
    const double free = lost ? behind : before;
    const double out = std::min(half + kOut, std::max(free - half - kBeside * frames_.interval, kFree * free)),
                 in = kShare * (lost ? before : behind);
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

/// The frame behind the last one at which T is about as high as after `begin`: then it is taken back.
std::size_t end_of_sliding(const Frames& frames, const LoadingRun& run, std::size_t begin) {
  constexpr double kHigh = 0.9;
  const auto T = [&](std::size_t i) { return run.direction * frames.T[i] - run.baseline; };
  double most = 0;
  for (std::size_t i = begin; i < run.last; ++i) most = std::max(most, T(i));
  std::size_t end = run.last;
  while (end > begin && T(end - 1) < kHigh * most) --end;
  return end;
}

std::vector<Fall> falls_of(const Frames& frames, const LoadingRun& run) {
  const double sample = frames.samples > 1 ? typical_step(frames.force_time) : frames.interval;
  std::vector<Fall> falls;
  double free = run.shear.time;  // from when the area may follow its trend
  if (run.onset && (run.cycles.empty() || run.onset->time < run.cycles.front().time - 3 * frames.interval))
    falls.push_back({run.onset->time, (run.onset->high - run.onset->low) / 3.92, 0, run.begin, run.last});
  for (const Cycle& cycle : run.cycles) {
    if (!cycle.T_min) break;
    const double lasts = std::max(cycle.time_min - cycle.time, sample), fall = cycle.T_peak - *cycle.T_min;
    // where a line before the fall and one along it meet
    constexpr double kEnd = 2, kOfEven = 3.46;  // error at a line's end over that of its mean; width over deviation
    const double noise = run.noise_T * std::sqrt(frames.samples),
                 along = kEnd * noise / std::sqrt(std::max(lasts / sample, 1.0)),
                 error = std::hypot(sample / kOfEven, std::hypot(cycle.error_peak, along) / fall * lasts);
    if (!falls.empty()) falls.back().last = index_of(cycle.time, frames.time);
    falls.push_back({cycle.time, error, lasts, index_of(free, frames.time), run.last});
    free = cycle.time_min;
  }
  if (!falls.empty()) falls.back().last = end_of_sliding(frames, run, index_of(free, frames.time));
  for (Fall& fall : falls) fall.time -= frames.lag;
  return falls;
}

}  // namespace

TimeDensity lag_by(const LagEvent& event, LagRange range, double interval) {
  const double step = step_of(range, interval);
  const auto count = static_cast<std::size_t>((range.last - range.first) / step) + 1;
  TimeDensity lag{range.first, step, std::vector<double>(count)};
  add_differences(event.in_forces, event.in_areas, lag);
  return lag;
}

std::vector<LagEvent> contact_events(const Recording& forces, const Frames& rough, LagRange range) {
  return ContactEvents(forces, rough, range).find();
}

std::vector<LagEvent> fall_events(const Frames& rough, LagRange range) {
  constexpr std::size_t kBefore = 40, kParabola = 12, kBehind = 12, kFew = 4, kBeside = 3;  // frames
  constexpr double kSudden = 0.05;                                                          // of a frame
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
      // the next fall, or unloading, is off by as much as the lag
      const std::size_t apart = std::max((to - from) / 2, kBeside),
                        end = std::min(to + kBehind, fall.last - std::min(fall.last, apart));
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
