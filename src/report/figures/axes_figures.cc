// Figures of elliptic contacts: the ratio of the axes, and the region of both couplings.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/readable.h"
#include "base/number_text.h"
#include "dataset/display_units.h"
#include "fitting/predicted_curves.h"
#include "mechanics/contact_model.h"
#include "report/figures/data_figures.h"
#include "statistics/distributions.h"

namespace mixity {
namespace {

Figure ratio_figure(const ReportedData& reported, const FitResult& fit) {
  const Dataset& data = reported.result.data;
  const DrawnUnits units(data);
  const auto by_run = points_by_curve(data);
  Figure figure{.name = reported.stem + "_axes_" + fit.model,
                .title = "Ratio of the axes against tangential load, model " + fit.model,
                .x = {units.T(), 0.0, {}},
                .y = {"a/b", {}, {}},
                .key_title = units.P(),
                .caption = "Axes along (a) and across (b) the shear: measured, and of the fitted model."};
  const std::vector<std::size_t>& runs = reported.figured.runs;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const std::size_t run = runs[k];
    Series points{rounded(data.curve_loads[run] * units.held, 4), Look::circles, color(k)},
        line{"", Look::solid, color(k)};
    for (const std::size_t i : shown_points(by_run[run], runs.size()))
      if (!data.axes.empty() && std::isfinite(data.axes[i].q))
        points.points.emplace_back(data.points[i].shear() * units.force, std::exp(data.axes[i].q));
    for (const auto& [T, ratio] : drawn_axes(data, reported.result.request.options, fit, run))
      line.points.emplace_back(T * units.force, ratio);
    figure.series.push_back(std::move(points));
    figure.series.push_back(std::move(line));
  }
  return figure;
}

/// Whether the couplings are equal, by their standard errors and correlation.
std::string difference_text(const FittedParameter& II, const FittedParameter& III, double rho) {
  const double difference = *II.value - *III.value,
               error = std::sqrt(std::max(
                   *II.stderr_ * *II.stderr_ + *III.stderr_ * *III.stderr_ - 2 * rho * *II.stderr_ * *III.stderr_,
                   0.0));
  const RoundedToError shown = rounded_to_error(difference, error);
  return " lambda_II - lambda_III is " + shown.value + " +/- " + shown.error +
         (std::abs(difference) > normal_quantile(0.975) * error ? ": the couplings differ." : ": they may be equal.");
}

/// The 95 % region of both couplings by their standard errors and correlation, and the line of circles.
std::optional<Figure> region_figure(const ReportedData& reported, const FitResult& fit) {
  constexpr int kSteps = 120;
  const FittedParameter &II = fit.parameters[0], &III = fit.parameters[1], &nu = fit.parameters.back();
  if (!II.value || !III.value || !nu.value || !II.stderr_ || !III.stderr_ || fit.correlations.size() < 4)
    return std::nullopt;
  const double rho = fit.correlations[1], size = std::sqrt(chi_squared_quantile(0.95, 2));
  Series region{"95 % region", Look::solid, model_color(fit.model)},
      best{"best fit", Look::circles, model_color(fit.model)}, circle{"circles", Look::dashed, color(7)};
  double least = 1e300, most = -1e300, lowest = 1e300, highest = -1e300;
  for (int k = 0; k <= kSteps; ++k) {
    const double t = 2 * std::numbers::pi * k / kSteps, u = size * std::cos(t),
                 v = size * (rho * std::cos(t) + std::sqrt(std::max(1 - rho * rho, 0.0)) * std::sin(t));
    const double x = std::clamp(*II.value + u * *II.stderr_, II.lower, II.upper),
                 y = std::clamp(*III.value + v * *III.stderr_, III.lower, III.upper);
    region.points.emplace_back(x, y);
    least = std::min(least, x);
    most = std::max(most, x);
    lowest = std::min(lowest, y);
    highest = std::max(highest, y);
  }
  const double wide = 0.3 * (most - least), high = 0.3 * (highest - lowest), coupling = 1 - *nu.value;
  best.points.emplace_back(*II.value, *III.value);
  // the part of the line within the frame
  const double first = std::max(least - wide, (lowest - high) / coupling),
               last = std::min(most + wide, (highest + high) / coupling);
  if (first < last) circle.points = {{first, coupling * first}, {last, coupling * last}};
  return Figure{.name = reported.stem + "_couplings_" + fit.model,
                .title = "Couplings of modes II and III, model " + fit.model,
                .x = {parameter_symbol(II.name), least - wide, most + wide},
                .y = {parameter_symbol(III.name), lowest - high, highest + high},
                .series = {std::move(region), std::move(circle), std::move(best)},
                .caption =
                    "The region by standard errors and correlation. Contacts are circles where lambda_III is (1 - "
                    "nu) lambda_II" +
                    std::string(first < last ? "." : ", outside this frame.") + difference_text(II, III, rho)};
}

}  // namespace

std::vector<Figure> axes_figures(const ReportedData& reported) {
  std::vector<Figure> figures;
  for (const FitResult& fit : reported.result.fits) {
    if (!is_elliptic(fit.model) || !has_all_values(fit)) continue;
    if (!reported.result.data.axes.empty()) figures.push_back(ratio_figure(reported, fit));
    if (fit.parameters[0].name == "lambda_II" && fit.parameters[1].name == "lambda_III")
      if (auto region = region_figure(reported, fit)) figures.push_back(std::move(*region));
  }
  return figures;
}

}  // namespace mixity
