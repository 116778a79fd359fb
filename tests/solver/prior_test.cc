// Priors are residuals: of a line, normal equations with 1/error^2 on their diagonal.
#include "solver/prior.h"

#include <gtest/gtest.h>

#include "solver/interval.h"
#include "solver/line.h"
#include "solver/solve.h"

namespace mixity {
namespace prior_test {

/// (X'X + P) b = X'y + P mean, of level and slope.
struct Posterior {
  double level, slope, level_error, slope_error;
  Posterior(double level_weight, double level_mean, double slope_weight, double slope_mean) {
    const double a = Line::kN + level_weight, b = Line::kSumT, d = Line::kSumTT + slope_weight;
    const double u = Line::kSumY + level_weight * level_mean, v = Line::kSumTY + slope_weight * slope_mean;
    const double determinant = a * d - b * b;
    level = (d * u - b * v) / determinant;
    slope = (a * v - b * u) / determinant;
    level_error = std::sqrt(d / determinant);
    slope_error = std::sqrt(a / determinant);
  }
};

constexpr double kRounding = 1e-12;  // of a linear problem with a condition of 5

/// A parameter about `mean`, with that standard error; 0: nothing is known of it.
FreeParameter known(const char* name, double mean, double error) {
  FreeParameter parameter = unbounded(name, mean);
  parameter.prior = error;
  return parameter;
}

TEST(Prior, OnALineGivesThePosteriorInClosedForm) {
  struct Case {
    FreeParameter level, slope;
    Posterior expected;
  };
  for (const Case& each : {Case{known("level", 0, 0), known("slope", 0, 0), {0, 0, 0, 0}},
                           Case{known("level", 0, 0), known("slope", 0.3, 0.1), {0, 0, 100, 0.3}},
                           Case{known("level", 2, 0.5), known("slope", 0, 0), {4, 2, 0, 0}},
                           Case{known("level", 2, 0.5), known("slope", 0.3, 0.1), {4, 2, 100, 0.3}},
                           Case{known("level", 0, 0), known("slope", 0.3, 1e-4), {0, 0, 1e8, 0.3}}}) {
    const auto line = Line::problem(each.level, each.slope);
    const ProblemWithPriors problem(line);
    for (const Engine engine : {Engine::ceres, Engine::kernel}) {
      const Verdict verdict = solve(problem, {.near = {0, 0}}, {.engine = engine});
      ASSERT_EQ(verdict.status, FitStatus::ok) << verdict.message;
      EXPECT_NEAR(verdict.best.x[0], each.expected.level, kRounding);
      EXPECT_NEAR(verdict.best.x[1], each.expected.slope, kRounding);
      EXPECT_NEAR(verdict.standard_errors[0].value(), each.expected.level_error, kRounding);
      EXPECT_NEAR(verdict.standard_errors[1].value(), each.expected.slope_error, kRounding);
      const Interval interval = profile_intervals(problem, verdict.best, 0.95, 3.84, verdict.standard_errors)[0];
      EXPECT_NEAR(interval.high - verdict.best.x[0], each.expected.level_error * std::sqrt(3.84), 1e-9);  // an end's
    }
  }
}

/// Residuals in a unit of 10 standard errors' worth: the priors weigh a hundred times as much beside them.
TEST(Prior, StandsBesideResidualsInTheirOwnUnit) {
  const auto line = Line::problem(unbounded("level", 0), known("slope", 0.3, 0.1));
  const ProblemWithPriors problem(line, 10);
  const Verdict verdict = solve(problem, {.near = {0, 0}});
  const Posterior expected(0, 0, 1e4, 0.3);
  EXPECT_NEAR(verdict.best.x[1], expected.slope, kRounding);
  EXPECT_NEAR(verdict.standard_errors[1].value(), 10 * expected.slope_error, kRounding);
}

TEST(Prior, MakesKnownWhatTheDataDoNotConstrain) {
  const auto residual = [](const auto* b, std::size_t i) { return b[0] + b[1] - static_cast<double>(i); };
  const auto unknown = problem_of<2>(3, {unbounded("a", 0), unbounded("b", 0)}, {1, true}, residual);
  EXPECT_EQ(solve(unknown, {.near = {0, 0}}).status, FitStatus::not_identifiable);
  const auto sum = problem_of<2>(3, {known("a", 0.25, 2), unbounded("b", 0)}, {1, true}, residual);
  const ProblemWithPriors problem(sum);
  const Verdict verdict = solve(problem, {.near = {0, 0}});
  ASSERT_EQ(verdict.status, FitStatus::ok) << verdict.message;
  EXPECT_NEAR(verdict.best.x[0], 0.25, kRounding);
  EXPECT_NEAR(verdict.best.x[1], 0.75, kRounding);
  EXPECT_NEAR(verdict.standard_errors[0].value(), 2, kRounding);
  EXPECT_NEAR(verdict.standard_errors[1].value(), std::sqrt(4 + 1.0 / 3), kRounding);
}

}  // namespace prior_test
}  // namespace mixity
