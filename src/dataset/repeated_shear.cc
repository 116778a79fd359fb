#include <algorithm>
#include <cmath>

#include "dataset/unnamed_runs.h"

namespace mixity {
namespace {

constexpr double kNearStart = 0.1, kHigh = 0.5;  // of the largest |T| in the run so far, minus its first T

/// The shear of a run, point by point.
struct ShearCourse {
  bool begun = false;
  double start = 0, last = 0, most = 0;

  /// Whether this point is the first of a new run.
  bool begins_again(double T) {
    const double shear = std::abs(T - start);
    const bool again = begun && most > 0 && last >= kHigh * most && shear <= kNearStart * most;
    *this = begun && !again ? ShearCourse{true, start, shear, std::max(most, shear)} : ShearCourse{true, T, 0, 0};
    return again;
  }
};

/// Whether T rises from begin to before end, with few drops, to some fraction of `most`.
bool rises(const std::vector<double>& T, std::size_t begin, std::size_t end, double most) {
  constexpr std::size_t kFewest = 4;
  constexpr double kSome = 0.3, kDrop = 0.02;
  std::size_t drops = 0;
  double reached = 0;
  for (std::size_t i = begin + 1; i < end; ++i) {
    const double before = std::abs(T[i - 1] - T[begin]), shear = std::abs(T[i] - T[begin]);
    reached = std::max(reached, shear);
    drops += shear < before - kDrop * most;
  }
  return end - begin >= kFewest && reached >= kSome * most && 4 * drops < end - begin;
}

/// The indices at which runs begin among these readings of T.
std::vector<std::size_t> beginnings(const std::vector<double>& T) {
  std::vector<std::size_t> begins{0};
  double most = 0;
  ShearCourse course;
  for (std::size_t i = 0; i < T.size(); ++i) {
    most = std::max(most, std::abs(T[i] - T[0]));
    if (course.begins_again(T[i])) begins.push_back(i);
  }
  for (std::size_t k = begins.size(); k-- > 0 && begins.size() > 1;) {
    if (rises(T, begins[k], k + 1 < begins.size() ? begins[k + 1] : T.size(), most)) continue;
    if (k == 0) return {0};
    begins.erase(begins.begin() + static_cast<std::ptrdiff_t>(k));
  }
  return begins;
}

/// A run of the data set, or one of the parts that it is split into.
struct Part {
  std::size_t first_point;
  std::string name;
  double load;
};

}  // namespace

void split_repeated_shear(Dataset& data) {
  std::vector<ShearCourse> courses(data.curves.size());
  bool any = false;
  for (const Point& point : data.points) any |= courses[point.curve].begins_again(point.T);
  if (!any) return;
  std::vector<Part> parts;
  std::vector<std::size_t> part_of_point(data.points.size());
  std::string split;
  const auto runs = points_by_curve(data);
  for (std::size_t run = 0; run < runs.size(); ++run) {
    std::vector<double> T;
    for (const std::size_t i : runs[run]) T.push_back(data.points[i].T);
    const std::vector<std::size_t> begins = beginnings(T);
    for (std::size_t k = 0; k < begins.size(); ++k) {
      const std::size_t end = k + 1 < begins.size() ? begins[k + 1] : T.size();
      for (std::size_t j = begins[k]; j < end; ++j) part_of_point[runs[run][j]] = parts.size();
      parts.push_back({runs[run][begins[k]], data.curves[run] + (k > 0 ? " (" + std::to_string(k + 1) + ")" : ""),
                       data.curve_loads[run]});
    }
    if (begins.size() > 1)
      split += (split.empty() ? "" : ", ") + data.curves[run] + " (" + std::to_string(begins.size()) + ")";
  }
  if (split.empty()) return;
  // numbered in order of appearance
  data.curves.clear();
  data.curve_loads.clear();
  std::vector<std::size_t> number(parts.size());
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    const Part& part = parts[part_of_point[i]];
    if (part.first_point == i) {
      number[part_of_point[i]] = data.curves.size();
      data.curves.push_back(part.name);
      data.curve_loads.push_back(part.load);
    }
    data.points[i].curve = static_cast<Point::Index>(number[part_of_point[i]]);
  }
  data.notes.push_back("T returns to its start and rises again: split into several runs at one load: " + split);
}

}  // namespace mixity
