#include <algorithm>
#include <cmath>
#include <functional>

#include "base/number_text.h"
#include "dataset/display_units.h"
#include "report/figures/data_figures.h"
#include "statistics/distributions.h"

namespace mixity {
namespace {

std::string residual_label(const FitResult& fit) {
  if (fit.known_errors || fit.objective == Objective::curve) return "residual [standard errors]";
  return fit.scale == Scale::log ? "residual in ln(G_c/G_{Ic})" : "residual in G_c/G_{Ic}";
}

/// The order of drawing: the first fit on top of the others.
std::vector<std::reference_wrapper<const FitResult>> last_first(const Analysis& result) {
  return {result.fits.rbegin(), result.fits.rend()};
}

constexpr std::size_t kLeastOfNormalFigure = 8;  // points: fewer always look like a line

std::string residuals_note(const ReportedData& reported) {
  std::size_t shown = 0, all = 0;
  for (const FitResult& fit : reported.result.fits) {
    all += fit.residuals.size();
    shown += shown_points(std::vector<std::size_t>(fit.residuals.size()), reported.result.fits.size()).size();
  }
  return shown_note(shown, all);
}

/// Residuals of every fit against `abscissa` at point i.
Figure residuals_against(const ReportedData& reported, const std::string& name, const std::string& title,
                         const std::string& label, const std::function<double(std::size_t)>& abscissa) {
  const Dataset& data = reported.result.data;
  Figure figure{.name = reported.stem + "_residuals_" + name,
                .title = title,
                .x = {label},
                .y = {residual_label(reported.result.fits.front())},
                .caption = "Model minus data in the fitted space. A model that is right leaves no trend." +
                           residuals_note(reported)};
  double first = 0, last = 0;
  for (const FitResult& fit : last_first(reported.result)) {
    if (fit.residuals.empty()) continue;
    Series series{"model " + fit.model, model_symbol(fit.model), model_color(fit.model)};
    for (const std::size_t i : shown_points(first_indices(fit.residuals.size()), reported.result.fits.size())) {
      const double x = abscissa(fit.used[i]);
      series.points.emplace_back(x, fit.residuals[i]);
      series.hover.push_back("model " + fit.model + ", residual " + rounded(fit.residuals[i], 3) + ", " +
                             point_hover(data, fit.used[i]));
      first = std::min(first, x);
      last = std::max(last, x);
    }
    figure.series.push_back(std::move(series));
  }
  figure.series.insert(figure.series.begin(), {"", Look::dotted, color(0), {{first, 0}, {last, 0}}});
  return figure;
}

/// The 95 % range of the k-th of n sorted normal numbers.
std::pair<double, double> usual_range(std::size_t k, std::size_t n) {
  const auto below = static_cast<double>(k), from_it_on = static_cast<double>(n + 1 - k);
  const auto at = [&](double p) {
    const double F = below / from_it_on * fisher_quantile(p, 2 * below, 2 * from_it_on);
    return normal_quantile(F / (1 + F));
  };
  return {at(0.025), at(0.975)};
}

}  // namespace

std::vector<Figure> residual_figures(const ReportedData& reported) {
  const Dataset& data = reported.result.data;
  if (std::all_of(reported.result.fits.begin(), reported.result.fits.end(),
                  [](const FitResult& fit) { return fit.residuals.empty(); }))
    return {};
  const DrawnUnits units(data);
  std::vector<Figure> figures;
  bool angles = true;
  for (const FitResult& fit : reported.result.fits)
    for (std::size_t k = 0; angles && k < fit.residuals.size(); ++k) angles = data.toughness(fit.used[k]).has_value();
  if (angles)
    figures.push_back(residuals_against(reported, "psi", "Residuals against phase angle", "ψ [°]",
                                        [&](std::size_t i) { return degrees(data.toughness(i)->psi()); }));
  if (data.has_loads) {
    figures.push_back(residuals_against(reported, "T", "Residuals against tangential load", units.T(),
                                        [&](std::size_t i) { return data.points[i].shear() * units.force; }));
    if (data.curves.size() > 1)
      figures.push_back(residuals_against(
          reported, "P", data.holds_approach() ? "Residuals against approach" : "Residuals against normal load",
          units.P(), [&](std::size_t i) { return data.points[i].P * units.held; }));
  }
  return figures;
}

/// Sorted residuals against the quantiles (i - 1/2)/n of a normal distribution.
std::vector<Figure> normal_figures(const ReportedData& reported) {
  Figure figure{.name = reported.stem + "_residuals_qq",
                .title = "Normal probability plot of the residuals",
                .x = {"normal quantile"},
                .y = {"residual [standard errors]"}};
  std::size_t shown = 0, all = 0, most = 0;
  for (const FitResult& fit : last_first(reported.result)) {
    const std::size_t n = fit.innovations.size();
    if (n < kLeastOfNormalFigure || fit.residuals.empty() || !(fit.standard_error > 0) || !fit.outdone_by.empty())
      continue;
    std::vector<std::size_t> order = first_indices(n);
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return fit.innovations[i] < fit.innovations[j]; });
    Series series{"model " + fit.model, model_symbol(fit.model), model_color(fit.model)};
    for (const std::size_t rank : shown_points(first_indices(n), reported.result.fits.size())) {
      const double size = fit.innovations[order[rank]] / fit.standard_error;
      series.points.emplace_back(normal_quantile((static_cast<double>(rank) + 0.5) / static_cast<double>(n)), size);
      series.hover.push_back("model " + fit.model + ", residual of " + rounded(size, 2) + " standard errors, " +
                             point_hover(reported.result.data, fit.used[order[rank]]));
    }
    shown += series.points.size();
    all += n;
    most = std::max(most, n);
    figure.series.push_back(std::move(series));
  }
  if (figure.series.empty()) return {};
  Points low, high, line;
  for (const std::size_t rank : shown_points(first_indices(most))) {
    const double q = normal_quantile((static_cast<double>(rank) + 0.5) / static_cast<double>(most));
    const auto [least, largest] = usual_range(rank + 1, most);
    low.emplace_back(q, least);
    high.emplace_back(q, largest);
    line.emplace_back(q, q);
  }
  figure.series.insert(figure.series.begin(), {band("95 % of clean points", color(7), low, high),
                                               {"", Look::dotted, color(0), {line.front(), line.back()}}});
  figure.caption =
      "On the dotted line the scatter is normal, which standard errors and intervals presume. Of clean data, each "
      "point lies within the band with a probability of 95 %. Single points far off at the ends are outliers." +
      shown_note(shown, all);
  return {figure};
}

}  // namespace mixity
