// The course of residuals along the runs. Under a wrong model it is the same function of T in all runs; noise, even
// autocorrelated, has no common course.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "dataset/dataset.h"
#include "fitting/point_indices.h"

namespace mixity {

/// Residuals are averaged in five parts of each run, by T over the run's largest T. F compares the mean of these over
/// the runs with the differences between the runs. Correlated noise raises both alike.
struct CourseTest {
  double F, p_value;
  double parts;
  double size;  // of the course: root mean square of the means, in the unit of the residuals

  /// Whether it is larger than independent noise of this standard error makes it in the mean of so many points. Noise
  /// that cancels along each run, as of readings in pairs, makes a smaller one, which the differences between the runs,
  /// smaller still, call significant.
  bool exceeds_noise(std::size_t points, double unit) const {
    return size * size * static_cast<double>(points) > parts * unit * unit;
  }
};

/// `used`: indices of the points of `residuals`. `T`: their tangential loads at the fitted curve, in any unit. With
/// readings instead, the highest part has more points that are read too large by chance, so that the mean of its
/// residuals is not 0. Null unless at least three runs have ten points or more.
using OfPoint = std::function<double(std::size_t)>;  // by place among the used points
std::optional<CourseTest> test_course(const Dataset& data, const PointIndices& used, const OfPoint& T,
                                      const OfPoint& residual);
std::optional<CourseTest> test_course(const Dataset& data, const PointIndices& used, std::span<const double> T,
                                      std::span<const double> residuals);

}  // namespace mixity
