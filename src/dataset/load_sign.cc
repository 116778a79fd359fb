#include "dataset/load_sign.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mechanics/contact.h"

namespace mixity {

namespace {
constexpr double kPullOff = 1.5 * std::numbers::pi;
}

bool compression_is_negative(const Dataset& data) {
  constexpr double kFar = 2, kGrows = -0.5, kAlike = 2;
  constexpr std::size_t kSome = 3;
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
  if (far < kSome) return false;
  double pp = 0, pa = 0, aa = 0;
  std::vector<double> over_jkr;  // where there is hardly any shear
  for (const Point& point : data.points) {
    pp += (point.P - P) * (point.P - P);
    pa += (point.P - P) * (point.A - A);
    aa += (point.A - A) * (point.A - A);
    if (point.shear() <= 0.1 * most && point.P < -kFar * kPullOff)
      over_jkr.push_back(point.A / area_from_radius(jkr_radius(-point.P)));
  }
  const bool several = pp > 0.01 * P * P * n;
  if (several && pa < kGrows * std::sqrt(pp * aa)) return true;
  return !over_jkr.empty() && std::all_of(over_jkr.begin(), over_jkr.end(),
                                          [&](double ratio) { return ratio < kAlike && ratio > 1 / kAlike; });
}

void turn_loads(Dataset& data) {
  for (Point& point : data.points) point.P = 0 - point.P;  // 0 stays 0 and does not become -0
  for (double& load : data.curve_loads) load = 0 - load;
  if (data.metadata.load_offset) *data.metadata.load_offset = 0 - *data.metadata.load_offset;
  data.notes.emplace_back(kLoadsTurned);
}

void turn_as_others(std::vector<Dataset>& parts) {
  const auto is_turned = [](const Dataset& part) {
    return std::find(part.notes.begin(), part.notes.end(), kLoadsTurned) != part.notes.end();
  };
  const auto may_be = [](const Dataset& part) {
    return !part.metadata.load && part.metadata.load_from.empty() &&
           std::all_of(part.points.begin(), part.points.end(), [](const Point& point) { return point.P <= kPullOff; });
  };
  if (std::none_of(parts.begin(), parts.end(), is_turned)) return;
  for (Dataset& part : parts)
    if (!is_turned(part) && may_be(part)) turn_loads(part);
}

}  // namespace mixity
