// A straight line through points by least squares.
#pragma once

#include <optional>
#include <vector>

namespace mixity {

/// y = mean_y + slope (x - mean_x), each point with the same weight.
struct LineFit {
  double n, mean_x, mean_y;
  double slope;    // 0 if all x are equal
  double xx;       // sum of (x - mean_x)^2
  double squares;  // sum of the squared deviations from the line

  double intercept() const { return mean_y - slope * mean_x; }
  /// From the deviations. Null with fewer than three points, or if all x are equal.
  std::optional<double> slope_stderr() const;
  std::optional<double> intercept_stderr() const;

 private:
  bool has_errors() const { return n > 2 && xx > 0; }
  double variance() const { return squares / (n - 2); }
};

/// x and y have the same length; all is 0 without points.
LineFit fit_line(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace mixity
