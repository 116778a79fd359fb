// The course of residuals over T: that of a wrong model, none of noise, however wide the noise of T is.
#include "fitting/course.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fitting/fit.h"
#include "fitting/synthetic_runs.h"

namespace mixity {
namespace course_test {

const std::vector<double> kLoads{-1.5, -0.2, 1.7, 3, 5, 9, 12, 24};

/// Eight runs of model c without noise, as if of a contact of this size.
Dataset exact_runs(std::size_t points) {
  Dataset data = synthetic_runs("c", {0.15}, kLoads, points, 0.97);
  data.contact = Contact{0.01, 2e6, 0.03};
  return data;
}

/// The same with proportional noise: of A 0.2 %, of T this share.
Dataset noisy_runs(unsigned seed, double share) {
  Dataset data = exact_runs(100);
  SeededNoise noise(seed, 0.002), shear(seed + 1000, share);
  for (Point& point : data.points) {
    point.T *= 1 + shear();
    point.A *= 1 + noise();
  }
  return data;
}

std::vector<std::size_t> all_of(const Dataset& data) {
  std::vector<std::size_t> list(data.points.size());
  std::iota(list.begin(), list.end(), std::size_t{0});
  return list;
}

/// A residual that is the noise of T is larger in the mean where the readings of T are.
TEST(Course, OfTheNoiseOfTIsNoneOverTheTrueT) {
  const Dataset data = exact_runs(500);
  const double largest = std::max_element(data.points.begin(), data.points.end(), [](const Point& x, const Point& y) {
                           return x.T < y.T;
                         })->T;
  SeededNoise noise(3, 1);
  std::vector<double> readings, T, residuals;
  for (const Point& point : data.points) {
    T.push_back(point.T);
    residuals.push_back(noise());
    readings.push_back(point.T + 0.03 * largest * residuals.back());
  }
  EXPECT_LT(test_course(data, all_of(data), readings, residuals)->p_value, 1e-6);
  const CourseTest course = *test_course(data, all_of(data), T, residuals);
  EXPECT_GT(course.p_value, 0.01);
  EXPECT_LT(course.size, 0.1);
}

/// The size is the root mean square of the means of the parts: here 0.4 in two of five parts, -0.4 in two.
TEST(Course, HasTheSizeOfTheMeans) {
  const Dataset data = exact_runs(500);
  SeededNoise noise(4, 1);
  std::vector<double> T, residuals;
  for (const Point& point : data.points) {
    const auto part = std::min(4.0, std::floor(point.T / data.points[point.curve * 500 + 499].T * 5));
    T.push_back(point.T);
    residuals.push_back(0.4 * (part < 2 ? 1 : part > 2 ? -1 : 0) + noise());
  }
  const CourseTest course = *test_course(data, all_of(data), T, residuals);
  EXPECT_LT(course.p_value, 1e-6);
  EXPECT_NEAR(course.size, 0.4 * std::sqrt(0.8), 0.05);  // the means of 800 points each err by 0.035
}

/// T has an error of 3 % of the largest one, A one of 0.2 %: A(T) is curved within the error of T.
TEST(Course, OfWideNoiseOfTMakesNoAlarm) {
  constexpr unsigned kExperiments = 40;
  unsigned ok = 0;
  for (unsigned seed = 1; seed <= kExperiments; ++seed) {
    Dataset data = exact_runs(100);
    SeededNoise noise(seed, 0.002), shear(seed + 1000, 1);
    double error = 0;
    for (const Point& point : data.points) error = std::max(error, 0.03 * point.T);
    for (Point& point : data.points) {
      point.T += error * shear();
      point.A *= 1 + noise();
    }
    const std::string sigma_T = std::to_string(1e6 * error * data.contact->force_unit()) + " uN";
    const FitOptions options{.sigma_T = parse_quantity(sigma_T), .sigma_A = parse_quantity("0.2%"), .intervals = false};
    const FitResult fit = fit_model(data, "c", options);
    ok += fit.status == FitStatus::ok;
    EXPECT_NEAR(*fit.parameters[0].value, 0.15, 4 * *fit.parameters[0].stderr_) << seed;
  }
  EXPECT_GE(ok, kExperiments - 1);  // of 200 experiments one makes an alarm
}

/// The first fit takes both errors as one share of the readings, by which these residuals have a course.
TEST(Course, OfTheFirstWeightsDoesNotKeepTheErrorsFromBeingFound) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    const Dataset data = noisy_runs(seed, 0.1);
    const FitResult fit = fit_model(data, "c", {.intervals = false});
    EXPECT_EQ(fit.status, FitStatus::ok) << seed << ": " << fit.message.text();
    EXPECT_NEAR(*fit.parameters[0].value, 0.15, 4 * *fit.parameters[0].stderr_) << seed;
    ASSERT_TRUE(fit.errors && fit.errors->model_T) << seed;
    EXPECT_NEAR(fit.errors->model_T->share, 0.1, 0.015) << seed;  // four errors of a scatter of 800 points, and less
  }
}

/// Each true area is read a tenth too large and a tenth too small: the means are 0 but for rounding, alike in all runs.
TEST(Course, OfReadingsInPairsIsTooSmallToMatter) {
  Dataset data = exact_runs(15);
  std::vector<Point> pairs;
  for (const Point& point : data.points)
    for (const double factor : {1.1, 0.9}) {
      pairs.push_back(point);
      pairs.back().T *= factor;
      pairs.back().A *= factor;
      pairs.back().line = static_cast<Point::Index>(pairs.size() + 1);
    }
  data.points = pairs;
  data.rows = pairs.size();
  const FitResult fit = fit_model(data, "c", {});
  EXPECT_EQ(fit.status, FitStatus::ok) << fit.message.text();
  EXPECT_LT(fit.parameters[0].interval->low, 0.15);
  EXPECT_GT(fit.parameters[0].interval->high, 0.15);
}

TEST(Course, OfAWrongModelIsAnAlarmAlsoUnderWideNoise) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    EXPECT_EQ(fit_model(noisy_runs(seed, 0.03), "a", {.intervals = false}).status, FitStatus::suspect) << seed;
  }
}

}  // namespace course_test
}  // namespace mixity
