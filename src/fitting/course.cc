#include "fitting/course.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fitting/consistency.h"
#include "statistics/distributions.h"

namespace mixity {
namespace {

constexpr std::size_t kParts = 5, kLeastRuns = 3;

struct Part {
  double points = 0, sum = 0;
};
using Run = std::array<Part, kParts>;

/// The parts of the runs that are long enough.
std::vector<Run> parts_of(const Dataset& data, std::span<const std::size_t> used, std::span<const double> residuals) {
  std::vector<double> largest(data.curves.size());
  std::vector<std::size_t> points(data.curves.size());
  for (const std::size_t i : used) {
    const std::size_t run = data.points[i].curve;
    largest[run] = std::max(largest[run], data.points[i].shear());
    ++points[run];
  }
  std::vector<Run> runs(data.curves.size());
  for (std::size_t i = 0; i < used.size(); ++i) {
    const std::size_t run = data.points[used[i]].curve;
    if (points[run] < 2 * kParts || !(largest[run] > 0)) continue;
    const double place = data.points[used[i]].shear() / largest[run] * kParts;
    Part& part = runs[run][std::min(static_cast<std::size_t>(place), kParts - 1)];
    ++part.points;
    part.sum += residuals[i];
  }
  std::erase_if(runs, [](const Run& run) {
    return std::all_of(run.begin(), run.end(), [](const Part& part) { return part.points == 0; });
  });
  return runs;
}

/// Areas of a run over (T/T_largest)^2, both about their weighted means, relative to the mean area.
class AreasOfRun {
 public:
  double xx = 0, xy = 0, squares = 0, products = 0;  // of the residuals about the line, and of neighbours among them

  /// `sigma`: of the area; 0: proportional errors.
  void add(const Point& point, double sigma) {
    T2_.push_back(point.T * point.T);
    A_.push_back(point.A);
    weights_.push_back(sigma > 0 ? 1 / (sigma * sigma) : 0);
    sum_ += point.A;
  }
  double points() const { return static_cast<double>(A_.size()); }

  /// False without shear.
  bool fit_line() {
    const double largest = *std::max_element(T2_.begin(), T2_.end()), area = sum_ / points();
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
    if (!(xx > 0)) return false;
    double before = 0;
    for (std::size_t i = 0; i < A_.size(); ++i) {
      const double residual = std::sqrt(weights_[i]) * (A_[i] - xy / xx * T2_[i]);
      squares += residual * residual;
      products += residual * before;
      before = residual;
    }
    return true;
  }

 private:
  std::vector<double> T2_, A_, weights_;
  double sum_ = 0;
};

}  // namespace

std::optional<CourseTest> test_course(const Dataset& data, std::span<const std::size_t> used,
                                      std::span<const double> residuals) {
  const std::vector<Run> runs = parts_of(data, used, residuals);
  if (runs.size() < kLeastRuns) return std::nullopt;
  double course = 0, differences = 0, parts = 0, freedom = 0;
  for (std::size_t k = 0; k < kParts; ++k) {
    Part all;
    for (const Run& run : runs) {
      all.points += run[k].points;
      all.sum += run[k].sum;
    }
    if (all.points == 0) continue;
    const double mean = all.sum / all.points;
    course += all.points * mean * mean;
    ++parts;
    --freedom;
    for (const Run& run : runs)
      if (run[k].points > 0) {
        differences += run[k].points * std::pow(run[k].sum / run[k].points - mean, 2);
        ++freedom;
      }
  }
  if (!(freedom > 0 && differences > 0)) return std::nullopt;
  const double F = course / parts / (differences / freedom);
  return CourseTest{F, fisher_p_value(F, parts, freedom)};
}

bool areas_stay(const Dataset& data, std::span<const std::size_t> used, std::span<const double> sigma_A) {
  constexpr double kEnough = 5, kEnoughInAll = 10;  // points of a run, and degrees of freedom
  std::vector<AreasOfRun> runs(data.curves.size());
  for (const std::size_t i : used) runs[data.points[i].curve].add(data.points[i], sigma_A.empty() ? 0 : sigma_A[i]);
  double lines = 0, freedom = 0, slopes = 0, sizes = 0, falls = 0, squares = 0, products = 0;
  for (AreasOfRun& run : runs) {
    if (run.points() < kEnough || !run.fit_line()) continue;
    ++lines;
    freedom += run.points() - 2;
    slopes += run.xy;
    sizes += run.xx;
    falls += run.xy * run.xy / run.xx;
    squares += run.squares;
    products += run.products;
  }
  if (freedom < kEnoughInAll) return false;
  // The correlation of neighbours about a line is too low by (2 + 4 r)/n (Marriott & Pope 1954).
  constexpr double kMost = 0.95;
  const double seen = squares > 0 ? products / squares : 0;
  const double r = std::clamp(seen + (2 + 4 * seen) / (freedom / lines + 2), 0.0, kMost);
  const double variance = squares / freedom * (1 + r) / (1 - r);
  if (slopes * slopes > kAboutAsWell * sizes * variance) return false;
  return !(falls > 0) || fisher_p_value(falls / lines / variance, lines, freedom) >= kChance;
}

}  // namespace mixity
