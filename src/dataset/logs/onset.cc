#include "dataset/logs/onset.h"

#include <algorithm>
#include <cmath>

#include "statistics/drops.h"
#include "statistics/noise.h"
#include "statistics/readings.h"

namespace mixity {
namespace {

constexpr std::size_t kBefore = 12;  // readings from which a parabola is extrapolated

/// A parabola through the last readings before `end`, extrapolated by `steps` beyond the last one. A straight line
/// would show false breaks: a stage that pulls through a spring bends T, and the area bends towards the fold. The
/// polynomials 1, x and x^2 - mean of x^2 are orthogonal for readings at x = -middle..middle.
struct Ahead {
  static constexpr double n = kBefore, middle = (n - 1) / 2, mean_square = (n * n - 1) / 12, xx = n * (n * n - 1) / 12,
                          qq = n * (n * n - 1) * (n * n - 4) / 180;
  double value = 0, slope = 0;  // the slope at the last reading

  Ahead(const std::vector<double>& y, std::size_t end, double steps) {
    double sum = 0, first = 0, second = 0;
    for (std::size_t i = 0; i < kBefore; ++i) {
      const double x = static_cast<double>(i) - middle, reading = y[end - kBefore + i];
      sum += reading;
      first += x * reading;
      second += (x * x - mean_square) * reading;
    }
    const double x = middle + steps;
    value = sum / n + first / xx * x + second / qq * (x * x - mean_square);
    slope = first / xx + 2 * second / qq * middle;
  }
  /// Variance of the value, in variances of one reading.
  static double variance(double steps) {
    const double x = middle + steps, q = x * x - mean_square;
    return 1 / n + x * x / xx + q * q / qq;
  }
};

/// Means of `width` readings from `begin` on.
std::vector<double> blocks(const std::vector<double>& y, std::size_t begin, std::size_t end, std::size_t width) {
  std::vector<double> means;
  for (std::size_t i = begin; i + width <= end; i += width) means.push_back(mean_of(y, i, i + width));
  return means;
}

/// A place where three blocks lie below the extrapolation, in T alone or in T and A, and T has lost much of its slope.
struct Break {
  std::size_t before, seen, width;  // the last frame before the three blocks, their last frame, frames in a block
};
std::optional<Break> first_break(const std::vector<double>& T, const std::vector<double>& A, std::size_t begin,
                                 std::size_t end, double noise_T, double noise_A, std::size_t width) {
  constexpr std::size_t kBehind = 3;
  constexpr double kMiddle = (kBehind + 1) / 2.0;
  constexpr double kAlone = 6, kEach = 3.5, kTogether = 8;  // standard deviations
  constexpr double kSlopeLost = 0.4;
  const std::vector<double> T_means = blocks(T, begin, end, width), A_means = blocks(A, begin, end, width);
  const double error = std::sqrt((Ahead::variance(kMiddle) + 1.0 / kBehind) / static_cast<double>(width));
  for (std::size_t cut = kBefore; cut + kBehind <= T_means.size(); ++cut) {
    const Ahead T_ahead(T_means, cut, kMiddle), A_ahead(A_means, cut, kMiddle);
    const double lost = T_ahead.value - mean_of(T_means, cut, cut + kBehind), by_T = lost / (noise_T * error),
                 by_A = (A_ahead.value - mean_of(A_means, cut, cut + kBehind)) / (noise_A * error);
    if (!(by_T > kAlone || (by_T > kEach && by_A > kEach && by_T + by_A > kTogether * std::sqrt(2.0)))) continue;
    if (!(lost > kSlopeLost * kMiddle * T_ahead.slope)) continue;
    return Break{begin + cut * width - 1, begin + (cut + kBehind) * width - 1, width};
  }
  return std::nullopt;
}

constexpr std::size_t kAround = 15;

/// Where to search for a break: in first..last; `top` is the last frame that may precede it.
struct Place {
  std::size_t first, seen, last, top;
};

/// Finds the earliest break in means of 1, 4 or 16 frames, as noise hides it in frames of fast cameras and slow ramps.
void take_break(const std::vector<double>& T, const std::vector<double>& A, std::size_t begin, std::size_t end,
                double noise_T, double noise_A, std::optional<Place>& place) {
  for (const std::size_t width : {1, 4, 16})
    if (const auto found = first_break(T, A, begin, end, noise_T, noise_A, width);
        found && (!place || found->seen < place->seen))
      // a sliding contact does not relax along a line, so as little of it as possible is used
      place = Place{found->before > kAround + width ? found->before - kAround - width : 0, found->seen,
                    found->seen + std::max<std::size_t>(width, 2), found->before};
}

/// The most likely break of the courses at this place, excluding frames before it that it already affects.
ChangePoint settle(const std::vector<Course>& courses, std::size_t begin, std::size_t end, const Place& place) {
  constexpr double kFar = 3.5;  // standard deviations
  ChangePoint found = break_point(courses, std::max(place.first, begin), std::min(place.last, end))
                          .value_or(ChangePoint{place.top, place.top, place.top});
  const auto slides = [&](std::size_t i) {
    return std::any_of(courses.begin(), courses.end(), [&](const Course& course) {
      return i >= begin + kBefore && Ahead(*course.values, i, 1).value - (*course.values)[i] >
                                         kFar * course.noise * std::sqrt(1 + Ahead::variance(1));
    });
  };
  const auto few_before = [&] { return found.at > begin + 6 ? found.at - 2 : found.at; };
  for (std::size_t i = few_before(); i <= found.at && i > begin + 3; ++i)
    if (slides(i)) {
      found.at = i - 1;
      i = few_before() - 1;
    }
  found.first = std::min(found.first, found.at);
  return found;
}

}  // namespace

std::optional<ChangePoint> onset_of(const std::vector<double>& T, const std::vector<double>& A, std::size_t shear,
                                    std::size_t end, double noise_T, double noise_A) {
  constexpr std::size_t kFewBehind = 4;
  std::optional<Place> place;
  if (const auto drop = first_drop(T, rising_from(T, shear, end), end, kDropOfNoise * noise_T, kLeastDrop))
    place = Place{drop->top > kAround ? drop->top - kAround : 0, drop->seen,
                  std::max(drop->seen + 3, std::min(drop->low + 1, drop->seen + kFewBehind)), drop->top};
  take_break(T, A, shear, end, noise_T, noise_A, place);
  if (!place) return std::nullopt;
  ChangePoint found = settle({{&T, noise_T}, {&A, noise_A}}, shear, end, *place);
  // a frame that is affected by the drop belongs to it
  const auto highest = [&](std::size_t i) {
    return *std::max_element(T.data() + i - std::min<std::size_t>(i, 3), T.data() + i + 1);
  };
  while (found.at > shear + 3 && T[found.at] < highest(found.at) - 3 * noise_T) --found.at;
  found.first = std::min(found.first, found.at);
  return found;
}

CutTime cut_of(const Frames& frames, const ChangePoint& change) {
  const auto behind = [&](std::size_t i) {
    return i + 1 < frames.time.size() ? 0.5 * (frames.time[i] + frames.time[i + 1]) : frames.time[i];
  };
  const double margin = frames.interval / 2 + 1.96 * frames.lag_error;
  return {behind(change.at), behind(change.first) - margin, behind(change.last) + margin, false};
}

std::optional<CutTime> onset_in_samples(const Frames& frames, const ChangePoint& change, std::size_t shear,
                                        double direction) {
  constexpr double kEnough = 4;  // samples in a frame
  constexpr std::size_t kLead = 8, kFew = 12;
  constexpr std::size_t kLongestDrop = 400;  // samples; a longer drop shows in the frames
  const auto& times = frames.force_time;
  const CutTime rough = cut_of(frames, change);
  if (frames.samples < kEnough) return std::nullopt;
  const std::size_t begin = index_of(frames.time[std::max(shear, change.at > kLead ? change.at - kLead : 0)], times),
                    end = index_of(rough.time + 3 * frames.interval, times);
  if (end < begin + kFew) return std::nullopt;
  std::vector<double> T = part_of(frames.force_T, begin, end);
  const double noise = noise_of(T);
  for (double& one : T) one *= direction;
  std::size_t last = T.size();
  if (const auto drop = first_drop(T, 0, T.size(), kDropOfNoise * noise)) last = drop->low + 6;
  const std::size_t end_of_drop = std::min(last, T.size());
  auto cut = noise > 0 ? break_point({{&T, noise}}, 0, end_of_drop) : std::nullopt;
  if (!cut) return std::nullopt;
  cut = beginning_of_drop({&T, noise}, 0, end_of_drop, *cut, kLongestDrop);
  const auto behind = [&](std::size_t i) {
    return 0.5 * (times[begin + i] + times[std::min(begin + i + 1, times.size() - 1)]);
  };
  const double margin = 1.96 * frames.lag_error;
  const CutTime exact{behind(cut->at), behind(cut->first) - margin, behind(cut->last) + margin, false};
  return std::abs(exact.time - rough.time) < 3 * frames.interval ? std::optional(exact) : std::nullopt;
}

std::optional<ChangePoint> first_break_below(const Course& course, std::size_t begin, std::size_t end) {
  std::optional<Place> place;
  take_break(*course.values, std::vector<double>(course.values->size()), begin, end, course.noise, 1, place);
  if (!place) return std::nullopt;
  return settle({course}, begin, end, *place);
}

}  // namespace mixity
