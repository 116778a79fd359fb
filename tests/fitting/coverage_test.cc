// What an interval promises: over many data sets it holds the true value as often as its confidence says.
#include <gtest/gtest.h>

#include <cmath>

#include "fitting/fit.h"
#include "fitting/synthetic_runs.h"

namespace mixity {
namespace coverage_test {

#if defined(__SANITIZE_ADDRESS__)
constexpr unsigned kSeeds = 16;  // slow under sanitizers
#else
constexpr unsigned kSeeds = 80;
#endif

/// Model c at lambda = 0.15, three runs well before their folds; noise in A and in T.
Dataset noisy(unsigned seed, double size_A, double size_T) {
  SeededNoise noise_A(seed, size_A), noise_T(seed + 1000000, size_T);
  Dataset data = synthetic_runs("c", {0.15}, {0.5, 5, 20}, 10, 0.8, noise_A);
  for (Point& p : data.points) p = {p.line, p.curve, p.P, p.T * (1 + noise_T()), p.A};
  return data;
}

/// Data sets whose interval holds 0.15, and whose value lies within one standard error of it.
struct Count {
  unsigned interval = 0, one_error = 0;
};
Count count(const FitOptions& options, double size_A, double size_T) {
  Count found;
  for (unsigned seed = 1; seed <= kSeeds; ++seed) {
    const FitResult fit = fit_model(noisy(seed, size_A, size_T), "c", options);
    // errors that are understated make a fit suspect, and one in a thousand is so by chance
    EXPECT_TRUE(fit.status == FitStatus::ok || fit.status == FitStatus::suspect) << seed << fit.message.text();
    const FittedParameter& lambda = fit.parameters[0];
    if (!lambda.interval || !lambda.stderr_) continue;
    found.interval += lambda.interval->low.value() <= 0.15 && 0.15 <= lambda.interval->high.value();
    found.one_error += std::abs(*lambda.value - 0.15) <= *lambda.stderr_;
  }
  return found;
}

/// Within four standard deviations of a binomial count.
void expect_share(unsigned count, double share) {
  const double expected = share * kSeeds;
  EXPECT_NEAR(count, expected, 4 * std::sqrt(expected * (1 - share)));
}

/// T exact: its error of 0 is raised to 1e-4 of the largest T, far below what A knows.
TEST(Coverage, OfCurveWithAnExactShear) {
  const Count found = count({.objective = Objective::curve, .sigma_A = *parse_quantity("1%")}, 0.01, 0);
  expect_share(found.interval, 0.95);
  expect_share(found.one_error, 0.683);
}

TEST(Coverage, OfCurveAtAnotherConfidence) {
  const Count found =
      count({.objective = Objective::curve, .sigma_A = *parse_quantity("1%"), .confidence = 0.6}, 0.01, 0);
  expect_share(found.interval, 0.6);
}

TEST(Coverage, OfCurveWithKnownErrorsOfBoth) {
  const Count found =
      count({.objective = Objective::curve, .sigma_T = *parse_quantity("1%"), .sigma_A = *parse_quantity("0.5%")},
            0.005, 0.01);
  expect_share(found.interval, 0.95);
  expect_share(found.one_error, 0.683);
}

/// Errors from the scatter: only their proportions matter, and the F distribution of thirty points.
TEST(Coverage, OfCurveWithErrorsFromTheScatter) {
  const Count found = count({.objective = Objective::curve}, 0.005, 0.005);
  expect_share(found.interval, 0.95);
  expect_share(found.one_error, 0.683);
}

/// Weighted, the toughness objective counts each point's error through f and psi at once.
TEST(Coverage, OfWeightedToughness) {
  const Count found = count({.objective = Objective::toughness,
                             .weighted = true,
                             .sigma_T = *parse_quantity("1%"),
                             .sigma_A = *parse_quantity("0.5%")},
                            0.005, 0.01);
  expect_share(found.interval, 0.95);
  expect_share(found.one_error, 0.683);
}

/// Errors stated half as large as they are: the interval is half as wide, and holds the truth too rarely.
TEST(Coverage, OfErrorsThatAreUnderstatedIsTooLow) {
  const Count found = count(
      {.objective = Objective::curve, .sigma_T = *parse_quantity("0%"), .sigma_A = *parse_quantity("0.5%")}, 0.01, 0);
  expect_share(found.interval, 0.673);  // within 0.98 standard errors of a Gaussian
}

}  // namespace coverage_test
}  // namespace mixity
