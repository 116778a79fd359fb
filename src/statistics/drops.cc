#include "statistics/drops.h"

#include <algorithm>

namespace mixity {

std::size_t bottom(const std::vector<double>& values, std::size_t seen, std::size_t end, double least) {
  std::size_t low = seen;
  for (std::size_t i = seen; i < end && !(values[i] - values[low] > least); ++i)
    if (values[i] < values[low]) low = i;
  return low;
}

std::size_t rising_from(const std::vector<double>& values, std::size_t begin, std::size_t end) {
  const auto from = values.begin() + static_cast<std::ptrdiff_t>(begin),
             to = values.begin() + static_cast<std::ptrdiff_t>(end);
  if (from == to) return begin;
  const double tenth = 0.1 * *std::max_element(from, to);
  return static_cast<std::size_t>(std::find_if(from, to, [&](double one) { return one >= tenth; }) - values.begin());
}

std::optional<Drop> first_drop(const std::vector<double>& values, std::size_t begin, std::size_t end, double least,
                               double share) {
  std::size_t top = begin;
  for (std::size_t i = begin; i < end; ++i) {
    if (values[i] > values[top]) top = i;
    if (!(values[top] - values[i] > std::max(least, share * values[top]))) continue;
    return Drop{top, i, bottom(values, i, end, least)};
  }
  return std::nullopt;
}

std::vector<Drop> drops(const std::vector<double>& values, std::size_t begin, std::size_t end, double least,
                        double share) {
  std::vector<Drop> found;
  for (auto drop = first_drop(values, begin, end, least, share); drop;
       drop = first_drop(values, drop->low, end, least, share))
    found.push_back(*drop);
  return found;
}

}  // namespace mixity
