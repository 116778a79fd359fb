// The course of areas and residuals along the runs. A wrong model takes the same course over T in all runs; noise does
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

/// Whether the areas of each run are one area within their scatter, by themselves, whatever was fitted: a fall with T^2
/// that all runs share lowers their squares by less than 6 times the variance about a line in T^2 for each run, and
/// these lines lower them by no more than chance. Where neighbours correlate, the variance counts accordingly more.
/// `sigma_A`: of each point of the data set, as far as is known; empty: proportional errors. False of too few points.
bool areas_stay(const Dataset& data, std::span<const std::size_t> used, std::span<const double> sigma_A);

}  // namespace mixity
