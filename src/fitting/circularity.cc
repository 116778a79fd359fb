#include "fitting/circularity.h"

#include <cmath>
#include <vector>

#include "fitting/consistency.h"
#include "mechanics/contact_model.h"
#include "statistics/distributions.h"
#include "statistics/line_fit.h"

namespace mixity {

std::optional<CircleTest> test_circle(const Dataset& data, const FitResult& fit) {
  constexpr double kFewest = 8;
  if (data.axes.empty() || !data.has_loads || is_elliptic(fit.model)) return std::nullopt;
  const PointPlaces places(data);
  std::vector<double> stretches, ratios;
  for (const std::size_t i : fit.used) {
    if (!std::isfinite(data.axes[i].q)) continue;
    stretches.push_back(places.at(i).stretch);
    ratios.push_back(data.axes[i].q);
  }
  const LineFit line = fit_line(stretches, ratios);
  if (line.n < kFewest || !(line.xx > 0)) return std::nullopt;
  const double error = *line.slope_stderr();
  return CircleTest{std::exp(line.slope), error > 0         ? student_p_value(line.slope / error, line.n - 2)
                                          : line.slope == 0 ? 1.0
                                                            : 0.0};
}

bool is_no_circle(const FitResult& fit) {
  constexpr double kHalfAPercent = 0.005;
  return fit.consistency && fit.consistency->circle && fit.consistency->circle->p_value < kChance &&
         std::abs(std::log(fit.consistency->circle->ratio)) > kHalfAPercent;
}

}  // namespace mixity
