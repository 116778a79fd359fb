#include "statistics/change_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "statistics/readings.h"

namespace mixity {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();
constexpr double kLikely = 3.841458820694124;  // 95 % of chi^2 of one degree of freedom

/// level + slope x, where x counts from the first reading and level is relative to that reading.
struct Line {
  double level, slope;
  double at(std::size_t x) const { return level + slope * static_cast<double>(x); }
};

/// The line through two readings.
Line line_between(std::size_t x0, double y0, std::size_t x1, double y1) {
  const double slope = (y1 - y0) / static_cast<double>(x1 - x0);
  return {y0 - slope * static_cast<double>(x0), slope};
}

constexpr std::size_t kLeast = 3;  // readings on either side of a change

/// Partial sums of readings, from which squares about a mean or a line follow.
class PartialSums {
 public:
  explicit PartialSums(const std::vector<double>& values, std::size_t begin, std::size_t end) : begin_(begin) {
    const std::size_t n = end - begin;
    y_.resize(n + 1);
    yy_.resize(n + 1);
    xy_.resize(n + 1);
    const double middle = values[begin];  // keeps the squares small
    for (std::size_t i = 0; i < n; ++i) {
      const double y = values[begin + i] - middle;
      y_[i + 1] = y_[i] + y;
      yy_[i + 1] = yy_[i] + y * y;
      xy_[i + 1] = xy_[i] + static_cast<double>(i) * y;
    }
  }
  double about_mean(std::size_t from, std::size_t to) const {
    const Sums s = sums(from, to);
    return std::max(0.0, s.yy - s.y * s.y / s.n);
  }
  double about_line(std::size_t from, std::size_t to) const {
    const Sums s = sums(from, to);
    return std::max(0.0, s.yy - s.y * s.y / s.n - s.xy * s.xy / s.xx());
  }
  /// The least-squares line through from..to.
  Line line(std::size_t from, std::size_t to) const {
    const Sums s = sums(from, to);
    const double slope = s.xy / s.xx();
    return {s.y / s.n - slope * s.middle, slope};
  }
  double about_given(const Line& line, std::size_t from, std::size_t to) const {
    const std::size_t i = from - begin_, j = to - begin_;
    const double n = static_cast<double>(j - i), first = static_cast<double>(i), x = n * (first + (n - 1) / 2);
    const double xx = n * first * (first + n - 1) + (n - 1) * n * (2 * n - 1) / 6;
    return std::max(0.0, yy_[j] - yy_[i] - 2 * line.level * (y_[j] - y_[i]) - 2 * line.slope * (xy_[j] - xy_[i]) +
                             n * line.level * line.level + 2 * line.level * line.slope * x +
                             line.slope * line.slope * xx);
  }

 private:
  /// Sums over n readings; x of xy and xx is relative to their middle.
  struct Sums {
    double n, middle, y, yy, xy;
    double xx() const { return n * (n * n - 1) / 12; }
  };
  Sums sums(std::size_t from, std::size_t to) const {
    const std::size_t i = from - begin_, j = to - begin_;
    const double n = static_cast<double>(j - i), y = y_[j] - y_[i], middle = static_cast<double>(i) + (n - 1) / 2;
    return {n, middle, y, yy_[j] - yy_[i], xy_[j] - xy_[i] - middle * y};
  }

  std::size_t begin_;
  std::vector<double> y_, yy_, xy_;
};

/// `costs`: -2 ln L of each cut.
ChangePoint best(const std::vector<double>& costs, std::size_t offset) {
  const auto least = std::min_element(costs.begin(), costs.end());
  ChangePoint point{static_cast<std::size_t>(least - costs.begin()), 0, 0};
  point.first = point.last = point.at;
  for (std::size_t i = 0; i < costs.size(); ++i)
    if (costs[i] <= *least + kLikely) {
      point.first = std::min(point.first, i);
      point.last = std::max(point.last, i);
    }
  return {point.at + offset, point.first + offset, point.last + offset};
}

}  // namespace

std::vector<std::size_t> mean_changes(const std::vector<double>& values, double variance, double penalty) {
  const std::size_t n = values.size();
  if (n == 0) return {};
  const PartialSums sums(values, 0, n);
  std::vector<double> cost(n + 1, kUnbounded);
  std::vector<std::size_t> before(n + 1), candidates{0};
  cost[0] = -penalty;
  for (std::size_t end = 1; end <= n; ++end) {
    for (const std::size_t begin : candidates) {
      const double one = cost[begin] + sums.about_mean(begin, end) / variance + penalty;
      if (one < cost[end]) {
        cost[end] = one;
        before[end] = begin;
      }
    }
    std::erase_if(candidates,
                  [&](std::size_t begin) { return cost[begin] + sums.about_mean(begin, end) / variance > cost[end]; });
    candidates.push_back(end);
  }
  std::vector<std::size_t> changes;
  for (std::size_t end = n; end > 0; end = before[end]) changes.push_back(before[end]);
  std::reverse(changes.begin(), changes.end());
  return changes;
}

std::optional<ChangePoint> break_point(const std::vector<Course>& courses, std::size_t begin, std::size_t end) {
  if (end < begin + 2 * kLeast) return std::nullopt;
  std::vector<double> costs(end - begin + 1 - 2 * kLeast);
  for (const Course& course : courses) {
    const PartialSums sums(*course.values, begin, end);
    for (std::size_t i = 0; i < costs.size(); ++i) {
      const std::size_t cut = begin + kLeast + i;  // the first reading after the cut
      costs[i] += (sums.about_line(begin, cut) + sums.about_line(cut, end)) / (course.noise * course.noise);
    }
  }
  return best(costs, begin + kLeast - 1);
}

ChangePoint beginning_of_drop(const Course& course, std::size_t begin, std::size_t end, const ChangePoint& about,
                              std::size_t reach) {
  const PartialSums sums(*course.values, begin, end);
  const std::size_t middle = about.at + 1, first = std::max(middle, begin + kLeast + reach) - reach,
                    last = std::min(middle + reach, end - kLeast);
  struct Behind {
    double level, squares;  // of the line from there on: its value there, and the squares about it
  };
  std::vector<Behind> behind;
  for (std::size_t low = first; low <= last; ++low)
    behind.push_back({sums.line(low, end).at(low - begin), sums.about_line(low, end)});
  std::vector<double> costs;
  for (std::size_t drop = first; drop <= last; ++drop) {
    const double before = sums.about_line(begin, drop);
    const double top = sums.line(begin, drop).at(drop - 1 - begin);
    double least = kUnbounded;
    for (std::size_t low = std::max(drop, middle); low <= last; ++low) {
      const Behind& rest = behind[low - first];
      const Line between = line_between(drop - 1 - begin, top, low - begin, rest.level);
      least = std::min(least, sums.about_given(between, drop, low) + rest.squares);
    }
    costs.push_back((before + least) / (course.noise * course.noise));
  }
  return best(costs, first - 1);
}

std::optional<DropEnds> ends_of_drop(const Course& course, std::size_t begin, std::size_t end, const DropSpan& span) {
  constexpr int kRounds = 50;
  if (end < begin + 2 * kLeast) return std::nullopt;
  const std::size_t first = std::max(span.first, begin + kLeast), last = std::min(span.last, end - kLeast),
                    seen = std::min(span.seen, last);
  if (first > seen) return std::nullopt;
  const PartialSums sums(*course.values, begin, end);
  const double variance = course.noise * course.noise;
  // `drop`: its first reading; `low`: the first reading after it
  const auto cost = [&](std::size_t drop, std::size_t low) {
    const Line between = line_between(drop - 1 - begin, sums.line(begin, drop).at(drop - 1 - begin), low - begin,
                                      sums.line(low, end).at(low - begin));
    return (sums.about_line(begin, drop) + (low > drop ? sums.about_given(between, drop, low) : 0) +
            sums.about_line(low, end)) /
           variance;
  };
  const auto costs = [](std::size_t from, std::size_t to, auto one) {
    std::vector<double> list;
    for (std::size_t i = from; i <= to; ++i) list.push_back(one(i));
    return list;
  };
  // first a single cut, then a symmetric drop about it, then each end alternately
  const std::size_t cut = best(costs(first, seen, [&](std::size_t i) { return cost(i, i); }), first).at;
  const std::size_t wide = std::min(cut - first, last - cut);
  const std::size_t half = best(costs(0, wide, [&](std::size_t i) { return cost(cut - i, cut + i); }), 0).at;
  ChangePoint drop{cut - half, 0, 0}, low{cut + half, 0, 0};
  for (int round = 0; round < kRounds; ++round) {
    const std::size_t before = drop.at, behind = low.at;
    drop = best(costs(first, std::min(seen, low.at), [&](std::size_t i) { return cost(i, low.at); }), first);
    low = best(costs(drop.at, last, [&](std::size_t i) { return cost(drop.at, i); }), drop.at);
    if (drop.at == before && low.at == behind) break;
  }
  const auto ending = [&](std::size_t from, std::size_t to, const ChangePoint& place) {
    const Line line = sums.line(from, to);
    const double n = static_cast<double>(to - from), at = static_cast<double>(place.at) - 0.5,
                 x = at - static_cast<double>(from) - (n - 1) / 2, spread = n * (n * n - 1) / 12;
    const double off = static_cast<double>(place.last - place.first) / 2 / std::sqrt(kLikely);
    return LineEnd{at, (*course.values)[begin] + line.level + line.slope * (at - static_cast<double>(begin)),
                   std::sqrt(variance * (1 / n + x * x / spread) + line.slope * line.slope * (off * off + 1 / 12.0))};
  };
  return DropEnds{ending(begin, drop.at, drop), ending(low.at, end, low)};
}

std::optional<Hinge> hinge_point(const Course& course, std::size_t begin, std::size_t end) {
  if (end < begin + 6) return std::nullopt;
  const std::vector<double>& y = *course.values;
  const std::size_t n = end - begin;
  std::vector<double> costs(n - 1), levels(n - 1), slopes(n - 1);  // for each cut
  // y = level + slope max(0, x - cut), least squares in level and slope
  const double mean = mean_of(y, begin, end);
  double squares = 0;
  for (std::size_t i = begin; i < end; ++i) squares += (y[i] - mean) * (y[i] - mean);
  double tail_y = 0, tail_xy = 0;  // of readings after the cut, about the mean; x from the cut
  for (std::size_t cut = n - 1; cut-- > 0;) {
    tail_y += y[begin + cut + 1] - mean;
    tail_xy += tail_y;
    const double m = static_cast<double>(n - 1 - cut), u = m * (m + 1) / 2, uu = m * (m + 1) * (2 * m + 1) / 6;
    const double spread = uu - u * u / static_cast<double>(n), slope = tail_xy / spread;
    costs[cut] = (squares - slope * tail_xy) / (course.noise * course.noise);
    slopes[cut] = slope;
    levels[cut] = mean - slope * u / static_cast<double>(n);
  }
  const ChangePoint change = best(costs, 0);
  return Hinge{{change.at + begin, change.first + begin, change.last + begin}, levels[change.at], slopes[change.at]};
}

}  // namespace mixity
