#include "dataset/series/loading_runs.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "dataset/number_text.h"
#include "dataset/series/falls.h"
#include "dataset/series/noise.h"
#include "dataset/series/onset.h"

namespace mixity {
namespace {

constexpr std::size_t kBeforeShear = 5;  // frames of the hold that a run keeps: areas without shear

std::vector<double> part(const std::vector<double>& values, std::size_t begin, std::size_t end) {
  return {values.begin() + static_cast<std::ptrdiff_t>(begin), values.begin() + static_cast<std::ptrdiff_t>(end)};
}

double mean(const std::vector<double>& values, std::size_t begin, std::size_t end) {
  return std::accumulate(values.begin() + static_cast<std::ptrdiff_t>(begin),
                         values.begin() + static_cast<std::ptrdiff_t>(end), 0.0) /
         static_cast<double>(end - begin);
}

struct Stretch {
  std::size_t begin, end;
};

/// Where the area says that there is contact; a lost frame or two do not end it.
std::vector<Stretch> contacts(const Frames& frames, double noise) {
  constexpr std::size_t kLost = 3;
  std::vector<double> sorted = frames.A;
  std::sort(sorted.begin(), sorted.end());
  const double largest = sorted[sorted.size() * 95 / 100], least = std::max(0.05 * largest, 5 * noise);
  std::vector<Stretch> found;
  for (std::size_t i = 0; i < frames.A.size(); ++i) {
    if (!(frames.A[i] > least)) continue;
    if (!found.empty() && i <= found.back().end + kLost)
      found.back().end = i + 1;
    else
      found.push_back({i, i + 1});
  }
  return found;
}

/// Stretches of one load in a contact.
std::vector<Stretch> levels(const std::vector<double>& P, Stretch contact, double noise, double range) {
  constexpr std::size_t kShortest = 10;
  const std::vector<double> inside = part(P, contact.begin, contact.end);
  const double n = static_cast<double>(inside.size());
  auto changes = level_changes(inside, noise * noise, 4 * std::log(std::max(n, 2.0)));
  changes.push_back(inside.size());
  std::vector<Stretch> found;
  for (std::size_t k = 0; k + 1 < changes.size(); ++k) {
    const Stretch one{contact.begin + changes[k], contact.begin + changes[k + 1]};
    if (one.end - one.begin < kShortest) continue;
    // what drifts or is moved by the shear remains one level
    if (!found.empty()) {
      const double before = mean(P, found.back().begin, found.back().end), here = mean(P, one.begin, one.end);
      if (std::abs(here - before) <= std::max({6 * noise, 0.03 * std::abs(before), 0.02 * range})) {
        found.back().end = one.end;
        continue;
      }
    }
    found.push_back(one);
  }
  return found;
}

/// T of a level, less where it began, in the direction in which it goes further.
struct Sheared {
  std::vector<double> T;  // of all frames; only those of the level count
  double direction;
};
Sheared turned(const std::vector<double>& T, Stretch level) {
  const double start = median(part(
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

CutTime cut_of(const Frames& frames, const ChangePoint& change) {
  const auto behind = [&](std::size_t i) {
    return i + 1 < frames.time.size() ? 0.5 * (frames.time[i] + frames.time[i + 1]) : frames.time[i];
  };
  const double margin = frames.interval / 2 + 1.96 * frames.lag_error;  // 95 % of what the lag may be off by
  return {behind(change.at), behind(change.first) - margin, behind(change.last) + margin, false};
}

std::vector<Cycle> cycles_of(const Frames& frames, const std::vector<double>& T, std::size_t begin, std::size_t end,
                             double noise) {
  std::vector<Cycle> cycles;
  for (const Fall& fall : falls(T, begin, end, kFallOfNoise * noise, kLeastFall))
    cycles.push_back({frames.time[fall.top], T[fall.top], frames.time[fall.low],
                      fall.low + 1 < end ? std::optional(T[fall.low]) : std::nullopt});
  return cycles;
}

class Finder {
 public:
  Finder(Frames frames, const std::string& unit, double factor, const RunOptions& options)
      : unit_(unit), factor_(factor), options_(options) {
    found_.frames = std::move(frames);
  }

  LoadingRuns find() {
    Frames& frames = found_.frames;
    noise_A_ = std::max(noise_of(frames.A), 1e-12 * *std::max_element(frames.A.begin(), frames.A.end()));
    const auto touching = contacts(frames, noise_A_);
    take_zero_off(touching);
    const auto [least, most] = std::minmax_element(frames.P.begin(), frames.P.end());
    const double range = *most - *least, noise_P = std::max({noise_of(frames.P), 1e-3 * range, 1e-9 * std::abs(*most)});
    std::size_t reached = 0;
    for (const Stretch& contact : touching) {
      add(reached, contact.begin, "out of contact", "no contact");
      reached = contact.begin;
      for (const Stretch& level : levels(frames.P, contact, noise_P, range)) {
        add(reached, level.begin, "approach", "the load changes");
        run(level);
        reached = level.end;
      }
      add(reached, contact.end, "approach", "the load changes");
      reached = contact.end;
    }
    add(reached, frames.time.size(), "out of contact", "no contact");
    if (options_.drift) take_drift_off();
    for (LoadingRun& one : found_.runs) finish(one);
    tell_noise();
    return std::move(found_);
  }

 private:
  void add(std::size_t begin, std::size_t end, std::string_view name, std::string_view reason) {
    if (end > begin) found_.phases.push_back({begin, end, name, reason});
  }

  /// The zero of the load, as read before the first contact.
  void take_zero_off(const std::vector<Stretch>& touching) {
    constexpr std::size_t kEnough = 10;
    Frames& frames = found_.frames;
    // not the last frames, which may be drawn to contact
    const std::size_t free = touching.empty() ? 0 : touching.front().begin * 8 / 10;
    if (free < kEnough) return;
    const std::vector<double> read = part(frames.P, 0, free);
    found_.zero_P = median(read);
    found_.zero_P_error = 1.2533 * noise_of(read) / std::sqrt(static_cast<double>(free));  // of a median
    for (double& P : frames.P) P -= found_.zero_P;
  }

  void run(Stretch level) {
    const Frames& frames = found_.frames;
    const Sheared sheared = turned(frames.T, level);
    const std::vector<double>& T = sheared.T;
    const double noise_T = std::max(noise_of(part(T, level.begin, level.end)), 1e-9);
    const std::size_t top =
        static_cast<std::size_t>(std::max_element(T.begin() + static_cast<std::ptrdiff_t>(level.begin),
                                                  T.begin() + static_cast<std::ptrdiff_t>(level.end)) -
                                 T.begin());
    LoadingRun run;
    run.contact = level.begin;
    run.last = level.end;
    run.direction = sheared.direction;
    run.P = mean(frames.P, level.begin, level.end);
    run.name = name_of(run.P);
    const auto stated = options_.cuts.find(run.name);
    static const StatedCut kNone;
    const StatedCut& cuts = stated == options_.cuts.end() ? kNone : stated->second;
    if (cuts.leave_out) return add(level.begin, level.end, "left out", "left out as stated");
    if (!(T[top] > 12 * noise_T)) return add(level.begin, level.end, "hold", "T does not rise above its noise");
    // where T leaves its level: until it has risen to a third of what it reaches before it first falls
    const auto fall = first_fall(T, level.begin, level.end, kFallOfNoise * noise_T, kLeastFall);
    const std::size_t highest = fall ? fall->top : top;
    std::size_t third = level.begin;
    while (third < highest && T[third] < T[highest] / 3) ++third;
    const auto hinge = hinge_point({&T, noise_T}, level.begin, std::max(third, std::min(level.begin + 8, highest)));
    std::size_t shear = level.begin;
    std::optional<double> rest;  // T before the shear; null: the level begins sheared
    if (hinge && hinge->slope > 0 && hinge->change.at > level.begin + 2) {
      shear = hinge->change.at + 1;
      run.shear = cut_of(frames, hinge->change);
      rest = mean(T, level.begin, shear);
    } else {
      run.shear = {frames.time[level.begin], frames.time[level.begin], frames.time[level.begin], false};
    }
    if (cuts.shear) {
      shear = frame_at(*cuts.shear, level);
      run.shear = {*cuts.shear, *cuts.shear, *cuts.shear, true};
      if (shear > level.begin) rest = mean(T, level.begin, shear);
    }
    std::size_t end = top + 1;
    if (cuts.onset) {
      run.onset = CutTime{*cuts.onset, *cuts.onset, *cuts.onset, true};
      end = frame_at(*cuts.onset, level);
    } else if (const auto change = onset_of(T, frames.A, shear, level.end, noise_T, noise_A_)) {
      run.onset = cut_of(frames, *change);
      end = change->at + 1;
    }
    if (end < shear + 3)
      return add(level.begin, level.end, "no run",
                 "fewer than three frames between the start of the shear and its end");
    run.begin = rest ? shear - std::min(kBeforeShear, shear - level.begin) : shear;
    run.end = end;
    const double start = frames.T[level.begin] * run.direction - T[level.begin], zero = rest.value_or(-start);
    run.baseline = zero + start;  // of the T that was read
    run.cycles = cycles_of(frames, T, shear, level.end, noise_T);
    for (Cycle& cycle : run.cycles) {
      cycle.T_peak -= zero;
      if (cycle.T_min) *cycle.T_min -= zero;
    }
    add(run.contact, run.begin, "hold", "before the shear");
    add(run.begin, shear, "hold", "");
    add(shear, end, "shear", "");
    add(end, run.last, "sliding", "past the onset of sliding");
    noise_T_.push_back(noise_T);
    found_.runs.push_back(std::move(run));
  }

  std::size_t frame_at(double time, Stretch level) const {
    const auto& times = found_.frames.time;
    const auto at = static_cast<std::size_t>(std::lower_bound(times.begin(), times.end(), time) - times.begin());
    return std::clamp(at, level.begin, level.end);
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
  void take_drift_off() {
    auto& runs = found_.runs;
    if (runs.size() < 2) return;
    const Frames& frames = found_.frames;
    double t = 0, b = 0, tt = 0, tb = 0;
    const auto at = [&](const LoadingRun& run) { return run.shear.time; };
    const auto base = [&](const LoadingRun& run) { return run.direction * run.baseline; };
    for (const LoadingRun& run : runs) {
      t += at(run) / static_cast<double>(runs.size());
      b += base(run) / static_cast<double>(runs.size());
    }
    for (const LoadingRun& run : runs) {
      tt += (at(run) - t) * (at(run) - t);
      tb += (at(run) - t) * (base(run) - b);
    }
    const double slope = tb / tt;
    for (const LoadingRun& run : runs)
      for (std::size_t i = run.contact; i < run.last; ++i) found_.frames.T[i] -= slope * (frames.time[i] - at(run));
  }

  void finish(LoadingRun& run) {
    const Frames& frames = found_.frames;
    for (std::size_t i = run.begin; i < run.end; ++i) run.T.push_back(run.direction * frames.T[i] - run.baseline);
    const std::vector<double> P = part(frames.P, run.begin, run.end);
    // A load that is held follows its mean over a second or so; what lies about that is noise of the reading.
    constexpr std::size_t kAround = 25;
    for (std::size_t i = 0; i < P.size(); ++i) {
      const std::size_t around = std::min({kAround, i, P.size() - 1 - i});
      run.smooth_P.push_back(
          around == kAround || P.size() <= 2 * kAround
              ? mean(P, i - around, i + around + 1)
              : mean(P, i < kAround ? 0 : P.size() - 2 * kAround, i < kAround ? 2 * kAround : P.size()));
    }
    run.P = mean(P, 0, P.size());
    double squares = 0;
    for (const double one : P) squares += (one - run.P) * (one - run.P);
    run.scatter_P = std::sqrt(squares / static_cast<double>(std::max<std::size_t>(1, P.size() - 1)));
  }

  /// Of all runs together: one apparatus has read them.
  void tell_noise() {
    std::vector<std::vector<double>> T, A;
    for (const LoadingRun& run : found_.runs) {
      T.push_back(run.T);
      A.push_back(part(found_.frames.A, run.begin, run.end));
    }
    std::vector<double> zeros;
    for (std::size_t k = 0; k < found_.runs.size(); ++k) {
      const LoadingRun& run = found_.runs[k];
      const auto before = static_cast<double>(std::max<std::ptrdiff_t>(
          1, std::lower_bound(found_.frames.time.begin(), found_.frames.time.end(), run.shear.time) -
                 found_.frames.time.begin() - static_cast<std::ptrdiff_t>(run.contact)));
      const double rate =
          run.T.back() / std::max(found_.frames.time[run.end - 1] - run.shear.time, found_.frames.interval);
      zeros.push_back(std::hypot(noise_T_[k] / std::sqrt(before), rate * found_.frames.lag_error));
    }
    if (!zeros.empty()) found_.zero_T_error = median(zeros);
    const NoiseModel of_T = noise_model(T, noise_T_.empty() ? 0 : median(noise_T_)), of_A = noise_model(A, noise_A_);
    for (std::size_t k = 0; k < found_.runs.size(); ++k) {
      LoadingRun& run = found_.runs[k];
      for (const double one : T[k]) run.sigma_T.push_back(of_T.at(one));
      for (const double one : A[k]) run.sigma_A.push_back(of_A.at(one));
    }
  }

  std::string unit_;
  double factor_;
  const RunOptions& options_;
  LoadingRuns found_;
  double noise_A_ = 0;
  std::vector<double> noise_T_;  // of each run
};

}  // namespace

LoadingRuns find_loading_runs(Frames frames, const std::string& force_unit, double force_factor,
                              const RunOptions& options) {
  return Finder(std::move(frames), force_unit, force_factor, options).find();
}

}  // namespace mixity
