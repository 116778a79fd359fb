#include "dataset/logs/run_errors.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "statistics/noise.h"
#include "statistics/readings.h"

namespace mixity {
namespace {

/// The typical standard deviation of T in the runs; 0 if there are no runs.
double noise_of_runs(const LoadingRuns& found) {
  std::vector<double> noise;
  for (const LoadingRun& run : found.runs) noise.push_back(run.noise_T);
  return noise.empty() ? 0 : median(noise);
}

/// Smooths by local lines: a held load and the response to slow shear are nearly straight for about a second.
std::vector<double> smoothed(const std::vector<double>& values, std::size_t around = 25) {
  std::vector<double> course;
  for (std::size_t i = 0; i < values.size(); ++i)
    course.push_back(line_through(values, i - std::min(i, around), std::min(values.size(), i + around + 1)).at(i));
  return course;
}

/// The course of a held load: constant, a line, or local lines, by BIC. Lines shorter than the load asks for would
/// follow its noise, which neighbouring points then share.
std::vector<double> course_of_load(const std::vector<double>& P) {
  const std::size_t n = P.size();
  std::vector<double> best(n, mean_of(P, 0, n));
  const auto badness = [&](const std::vector<double>& course, double parameters) {
    double squares = 0;
    for (std::size_t i = 0; i < n; ++i) squares += (P[i] - course[i]) * (P[i] - course[i]);
    return static_cast<double>(n) * std::log(squares) + parameters * std::log(static_cast<double>(n));
  };
  double least = badness(best, 1);
  for (std::size_t around = n; around >= 25; around /= 2) {
    std::vector<double> course = smoothed(P, around);
    // each local line has two parameters
    const double lines = std::max(1.0, static_cast<double>(n) / static_cast<double>(2 * around + 1));
    if (const double bad = badness(course, 2 * lines); bad < least) {
      least = bad;
      best = std::move(course);
    }
  }
  return best;
}

/// Fits a line to the baselines over time.
void find_drift(std::optional<bool> drift, LoadingRuns& found) {
  constexpr double kSignificant = 4;  // standard errors of the slope
  auto& runs = found.runs;
  found.drift_removed = drift.value_or(false) && runs.size() >= 2;
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
  if (!(tt > 0)) return;  // zeros read at one time do not determine a drift
  found.drift_T = tb / tt;
  if (runs.size() < 3) return;
  double squares = 0;
  for (const LoadingRun& run : runs) squares += std::pow(base(run) - b - found.drift_T * (at(run) - t), 2);
  found.drift_error =
      std::max(std::sqrt(squares / static_cast<double>(runs.size() - 2)), noise_of_runs(found) / 3) / std::sqrt(tt);
  if (!drift) found.drift_removed = std::abs(found.drift_T) > kSignificant * found.drift_error;
}

void subtract_drift(LoadingRuns& found) {
  for (LoadingRun& run : found.runs) {
    const auto since = [&](double time) { return found.drift_T * (time - run.baseline_time); };
    for (std::size_t i = run.contact; i < run.last; ++i) found.frames.T[i] -= since(found.frames.time[i]);
    for (Cycle& cycle : run.cycles) {
      cycle.T_peak -= run.direction * since(cycle.time);
      if (cycle.T_min) *cycle.T_min -= run.direction * since(cycle.time_min);
    }
  }
}

void finish(const Frames& frames, LoadingRun& run) {
  for (std::size_t i = run.begin; i < run.end; ++i) run.T.push_back(run.direction * frames.T[i] - run.baseline);
  const std::vector<double> P = part_of(frames.P, run.begin, run.end);
  run.smooth_P = course_of_load(P);
  run.P = mean_of(P, 0, P.size());
  double squares = 0;
  for (const double one : P) squares += (one - run.P) * (one - run.P);
  run.scatter_P = std::sqrt(squares / static_cast<double>(std::max<std::size_t>(1, P.size() - 1)));
}

}  // namespace

void remove_drift(std::optional<bool> wanted, LoadingRuns& found) {
  find_drift(wanted, found);
  if (found.drift_removed) subtract_drift(found);
}

void estimate_errors(double noise_A, LoadingRuns& found) {
  for (LoadingRun& run : found.runs) finish(found.frames, run);
  std::vector<std::vector<double>> T, A;
  for (const LoadingRun& run : found.runs) {
    T.push_back(run.T);
    A.push_back(part_of(found.frames.A, run.begin, run.end));
  }
  std::vector<double> zeros, wander;
  for (const LoadingRun& run : found.runs) {
    const std::size_t shear = index_of(run.shear.time, found.frames.time);
    const double before = shear > run.contact ? static_cast<double>(shear - run.contact) : 1;  // frames
    const double rate = run.T.back() / std::max(found.frames.time[run.end - 1] - run.shear.time, found.frames.interval);
    const double since = found.frames.time[run.end - 1] - run.baseline_time;
    zeros.push_back(std::hypot(run.noise_T / std::sqrt(before), rate * found.frames.lag_error));
    // at the end of the run, where T and its influence on lambda are largest
    wander.push_back((found.drift_removed ? found.drift_error : std::abs(found.drift_T)) * since);
  }
  if (!zeros.empty()) {
    found.drifts = median(wander) > median(zeros) && !found.drift_removed;
    found.zero_T_error = std::hypot(median(zeros), median(wander));
  }
  const NoiseModel of_T = noise_model(T, noise_of_runs(found)), of_A = noise_model(A, noise_A);
  for (std::size_t k = 0; k < found.runs.size(); ++k) {
    LoadingRun& run = found.runs[k];
    // based on the smoothed value: otherwise readings low by chance would get more weight than high ones
    for (const double one : smoothed(T[k])) run.sigma_T.push_back(of_T.at(one));
    for (const double one : smoothed(A[k])) run.sigma_A.push_back(of_A.at(one));
  }
}

}  // namespace mixity
