#include "fitting/heavy_points.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/number_text.h"
#include "base/phrases.h"
#include "statistics/readings.h"

namespace mixity {
namespace {

/// A column of errors relative to a scale, for the points of a fit.
struct ErrorColumn {
  const char* name;
  std::vector<double> errors;
  double middle = 0;  // the median error
};

/// Columns in the file that the fit uses.
std::vector<ErrorColumn> stated_columns(const Dataset& data, const FitResult& fit) {
  std::vector<ErrorColumn> list;
  const auto add = [&](const char* name, const auto& error) {
    ErrorColumn column{name, {}};
    column.errors.reserve(fit.used.size());
    for (const std::size_t i : fit.used) column.errors.push_back(error(i));
    column.middle = median(column.errors);
    list.push_back(std::move(column));
  };
  if (data.has_loads) {
    if (!fit.errors || fit.objective != Objective::curve) return {};
    if (fit.errors->source_T == ErrorSource::columns) add("sigma_T", [&](std::size_t i) { return fit.errors->T[i]; });
    if (fit.errors->source_A == ErrorSource::columns) add("sigma_A", [&](std::size_t i) { return fit.errors->A[i]; });
  } else if (data.errors.empty() || !fit.known_errors) {
    return {};
  } else if (data.has_energies) {
    add("sigma_GI", [&](std::size_t i) { return data.energies[i].sigma_GI; });
    add("sigma_GII", [&](std::size_t i) { return data.energies[i].sigma_GII; });
  } else {
    add("sigma_Gc", [&](std::size_t i) { return data.errors[i].ratio / data.converted[i].ratio; });
  }
  return list;
}

/// Per point of the fit: 1/variance of its distance from the curve. Errors of the two energies are combined.
std::vector<double> weights_of(const Dataset& data, const FitResult& fit, const std::vector<ErrorColumn>& columns,
                               const std::function<std::vector<double>()>& along_A) {
  const std::size_t n = fit.used.size();
  std::vector<double> weights(n, 0.0);
  if (data.has_loads) {
    const std::vector<double> part = along_A();
    for (std::size_t k = 0; k < n && k < part.size(); ++k)
      weights[k] = std::pow(part[k] / fit.errors->A[fit.used[k]], 2);
    return weights;
  }
  for (std::size_t k = 0; k < n; ++k) {
    double variance = 0;
    for (const ErrorColumn& one : columns) variance += one.errors[k] * one.errors[k];
    weights[k] = 1 / variance;
  }
  return weights;
}

/// Whether any error is below this fraction of the median of its column.
bool any_far_below(const std::vector<ErrorColumn>& columns, double share) {
  return std::any_of(columns.begin(), columns.end(), [&](const ErrorColumn& one) {
    return *std::min_element(one.errors.begin(), one.errors.end()) < share * one.middle;
  });
}

}  // namespace

std::optional<HeavyPoints> heavy_points(const Dataset& data, const FitResult& fit,
                                        const std::function<std::vector<double>()>& along_A) {
  constexpr double kFarBelow = 0.2;  // of the median error: errors of one instrument differ less
  constexpr double kFew = 0.1;       // of the points
  const std::vector<ErrorColumn> columns = stated_columns(data, fit);
  const std::size_t n = fit.used.size();
  if (columns.empty() || n < 4 || !any_far_below(columns, kFarBelow)) return std::nullopt;
  const std::vector<double> weights = weights_of(data, fit, columns, along_A);
  const double all = std::accumulate(weights.begin(), weights.end(), 0.0),
               heavy = median(weights) / (kFarBelow * kFarBelow);
  if (!std::isfinite(all)) return std::nullopt;
  HeavyPoints found{{}, 0, "", 1};
  for (std::size_t k = 0; k < n; ++k) {
    if (!(weights[k] > heavy)) continue;
    found.points.push_back(fit.used[k]);
    found.share += weights[k] / all;
    for (const ErrorColumn& one : columns)
      if (const double ratio = one.errors[k] / one.middle; ratio < found.ratio) {
        found.ratio = ratio;
        found.column = one.name;
      }
  }
  const auto most = std::max<std::size_t>(1, static_cast<std::size_t>(kFew * static_cast<double>(n)));
  if (found.points.empty() || found.points.size() > most || found.column.empty() || !(found.share > 0.5))
    return std::nullopt;
  return found;
}

std::vector<std::size_t> lines_of(const HeavyPoints& heavy, const Dataset& data) {
  std::vector<std::size_t> lines;
  for (const std::size_t i : heavy.points) lines.push_back(data.line_in_file(data.points[i].line));
  return lines;
}

std::string text_of(const HeavyPoints& heavy, const Dataset& data) {
  constexpr std::size_t kShown = 5;
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < heavy.points.size() && k < kShown; ++k)
    lines.push_back(data.line_text(data.points[heavy.points[k]].line));
  const bool one = heavy.points.size() == 1;
  if (heavy.points.size() > kShown) lines.push_back(std::to_string(heavy.points.size() - kShown) + " more");
  return joined(lines) + (one ? " carries " : " carry ") + rounded(100 * heavy.share, heavy.share > 0.99 ? 4 : 2) +
         " % of the weight (" + (one ? "its " : "their ") + heavy.column + " is 1/" + rounded(1 / heavy.ratio, 2) +
         " of the median)";
}

}  // namespace mixity
