#include "dataset/pull_off.h"

#include <algorithm>
#include <cmath>

namespace mixity {

void finish_pull_off(Dataset& data) {
  std::vector<PullOffReading>& list = data.pull_off;
  if (list.empty()) return;
  const auto less_shear = [](const PullOffReading& one, const PullOffReading& other) {
    return std::abs(one.shear) < std::abs(other.shear);
  };
  const auto [least, most] = std::minmax_element(list.begin(), list.end(), less_shear);
  const bool positive = std::all_of(list.begin(), list.end(), [](const PullOffReading& one) { return one.P >= 0; });
  // with tension positive they fall with shear; a load of compression that falls with it is none of pull-off
  const bool without_shear = std::abs(least->shear) <= 0.01 * std::abs(most->shear);
  if (positive && least->P > 0 && (without_shear || most->P < least->P)) {
    for (PullOffReading& one : list) one.P = 0 - one.P;
    data.notes.push_back(
        "pull-off loads are read with tension positive (P_c -> -P_c): without shear a contact is pulled off in "
        "tension");
  }
}

std::size_t without_pull_off_error(const Dataset& data) {
  return static_cast<std::size_t>(std::count_if(data.pull_off.begin(), data.pull_off.end(),
                                                [](const PullOffReading& one) { return one.sigma_P < 0; }));
}

LargestPullOff largest_pull_off(const Dataset& data) {
  LargestPullOff largest;
  for (const PullOffReading& one : data.pull_off) {
    largest.load = std::max(largest.load, std::abs(one.P));
    if (one.held == HeldShear::load) largest.shear = std::max(largest.shear, std::abs(one.shear));
  }
  return largest;
}

Dataset without_pull_off(Dataset data) {
  data.pull_off.clear();
  return data;
}

}  // namespace mixity
