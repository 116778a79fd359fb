// A contact that is not circular and autocorrelated noise of T leave similar residuals.
#include <gtest/gtest.h>

#include "fitting/causes.h"
#include "fitting/fit.h"
#include "fitting/measured_runs.h"

namespace mixity {
namespace shape_or_memory_test {

/// First-order autoregressive noise of unit variance along each run.
Dataset with_memory(unsigned seed, double rho, double size) {
  Dataset data = synthetic_runs("c", {0.15}, {-1, 0.5, 2, 5, 12, 30}, 60);
  SeededNoise noise(seed, 1);
  double A = 0, T = 0;
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    Point& point = data.points[i];
    const bool first = i == 0 || data.points[i - 1].curve != point.curve;
    A = first ? noise() : rho * A + std::sqrt(1 - rho * rho) * noise();
    T = first ? noise() : rho * T + std::sqrt(1 - rho * rho) * noise();
    point.A *= 1 + size * A;
    point.T *= 1 + size * T;
  }
  return data;
}

/// The radius reads too large by a share of the square of T over its largest value.
Dataset with_shape(unsigned seed, double share, double noise_A, double noise_T) {
  Dataset data = synthetic_runs("c", {0.15}, {-1, 0.5, 2, 5, 12, 30}, 40);
  std::vector<double> largest(data.curves.size());
  for (const Point& point : data.points) largest[point.curve] = std::max(largest[point.curve], point.T);
  SeededNoise of_A(seed, noise_A), of_T(seed + 1000, noise_T);
  for (Point& point : data.points) {
    const double x = point.T / largest[point.curve];
    point.A *= std::pow(1 + share * x * x, 2) * (1 + of_A());
    point.T *= 1 + of_T();
  }
  return data;
}

struct Tried {
  std::size_t fits = 0;
  std::optional<double> misfit{};  // of the last one
  bool with_memory = false;
};

Tried tried(const Dataset& data, const FitResult& fit) {
  Tried found;
  const FitOptions options = value_only({});
  const Refit refit = [&](const Dataset& of, const FitOptions& with, const std::vector<std::size_t>& points,
                          const std::vector<FittedParameter>*) {
    FitResult other = fit_and_test(of, "c", with, &points);
    ++found.fits;
    found.misfit = misfit(other);
    found.with_memory = other.errors->correlations.any();
    return other;
  };
  shape_instead_of_memory({data, fit, options, refit});
  return found;
}

TEST(ShapeOrMemory, NoShapeIsTriedWhereTheNoiseHasAMemory) {
  for (const unsigned seed : {1, 2, 3}) {
    const Dataset data = with_memory(seed, 0.6, 0.01);
    const FitResult fit = fit_and_test(data, "c", {});
    ASSERT_TRUE(fit.errors->correlations.any()) << seed;
    ASSERT_TRUE(fit.shape_instead_of_memory) << seed;
    EXPECT_GT(*fit.shape_instead_of_memory, misfit(fit) + 50) << seed;
    EXPECT_EQ(tried(data, fit).fits, 0U) << seed;
  }
}

/// A contact that is hardly elliptic passes its tests, in one of 60 experiments with a memory that is not there.
TEST(ShapeOrMemory, AShapeThatDoesAsWellWithoutMemoryIsTried) {
  constexpr double kTooLarge = 40;  // as in shape_instead_of_memory
  std::size_t alternatives = 0;
  for (const auto& [noise_A, noise_T] : {std::pair(0.001, 0.01), {0.001, 0.03}, {0.003, 0.003}, {0.003, 0.01}})
    for (unsigned seed = 0; seed < 60; ++seed) {
      const Dataset data = with_shape(seed, 0.003, noise_A, noise_T);
      const FitResult fit = fit_and_test(data, "c", {});
      if (!fit.shape_instead_of_memory || fit.status != FitStatus::ok) continue;
      const Tried shape = tried(data, fit);
      if (shape.fits == 0 || shape.with_memory) continue;
      ++alternatives;
      EXPECT_LT(*fit.shape_instead_of_memory, *shape.misfit + kTooLarge / 2) << seed;
    }
  EXPECT_GE(alternatives, 3U);
}

}  // namespace shape_or_memory_test
}  // namespace mixity
