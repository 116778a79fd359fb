// Drops of readings that exceed their noise.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace mixity {

/// Indices of the largest reading before a drop, the first far enough below it, and the smallest after it.
struct Drop {
  std::size_t top, seen, low;
};

/// The first drop in begin..end (end excluded) that exceeds `least` and this fraction of its top; it ends where
/// readings have risen by more than `least` again (Page 1954, Biometrika 41, 100). Null if there is none.
std::optional<Drop> first_drop(const std::vector<double>& values, std::size_t begin, std::size_t end, double least,
                               double share = 0);
/// The first reading that reaches a tenth of the largest in begin..end; earlier drops are not peaks.
std::size_t rising_from(const std::vector<double>& values, std::size_t begin, std::size_t end);
/// The smallest reading from `seen` on, before readings have risen by more than `least`.
std::size_t bottom(const std::vector<double>& values, std::size_t seen, std::size_t end, double least);
/// All drops in order.
std::vector<Drop> drops(const std::vector<double>& values, std::size_t begin, std::size_t end, double least,
                        double share = 0);

}  // namespace mixity
