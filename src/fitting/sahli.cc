#include "fitting/sahli.h"

#include <algorithm>
#include <cmath>

#include "mechanics/contact_model.h"

namespace mixity {
namespace {

/// y = intercept + slope x by least squares.
struct Line {
  double intercept, slope;
  std::optional<double> intercept_stderr, slope_stderr;  // null with fewer than three points
};

/// Null if all x are equal.
std::optional<Line> fit_line(const std::vector<double>& x, const std::vector<double>& y) {
  const double n = static_cast<double>(x.size());
  double mean_x = 0, mean_y = 0, sxx = 0, sxy = 0, squares = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += x[i] / n;
    mean_y += y[i] / n;
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    sxx += (x[i] - mean_x) * (x[i] - mean_x);
    sxy += (x[i] - mean_x) * (y[i] - mean_y);
  }
  if (!(sxx > 0)) return std::nullopt;
  Line line{0, sxy / sxx, {}, {}};
  line.intercept = mean_y - line.slope * mean_x;
  if (x.size() < 3) return line;
  for (std::size_t i = 0; i < x.size(); ++i) squares += std::pow(y[i] - line.intercept - line.slope * x[i], 2);
  const double variance = squares / (n - 2);
  line.slope_stderr = std::sqrt(variance) / std::sqrt(sxx);  // sxx may be as small as doubles go
  line.intercept_stderr = std::sqrt(variance * (1 / n + mean_x * mean_x / sxx));
  return line;
}

std::optional<PowerLaw> fit_power_law(const std::vector<SahliRun>& runs, bool predicted) {
  std::vector<double> x, y;
  for (const SahliRun& run : runs) {
    const double alpha = predicted ? run.alpha_predicted.value_or(0) : run.alpha;
    if (!(alpha > 0 && run.A0 > 0)) continue;
    x.push_back(std::log(run.A0));
    y.push_back(std::log(alpha));
  }
  const auto line = fit_line(x, y);
  if (!line) return std::nullopt;
  return PowerLaw{std::exp(line->intercept), line->slope, line->slope_stderr};
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
    const auto line = fit_line(squares, areas);
    if (!line) {
      result.skipped.push_back(data.curves[c]);
      continue;
    }
    result.runs.push_back({data.curves[c], data.curve_loads[c], squares.size(), line->intercept, -line->slope,
                           line->intercept_stderr, line->slope_stderr, predicted(line->intercept)});
  }
  result.power_law = fit_power_law(result.runs, false);
  result.predicted_power_law = fit_power_law(result.runs, true);
  return result;
}

}  // namespace mixity
