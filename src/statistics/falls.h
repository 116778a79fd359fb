// Where readings fall by more than their noise.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace mixity {

/// From the largest reading before it, over the first one that is far enough below, to the smallest one behind it.
struct Fall {
  std::size_t top, seen, low;
};

/// The first fall in begin..end (end not included) of more than `least`, and of more than this share of its top, up to
/// where readings have risen by more than `least` again (Page 1954, Biometrika 41, 100, of the sums' maximum). Null if
/// there is none.
std::optional<Fall> first_fall(const std::vector<double>& values, std::size_t begin, std::size_t end, double least,
                               double share = 0);
/// The first reading of a tenth of the largest in begin..end: what falls before that is no peak.
std::size_t rising_from(const std::vector<double>& values, std::size_t begin, std::size_t end);
/// The smallest reading from `seen` on, up to where readings have risen by more than `least`.
std::size_t bottom(const std::vector<double>& values, std::size_t seen, std::size_t end, double least);
/// All of them, one after the other.
std::vector<Fall> falls(const std::vector<double>& values, std::size_t begin, std::size_t end, double least,
                        double share = 0);

}  // namespace mixity
