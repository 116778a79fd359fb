#include "fitting/pull_off_course.h"

#include <cmath>
#include <vector>

#include "dataset/pull_off.h"
#include "fitting/consistency.h"
#include "statistics/distributions.h"
#include "statistics/line_fit.h"

namespace mixity {

std::optional<PullOffTest> test_pull_off(const Dataset& data, const FitResult& fit) {
  constexpr double kFewest = 6, kDirections = 2;
  const std::vector<double>& r = fit.pull_off_residuals;
  const auto n = static_cast<double>(r.size());
  const double largest = largest_pull_off(data).shear;
  if (n < kFewest || r.size() != data.pull_off.size() || !(largest > 0)) return std::nullopt;
  std::vector<double> places;
  for (const PullOffReading& one : data.pull_off) places.push_back(std::pow(one.shear / largest, 2));
  const LineFit line = fit_line(places, r);
  const double explained = n * line.mean_y * line.mean_y + line.slope * line.slope * line.xx, freedom = n - kDirections;
  // What is far smaller than a stated error, or is rounding, does not count.
  constexpr double kSmall = 0.25, kRounding = 1e-6;
  const double size = std::sqrt(explained / n), of_load = fit.errors ? size * fit.errors->pull_off : 0;
  const bool counts =
      size > kSmall && (without_pull_off_error(data) == 0 || of_load > kRounding * largest_pull_off(data).load);
  if (!counts || !(line.squares > 0)) return PullOffTest{0, counts ? 0.0 : 1.0};
  const double F = explained / kDirections / (line.squares / freedom);
  return PullOffTest{F, fisher_p_value(F, kDirections, freedom)};
}

bool pull_off_departs(const FitResult& fit) {
  return fit.consistency && fit.consistency->pull_off && fit.consistency->pull_off->p_value < kChance;
}

}  // namespace mixity
