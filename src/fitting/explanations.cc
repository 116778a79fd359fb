#include "fitting/explanations.h"

#include <algorithm>
#include <cmath>

#include "dataset/exclusion.h"
#include "fitting/causes.h"
#include "fitting/predicted_area.h"

namespace mixity {
namespace {

/// The largest shear among these points in each run.
std::vector<double> largest_shears(const Dataset& data, const Points& points) {
  std::vector<double> largest(data.curves.size());
  for (const std::size_t i : points)
    largest[data.points[i].curve] = std::max(largest[data.points[i].curve], data.points[i].shear());
  return largest;
}

/// The points of each run; reversed if the file has them from high to low shear.
std::vector<Points> runs_from_low_shear(const Dataset& data, const Points& points) {
  std::vector<Points> runs(data.curves.size());
  for (const std::size_t i : points) runs[data.points[i].curve].push_back(i);
  for (Points& run : runs)
    if (!run.empty() && data.points[run.back()].shear() < data.points[run.front()].shear())
      std::reverse(run.begin(), run.end());
  return runs;
}

/// Whether each point of the data set is far off a fit to some of `points`. Null if the fit predicts nothing for them.
std::optional<std::vector<bool>> far_off(const Case& of, const FitResult& fit, const Points& points) {
  constexpr double kFar = 4;  // standard errors of a residual
  FitOptions as_found = of.options;
  as_found.hold.clear();
  for (const FittedParameter& one : fit.parameters) as_found.hold.push_back({one.name, one.value});
  as_found.constants = constants_of(of.data, of.options, fit.parameters);
  as_found.free.clear();
  as_found.errors = fit.errors;
  const FitResult all = of.refit(of.data, as_found, points, nullptr);
  if (all.residuals.empty()) return std::nullopt;
  std::vector<bool> off(of.data.points.size(), false);
  for (std::size_t k = 0; k < all.used.size(); ++k)
    off[all.used[k]] = std::abs(all.residuals[k]) > kFar * residual_unit(fit);
  return off;
}

/// The index in the run after which nearly all points are far off; the size of the run if there is none.
std::size_t onset(const Points& run, const std::vector<bool>& off) {
  double sum = 0, most = 0;
  std::size_t at = run.size();
  for (std::size_t i = run.size(); i-- > 0;) {
    sum += off[run[i]] ? 1 : -1.5;
    if (sum > most) {
      most = sum;
      at = i;
    }
  }
  return at;
}

}  // namespace

Points thinned(const PointIndices& points, std::size_t enough) {
  const std::size_t step = points.size() / enough + 1;
  Points some;
  for (std::size_t i = 0; i < points.size(); i += step) some.push_back(points[i]);
  return some;
}

Points thinned_from_ends(const Dataset& data, const Points& points, std::size_t enough) {
  const std::size_t step = points.size() / enough + 1;
  Points some;
  for (const Points& run : runs_from_low_shear(data, points))
    for (std::size_t k = run.size(); k > 0; k -= std::min(k, step)) some.push_back(run[k - 1]);
  std::sort(some.begin(), some.end());
  return some;
}

bool is_found(const FitResult& fit) { return has_minimum(fit) && fit.freedom() > 0; }

double per_freedom(const FitResult& fit) { return comparable_squares(fit) / static_cast<double>(fit.freedom()); }

Message cut_at(const std::vector<std::size_t>& onsets, const Dataset& data, const FitResult& fit) {
  const std::vector<Points> runs = runs_from_low_shear(data, {fit.used.begin(), fit.used.end()});
  Points cut;
  for (const std::size_t onset : onsets) {
    const Points& run = runs[data.points[onset].curve];
    cut.insert(cut.end(), std::find(run.begin(), run.end(), onset), run.end());
  }
  const std::string lines = lines_text(data, cut);
  return lines.empty() ? Message() : Message(" (") + Remedy::set("exclude", lines) + ")";
}

std::optional<Cut> before_sliding(const Case& of, const Points& points, std::size_t few) {
  constexpr int kRounds = 8;
  const std::vector<Points> runs = runs_from_low_shear(of.data, points);
  const std::vector<double> largest = largest_shears(of.data, points);
  Points before;
  for (std::size_t c = 0; c < runs.size(); ++c)
    for (const std::size_t i : runs[c]) {
      if (of.data.points[i].shear() > 0.5 * largest[c]) break;
      before.push_back(i);
    }
  std::vector<FittedParameter> near;
  for (int round = 0; round < kRounds && before.size() > of.fit.free_parameters + kFew; ++round) {
    FitResult start = of.refit(of.data, of.options, before, near.empty() ? nullptr : &near);
    if (!is_found(start)) return std::nullopt;
    near = start.parameters;
    const auto off = far_off(of, start, points);
    if (!off) return std::nullopt;
    Points next;
    std::size_t left_out = 0, first = of.data.points.size();
    std::vector<std::size_t> onsets;
    for (const Points& run : runs) {
      const std::size_t end = onset(run, *off);
      next.insert(next.end(), run.begin(), run.begin() + static_cast<std::ptrdiff_t>(end));
      left_out += run.size() - end;
      if (end == run.size()) continue;
      first = std::min(first, run[end]);
      onsets.push_back(run[end]);
    }
    if (left_out < few) return std::nullopt;
    if (next == before) return Cut{std::move(start), left_out, first, std::move(onsets)};
    before = std::move(next);
  }
  return std::nullopt;
}

FitResult without_ends(const Case& of, const FitResult& whole, const Points& points) {
  const std::vector<double> largest = largest_shears(of.data, points);
  Points before = points;
  std::erase_if(before,
                [&](std::size_t i) { return of.data.points[i].shear() > 0.9 * largest[of.data.points[i].curve]; });
  return of.refit(of.data, of.options, before, &whole.parameters);
}

bool explains(const Dataset& data, const FitResult& fit, double chance) {
  if (fit.residuals.empty() && fit.pull_off_residuals.empty()) return false;
  const Consistency consistency = consistency_of(data, fit);
  const ResidualTests& tests = consistency.residuals;
  return !runs_differ(fit, chance) && !wrong_constant(fit) && consistency.chi2_p.value_or(1) > chance &&
         !consistency.pinned && !is_far(tests) && tests.course_p > chance && !tests.together &&
         !tests.neighbours_correlate(chance) && tests.trend_p > chance && tests.ends_p > chance &&
         !(consistency.pull_off && consistency.pull_off->p_value < chance);
}

}  // namespace mixity
