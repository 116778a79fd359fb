// What robust losses do to a fit of the model.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fitting/consistency.h"
#include "fitting/fit.h"
#include "fitting/measured_runs.h"

namespace mixity {
namespace robust_fit_test {

Dataset scattered(unsigned seed) {
  SeededNoise noise(seed, 0.01);
  return synthetic_runs("c", {0.15}, {0.5, 5, 20}, 30, 0.85, noise);
}

FitOptions curve_with(Loss loss, std::optional<double> scale = {}) {
  return {.objective = Objective::curve,
          .sigma_T = *parse_quantity("0.1%"),
          .sigma_A = *parse_quantity("1%"),
          .loss = loss,
          .loss_scale = scale,
          .intervals = false};
}

TEST(RobustFit, OfALargeScaleIsNoLossAtAll) {
  const Dataset data = scattered(1);
  const FitResult plain = fit_model(data, "c", curve_with(Loss::none));
  ASSERT_EQ(plain.status, FitStatus::ok);
  const double huber = *fit_model(data, "c", curve_with(Loss::huber, 1e6)).parameters[0].value;
  EXPECT_NEAR(huber, *plain.parameters[0].value, 1e-12);  // the same residuals to the bit
  const double cauchy = *fit_model(data, "c", curve_with(Loss::cauchy, 1e6)).parameters[0].value;
  EXPECT_NEAR(cauchy, *plain.parameters[0].value, 1e-9);  // r^2/s^2 = 1e-11 is left
}

TEST(RobustFit, OutliersMoveAFitLessThanLeastSquares) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Dataset clean = scattered(seed);
    Dataset spoilt = clean;
    for (std::size_t i = 0; i < 10; ++i) {
      const Point& p = clean.points[9 * i + 4];
      spoilt.points[9 * i + 4] = {p.line, p.curve, p.P, p.T, 1.3 * p.A};
    }
    const auto moved = [&](Loss loss) {
      return std::abs(*fit_model(spoilt, "c", curve_with(loss)).parameters[0].value -
                      *fit_model(clean, "c", curve_with(loss)).parameters[0].value);
    };
    // Ten of ninety points are off by thirty standard errors; Huber's influence is cut at 1.345, Cauchy's falls to 0.2.
    const double plain = moved(Loss::none), huber = moved(Loss::huber), cauchy = moved(Loss::cauchy);
    EXPECT_LT(huber, 0.2 * plain) << seed;
    EXPECT_LT(cauchy, 0.5 * huber) << seed;
  }
}

/// Every twentieth area is off by twenty standard errors. The interval that follows from Student's likelihood holds the
/// truth about as often as it says; without outliers there are more degrees of freedom.
TEST(RobustFit, StudentsLikelihoodGivesOutliersTheirShare) {
  constexpr unsigned kSeeds = 60;
  unsigned covered = 0;
  for (unsigned seed = 1; seed <= kSeeds; ++seed) {
    Dataset data = scattered(seed);
    for (std::size_t i = seed % 20; i < data.points.size(); i += 20) data.points[i].A *= i % 40 < 20 ? 1.2 : 0.8;
    FitOptions options{.objective = Objective::curve, .loss = Loss::t};
    const FitResult fit = fit_model(data, "c", options);
    ASSERT_TRUE(fit.parameters[0].interval) << seed << fit.message.text();
    EXPECT_LT(fit.loss_freedom, 4) << seed;
    covered += *fit.parameters[0].interval->low <= 0.15 && 0.15 <= *fit.parameters[0].interval->high;
  }
  // 57 expected; four standard deviations of a binomial count are 6.8
  EXPECT_GE(covered, 50u);
  const FitResult clean = fit_model(scattered(1), "c", {.objective = Objective::curve, .loss = Loss::t});
  EXPECT_GT(clean.loss_freedom, 5);
}

/// Scale and degrees of freedom cost what they are uncertain by: taken as known, the intervals of so
/// few Gaussian errors were narrower by a tenth, and 90 % of them held the truth.
TEST(RobustFit, OfFewPointsStudentsIntervalsAreAsWideAsThoseOfLeastSquares) {
  double sum = 0;
  constexpr unsigned kSeeds = 30;
  for (unsigned seed = 1; seed <= kSeeds; ++seed) {
    SeededNoise noise(seed, 0.01);
    const Dataset data = synthetic_runs("c", {0.15}, {0.5, 5, 20}, 7, 0.85, noise);
    const auto width = [&](Loss loss) {
      const FitResult fit = fit_model(data, "c", {.objective = Objective::curve, .loss = loss, .checks = false});
      EXPECT_TRUE(fit.parameters[0].interval) << seed << fit.message.text();
      return fit.parameters[0].interval ? *fit.parameters[0].interval->high - *fit.parameters[0].interval->low : 0;
    };
    sum += std::log(width(Loss::t) / width(Loss::none));
  }
  EXPECT_NEAR(std::exp(sum / kSeeds), 1.03, 0.05);  // one degree of freedom of twenty is 0.03; errors differ, too
}

TEST(RobustFit, StudentsLikelihoodIsRefusedForFewPointsWithAnotherLoss) {
  SeededNoise noise(1, 0.01);
  const Dataset data = synthetic_runs("c", {0.15}, {0.5, 20}, 8, 0.85, noise);
  const FitResult fit = fit_model(data, "c", {.objective = Objective::curve, .loss = Loss::t});
  EXPECT_EQ(fit.status, FitStatus::not_identifiable);
  EXPECT_EQ(fit.message.text(), "the loss t needs 20 different points, here are 16: loss = \"huber\"");
  EXPECT_EQ(fit_model(data, "c", {.objective = Objective::curve, .loss = Loss::huber}).status, FitStatus::ok);
}

TEST(RobustFit, OfExactDataStudentsLikelihoodIsThatOfLeastSquares) {
  const Dataset data = synthetic_runs("c", {0.15}, {0.5, 5, 20}, 10, 0.85);
  for (const Objective objective : {Objective::curve, Objective::toughness}) {
    const FitResult fit = fit_model(data, "c", {.objective = objective, .loss = Loss::t});
    EXPECT_EQ(fit.status, FitStatus::ok) << fit.message.text();
    EXPECT_NEAR(*fit.parameters[0].value, 0.15, 1e-9);  // the curve is found to 1e-10
    EXPECT_EQ(fit.loss_scale, 0);
  }
}

/// By brute force: the square root of the mean square of residuals that count no more than points where the loss bends.
/// Their unknown size is that of ln f, some 0.1, and has nothing to do with the cost of the likelihood.
TEST(RobustFit, UnitOfStudentsResidualsIsThatOfATypicalPoint) {
  std::mt19937_64 random(7);
  for (const double freedom : {2.0, 4.0, 30.0}) {
    std::student_t_distribution<double> student(freedom);
    Dataset data = synthetic_runs("c", {0.15}, {0.5, 5, 20}, 100, 0.85);
    for (Point& point : data.points) point.A *= std::exp(0.005 * student(random));
    const FitResult fit = fit_model(data, "c", {.objective = Objective::toughness, .loss = Loss::t});
    ASSERT_GT(fit.loss_freedom, 0) << fit.message.text();
    double squares = 0;
    for (const double r : fit.residuals) squares += std::pow(std::min(std::abs(r), fit.loss_scale), 2);
    const double size = std::sqrt(squares / static_cast<double>(fit.residuals.size()));
    // sqrt(E min(t^2, freedom)) is 0.97 to 1.10 for 2 to 30 degrees of freedom; of 300 points its error is 0.04
    EXPECT_NEAR(size / residual_unit(fit), 1.05, 0.15) << freedom;
  }
}

/// Three times too small for all points is no matter of outliers, a tenth of the points at twenty standard errors is.
TEST(RobustFit, StatedErrorsThatAreTooSmallAreSuspectAndOutliersAreNot) {
  for (const Loss loss : {Loss::huber, Loss::cauchy, Loss::t}) {
    FitOptions options{.objective = Objective::curve, .loss = loss, .intervals = false};
    options.sigma_T = parse_quantity("0.1%");
    options.sigma_A = parse_quantity("0.33%");
    const FitResult small = fit_model(scattered(2), "c", options);
    EXPECT_EQ(small.status, FitStatus::suspect) << to_string(loss);
    EXPECT_NE(small.message.text().find("larger than the stated errors"), std::string::npos) << small.message.text();
    EXPECT_NEAR(std::sqrt(*small.consistency->chi2_per_freedom), 3, 0.9);  // the median of 90 points is known to 12 %
    options.sigma_A = parse_quantity("1%");
    Dataset spoilt = scattered(2);
    for (std::size_t i = 3; i < spoilt.points.size(); i += 10) spoilt.points[i].A *= i % 20 < 10 ? 1.2 : 0.8;
    const FitResult outliers = fit_model(spoilt, "c", options);
    EXPECT_EQ(outliers.status, FitStatus::ok) << to_string(loss) << outliers.message.text();
  }
}

/// No cause is searched beside a robust loss: the score test says what is wrong, where it would be right, and on which
/// side. Here the load cell reads too much.
TEST(RobustFit, AConstantThatLooksWrongHasAValue) {
  Dataset data = measured_runs(5);
  for (Point& point : data.points) point.P += 1;
  for (double& load : data.curve_loads) load += 1;
  const FitResult fit = fit_model(data, "c", {.objective = Objective::curve, .loss = Loss::huber, .intervals = false});
  EXPECT_EQ(fit.status, FitStatus::suspect);
  EXPECT_TRUE(fit.message.text().starts_with("load_offset looks wrong: near -")) << fit.message.text();
}

/// Errors of unknown size: the loss bends at so many of the residuals' own spread.
TEST(RobustFit, ScaleFollowsTheSpreadWhereErrorsAreNotKnown) {
  const Dataset data = scattered(3);
  const FitOptions options{.objective = Objective::toughness, .loss = Loss::huber, .intervals = false};
  const FitResult fit = fit_model(data, "c", options);
  ASSERT_EQ(fit.status, FitStatus::ok);
  // ln f scatters by more than A does; its median and RMS agree to some ten percent for Gaussian noise without tails
  EXPECT_NEAR(fit.loss_scale / 1.345, *fit.rmse, 0.5 * *fit.rmse);
  EXPECT_EQ(fit_model(data, "c", curve_with(Loss::huber)).loss_scale, 1.345);
}

}  // namespace robust_fit_test
}  // namespace mixity
