#include "fitting/pinned.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fitting/consistency.h"
#include "fitting/run_differences.h"
#include "solver/robust.h"
#include "statistics/distributions.h"

namespace mixity {
namespace {

/// Sums about the weighted means of a run, and about its line: xx > 0 if there is one.
struct LineOfRun {
  double points = 0, xx = 0, xy = 0;
  double squares = 0, products = 0;  // of the residuals about the line, and of neighbours among them
};

/// Areas of a run against (T/T_largest)^2, both about their weighted means, relative to the mean area.
class AreasOfRun {
 public:
  explicit AreasOfRun(std::size_t points) {
    for (std::vector<double>* const list : {&T2_, &A_, &weights_}) list->reserve(points);
  }
  /// `sigma`: of the area; 0: proportional errors.
  void add(const Point& point, double sigma) {
    T2_.push_back(point.T * point.T);
    A_.push_back(point.A);
    weights_.push_back(sigma > 0 ? 1 / (sigma * sigma) : 0);
    sum_ += point.A;
  }
  LineOfRun fit_line() {
    LineOfRun line{static_cast<double>(A_.size())};
    auto& [points, xx, xy, squares, products] = line;
    const double largest = *std::max_element(T2_.begin(), T2_.end()), area = sum_ / points;
    double weights = 0, x = 0, y = 0;
    for (std::size_t i = 0; i < A_.size(); ++i) {
      if (weights_[i] == 0) weights_[i] = 1 / (area * area);
      weights += weights_[i];
      x += weights_[i] / weights * (T2_[i] - x);
      y += weights_[i] / weights * (A_[i] - y);
    }
    for (std::size_t i = 0; i < A_.size(); ++i) {
      T2_[i] = (T2_[i] - x) / largest * area;
      A_[i] -= y;
      xx += weights_[i] * T2_[i] * T2_[i];
      xy += weights_[i] * T2_[i] * A_[i];
    }
    if (!(xx > 0)) return line;
    double before = 0;
    for (std::size_t i = 0; i < A_.size(); ++i) {
      const double residual = std::sqrt(weights_[i]) * (A_[i] - xy / xx * T2_[i]);
      squares += residual * residual;
      products += residual * before;
      before = residual;
    }
    return line;
  }

 private:
  std::vector<double> T2_, A_, weights_;
  double sum_ = 0;
};

/// The points that a robust loss does not treat as outliers.
PointIndices without_outliers(const FitResult& fit) {
  constexpr double kFar = 4;  // standard errors of a residual
  const double most = kFar * spread(fit.innovations);
  PointIndices points;
  for (std::size_t i = 0; i < fit.used.size(); ++i)
    if (std::abs(fit.innovations[i]) <= most) points.push_back(fit.used[i]);
  return points;
}

/// Whether the fitted curves describe the areas better than one area per run, by more than such autocorrelated noise
/// can. The fall is steepest next to the jump, where no simple trend detects it.
bool fall_as_fitted(const Dataset& data, const FitResult& fit, const std::function<double(std::size_t)>& residual) {
  if (fit.objective != Objective::curve || !fit.errors || fit.errors->A.empty()) return false;
  const auto weight = [&](std::size_t i) { return 1 / std::pow(fit.errors->A[fit.used[i]], 2); };
  double excess = 0;
  const PointsByRun runs(data, fit.used);
  for (std::size_t g = 0; g < runs.runs(); ++g) {
    double weights = 0, mean = 0;
    for (std::size_t k = 0; k < runs.size(g); ++k) {
      const std::size_t i = runs.at(g, k);
      weights += weight(i);
      mean += weight(i) / weights * (data.points[fit.used[i]].A - mean);
    }
    for (std::size_t k = 0; k < runs.size(g); ++k) {
      const std::size_t i = runs.at(g, k);
      excess += weight(i) * std::pow(data.points[fit.used[i]].A - mean, 2) - std::pow(residual(i), 2);
    }
  }
  const double worth = independent_points(fit) / static_cast<double>(fit.used.size());
  return excess / std::pow(residual_unit(fit), 2) * worth > kAboutAsWell;
}

}  // namespace

bool areas_stay(const Dataset& data, const PointIndices& used, std::span<const double> sigma_A) {
  constexpr double kEnough = 5, kEnoughInAll = 10;  // points in a run; degrees of freedom in all
  double lines = 0, freedom = 0, slopes = 0, sizes = 0, falls = 0, squares = 0, products = 0;
  const PointsByRun runs(data, used);
  std::vector<LineOfRun> of_runs(runs.runs());
  runs.for_each_run([&](std::size_t g) {
    if (static_cast<double>(runs.size(g)) < kEnough) return;
    AreasOfRun run(runs.size(g));
    for (std::size_t k = 0; k < runs.size(g); ++k) {
      const std::size_t point = used[runs.at(g, k)];
      run.add(data.points[point], sigma_A.empty() ? 0 : sigma_A[point]);
    }
    of_runs[g] = run.fit_line();
  });
  for (const LineOfRun& run : of_runs) {
    if (!(run.xx > 0)) continue;
    ++lines;
    freedom += run.points - 2;
    slopes += run.xy;
    sizes += run.xx;
    falls += run.xy * run.xy / run.xx;
    squares += run.squares;
    products += run.products;
  }
  if (freedom < kEnoughInAll) return false;
  // The correlation of neighbours about a line is estimated too low by (2 + 4 r)/n (Marriott & Pope 1954).
  constexpr double kMost = 0.95;
  const double seen = squares > 0 ? products / squares : 0;
  const double r = std::clamp(seen + (2 + 4 * seen) / (freedom / lines + 2), 0.0, kMost);
  const double variance = squares / freedom * (1 + r) / (1 - r);
  if (slopes * slopes > kAboutAsWell * sizes * variance) return false;
  return !(falls > 0) || fisher_p_value(falls / lines / variance, lines, freedom) >= kChance;
}

bool is_pinned(const Dataset& data, const FitResult& fit, const std::function<double(std::size_t)>& residual) {
  const bool robust = fit.loss_scale > 0 && fit.innovations.size() == fit.used.size();
  const std::span<const double> sigma_A = fit.errors ? fit.errors->A : std::span<const double>();
  const bool stay = robust ? areas_stay(data, without_outliers(fit), sigma_A) : areas_stay(data, fit.used, sigma_A);
  return stay && !fall_as_fitted(data, fit, residual);
}

}  // namespace mixity
