#include "fitting/circularity.h"

#include <cmath>
#include <vector>

#include "fitting/consistency.h"
#include "mechanics/contact_model.h"
#include "statistics/distributions.h"
#include "statistics/line_fit.h"

namespace mixity {
namespace {

/// Standard error of ln(a/b): as stated, or a multiple of the relative error of A.
double error_of(const PointAxes& axes, const StandardErrors& errors, std::size_t point, const Dataset& data) {
  return axes.sigma_q > 0 ? axes.sigma_q : errors.axes_factor * errors.A[point] / data.points[point].A;
}

}  // namespace

std::optional<CircleTest> test_axes(const Dataset& data, const FitResult& fit) {
  constexpr double kFewest = 8;
  const bool ellipse = is_elliptic(fit.model);
  if (data.axes.empty() || !data.has_loads || (ellipse && fit.axes_residuals.size() != fit.used.size()))
    return std::nullopt;
  const PointPlaces places(data);
  std::vector<double> stretches, ratios;
  for (std::size_t k = 0; k < fit.used.size(); ++k) {
    const std::size_t i = fit.used[k];
    const PointAxes& axes = data.axes[i];
    if (!std::isfinite(axes.q)) continue;
    stretches.push_back(places.at(i).stretch);
    ratios.push_back(ellipse ? -fit.axes_residuals[k] * error_of(axes, *fit.errors, i, data) : axes.q);
  }
  const LineFit line = fit_line(stretches, ratios);
  if (line.n < kFewest || !(line.xx > 0)) return std::nullopt;
  const double error = *line.slope_stderr();
  return CircleTest{std::exp(line.slope), error > 0         ? student_p_value(line.slope / error, line.n - 2)
                                          : line.slope == 0 ? 1.0
                                                            : 0.0};
}

bool axes_leave_fit(const FitResult& fit) {
  constexpr double kHalfAPercent = 0.005;
  return fit.consistency && fit.consistency->circle && fit.consistency->circle->p_value < kChance &&
         std::abs(std::log(fit.consistency->circle->ratio)) > kHalfAPercent;
}

}  // namespace mixity
