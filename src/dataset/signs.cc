#include "dataset/signs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <string>

#include "base/phrases.h"
#include "base/text.h"
#include "mechanics/contact.h"

namespace mixity {
namespace {

constexpr double kPullOff = 1.5 * std::numbers::pi;

double reversed(double value) { return 0 - value; }  // maps 0 to 0, not to -0

/// The shear of the points of a run.
struct ShearRange {
  double least = 0, most = 0;  // least <= 0 <= most
  std::size_t points = 0, below = 0;

  bool is_negative() const { return points >= 3 && least < 0 && most <= -0.1 * least; }
};

/// Ranges of T with the stated offset.
std::vector<ShearRange> shear_ranges(const Dataset& data) {
  std::vector<ShearRange> ranges(data.curves.size());
  const ConstantsScale by(data.stated_constants());
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    const auto [line, run, P, T, A] = data.corrected(i, by);
    ShearRange& range = ranges[run];
    range.least = std::min(range.least, T);
    range.most = std::max(range.most, T);
    ++range.points;
    range.below += T < 0;
  }
  return ranges;
}

/// The names of the first few of these runs.
std::string names_of(const Dataset& data, const std::vector<std::size_t>& runs, std::size_t few) {
  return joined(texts_of(std::span(runs).first(std::min(few, runs.size())),
                         [&](std::size_t run) { return printable(data.curves[run], 40); }));
}

void reverse_negative_runs(Dataset& data) {
  constexpr std::size_t kFew = 4;
  const std::vector<ShearRange> ranges = shear_ranges(data);
  std::vector<std::size_t> runs;
  for (std::size_t i = 0; i < ranges.size(); ++i)
    if (ranges[i].is_negative()) runs.push_back(i);
  if (runs.empty()) return;
  for (const ShearRange& range : ranges) data.shear_reversed.push_back(range.is_negative());
  for (Point& point : data.points)
    if (data.shear_reversed[point.curve]) point.T = reversed(point.T);
  data.notes.push_back((runs.size() == 1 ? "a run" : std::to_string(runs.size()) + " runs") +
                       " sheared in the negative direction " + (runs.size() == 1 ? "was" : "were") +
                       " reversed (T -> -T): " + names_of(data, runs, kFew) +
                       (runs.size() > kFew ? " and " + std::to_string(runs.size() - kFew) + " more" : ""));
}

/// Adds a note on runs that rise through zero from well below. In noise, one in 400 has four rising readings in a row.
void ask_for_zero(Dataset& data) {
  constexpr std::size_t kInARow = 4, kFew = 3;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<std::size_t> rising(data.curves.size());  // rising readings below zero, counted from the first
  std::vector<double> last(data.curves.size(),
                           -kInfinity);  // kInfinity: the readings rise no longer, or are above zero
  const ConstantsScale by(data.stated_constants());
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    const auto [line, run, P, T, A] = data.corrected(i, by);
    const bool rises = T < 0 && T > last[run];
    rising[run] += rises;
    last[run] = rises ? T : kInfinity;
  }
  std::vector<std::size_t> runs;
  for (std::size_t i = 0; i < rising.size(); ++i)
    if (rising[i] >= kInARow) runs.push_back(i);
  if (runs.empty()) return;
  data.notes.push_back("T rises through zero from below in run " + names_of(data, runs, kFew) +
                       (runs.size() > kFew ? " and others" : "") +
                       ": is its zero right? An error of it can be stated (shear_offset) or fitted (" +
                       Remedy::set("free", "shear_offset") + ")");
}

}  // namespace

bool compression_is_negative(const Dataset& data) {
  constexpr double kFar = 2, kGrows = -0.5, kAlike = 2;
  constexpr std::size_t kFew = 3;
  const double n = static_cast<double>(data.points.size());
  std::size_t far = 0;
  double P = 0, A = 0, most = 0;
  for (const Point& point : data.points) {
    if (point.P > kPullOff) return false;
    far += point.P < -kFar * kPullOff;
    P += point.P / n;
    A += point.A / n;
    most = std::max(most, point.shear());
  }
  if (far < kFew) return false;
  double pp = 0, pa = 0, aa = 0;
  std::vector<double> over_jkr;  // for points with hardly any shear
  for (const Point& point : data.points) {
    pp += (point.P - P) * (point.P - P);
    pa += (point.P - P) * (point.A - A);
    aa += (point.A - A) * (point.A - A);
    if (point.shear() <= 0.1 * most && point.P < -kFar * kPullOff)
      over_jkr.push_back(point.A / area_from_radius(jkr_radius(-point.P)));
  }
  const bool several_loads = pp > 0.01 * P * P * n;
  if (several_loads && pa < kGrows * std::sqrt(pp * aa)) return true;
  return !over_jkr.empty() && std::all_of(over_jkr.begin(), over_jkr.end(),
                                          [&](double ratio) { return ratio < kAlike && ratio > 1 / kAlike; });
}

void reverse_loads(Dataset& data) {
  for (Point& point : data.points) point.P = reversed(point.P);
  for (double& load : data.curve_loads) load = reversed(load);
  if (data.metadata.load_offset) data.metadata.load_offset = reversed(*data.metadata.load_offset);
  data.notes.emplace_back(kLoadsReversed);
}

void reverse_loads_alike(std::vector<Dataset>& parts) {
  const auto is_reversed = [](const Dataset& part) {
    return std::find(part.notes.begin(), part.notes.end(), kLoadsReversed) != part.notes.end();
  };
  const auto may_be_negative = [](const Dataset& part) {
    return !part.metadata.load && part.metadata.load_from.empty() &&
           std::all_of(part.points.begin(), part.points.end(), [](const Point& point) { return point.P <= kPullOff; });
  };
  if (std::none_of(parts.begin(), parts.end(), is_reversed)) return;
  for (Dataset& part : parts)
    if (!is_reversed(part) && may_be_negative(part)) reverse_loads(part);
}

void finish_shear(Dataset& data) {
  reverse_negative_runs(data);
  std::size_t below = 0;
  for (const ShearRange& range : shear_ranges(data)) below += range.below;
  if (below == 0) return;
  ask_for_zero(data);
  data.notes.push_back(std::to_string(below) + " of " + std::to_string(data.points.size()) +
                       (below == 1 ? " points has T < 0, used as it is" : " points have T < 0, used as they are") +
                       ": equilibrium depends on T^2");
}

}  // namespace mixity
