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
};

/// `used`: indices of the points of `residuals`. Null of fewer than three runs of ten points or more.
std::optional<CourseTest> test_course(const Dataset& data, std::span<const std::size_t> used,
                                      std::span<const double> residuals);

}  // namespace mixity
