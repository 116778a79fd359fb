// The course of residuals along the runs. A wrong model takes the same course over T in all runs; noise does
// not, whatever its memory.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "dataset/dataset.h"

namespace mixity {

/// The means of the residuals in five parts of each run, over T in the largest T of the run: their mean over the runs
/// against the differences between the runs. Correlated noise raises both alike.
struct CourseTest {
  double F, p_value;
  double size;  // of the course: root mean square of the means, in the unit of the residuals
};

/// `used`: indices of the points of `residuals`. `T`: their tangential loads, in any unit, at the fitted curve: a part
/// of the readings above some T has more that are too large by chance, whose residuals are not 0 in the mean. Null for
/// fewer than three runs of ten points or more.
std::optional<CourseTest> test_course(const Dataset& data, std::span<const std::size_t> used, std::span<const double> T,
                                      std::span<const double> residuals);

}  // namespace mixity
