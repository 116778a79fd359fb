#include "statistics/line_fit.h"

#include <cmath>

namespace mixity {

std::optional<double> LineFit::slope_stderr() const {
  if (!has_errors()) return std::nullopt;
  return std::sqrt(variance()) / std::sqrt(xx);  // xx may be as small as doubles go
}

std::optional<double> LineFit::intercept_stderr() const {
  if (!has_errors()) return std::nullopt;
  return std::sqrt(variance() * (1 / n + mean_x * mean_x / xx));
}

LineFit fit_line(const std::vector<double>& x, const std::vector<double>& y) {
  LineFit line{static_cast<double>(x.size()), 0, 0, 0, 0, 0};
  double xy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    line.mean_x += x[i] / line.n;
    line.mean_y += y[i] / line.n;
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    line.xx += (x[i] - line.mean_x) * (x[i] - line.mean_x);
    xy += (x[i] - line.mean_x) * (y[i] - line.mean_y);
  }
  if (line.xx > 0) line.slope = xy / line.xx;
  for (std::size_t i = 0; i < x.size(); ++i) line.squares += std::pow(y[i] - line.intercept() - line.slope * x[i], 2);
  return line;
}

}  // namespace mixity
