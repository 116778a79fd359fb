// The course of residuals along the runs. Under a wrong model it is the same function of T in all runs; noise, even
// autocorrelated, has no common course.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "dataset/dataset.h"

namespace mixity {

/// Residuals are averaged in five parts of each run, by T over the run's largest T. F compares the mean of these over
/// the runs with the differences between the runs. Correlated noise raises both alike.
struct CourseTest {
  double F, p_value;
};

/// `used`: indices of the points of `residuals`. Null unless at least three runs have ten points or more.
std::optional<CourseTest> test_course(const Dataset& data, std::span<const std::size_t> used,
                                      std::span<const double> residuals);

}  // namespace mixity
