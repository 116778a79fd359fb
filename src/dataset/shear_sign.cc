#include "dataset/shear_sign.h"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "base/text.h"

namespace mixity {
namespace {

/// The shear of the points of a run.
struct ShearRange {
  double least = 0, most = 0;  // zero among them
  std::size_t points = 0, below = 0;

  bool is_negative() const { return points >= 3 && least < 0 && most <= -0.1 * least; }
};

std::vector<ShearRange> shear_ranges(const Dataset& data) {
  std::vector<ShearRange> ranges(data.curves.size());
  for (const Point& point : data.points) {
    ShearRange& range = ranges[point.curve];
    range.least = std::min(range.least, point.T);
    range.most = std::max(range.most, point.T);
    ++range.points;
    range.below += point.T < 0;
  }
  return ranges;
}

/// Returns how many points of the runs that were turned are below zero then.
std::size_t turn_negative_runs(const std::vector<ShearRange>& ranges, Dataset& data) {
  constexpr std::size_t kNamed = 4, kLongest = 40;  // runs, characters
  std::size_t count = 0, below = 0;
  std::string names;
  for (std::size_t i = 0; i < ranges.size(); ++i)
    if (ranges[i].is_negative() && ++count <= kNamed)
      names += (names.empty() ? "" : ", ") + printable(data.curves[i], kLongest);
  if (count == 0) return 0;
  for (const ShearRange& range : ranges) data.turned.push_back(range.is_negative());
  for (Point& point : data.points) {
    if (!ranges[point.curve].is_negative()) continue;
    point.T = 0 - point.T;  // 0 stays 0 and does not become -0
    below += point.T < 0;
  }
  if (count > kNamed) names += " and " + std::to_string(count - kNamed) + " more";
  data.notes.push_back((count == 1 ? "a run is" : std::to_string(count) + " runs are") +
                       " sheared the other way and turned round (T -> -T): " + names);
  return below;
}

/// Notes runs that rise through zero from well below it. By noise four rising readings in a row are one in 400.
void ask_for_zero(Dataset& data) {
  constexpr std::size_t kInARow = 4;
  std::string names;
  std::size_t count = 0;
  std::vector<std::size_t> rising(data.curves.size());  // readings below zero, each above the last, from the first on
  std::vector<double> last(data.curves.size(), -std::numeric_limits<double>::infinity());
  for (const Point& point : data.points) {
    double& before = last[point.curve];
    if (before == std::numeric_limits<double>::infinity()) continue;
    if (point.T < 0 && point.T > before) {
      before = point.T;
      ++rising[point.curve];
    } else {
      before = std::numeric_limits<double>::infinity();
    }
  }
  for (std::size_t i = 0; i < rising.size(); ++i)
    if (rising[i] >= kInARow && ++count <= 3) names += (names.empty() ? "" : ", ") + printable(data.curves[i], 40);
  if (count == 0) return;
  data.notes.push_back("T rises through zero from below in run " + names + (count > 3 ? " and others" : "") +
                       ": is its zero right? An error of it can be stated (shear_offset) or fitted (" +
                       Remedy::set("free", "shear_offset") + ")");
}

}  // namespace

void finish_shear(Dataset& data) {
  const std::vector<ShearRange> ranges = shear_ranges(data);
  std::size_t below = turn_negative_runs(ranges, data);
  for (const ShearRange& range : ranges) below += range.is_negative() ? 0 : range.below;
  if (below == 0) return;
  ask_for_zero(data);
  data.notes.push_back(std::to_string(below) + " of " + std::to_string(data.points.size()) +
                       (below == 1 ? " points has T < 0, used as it is" : " points have T < 0, used as they are") +
                       ": equilibrium depends on T^2");
}

}  // namespace mixity
