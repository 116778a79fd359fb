#include "statistics/steps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace mixity {

double common_step(const std::vector<std::vector<double>>& runs) {
  constexpr double kEqual = 0.2, kOff = 0.05, kRounding = 1e-9;
  std::vector<double> values;
  double pairs = 0, equal = 0, largest = 0;
  for (const auto& run : runs)
    for (std::size_t i = 0; i < run.size(); ++i) {
      values.push_back(run[i]);
      largest = std::max(largest, std::abs(run[i]));
      if (i == 0) continue;
      ++pairs;
      equal += std::abs(run[i] - run[i - 1]) <= kRounding * largest;
    }
  if (!(pairs > 0 && equal >= kEqual * pairs)) return 0;
  std::sort(values.begin(), values.end());
  std::vector<double> apart;
  for (std::size_t i = 1; i < values.size(); ++i)
    if (values[i] - values[i - 1] > kRounding * largest) apart.push_back(values[i] - values[i - 1]);
  if (apart.empty()) return 0;
  const double least = *std::min_element(apart.begin(), apart.end());
  double steps = 0, sum = 0;
  for (const double one : apart) {
    const double count = std::round(one / least);
    if (std::abs(one - count * least) > kOff * least) return 0;
    steps += count;
    sum += one;
  }
  return sum / steps;
}

}  // namespace mixity
