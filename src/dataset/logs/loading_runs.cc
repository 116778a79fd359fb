#include "dataset/logs/loading_runs.h"

#include <algorithm>
#include <cmath>

#include "base/number_text.h"
#include "dataset/dataset.h"
#include "dataset/logs/contacts.h"
#include "dataset/logs/run_errors.h"
#include "statistics/drops.h"
#include "statistics/noise.h"
#include "statistics/readings.h"

namespace mixity {
namespace {

/// The shear of a load step: T starts at 0 and is positive in the direction of its larger excursion. It is written to
/// the places of the step in `sheared`, one array for all steps: copies of the log would take its length times the
/// number of runs.
Shear shear_of(const std::vector<double>& T, FrameRange step, std::vector<double>& sheared) {
  const double start = median(
      part_of(T, step.begin, std::min(step.end, step.begin + std::max<std::size_t>(3, (step.end - step.begin) / 20))));
  double up = 0, down = 0;
  for (std::size_t i = step.begin; i < step.end; ++i) {
    up = std::max(up, T[i] - start);
    down = std::max(down, start - T[i]);
  }
  Shear shear{sheared, down > up ? -1.0 : 1.0, 0, 0};
  for (std::size_t i = step.begin; i < step.end; ++i) sheared[i] = shear.direction * (T[i] - start);
  shear.start = T[step.begin] * shear.direction - shear.T[step.begin];
  shear.noise = std::max(noise_of(part_of(shear.T, step.begin, step.end)), 1e-9);
  return shear;
}

constexpr std::string_view kNotHeld = "the load changes, or is held for fewer than 10 frames or 0.2 s";

class Finder {
 public:
  Finder(Frames frames, const std::string& unit, double factor, const RunOptions& options)
      : unit_(unit), factor_(factor), options_(options) {
    found_.frames = std::move(frames);
    for (const std::string& name : options.taken) names_.take(name);
    sheared_.resize(found_.frames.T.size(), std::nan(""));
    if (options_.by_shear_alone) constant_.resize(found_.frames.A.size());
  }

  LoadingRuns find() {
    Frames& frames = found_.frames;
    noise_A_ = std::max(noise_of(frames.A), 1e-12 * *std::max_element(frames.A.begin(), frames.A.end()));
    const auto touching = contacts(frames, noise_A_);
    const LoadZero zero = load_zero(frames, touching);
    found_.zero_P = zero.value;
    found_.zero_P_error = zero.error;
    for (double& P : frames.P) P -= zero.value;
    rest_T_ = zero_of_shear(frames, touching);
    const auto [least, most] = std::minmax_element(frames.P.begin(), frames.P.end());
    const double range = *most - *least, noise_P = std::max({noise_of(frames.P), 1e-3 * range, 1e-9 * std::abs(*most)});
    std::size_t reached = 0;
    for (const FrameRange& contact : touching) {
      add(reached, contact.begin, "out of contact", "no contact");
      reached = contact.begin;
      for (const FrameRange& step : load_steps(frames, contact, noise_P, range)) {
        add(reached, step.begin, "approach", kNotHeld);
        find_run(step);
        reached = step.end;
      }
      add(reached, contact.end, "approach", kNotHeld);
      reached = contact.end;
    }
    add(reached, frames.time.size(), "out of contact", "no contact");
    remove_drift(options_.drift, found_);
    estimate_errors(noise_A_, found_);
    return std::move(found_);
  }

 private:
  void add(std::size_t begin, std::size_t end, std::string_view name, std::string_view reason) {
    if (end > begin) found_.phases.push_back({begin, end, name, reason});
  }

  /// T out of contact, or the first reading if the log begins and ends in contact.
  static double zero_of_shear(const Frames& frames, const std::vector<FrameRange>& touching) {
    std::vector<double> read;
    std::size_t begin = 0;
    for (const FrameRange& contact : touching) {
      for (std::size_t i = begin; i < contact.begin; ++i) read.push_back(frames.T[i]);
      begin = contact.end;
    }
    return read.empty() ? frames.T.front() : median(read);
  }

  void find_run(FrameRange step) {
    constexpr std::size_t kBeforeShear = 5;  // frames before the shear that a run keeps, as areas without shear
    constexpr double kRises = 12;            // standard deviations of T
    const Frames& frames = found_.frames;
    const Shear shear = shear_of(frames.T, step, sheared_);
    const std::vector<double>& T = shear.T;
    const auto top = static_cast<std::size_t>(std::max_element(T.data() + step.begin, T.data() + step.end) - T.data());
    // if T approaches its zero, the contact is released, not sheared
    if (std::abs(frames.T[top] - rest_T_) < std::abs(frames.T[step.begin] - rest_T_) - kRises * shear.noise)
      return add(step.begin, step.end, "no run", "the shear is only taken back");
    LoadingRun run;
    run.contact = step.begin;
    run.last = step.end;
    run.direction = shear.direction;
    run.noise_T = shear.noise;
    run.P = mean_of(frames.P, step.begin, step.end);
    run.name = names_.free_name("P=" + rounded(run.P / factor_, 3) + " " + unit_);
    const auto stated = options_.cuts.find(run.name);
    const StatedCut cuts = stated == options_.cuts.end() ? StatedCut{} : stated->second;
    require_inside(cuts.shear, cuts, cuts.shear_place, run.name, step);
    require_inside(cuts.onset, cuts, cuts.onset_place, run.name, step);
    if (!(T[top] > kRises * shear.noise)) return add(step.begin, step.end, "hold", "T does not rise above its noise");
    const ShearStart start = start_of_shear(shear, step, top, cuts);
    run.shear = start.cut;
    run.end = end_of_run(shear, step, start.frame, top, cuts, run);
    if (run.end < start.frame + 3)
      return add(step.begin, step.end, "no run", "fewer than three frames between the start of the shear and its end");
    if (cuts.leave_out) {
      names_.take(run.name);
      found_.left_out.push_back(run.name);
      return add(step.begin, step.end, "left out", "left out as stated");
    }
    run.begin = start.rest ? start.frame - std::min(kBeforeShear, start.frame - step.begin) : start.frame;
    const double zero = start.rest.value_or(-shear.start);
    run.baseline = zero + shear.start;
    run.baseline_time = start.rest ? mean_of(frames.time, step.begin, start.frame) : run.shear.time;
    run.cycles = slip_cycles(frames, shear, rising_from(T, start.frame, step.end), step.end);
    const double zero_error = start.rest ? shear.noise / std::sqrt(static_cast<double>(start.frame - step.begin)) : 0;
    for (Cycle& cycle : run.cycles) {
      cycle.T_peak -= zero;
      cycle.error_peak = std::hypot(cycle.error_peak, zero_error);
      if (cycle.T_min) *cycle.T_min -= zero;
      cycle.error_min = std::hypot(cycle.error_min, zero_error);
    }
    add(run.contact, run.begin, "hold", "before the shear");
    add(run.begin, start.frame, "hold", "");
    add(start.frame, run.end, "shear", "");
    add(run.end, run.last, "sliding", "past the onset of sliding");
    names_.take(run.name);
    found_.runs.push_back(std::move(run));
  }

  struct ShearStart {
    std::size_t frame;  // the first frame of the shear
    CutTime cut;
    std::optional<double> rest;  // T before the shear; null: the contact is sheared when the step begins
  };

  /// Where T departs from its baseline, searched until T has risen to a third of its value before its first fall.
  ShearStart start_of_shear(const Shear& shear, FrameRange step, std::size_t top, const StatedCut& cuts) const {
    const Frames& frames = found_.frames;
    const std::vector<double>& T = shear.T;
    if (cuts.shear) {
      const std::size_t frame = frame_at(*cuts.shear, step);
      const bool rests = frame > step.begin;
      return {frame,
              {*cuts.shear, *cuts.shear, *cuts.shear, true},
              rests ? std::optional(mean_of(T, step.begin, frame)) : std::nullopt};
    }
    const auto drop =
        first_drop(T, rising_from(T, step.begin, step.end), step.end, kDropOfNoise * shear.noise, kLeastDrop);
    const std::size_t highest = drop ? drop->top : top;
    std::size_t third = step.begin;
    while (third < highest && T[third] < T[highest] / 3) ++third;
    const auto hinge = hinge_point({&T, shear.noise}, step.begin, std::max(third, std::min(step.begin + 8, highest)));
    if (!hinge || !(hinge->slope > 0) || hinge->change.at <= step.begin + 2) {
      const double begin = frames.time[step.begin];
      return {step.begin, {begin, begin, begin, false}, std::nullopt};
    }
    const std::size_t frame = hinge->change.at + 1;
    CutTime cut = cut_of(frames, hinge->change);
    cut.low -= frames.interval / 2;  // the bend is at a frame, not after it
    return {frame, cut, mean_of(T, step.begin, frame)};
  }

  /// The frame after the last one that the run keeps. Sets the onset of the run.
  std::size_t end_of_run(const Shear& shear, FrameRange step, std::size_t begin, std::size_t top, const StatedCut& cuts,
                         LoadingRun& run) const {
    const Frames& frames = found_.frames;
    if (cuts.onset) {
      run.onset = CutTime{*cuts.onset, *cuts.onset, *cuts.onset, true};
      return frames_before(*cuts.onset, begin, frame_at(*cuts.onset, step));
    }
    const double own_noise = noise_of(part_of(frames.A, step.begin, step.end));
    const bool alone = options_.by_shear_alone;
    const auto change = onset_of(shear.T, alone ? constant_ : frames.A, begin, step.end, shear.noise,
                                 alone           ? 1
                                 : own_noise > 0 ? own_noise
                                                 : noise_A_);
    if (!change) return top + 1;
    if (const auto exact = onset_in_samples(frames, *change, begin, shear.direction)) {
      run.onset = exact;
      return frames_before(exact->time, begin, change->at + 1);
    }
    run.onset = cut_of(frames, *change);
    // leaves out the last frame if it may already slide
    return change->at + (change->first < change->at ? 0 : 1);
  }

  void require_inside(std::optional<double> time, const StatedCut& cuts, FilePlace place, const std::string& run,
                      FrameRange step) const {
    const double first = found_.frames.time[step.begin] - found_.frames.interval,
                 last = found_.frames.time[step.end - 1] + found_.frames.interval;
    if (time && !(*time >= first && *time <= last))
      throw InputError(cuts.file, place,
                       rounded(*time, 7) + " s is no time of run '" + run + "', which is held from " +
                           rounded(first, 6) + " s to " + rounded(last, 6) + " s on the clock of the areas");
  }

  std::size_t frame_at(double time, FrameRange step) const {
    return std::clamp(index_of(time, found_.frames.time), step.begin, step.end);
  }

  /// The end of the range of frames that end before this time.
  std::size_t frames_before(double time, std::size_t begin, std::size_t end) const {
    while (end > begin && found_.frames.time[end - 1] + found_.frames.interval / 2 > time) --end;
    return end;
  }

  std::string unit_;
  double factor_;
  const RunOptions& options_;
  LoadingRuns found_;
  DistinctNames names_;
  double noise_A_ = 0;            // m^2
  double rest_T_ = 0;             // N
  std::vector<double> sheared_;   // T of the steps searched so far, see shear_of; NaN elsewhere
  std::vector<double> constant_;  // replaces areas that are not used
};

}  // namespace

LoadingRuns find_loading_runs(Frames frames, const std::string& force_unit, double force_factor,
                              const RunOptions& options) {
  return Finder(std::move(frames), force_unit, force_factor, options).find();
}

}  // namespace mixity
