#include "fitting/circularity.h"

#include <cmath>
#include <vector>

#include "fitting/consistency.h"
#include "mechanics/contact_model.h"
#include "statistics/distributions.h"

namespace mixity {

std::optional<CircleTest> test_circle(const Dataset& data, const FitResult& fit) {
  constexpr double kFewest = 8;
  if (data.axes.empty() || !data.has_loads || is_elliptic(fit.model)) return std::nullopt;
  const PointPlaces places(data);
  double n = 0, s = 0, q = 0, ss = 0, sq = 0, qq = 0;
  std::vector<std::size_t> measured;
  for (const std::size_t i : fit.used)
    if (std::isfinite(data.axes[i].q)) measured.push_back(i);
  for (const std::size_t i : measured) {
    n += 1;
    s += places.at(i).stretch;
    q += data.axes[i].q;
  }
  for (const std::size_t i : measured) {
    const double x = places.at(i).stretch - s / n, y = data.axes[i].q - q / n;
    ss += x * x;
    sq += x * y;
    qq += y * y;
  }
  if (n < kFewest || !(ss > 0)) return std::nullopt;
  const double slope = sq / ss, left = std::max(qq - slope * sq, 0.0), error = std::sqrt(left / (n - 2) / ss);
  return CircleTest{std::exp(slope), error > 0 ? student_p_value(slope / error, n - 2) : slope == 0 ? 1.0 : 0.0};
}

bool is_no_circle(const FitResult& fit) {
  constexpr double kHalfAPercent = 0.005;
  return fit.consistency && fit.consistency->circle && fit.consistency->circle->p_value < kChance &&
         std::abs(std::log(fit.consistency->circle->ratio)) > kHalfAPercent;
}

}  // namespace mixity
