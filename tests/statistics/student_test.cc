// Student's errors against a scan of the likelihood, and against what made them.
#include "statistics/student.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace mixity {
namespace student_test {

std::vector<double> drawn(double freedom, double scale, std::size_t n, unsigned seed) {
  std::mt19937_64 random(seed);
  std::student_t_distribution<double> student(freedom);
  std::vector<double> values(n);
  for (double& one : values) one = scale * student(random);
  return values;
}

/// ln L by the density as printed, and the gamma prior of the logarithm of nu.
double printed(const std::vector<double>& values, double nu, double s) {
  double sum = 2 * std::log(nu) - 0.1 * nu;
  for (const double x : values)
    sum += std::log(std::tgamma((nu + 1) / 2) / (std::sqrt(nu * M_PI) * std::tgamma(nu / 2) * s) *
                    std::pow(1 + x * x / (nu * s * s), -(nu + 1) / 2));
  return sum;
}

TEST(Student, NothingNearbyIsMoreLikely) {
  for (const double freedom : {1.5, 3.0, 8.0}) {
    const std::vector<double> values = drawn(freedom, 0.4, 150, 5);
    const StudentErrors found = student_errors(values, false);
    const double most = printed(values, found.freedom, found.scale);
    for (const double nu : {0.9, 0.99, 1.01, 1.1})
      for (const double s : {0.9, 0.99, 1.0, 1.01, 1.1})
        EXPECT_GT(most, printed(values, nu * found.freedom, s * found.scale)) << freedom << ' ' << nu << ' ' << s;
  }
}

TEST(Student, RecoversWhatMadeTheErrors) {
  const StudentErrors found = student_errors(drawn(3, 0.4, 20000, 1), false);
  EXPECT_NEAR(found.freedom, 3, 0.3);  // its standard error is 0.08
  EXPECT_NEAR(found.scale, 0.4, 0.02);
  const StudentErrors known = student_errors(drawn(3, 1, 20000, 2), true);
  EXPECT_NEAR(known.freedom, 3, 0.2);
  EXPECT_EQ(known.scale, 1);
}

TEST(Student, OfGaussianErrorsIsNearlyGaussian) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  std::vector<double> values(2000);
  for (double& one : values) one = normal(random);
  EXPECT_GT(student_errors(values, false).freedom, 20);
}

/// By greatest likelihood alone a tenth of such samples have fewer than five degrees of freedom.
TEST(Student, OfFewGaussianErrorsHasNoTails) {
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  for (int sample = 0; sample < 50; ++sample) {
    std::vector<double> values(8);
    for (double& one : values) one = normal(random);
    EXPECT_GT(student_errors(values, false).freedom, 5) << sample;
  }
}

}  // namespace student_test
}  // namespace mixity
