#include "fitting/course.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fitting/run_differences.h"
#include "statistics/distributions.h"

namespace mixity {
namespace {

constexpr std::size_t kParts = 5, kLeastRuns = 3;

struct Part {
  double points = 0, sum = 0;
};
using Run = std::array<Part, kParts>;

/// The parts of all runs that are long enough.
template <class Shear, class Residual>
std::vector<Run> parts_of(const Dataset& data, const PointIndices& used, const Shear& T, const Residual& residual) {
  const PointsByRun in_runs(data, used);
  std::vector<Run> runs(in_runs.runs());
  in_runs.for_each_run([&](std::size_t g) {
    const std::size_t size = in_runs.size(g);
    double largest = 0;
    for (std::size_t k = 0; k < size; ++k) largest = std::max(largest, std::abs(T(in_runs.at(g, k))));
    if (size < 2 * kParts || !(largest > 0)) return;
    Run run;
    for (std::size_t k = 0; k < size; ++k) {
      const std::size_t i = in_runs.at(g, k);
      const double place = std::abs(T(i)) / largest * kParts;
      Part& part = run[std::min(static_cast<std::size_t>(place), kParts - 1)];
      ++part.points;
      part.sum += residual(i);
    }
    runs[g] = run;
  });
  std::erase_if(runs, [](const Run& run) {
    return std::all_of(run.begin(), run.end(), [](const Part& part) { return part.points == 0; });
  });
  return runs;
}

std::optional<CourseTest> test_parts(const std::vector<Run>& runs) {
  if (runs.size() < kLeastRuns) return std::nullopt;
  double course = 0, differences = 0, parts = 0, freedom = 0, points = 0;
  for (std::size_t k = 0; k < kParts; ++k) {
    Part all;
    for (const Run& run : runs) {
      all.points += run[k].points;
      all.sum += run[k].sum;
    }
    if (all.points == 0) continue;
    const double mean = all.sum / all.points;
    course += all.points * mean * mean;
    points += all.points;
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
  return CourseTest{F, fisher_p_value(F, parts, freedom), parts, std::sqrt(course / points)};
}

}  // namespace

std::optional<CourseTest> test_course(const Dataset& data, const PointIndices& used, const OfPoint& T,
                                      const OfPoint& residual) {
  return test_parts(parts_of(data, used, T, residual));
}

std::optional<CourseTest> test_course(const Dataset& data, const PointIndices& used, std::span<const double> T,
                                      std::span<const double> residuals) {
  return test_parts(parts_of(
      data, used, [&](std::size_t i) { return T[i]; }, [&](std::size_t i) { return residuals[i]; }));
}

}  // namespace mixity
