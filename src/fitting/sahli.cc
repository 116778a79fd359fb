#include "fitting/sahli.h"

#include <algorithm>
#include <cmath>

#include "mechanics/contact_model.h"
#include "statistics/line_fit.h"

namespace mixity {
namespace {

std::optional<PowerLaw> fit_power_law(const std::vector<SahliRun>& runs, bool predicted) {
  std::vector<double> x, y;
  for (const SahliRun& run : runs) {
    const double alpha = predicted ? run.alpha_predicted.value_or(0) : run.alpha;
    if (!(alpha > 0 && run.A0 > 0)) continue;
    x.push_back(std::log(run.A0));
    y.push_back(std::log(alpha));
  }
  const LineFit line = fit_line(x, y);
  if (!(line.xx > 0)) return std::nullopt;
  return PowerLaw{std::exp(line.intercept()), line.slope, line.slope_stderr()};
}

}  // namespace

SahliResult fit_sahli(const Dataset& data, double upto, std::string_view model, const std::vector<double>& parameters) {
  if (data.stated_constants() != Constants{}) return fit_sahli(corrected(data), upto, model, parameters);
  const auto found = ContactModel::find(model);
  const auto predicting = found ? std::optional(data.under_control(*found)) : std::nullopt;
  SahliResult result;
  const auto runs = points_by_curve(data);
  const auto predicted = [&](double A0) {
    const auto alpha = predicting ? predicting->shear_sensitivity(parameters, A0) : std::nullopt;
    return alpha ? std::optional(*alpha * data.metadata.kappa()) : std::nullopt;
  };
  for (std::size_t c = 0; c < runs.size(); ++c) {
    double largest = 0;
    for (const std::size_t i : runs[c]) largest = std::max(largest, data.points[i].shear());
    std::vector<double> squares, areas;
    for (const std::size_t i : runs[c]) {
      const Point& point = data.points[i];
      if (point.shear() > upto * largest) continue;
      squares.push_back(point.T * point.T);
      areas.push_back(point.A);
    }
    const LineFit line = fit_line(squares, areas);
    if (!(line.xx > 0)) {
      result.skipped.push_back(data.curves[c]);
      continue;
    }
    result.runs.push_back({data.curves[c], data.curve_loads[c], squares.size(), line.intercept(), -line.slope,
                           line.intercept_stderr(), line.slope_stderr(), predicted(line.intercept())});
  }
  result.power_law = fit_power_law(result.runs, false);
  result.predicted_power_law = fit_power_law(result.runs, true);
  return result;
}

}  // namespace mixity
