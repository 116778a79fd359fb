#include "dataset/logs/contacts.h"

#include <algorithm>
#include <cmath>

#include "statistics/change_points.h"
#include "statistics/noise.h"
#include "statistics/readings.h"

namespace mixity {

std::vector<FrameRange> contacts(const Frames& frames, double noise) {
  constexpr std::size_t kLost = 3;
  std::vector<double> sorted = frames.A;
  std::sort(sorted.begin(), sorted.end());
  const double largest = sorted[sorted.size() * 95 / 100], least = std::max(0.05 * largest, 5 * noise);
  std::vector<FrameRange> found;
  for (std::size_t i = 0; i < frames.A.size(); ++i) {
    if (!(frames.A[i] > least)) continue;
    if (!found.empty() && i <= found.back().end + kLost)
      found.back().end = i + 1;
    else
      found.push_back({i, i + 1});
  }
  return found;
}

std::vector<FrameRange> load_steps(const Frames& frames, FrameRange contact, double noise, double range) {
  constexpr std::size_t kFewest = 10;
  constexpr double kShortest = 0.2;  // s: with a fast camera a ramp of the load looks like stairs
  const std::vector<double> inside = part_of(frames.P, contact.begin, contact.end);
  const double n = static_cast<double>(inside.size());
  auto changes = mean_changes(inside, noise * noise, 4 * std::log(std::max(n, 2.0)));
  changes.push_back(inside.size());
  // a drift, or the effect of the shear on the load, is not a new step
  const auto least_step = [&](double load) {
    return std::max({6 * noise, 0.06 * std::abs(load), std::min(0.02 * range, 0.15 * std::abs(load))});
  };
  std::vector<FrameRange> found;
  for (std::size_t k = 0; k + 1 < changes.size(); ++k) {
    const FrameRange one{contact.begin + changes[k], contact.begin + changes[k + 1]};
    if (one.end - one.begin < kFewest) continue;
    if (!found.empty()) {
      const double before = mean_of(frames.P, found.back().begin, found.back().end);
      if (std::abs(mean_of(frames.P, one.begin, one.end) - before) <= least_step(before)) {
        found.back().end = one.end;
        continue;
      }
    }
    found.push_back(one);
  }
  std::erase_if(found, [&](const FrameRange& step) {
    const StraightLine P = line_through(frames.P, step.begin, step.end);
    return frames.time[step.end - 1] - frames.time[step.begin] < kShortest ||
           std::abs(P.slope * static_cast<double>(step.end - step.begin - 1)) > least_step(P.mean);
  });
  return found;
}

LoadZero load_zero(const Frames& frames, const std::vector<FrameRange>& touching) {
  if (frames.load_is_stated) return {};
  constexpr double kFewest = 30, kBeside = 0.2;  // samples; fraction of each gap in which contact may affect P
  std::vector<double> read;
  std::size_t begin = 0;
  for (std::size_t k = 0; k <= touching.size(); ++k) {
    const std::size_t end = k < touching.size() ? touching[k].begin : frames.P.size();
    const auto margin = static_cast<std::size_t>(std::ceil(kBeside * static_cast<double>(end - begin)));
    for (std::size_t i = begin + (begin > 0 ? margin : 0); i + margin < end; ++i) read.push_back(frames.P[i]);
    if (k < touching.size()) begin = touching[k].end;
  }
  if (touching.empty() || static_cast<double>(read.size()) * frames.samples < kFewest) return {};
  // the scatter of the readings includes wander of the zero, their noise does not
  std::vector<double> apart;
  const double zero = median(read);
  for (const double one : read) apart.push_back(std::abs(one - zero));
  const double scatter = std::max(kOfMedian * median(apart), frames.noise_P / std::sqrt(frames.samples));
  constexpr double kOverMean = 1.2533;  // standard error of a median over that of a mean
  return {zero, kOverMean * scatter / std::sqrt(static_cast<double>(read.size()))};
}

}  // namespace mixity
