#include "dataset/repeated_shear.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace mixity {
namespace {

constexpr double kNearStart = 0.1, kHigh = 0.5;  // of the largest |T| of the run so far, less the T it began with

/// The shear of a run, point by point.
struct ShearCourse {
  bool begun = false;
  double start = 0, last = 0, most = 0;

  /// Whether this point is the first of another run.
  bool begins_again(double T) {
    if (!begun) {
      *this = {true, T, 0, 0};
      return false;
    }
    const double shear = std::abs(T - start);
    if (most > 0 && last >= kHigh * most && shear <= kNearStart * most) {
      *this = {true, T, 0, 0};
      return true;
    }
    last = shear;
    most = std::max(most, shear);
    return false;
  }
};

/// Whether T rises from begin to before end, with few drops, to some share of `most`.
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

/// The indices at which runs begin among these readings of T; empty if there is only one.
std::vector<std::size_t> beginnings(const std::vector<double>& T) {
  std::vector<std::size_t> begins{0};
  double most = 0;
  ShearCourse course;
  for (std::size_t i = 0; i < T.size(); ++i) {
    most = std::max(most, std::abs(T[i] - T[0]));
    if (course.begins_again(T[i])) begins.push_back(i);
  }
  for (std::size_t k = begins.size(); k-- > 0;) {
    if (rises(T, begins[k], k + 1 < begins.size() ? begins[k + 1] : T.size(), most)) continue;
    if (k == 0) return {};
    begins.erase(begins.begin() + static_cast<std::ptrdiff_t>(k));
  }
  return begins.size() > 1 ? begins : std::vector<std::size_t>{};
}

}  // namespace

void split_repeated_shear(Dataset& data) {
  std::vector<ShearCourse> courses(data.curves.size());
  bool any = false;
  for (const Point& point : data.points) any |= courses[point.curve].begins_again(point.T);
  if (!any) return;
  std::vector<std::string> names;
  std::string parted;
  const auto by_run = points_by_curve(data);
  std::map<std::size_t, std::size_t> run_at;  // by the index of its first point
  std::vector<std::size_t> run(data.points.size());
  std::vector<double> loads;
  for (std::size_t one = 0; one < by_run.size(); ++one) {
    std::vector<double> T;
    for (const std::size_t i : by_run[one]) T.push_back(data.points[i].T);
    const std::vector<std::size_t> begins = beginnings(T);
    for (std::size_t k = 0, j = 0; j < T.size(); ++j) {
      if (k + 1 < begins.size() && j == begins[k + 1]) ++k;
      if (j == 0 || (!begins.empty() && j == begins[k])) {
        run_at.emplace(by_run[one][j], names.size());
        names.push_back(data.curves[one] + (k > 0 ? " (" + std::to_string(k + 1) + ")" : ""));
        loads.push_back(data.curve_loads[one]);
      }
      run[by_run[one][j]] = names.size() - 1;
    }
    if (!begins.empty())
      parted += (parted.empty() ? "" : ", ") + data.curves[one] + " (" + std::to_string(begins.size()) + ")";
  }
  if (parted.empty()) return;
  std::vector<std::size_t> number(names.size());
  data.curves.clear();
  data.curve_loads.clear();
  for (const auto& [first, one] : run_at) {
    number[one] = data.curves.size();
    data.curves.push_back(names[one]);
    data.curve_loads.push_back(loads[one]);
  }
  for (std::size_t i = 0; i < run.size(); ++i) data.points[i].curve = number[run[i]];
  data.notes.push_back("T goes back to where it began and rises anew: taken for several runs at one load: " + parted);
}

}  // namespace mixity
