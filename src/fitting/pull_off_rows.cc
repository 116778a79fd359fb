#include "fitting/pull_off_rows.h"

#include <algorithm>
#include <cmath>

namespace mixity {

MeasuredPullOff measured_pull_off(const PullOffReading& reading, double common, double least) {
  return {reading.held, reading.P, reading.shear, std::max(reading.error_of_load(common), least),
          std::max(reading.sigma_shear, 0.0)};
}

double held_shear(const ConstantsScale& scale, HeldShear held, double reading) {
  return held == HeldShear::load ? scale.shear(reading) : scale.displacement * reading;
}

bool pull_off_rows(const std::vector<MeasuredPullOff>& points, const FreeChoice& choice, const Candidate& at,
                   std::span<double> residuals, std::span<double> jacobian) {
  const std::size_t n = points.size(), p = choice.model().parameters().size(), width = choice.size();
  const ConstantsScale scale(at.constants);
  std::vector<double> P(n), shear(n), sigma_P(n), sigma_shear(n), dP(n), dshear(n), normal(n),
      by_parameter(jacobian.empty() ? 0 : n * p);
  std::vector<HeldShear> held(n);
  for (std::size_t i = 0; i < n; ++i) {
    const MeasuredPullOff& one = points[i];
    const bool by_load = one.held == HeldShear::load;
    held[i] = one.held;
    P[i] = scale.load(one.P);
    shear[i] = held_shear(scale, one.held, one.shear);
    sigma_P[i] = scale.force * one.sigma_P;
    sigma_shear[i] = (by_load ? scale.shear_force : scale.displacement) * one.sigma_shear;
  }
  if (!choice.model().pull_off_distances(at.parameters, {P, shear, sigma_P, sigma_shear, held},
                                         {residuals, dP, dshear, normal, by_parameter}))
    return false;
  for (std::size_t i = 0; i < n && !jacobian.empty(); ++i) {
    const std::span<double> row = jacobian.subspan(i * width, width);
    const bool by_load = held[i] == HeldShear::load;
    // in the logarithms of all forces, and of the displacement
    const double of_P = dP[i] * P[i] - residuals[i] * normal[i] * normal[i],
                 of_shear = dshear[i] * shear[i] - residuals[i] * (1 - normal[i] * normal[i]);
    const ScaledSlopes slopes{dP[i], by_load ? dshear[i] : 0, 0, of_P + (by_load ? of_shear : 0), 0};
    std::size_t k = 0;
    for (const std::size_t parameter : choice.of_model()) row[k++] = by_parameter[i * p + parameter];
    for (const Constant constant : choice.constants()) {
      row[k] = slopes.in(constant, scale, {});
      if (!by_load && constant == kToughness) row[k] -= 2.0 / 3 * of_shear;
      if (!by_load && constant == kModulus) row[k] += 2.0 / 3 * of_shear;
      if (!by_load && constant == kRadius) row[k] -= 1.0 / 3 * of_shear;
      ++k;
    }
    if (!std::all_of(row.begin(), row.end(), [](double one) { return std::isfinite(one); })) return false;
  }
  return true;
}

double size_of_pull_off(const Dataset& data) {
  const double largest = largest_pull_off(data).load;
  return largest > 0 ? largest : 1;
}

double assumed_pull_off_error(const Dataset& data) { return 0.01 * size_of_pull_off(data); }

}  // namespace mixity
