// Sections, means, medians and straight lines of readings.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace mixity {

inline std::vector<double> part_of(const std::vector<double>& values, std::size_t begin, std::size_t end) {
  return {values.begin() + static_cast<std::ptrdiff_t>(begin), values.begin() + static_cast<std::ptrdiff_t>(end)};
}

inline double mean_of(const std::vector<double>& values, std::size_t begin, std::size_t end) {
  return std::accumulate(values.begin() + static_cast<std::ptrdiff_t>(begin),
                         values.begin() + static_cast<std::ptrdiff_t>(end), 0.0) /
         static_cast<double>(end - begin);
}

inline constexpr double kOfMedian = 1.4826;  // standard deviation over median of |x|, for a normal distribution

/// The median of at least one value.
inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The least-squares line through readings begin..end (end excluded, at least one).
struct StraightLine {
  double mean, slope, middle;  // slope per reading; 0 for fewer than three
  double at(std::size_t i) const { return mean + slope * (static_cast<double>(i) - middle); }
};
inline StraightLine line_through(const std::vector<double>& y, std::size_t begin, std::size_t end) {
  const double n = static_cast<double>(end - begin), mean = mean_of(y, begin, end);
  StraightLine line{mean, 0, static_cast<double>(begin) + (n - 1) / 2};
  if (n < 3) return line;
  for (std::size_t i = begin; i < end; ++i) line.slope += (static_cast<double>(i) - line.middle) * (y[i] - mean);
  line.slope /= n * (n * n - 1) / 12;
  return line;
}

}  // namespace mixity
