// Change points of noisy readings: of their mean, or of the line that they follow.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace mixity {

/// Where the mean of the readings changes: the first index of each segment, including 0. Minimises the sum of squares
/// plus `penalty` variances per change exactly over all partitions, by PELT (Killick, Fearnhead & Eckley 2012, J. Am.
/// Stat. Assoc. 107, 1590).
std::vector<std::size_t> mean_changes(const std::vector<double>& values, double variance, double penalty);

/// A change after reading `at`, and its 95 % interval by the likelihood ratio (2 ln L at most 3.84 below its maximum).
struct ChangePoint {
  std::size_t at, first, last;
};

/// One of several series that change at the same time, and the standard deviation of its readings.
struct Course {
  const std::vector<double>* values;
  double noise;
};

/// The place in begin..end (end excluded) where all courses change from one straight line to another, which need not
/// meet. Null if fewer than three readings are on either side.
std::optional<ChangePoint> break_point(const std::vector<Course>& courses, std::size_t begin, std::size_t end);

/// The place in begin..end where a course leaves a line for a drop (or rise) of several readings, followed by another
/// line. `about`: the result of break_point, which finds the middle of a drop whose duration noise hides; the place is
/// less than `reach` readings from it.
ChangePoint beginning_of_drop(const Course& course, std::size_t begin, std::size_t end, const ChangePoint& about,
                              std::size_t reach);

/// The end or the beginning of a line: the value there and its standard error, including that of the position.
struct LineEnd {
  double at;  // position in readings, not rounded
  double value, error;
};

/// The range for a drop: its first reading is in first..seen, and the first reading after it is at most `last`.
struct DropSpan {
  std::size_t first, seen, last;
};

/// The ends of a drop from one line to another, along a line or between two readings. Least squares over begin..end
/// (end excluded), alternating between the beginning and the end of the drop. Null if fewer than three readings are on
/// either side.
struct DropEnds {
  LineEnd top, bottom;
};
std::optional<DropEnds> ends_of_drop(const Course& course, std::size_t begin, std::size_t end, const DropSpan& span);

/// The place in begin..end where a constant course begins to rise or fall along a line, and its value before.
struct Hinge {
  ChangePoint change;
  double level, slope;  // per reading
};
std::optional<Hinge> hinge_point(const Course& course, std::size_t begin, std::size_t end);

}  // namespace mixity
