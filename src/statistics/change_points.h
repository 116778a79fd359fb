// Where a noisy course changes: levels, and the two kinds of cut that a loading run has.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace mixity {

/// From where on readings have another mean: the exact minimum of squares over all partitions, each change paid with
/// `penalty` variances, by PELT (Killick, Fearnhead & Eckley 2012, J. Am. Stat. Assoc. 107, 1590). Begins with 0.
std::vector<std::size_t> level_changes(const std::vector<double>& values, double variance, double penalty);

/// A cut behind reading `at`, and the first and last that the likelihood cannot tell from it (95 %: twice the logarithm
/// less than 3.84 below its maximum).
struct ChangePoint {
  std::size_t at, first, last;
};

/// One of several courses that change at one time, and its standard deviation.
struct Course {
  const std::vector<double>* values;
  double noise;
};

/// Where in begin..end (end not included) courses break: before and behind each is a straight line, and they need not
/// meet. Null if fewer than three readings are on either side.
std::optional<ChangePoint> break_point(const std::vector<Course>& courses, std::size_t begin, std::size_t end);

/// Where in begin..end a course leaves a line and falls or rises along a second to a third: the cut behind the first,
/// where break_point finds the middle of the second if noise hides that it takes time. Nearer than `reach` readings to
/// `about`, which is of break_point.
ChangePoint beginning_of_fall(const Course& course, std::size_t begin, std::size_t end, const ChangePoint& about,
                              std::size_t reach);

/// Where a line ends or begins: its value there, and the standard error of that, with what the place may be off by.
struct LineEnd {
  double at;  // in readings, between two of them
  double value, error;
};

/// Where a fall can be: its first reading is in first..seen, the first one behind it not after `last`.
struct FallSpan {
  std::size_t first, seen, last;
};

/// A line that ends in a fall along a second one, or between two readings, and a third one from its end on: least
/// squares over begin..end (end not included), by turns in where the fall begins and where it ends. Null if fewer than
/// three readings are on either side.
struct FallEnds {
  LineEnd top, bottom;
};
std::optional<FallEnds> ends_of_fall(const Course& course, std::size_t begin, std::size_t end, const FallSpan& span);

/// Where in begin..end a course that was level begins to rise or fall along a straight line; also its level before.
struct Hinge {
  ChangePoint change;
  double level, slope;  // per reading
};
std::optional<Hinge> hinge_point(const Course& course, std::size_t begin, std::size_t end);

}  // namespace mixity
