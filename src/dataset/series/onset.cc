#include "dataset/series/onset.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "dataset/series/falls.h"

namespace mixity {
namespace {

/// The first three frames below what the line through a dozen before them leads to, in T alone or in T and A.
std::optional<Fall> first_break(const std::vector<double>& T, const std::vector<double>& A, std::size_t begin,
                                std::size_t end, double noise_T, double noise_A) {
  constexpr std::size_t kBefore = 12, kBehind = 3;
  constexpr double kAlone = 6, kEach = 3.5, kTogether = 8;  // standard deviations
  // mean of the readings behind less the line before, and its variance in those of one reading
  const auto below = [&](const std::vector<double>& y, std::size_t cut) {
    const auto at = y.begin() + static_cast<std::ptrdiff_t>(cut);
    double sum = 0, slope = 0;
    constexpr double n = kBefore, xx = n * (n * n - 1) / 12, middle = (n - 1) / 2,
                     ahead = n - 1 + (kBehind + 1) / 2.0 - middle;
    for (std::size_t i = 0; i < kBefore; ++i) {
      const double value = y[cut - kBefore + i];
      sum += value;
      slope += (static_cast<double>(i) - middle) * value / xx;
    }
    const double expected = sum / n + slope * ahead, variance = 1.0 / kBehind + 1 / n + ahead * ahead / xx;
    return (expected - std::accumulate(at, at + kBehind, 0.0) / kBehind) / std::sqrt(variance);
  };
  for (std::size_t cut = begin + kBefore; cut + kBehind <= end; ++cut) {
    const double by_T = below(T, cut) / noise_T, by_A = below(A, cut) / noise_A;
    if (!(by_T > kAlone || (by_T > kEach && by_A > kEach && by_T + by_A > kTogether * std::sqrt(2.0)))) continue;
    const auto top = std::max_element(T.begin() + static_cast<std::ptrdiff_t>(cut - kBehind),
                                      T.begin() + static_cast<std::ptrdiff_t>(cut + 1));
    const std::size_t seen = cut + kBehind - 1;
    return Fall{static_cast<std::size_t>(top - T.begin()), seen, bottom(T, seen, end, kFallOfNoise * noise_T)};
  }
  return std::nullopt;
}

}  // namespace

std::optional<ChangePoint> onset_of(const std::vector<double>& T, const std::vector<double>& A, std::size_t shear,
                                    std::size_t end, double noise_T, double noise_A) {
  constexpr std::size_t kAround = 15;
  auto fall = first_fall(T, shear, end, kFallOfNoise * noise_T, kLeastFall);
  if (const auto sudden = first_break(T, A, shear, end, noise_T, noise_A);
      sudden && (!fall || sudden->seen < fall->seen))
    fall = sudden;
  if (!fall) return std::nullopt;
  const std::size_t first = std::max(shear, fall->top > kAround ? fall->top - kAround : 0),
                    last = std::min({end, std::max(fall->low + 1, fall->seen + 3), fall->seen + kAround});
  ChangePoint found =
      break_point({{&T, noise_T}, {&A, noise_A}}, first, last).value_or(ChangePoint{fall->top, fall->top, fall->top});
  // a frame that saw part of the fall belongs to it
  const auto highest = [&](std::size_t i) {
    const auto at = T.begin() + static_cast<std::ptrdiff_t>(i);
    return *std::max_element(at - static_cast<std::ptrdiff_t>(std::min<std::size_t>(i, 3)), at + 1);
  };
  while (found.at > shear + 3 && T[found.at] < highest(found.at) - 3 * noise_T) --found.at;
  found.first = std::min(found.first, found.at);
  return found;
}

}  // namespace mixity
