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

std::string residuals_note(const ReportedData& reported) {
  std::size_t shown = 0, all = 0;
  for (const FitResult& fit : reported.result.fits) {
    all += fit.residuals.size();
    shown += shown_points(std::vector<std::size_t>(fit.residuals.size()), reported.result.fits.size()).size();
  }
  return shown_note(shown, all);
}

/// Residuals of every fit over the value of `abscissa` at point i.
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

/// Sorted residuals in units of their RMS against the quantiles (i - 1/2)/n of a normal distribution.
Figure quantiles(const ReportedData& reported) {
  Figure figure{.name = reported.stem + "_residuals_qq",
                .title = "Quantiles of the residuals against those of a normal distribution",
                .x = {"normal quantile"},
                .y = {"residual/RMS"},
                .caption = "On the dotted line the scatter is normal, which standard errors and intervals presume." +
                           residuals_note(reported)};
  double most = 0;
  for (const FitResult& fit : last_first(reported.result)) {
    if (fit.residuals.empty() || !fit.rmse || !(*fit.rmse > 0)) continue;
    std::vector<std::size_t> order = first_indices(fit.residuals.size());
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return fit.residuals[i] < fit.residuals[j]; });
    Series series{"model " + fit.model, model_symbol(fit.model), model_color(fit.model)};
    for (const std::size_t rank : shown_points(first_indices(order.size()), reported.result.fits.size())) {
      const double q = normal_quantile((static_cast<double>(rank) + 0.5) / static_cast<double>(order.size()));
      series.points.emplace_back(q, fit.residuals[order[rank]] / *fit.rmse);
      series.hover.push_back("model " + fit.model + ", " + point_hover(reported.result.data, fit.used[order[rank]]));
      most = std::max(most, std::abs(q));
    }
    figure.series.push_back(std::move(series));
  }
  if (figure.series.empty()) return figure;
  figure.series.insert(figure.series.begin(), {"", Look::dotted, color(0), {{-most, -most}, {most, most}}});
  return figure;
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
    figures.push_back(residuals_against(reported, "psi", "Residuals against phase angle", "ψ [rad]",
                                        [&](std::size_t i) { return data.toughness(i)->psi(); }));
  if (data.has_loads) {
    figures.push_back(residuals_against(reported, "T", "Residuals against tangential load", units.T(),
                                        [&](std::size_t i) { return data.points[i].shear() * units.force; }));
    if (data.curves.size() > 1)
      figures.push_back(residuals_against(reported, "P", "Residuals against normal load", units.P(),
                                          [&](std::size_t i) { return data.points[i].P * units.force; }));
  }
  if (Figure qq = quantiles(reported); !qq.series.empty()) figures.push_back(std::move(qq));
  return figures;
}

}  // namespace mixity
