#include "fitting/fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/input_error.h"
#include "fitting/measured_runs.h"
#include "fitting/synthetic.h"

namespace mixity {
namespace fit_test {

class Recovery : public OfModel {};
INSTANTIATE_TEST_SUITE_P(OfLambda, Recovery, ::testing::Values("a", "b", "c"));

/// Noise-free data give lambda back to the digits that rounding of f leaves of it.
TEST_P(Recovery, ExactDataGiveLambdaBack) {
  for (const double lambda : {1e-6, 1e-4, 0.0023, 0.15, 0.5, 0.9}) {
    const FitResult fit = fit_model(synthetic(key(), {lambda}, angles_up_to(1.56, 40)), key());
    EXPECT_EQ(fit.status, FitStatus::ok) << fit.message.text();
    // f holds lambda to eps/(lambda d ln f/d lambda): at psi <= 1.56 a sees lambda = 1e-6 to 1e-10, the others better
    EXPECT_NEAR(*fit.parameters[0].value / lambda, 1, 1e-12 / lambda) << lambda;
    EXPECT_GT(*fit.r2, 1 - 1e-14);
  }
}

/// The zero of the gradient, found here by bisection of the sum's derivative, is where the fit ends.
TEST(Fit, EndsAtTheZeroOfTheGradientHoweverLargeTheResiduals) {
  for (const double noise : {0.01, 0.3, 1.0}) {
    const Dataset data =
        synthetic("c", {0.05}, angles_up_to(1.5, 60), [&](std::size_t i) { return noise * scatter(i); });
    const auto gradient = [&](double l) {
      double sum = 0;
      for (const ToughnessPoint& point : data.converted) {
        const double c2 = std::pow(std::cos(point.psi()), 2), s2 = std::pow(std::sin(point.psi()), 2);
        sum += (-std::log(c2 + l * s2) - std::log(point.ratio)) * -s2 / (c2 + l * s2);
      }
      return sum;
    };
    double low = 1e-6, high = 0.9;
    ASSERT_LT(gradient(low) * gradient(high), 0);
    for (int i = 0; i < 200; ++i) {
      const double middle = std::sqrt(low * high);
      (gradient(middle) * gradient(high) > 0 ? high : low) = middle;
    }
    const FitResult fit = fit_model(data, "c");
    ASSERT_EQ(fit.status, FitStatus::ok) << fit.message.text();
    // Rounding of sixty terms in the gradient moves its zero by about 1e-15 relative.
    EXPECT_NEAR(*fit.parameters[0].value / low, 1, 1e-12);
  }
}

TEST(Fit, SaysAtBoundWhenTheDataWantMoreThanTheRangeHolds) {
  // f of model c at lambda = 0 is 1/cos^2 psi; data above that want lambda < 0
  const Dataset data =
      synthetic("c", {0.0}, angles_up_to(1.4, 30), [](std::size_t i) { return 0.1 + 0.01 * scatter(i); });
  const FitResult fit = fit_model(data, "c");
  EXPECT_EQ(fit.status, FitStatus::at_bound);
  EXPECT_EQ(*fit.parameters[0].value, 0);
  EXPECT_TRUE(fit.parameters[0].at_bound);
  EXPECT_FALSE(fit.parameters[0].stderr_);
}

/// One angle next to pi/2 knows 1 - lambda to a part of 1e8 of its scatter: the least squares lie 18 roundings of
/// lambda below the bound 1, where f = 1 + (1 - lambda) tan^2 psi meets that point, as the others hardly feel lambda.
TEST(Fit, TellsAMinimumAFewRoundingsFromABoundFromTheBound) {
  std::vector<double> angles = angles_up_to(1.4, 7);
  angles.push_back(1.5707);
  const double excess = 2.2e-7, tan = std::tan(angles.back());
  const Dataset data = synthetic("a", {1}, angles, [&](std::size_t i) { return i < 7 ? 1e-6 * scatter(i) : excess; });
  const FitResult fit = fit_model(data, "a");
  ASSERT_EQ(fit.status, FitStatus::ok) << fit.message.text();
  // to three roundings of lambda; the others move it by less than one
  EXPECT_NEAR(1 - *fit.parameters[0].value, excess / (tan * tan), 3.4e-16);
}

TEST(Fit, SaysNotIdentifiableWithoutShear) {
  const Dataset data =
      synthetic("c", {0.3}, std::vector<double>(10, 0.0), [](std::size_t i) { return 0.01 * scatter(i); });
  for (const char* model : {"a", "b", "c", "bk"}) {
    const FitResult fit = fit_model(data, model);
    EXPECT_EQ(fit.status, FitStatus::not_identifiable) << model;
    for (const FittedParameter& parameter : fit.parameters) EXPECT_FALSE(parameter.value);
    EXPECT_FALSE(fit.r2);
    EXPECT_FALSE(fit.area);
  }
}

TEST(Fit, SaysNotIdentifiableForOnePointOrNone) {
  EXPECT_EQ(fit_model(synthetic("a", {0.3}, {1.0}), "a").status, FitStatus::not_identifiable);
  EXPECT_EQ(fit_model(synthetic("a", {0.3}, {}), "a").status, FitStatus::not_identifiable);
}

TEST(Fit, SaysNotIdentifiableWhenScatterDrownsTheSignal) {
  const Dataset data = synthetic("c", {0.3}, angles_up_to(0.05, 20), [](std::size_t i) { return 0.5 * scatter(i); });
  EXPECT_EQ(fit_model(data, "c").status, FitStatus::not_identifiable);
}

TEST(Fit, LeavesOutWhatAModelCannotDescribeAndSaysSo) {
  Dataset data = synthetic("c", {0.3}, {0.0, 0.4, 0.8, 1.2});
  data.points.push_back({6, 0, 0, 0, 0});
  data.converted.push_back({{0, 1}, 1 / 0.3});
  const FitResult a = fit_model(data, "a"), c = fit_model(data, "c");
  ASSERT_EQ(a.excluded.size(), 1u);
  EXPECT_EQ(a.excluded[0].line, 6u);
  EXPECT_EQ(a.used.size(), 4u);
  EXPECT_TRUE(c.excluded.empty());
  EXPECT_NEAR(*c.parameters[0].value, 0.3, 1e-13);  // exact data
}

/// Nothing is fitted, but the values are tested by the points as those of any fit.
TEST(Fit, TestsValuesThatAreAllHeld) {
  Dataset data = measured_runs(4);
  for (const Point& point : data.points) data.errors.push_back({0.01 * point.shear() + 1e-3, 0.01 * point.A, 0});
  const auto held_at = [&](double lambda) {
    return fit_model(data, "c", {.hold = {{"lambda", lambda}}, .fitted_errors = false});
  };
  const FitResult fit = fit_model(data, "c", {.fitted_errors = false}), at_the_fit = held_at(*fit.parameters[0].value),
                  off = held_at(0.9);
  ASSERT_TRUE(fit.consistency && at_the_fit.consistency && off.consistency);
  EXPECT_TRUE(at_the_fit.known_errors);
  EXPECT_EQ(at_the_fit.freedom(), fit.freedom() + 1);
  // the same residuals, at a lambda that is the minimum to 1e-8 of its standard error
  EXPECT_NEAR(at_the_fit.sum_of_squares, fit.sum_of_squares, 1e-9 * fit.sum_of_squares);
  EXPECT_EQ(off.status, FitStatus::suspect);
  EXPECT_GT(off.consistency->chi2_per_freedom.value(), 10);
}

TEST(Fit, HoldsWhatItIsToldToHold) {
  const Dataset data = synthetic("bk", {1.774, 2.284}, angles_up_to(1.5, 20));
  const FitResult fit = fit_model(data, "bk", {.scale = Scale::linear, .hold = {{"r", 1.774}}});
  EXPECT_EQ(fit.status, FitStatus::ok);
  EXPECT_TRUE(fit.parameters[0].held);
  EXPECT_EQ(*fit.parameters[0].value, 1.774);
  EXPECT_NEAR(*fit.parameters[1].value, 2.284, 1e-11);  // exact data; eps over the slope of f in eta
  EXPECT_THROW(fit_model(data, "bk", {.scale = Scale::linear, .hold = {{"r", {}}}}), InputError);
  EXPECT_THROW(fit_model(data, "bk", {.scale = Scale::linear, .hold = {{"r", 1e9}}}), InputError);
}

TEST(Fit, FindsBothParametersOfTheTwoParameterLaw) {
  const FitResult fit = fit_model(synthetic("bk", {2.5, 1.6}, angles_up_to(1.55, 30)), "bk");
  EXPECT_EQ(fit.status, FitStatus::ok) << fit.message.text();
  EXPECT_NEAR(*fit.parameters[0].value, 2.5, 1e-11);  // exact data; eps times a condition of about 1e3
  EXPECT_NEAR(*fit.parameters[1].value, 1.6, 1e-11);
}

}  // namespace fit_test
}  // namespace mixity
