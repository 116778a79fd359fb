// Readings of the tangential load below zero: noise about zero, or a run that is sheared the other way.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "dataset/dataset.h"

namespace mixity {

/// How the shear of a run's points lies about zero.
struct ShearRange {
  double least = 0, most = 0;  // zero among them
  std::size_t points = 0, below = 0;

  void add(double T) {
    least = T < least ? T : least;
    most = T > most ? T : most;
    ++points;
    below += T < 0;
  }
  void add(const ShearRange& other) {
    least = std::min(least, other.least);
    most = std::max(most, other.most);
    points += other.points;
    below += other.below;
  }
  /// Sheared the other way: a run (three points or more) whose largest reading above zero is at most a tenth of its
  /// largest below.
  bool is_negative() const { return points >= 3 && least < 0 && most <= -0.1 * least; }
};

/// Of each of so many runs.
std::vector<ShearRange> shear_ranges(const std::vector<Point>& points, std::size_t runs);

/// Once all points are read: asks for the zero of T where a run rises through it from below; turns runs round that are
/// sheared the other way (T -> -T), and notes which and how many points lie below zero then. `ranges`: of each run.
void finish_shear(const std::vector<ShearRange>& ranges, Dataset& data);

}  // namespace mixity
