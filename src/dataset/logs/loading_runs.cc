#include "dataset/logs/loading_runs.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/number_text.h"
#include "dataset/logs/levels.h"
#include "dataset/logs/onset.h"
#include "statistics/falls.h"
#include "statistics/noise.h"
#include "statistics/readings.h"

namespace mixity {
namespace {

constexpr std::size_t kBeforeShear = 5;  // frames of the hold that a run keeps: areas without shear

/// T of a level, less where it began, in the direction in which it goes further.
struct Sheared {
  std::vector<double> T;  // of all frames; only those of the level count
  double direction;
};
Sheared turned(const std::vector<double>& T, Stretch level) {
  const double start = median(part_of(
      T, level.begin, std::min(level.end, level.begin + std::max<std::size_t>(3, (level.end - level.begin) / 20))));
  double up = 0, down = 0;
  for (std::size_t i = level.begin; i < level.end; ++i) {
    up = std::max(up, T[i] - start);
    down = std::max(down, start - T[i]);
  }
  Sheared sheared{T, down > up ? -1.0 : 1.0};
  for (double& one : sheared.T) one = sheared.direction * (one - start);
  return sheared;
}

/// A held load and what follows a slow shear are as good as a line for a second or so; what lies about that is noise of
/// the reading.
std::vector<double> smoothed(const std::vector<double>& values) {
  constexpr std::size_t kAround = 25;
  std::vector<double> course;
  for (std::size_t i = 0; i < values.size(); ++i)
    course.push_back(line_through(values, i - std::min(i, kAround), std::min(values.size(), i + kAround + 1)).at(i));
  return course;
}

CutTime cut_of(const Frames& frames, const ChangePoint& change) {
  const auto behind = [&](std::size_t i) {
    return i + 1 < frames.time.size() ? 0.5 * (frames.time[i] + frames.time[i + 1]) : frames.time[i];
  };
  const double margin = frames.interval / 2 + 1.96 * frames.lag_error;  // 95 % of what the lag may be off by
  return {behind(change.at), behind(change.first) - margin, behind(change.last) + margin, false};
}

/// The onset among the samples of the force, of which a frame holds many; null if they are few, or tell another time.
std::optional<CutTime> onset_in_samples(const Frames& frames, const ChangePoint& change, std::size_t shear,
                                        double direction) {
  constexpr double kEnough = 4;  // samples in a frame
  constexpr std::size_t kBefore = 8, kFew = 12;
  constexpr std::size_t kLongestFall = 400;  // samples; frames see a longer one
  const auto& times = frames.force_time;
  const CutTime rough = cut_of(frames, change);
  if (frames.samples < kEnough) return std::nullopt;
  const auto at = [&](double time) {
    return static_cast<std::size_t>(std::lower_bound(times.begin(), times.end(), time) - times.begin());
  };
  const std::size_t begin = at(frames.time[std::max(shear, change.at > kBefore ? change.at - kBefore : 0)]),
                    end = at(rough.time + 3 * frames.interval);
  if (end < begin + kFew) return std::nullopt;
  std::vector<double> T = part_of(frames.force_T, begin, end);
  const double noise = noise_of(T);
  for (double& one : T) one *= direction;
  std::size_t last = T.size();
  if (const auto fall = first_fall(T, 0, T.size(), kFallOfNoise * noise)) last = fall->low + 6;
  const std::size_t end_of_fall = std::min(last, T.size());
  auto cut = noise > 0 ? break_point({{&T, noise}}, 0, end_of_fall) : std::nullopt;
  if (!cut) return std::nullopt;
  cut = beginning_of_fall({&T, noise}, 0, end_of_fall, *cut, kLongestFall);
  const auto behind = [&](std::size_t i) {
    return 0.5 * (times[begin + i] + times[std::min(begin + i + 1, times.size() - 1)]);
  };
  const double margin = 1.96 * frames.lag_error;
  const CutTime exact{behind(cut->at), behind(cut->first) - margin, behind(cut->last) + margin, false};
  return std::abs(exact.time - rough.time) < 3 * frames.interval ? std::optional(exact) : std::nullopt;
}

class Finder {
 public:
  Finder(Frames frames, const std::string& unit, double factor, const RunOptions& options)
      : unit_(unit), factor_(factor), options_(options) {
    found_.frames = std::move(frames);
    if (options_.by_shear_alone) still_.resize(found_.frames.A.size());
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
    for (const Stretch& contact : touching) {
      add(reached, contact.begin, "out of contact", "no contact");
      reached = contact.begin;
      for (const Stretch& level : load_levels(frames, contact, noise_P, range)) {
        add(reached, level.begin, "approach", "the load changes");
        run(level);
        reached = level.end;
      }
      add(reached, contact.end, "approach", "the load changes");
      reached = contact.end;
    }
    add(reached, frames.time.size(), "out of contact", "no contact");
    find_drift();
    if (found_.drift_removed) take_drift_off();
    for (LoadingRun& one : found_.runs) finish(one);
    tell_noise();
    return std::move(found_);
  }

 private:
  void add(std::size_t begin, std::size_t end, std::string_view name, std::string_view reason) {
    if (end > begin) found_.phases.push_back({begin, end, name, reason});
  }

  /// T out of contact, or as first read in contact.
  static double zero_of_shear(const Frames& frames, const std::vector<Stretch>& touching) {
    std::vector<double> read;
    std::size_t begin = 0;
    for (const Stretch& contact : touching) {
      for (std::size_t i = begin; i < contact.begin; ++i) read.push_back(frames.T[i]);
      begin = contact.end;
    }
    return read.empty() ? frames.T.front() : median(read);
  }

  void run(Stretch level) {
    const Frames& frames = found_.frames;
    const Sheared sheared = turned(frames.T, level);
    const std::vector<double>& T = sheared.T;
    const double noise_T = std::max(noise_of(part_of(T, level.begin, level.end)), 1e-9),
                 own_noise_A = noise_of(part_of(frames.A, level.begin, level.end)),
                 noise_A = own_noise_A > 0 ? own_noise_A : noise_A_;
    const std::size_t top =
        static_cast<std::size_t>(std::max_element(T.begin() + static_cast<std::ptrdiff_t>(level.begin),
                                                  T.begin() + static_cast<std::ptrdiff_t>(level.end)) -
                                 T.begin());
    // a contact that is let go is not sheared: T comes nearer to its zero
    if (std::abs(frames.T[top] - rest_T_) < std::abs(frames.T[level.begin] - rest_T_) - 12 * noise_T)
      return add(level.begin, level.end, "no run", "the shear is only taken back");
    LoadingRun run;
    run.contact = level.begin;
    run.last = level.end;
    run.direction = sheared.direction;
    run.P = mean_of(frames.P, level.begin, level.end);
    run.name = name_of(run.P);
    const auto stated = options_.cuts.find(run.name);
    static const StatedCut kNone;
    const StatedCut& cuts = stated == options_.cuts.end() ? kNone : stated->second;
    require_inside(cuts.shear, cuts, cuts.shear_place, run.name, level);
    require_inside(cuts.onset, cuts, cuts.onset_place, run.name, level);
    if (cuts.leave_out) return add(level.begin, level.end, "left out", "left out as stated");
    if (!(T[top] > 12 * noise_T)) return add(level.begin, level.end, "hold", "T does not rise above its noise");
    // where T leaves its level: until it has risen to a third of what it reaches before it first falls
    const auto fall =
        first_fall(T, rising_from(T, level.begin, level.end), level.end, kFallOfNoise * noise_T, kLeastFall);
    const std::size_t highest = fall ? fall->top : top;
    std::size_t third = level.begin;
    while (third < highest && T[third] < T[highest] / 3) ++third;
    const auto hinge = hinge_point({&T, noise_T}, level.begin, std::max(third, std::min(level.begin + 8, highest)));
    std::size_t shear = level.begin;
    std::optional<double> rest;  // T before the shear; null: the level begins sheared
    if (hinge && hinge->slope > 0 && hinge->change.at > level.begin + 2) {
      shear = hinge->change.at + 1;
      run.shear = cut_of(frames, hinge->change);
      rest = mean_of(T, level.begin, shear);
    } else {
      run.shear = {frames.time[level.begin], frames.time[level.begin], frames.time[level.begin], false};
    }
    if (cuts.shear) {
      shear = frame_at(*cuts.shear, level);
      run.shear = {*cuts.shear, *cuts.shear, *cuts.shear, true};
      if (shear > level.begin) rest = mean_of(T, level.begin, shear);
    }
    std::size_t end = top + 1;
    if (cuts.onset) {
      run.onset = CutTime{*cuts.onset, *cuts.onset, *cuts.onset, true};
      end = frames_before(*cuts.onset, shear, frame_at(*cuts.onset, level));
    } else if (const auto change = onset_of(T, options_.by_shear_alone ? still_ : frames.A, shear, level.end, noise_T,
                                            options_.by_shear_alone ? 1 : noise_A)) {
      run.onset = cut_of(frames, *change);
      if (const auto exact = onset_in_samples(frames, *change, shear, run.direction)) {
        run.onset = exact;
        end = frames_before(exact->time, shear, change->at + 1);
      } else {
        // the last frame that may as well be the first to slide is no loss
        end = change->at + (change->first < change->at ? 0 : 1);
      }
    }
    if (end < shear + 3)
      return add(level.begin, level.end, "no run",
                 "fewer than three frames between the start of the shear and its end");
    run.begin = rest ? shear - std::min(kBeforeShear, shear - level.begin) : shear;
    run.end = end;
    const double start = frames.T[level.begin] * run.direction - T[level.begin], zero = rest.value_or(-start);
    run.baseline = zero + start;  // of the T that was read
    run.baseline_time = rest ? mean_of(frames.time, level.begin, shear) : run.shear.time;
    run.cycles = slip_cycles(frames, {T, run.direction, start, noise_T}, rising_from(T, shear, level.end), level.end);
    const double zero_error = rest ? noise_T / std::sqrt(static_cast<double>(shear - level.begin)) : 0;
    for (Cycle& cycle : run.cycles) {
      cycle.T_peak -= zero;
      cycle.error_peak = std::hypot(cycle.error_peak, zero_error);
      if (cycle.T_min) *cycle.T_min -= zero;
      cycle.error_min = std::hypot(cycle.error_min, zero_error);
    }
    add(run.contact, run.begin, "hold", "before the shear");
    add(run.begin, shear, "hold", "");
    add(shear, end, "shear", "");
    add(end, run.last, "sliding", "past the onset of sliding");
    noise_T_.push_back(noise_T);
    found_.runs.push_back(std::move(run));
  }

  void require_inside(std::optional<double> time, const StatedCut& cuts, FilePlace place, const std::string& run,
                      Stretch level) const {
    const double first = found_.frames.time[level.begin] - found_.frames.interval,
                 last = found_.frames.time[level.end - 1] + found_.frames.interval;
    if (time && !(*time >= first && *time <= last))
      throw InputError(cuts.file, place,
                       rounded(*time, 7) + " s is no time of run '" + run + "', which is held from " +
                           rounded(first, 6) + " s to " + rounded(last, 6) + " s on the clock of the areas");
  }

  std::size_t frame_at(double time, Stretch level) const {
    const auto& times = found_.frames.time;
    const auto at = static_cast<std::size_t>(std::lower_bound(times.begin(), times.end(), time) - times.begin());
    return std::clamp(at, level.begin, level.end);
  }

  /// The end of the frames that are over at that time.
  std::size_t frames_before(double time, std::size_t begin, std::size_t end) const {
    while (end > begin && found_.frames.time[end - 1] + found_.frames.interval / 2 > time) --end;
    return end;
  }

  std::string name_of(double P) const {
    const std::string name = "P=" + rounded(P / factor_, 3) + " " + unit_;
    std::string own = name;
    const auto taken = [&] {
      return std::any_of(found_.runs.begin(), found_.runs.end(),
                         [&](const LoadingRun& run) { return run.name == own; });
    };
    for (int same = 2; taken(); ++same) own = name + " (" + std::to_string(same) + ")";
    return own;
  }

  /// A line through the baselines over time, as a drift of the zero within runs.
  void find_drift() {
    constexpr double kSure = 4;  // standard errors of the slope
    auto& runs = found_.runs;
    found_.drift_removed = options_.drift.value_or(false) && runs.size() >= 2;
    if (runs.size() < 2) return;
    double t = 0, b = 0, tt = 0, tb = 0;
    const auto at = [&](const LoadingRun& run) { return run.baseline_time; };
    const auto base = [&](const LoadingRun& run) { return run.direction * run.baseline; };
    for (const LoadingRun& run : runs) {
      t += at(run) / static_cast<double>(runs.size());
      b += base(run) / static_cast<double>(runs.size());
    }
    for (const LoadingRun& run : runs) {
      tt += (at(run) - t) * (at(run) - t);
      tb += (at(run) - t) * (base(run) - b);
    }
    found_.drift_T = tb / tt;
    if (runs.size() < 3) return;
    double squares = 0;
    for (const LoadingRun& run : runs) squares += std::pow(base(run) - b - found_.drift_T * (at(run) - t), 2);
    found_.drift_error =
        std::max(std::sqrt(squares / static_cast<double>(runs.size() - 2)), median(noise_T_) / 3) / std::sqrt(tt);
    if (!options_.drift) found_.drift_removed = std::abs(found_.drift_T) > kSure * found_.drift_error;
  }
  void take_drift_off() {
    for (LoadingRun& run : found_.runs) {
      const auto since = [&](double time) { return found_.drift_T * (time - run.baseline_time); };
      for (std::size_t i = run.contact; i < run.last; ++i) found_.frames.T[i] -= since(found_.frames.time[i]);
      for (Cycle& cycle : run.cycles) {
        cycle.T_peak -= run.direction * since(cycle.time);
        if (cycle.T_min) *cycle.T_min -= run.direction * since(cycle.time_min);
      }
    }
  }

  void finish(LoadingRun& run) {
    const Frames& frames = found_.frames;
    for (std::size_t i = run.begin; i < run.end; ++i) run.T.push_back(run.direction * frames.T[i] - run.baseline);
    const std::vector<double> P = part_of(frames.P, run.begin, run.end);
    run.smooth_P = smoothed(P);
    run.P = mean_of(P, 0, P.size());
    double squares = 0;
    for (const double one : P) squares += (one - run.P) * (one - run.P);
    run.scatter_P = std::sqrt(squares / static_cast<double>(std::max<std::size_t>(1, P.size() - 1)));
  }

  /// Of all runs together: one apparatus has read them.
  void tell_noise() {
    std::vector<std::vector<double>> T, A;
    for (const LoadingRun& run : found_.runs) {
      T.push_back(run.T);
      A.push_back(part_of(found_.frames.A, run.begin, run.end));
    }
    std::vector<double> zeros, wander;
    for (std::size_t k = 0; k < found_.runs.size(); ++k) {
      const LoadingRun& run = found_.runs[k];
      const auto before = static_cast<double>(std::max<std::ptrdiff_t>(
          1, std::lower_bound(found_.frames.time.begin(), found_.frames.time.end(), run.shear.time) -
                 found_.frames.time.begin() - static_cast<std::ptrdiff_t>(run.contact)));
      const double rate =
          run.T.back() / std::max(found_.frames.time[run.end - 1] - run.shear.time, found_.frames.interval);
      const double since = found_.frames.time[run.end - 1] - run.baseline_time;
      zeros.push_back(std::hypot(noise_T_[k] / std::sqrt(before), rate * found_.frames.lag_error));
      // at its end, where T and what it says of lambda are largest
      wander.push_back((found_.drift_removed ? found_.drift_error : std::abs(found_.drift_T)) * since);
    }
    if (!zeros.empty()) {
      found_.drifts = median(wander) > median(zeros) && !found_.drift_removed;
      found_.zero_T_error = std::hypot(median(zeros), median(wander));
    }
    const NoiseModel of_T = noise_model(T, noise_T_.empty() ? 0 : median(noise_T_)), of_A = noise_model(A, noise_A_);
    for (std::size_t k = 0; k < found_.runs.size(); ++k) {
      LoadingRun& run = found_.runs[k];
      // of the course, not of the reading: readings that are low by chance would weigh more than those that are high
      for (const double one : smoothed(T[k])) run.sigma_T.push_back(of_T.at(one));
      for (const double one : smoothed(A[k])) run.sigma_A.push_back(of_A.at(one));
    }
  }

  std::string unit_;
  double factor_;
  const RunOptions& options_;
  LoadingRuns found_;
  double noise_A_ = 0;
  double rest_T_ = 0;            // N
  std::vector<double> still_;    // an area that says nothing
  std::vector<double> noise_T_;  // of each run
};

}  // namespace

LoadingRuns find_loading_runs(Frames frames, const std::string& force_unit, double force_factor,
                              const RunOptions& options) {
  return Finder(std::move(frames), force_unit, force_factor, options).find();
}

}  // namespace mixity
