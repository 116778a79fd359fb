// What a status claims, on data made to deserve it: known errors, rounded files, and losses with narrow basins.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "dataset/load_text.h"
#include "fitting/fit.h"
#include "fitting/prepare.h"
#include "fitting/synthetic_runs.h"
#include "solver/kernel.h"
#include "solver/robust.h"

namespace mixity {
namespace status_test {

FitOptions with(Objective objective, const char* sigma_A) {
  return {.objective = objective, .sigma_T = *parse_quantity("0.01%"), .sigma_A = *parse_quantity(sigma_A)};
}

/// Points that scatter far less than their stated errors say nothing that the errors do not allow.
TEST(KnownErrors, LargerThanTheSignalLeaveNothingToIdentify) {
  SeededNoise noise(1, 1e-5);
  const Dataset data = synthetic_runs("c", {0.15}, {0.5, 5, 20}, 12, 0.3, noise);
  EXPECT_EQ(fit_model(data, "c", with(Objective::curve, "0.1%")).status, FitStatus::ok);
  EXPECT_EQ(fit_model(data, "c", with(Objective::curve, "500%")).status, FitStatus::not_identifiable);
}

/// The same for toughness with a sigma_Gc column, which needs no loads.
TEST(KnownErrors, OfAToughnessFileAreTakenAtTheirWord) {
  const auto file = [](const char* sigma) {
    std::string text = "psi [deg],Gc_over_GIc,sigma_Gc\n";
    for (const char* point : {"0,1", "20,1.11", "40,1.5", "60,2.63", "75,4.8"})
      text += std::string(point) + ',' + sigma + '\n';
    return load_text(text);
  };
  const FitResult fit = fit_model(file("0.05"), "c", {.weighted = true});
  ASSERT_EQ(fit.status, FitStatus::ok) << fit.message.text();
  EXPECT_TRUE(fit.known_errors);
  // The curvature of chi^2 is 1/stderr^2: errors twice as large double it exactly, whatever the scatter.
  const FitResult twice = fit_model(file("0.1"), "c", {.weighted = true});
  EXPECT_NEAR(*twice.parameters[0].stderr_ / *fit.parameters[0].stderr_, 2, 1e-9);
  EXPECT_EQ(fit_model(file("50"), "c", {.weighted = true}).status, FitStatus::not_identifiable);
}

/// Rows that repeat each other are one observation: their scatter of 0 is no standard error.
TEST(RepeatedRows, AreOnePoint) {
  for (const std::size_t different : {1u, 2u, 3u}) {
    Dataset data = synthetic_runs("c", {0.15}, {0.5}, 4, 0.9);
    data.points.erase(data.points.begin());  // T = 0, which says nothing of lambda
    data.points.resize(different);
    for (std::size_t i = 0; i < 6; ++i) data.points.push_back(data.points[i % different]);
    for (const Objective objective : {Objective::toughness, Objective::curve})
      for (const char* model : {"c", "bk"}) {
        const FitResult fit = fit_model(data, model, {.objective = objective});
        const bool enough = different > (model == std::string_view("c") ? 1 : 2);
        EXPECT_EQ(fit.status != FitStatus::not_identifiable, enough) << to_string(objective) << model << different;
        if (!enough) {
          EXPECT_NE(fit.message.text().find("repeated in " + std::to_string(different + 6) + " rows"),
                    std::string::npos)
              << fit.message.text();
        }
      }
  }
}

/// A number as a file of so many digits holds it.
double rounded_to(double x, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*e", digits - 1, x);
  return std::strtod(text, nullptr);
}

/// Residuals that are nothing but the rounding of the file are no reason to call a fit unfinished.
TEST(RoundedData, ConvergeWhateverTheirDigits) {
  for (const int digits : {3, 6, 9, 12, 15})
    for (const double lambda : {0.01, 0.15, 0.4, 0.8})
      for (const Objective objective : {Objective::toughness, Objective::curve}) {
        Dataset data = synthetic_runs("c", {lambda}, {0.5, 5, 20}, 12, 0.9);
        for (Point& p : data.points) p = {p.line, p.curve, p.P, rounded_to(p.T, digits), rounded_to(p.A, digits)};
        FitOptions options{.objective = objective};
        const FitResult fit = fit_model(data, "c", options);
        const std::string where =
            std::string(to_string(objective)) + ' ' + std::to_string(lambda) + ' ' + std::to_string(digits);
        EXPECT_EQ(fit.status, FitStatus::ok) << where << ' ' << fit.message.text();
        // the relative rounding, times the 1/(dlnA/dlnlambda) of runs to 0.9 of the fold
        EXPECT_NEAR(*fit.parameters[0].value / lambda, 1, 100 * std::pow(10.0, -digits)) << where;
      }
}

/// T^2 is the largest double: at lambda = 0 the slope of the cost is infinite, and no step outwards can be told from
/// none.
TEST(ExtremeShear, EndsAnIntervalOpenAndNotNever) {
  Dataset data = synthetic_runs("c", {0.15}, {1, 5}, 6, 0.5);
  for (Point& p : data.points) p = {p.line, p.curve, p.P, 1e150, p.A};
  const FitResult fit = fit_model(data, "c", with(Objective::curve, "1%"));
  EXPECT_NE(fit.status, FitStatus::ok);
  ASSERT_EQ(fit.parameters.size(), 1u);
  if (fit.parameters[0].interval) {
    EXPECT_NE(fit.parameters[0].interval->high_status, EndStatus::found);
  }
}

double cost_at(const Problem& problem, double x) {
  std::vector<double> residuals(problem.residual_count());
  return sum_of_squares(problem, {&x, 1}, residuals).value_or(HUGE_VAL);
}

/// Outliers give Cauchy's cost basins far narrower than the range: no value in it may cost less than what was found.
void expect_global_under_cauchy(const std::string& model, unsigned seed) {
  SeededNoise noise(seed, 0.01);
  Dataset data = synthetic_runs("b", {0.3}, {0.5, 5, 20}, 20, 0.9, noise);
  for (std::size_t i = seed % 5; i < data.points.size(); i += 6) {
    const Point& p = data.points[i];
    data.points[i] = {p.line, p.curve, p.P, p.T, p.A * (1.1 + 0.05 * static_cast<double>(i % 7))};
  }
  const FitOptions options{.objective = Objective::curve,
                           .sigma_T = *parse_quantity("1%"),
                           .sigma_A = *parse_quantity("1%"),
                           .fitted_errors = false,
                           .loss = Loss::cauchy,
                           .intervals = false};
  const FitResult fit = fit_model(data, model, options);
  ASSERT_TRUE(fit.parameters[0].value) << fit.message.text();
  const auto problem =
      make_problem(data, options, prepare(data, model_named(model), options, *options.objective, nullptr));
  const RobustProblem robust(*problem, Loss::cauchy, fit.loss_scale);
  for (int i = 1; i < 4000; ++i) {
    const double even = i / 4000.0;
    for (const double x : {even * robust.parameters()[0].upper, std::pow(10.0, -6 * even)})
      // a fit is stationary to 1e-8 of its residuals
      ASSERT_GE(cost_at(robust, x), fit.sum_of_squares * (1 - 1e-8)) << model << " seed " << seed << " " << x;
  }
}

TEST(RobustLoss, FindsTheLowestOfItsBasins) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    expect_global_under_cauchy("a", seed);
    expect_global_under_cauchy("c", seed);
  }
}

/// Without known errors, too, where the outliers leave plain least squares nothing to determine.
TEST(RobustLoss, FindsWhatOutliersHideFromLeastSquares) {
  SeededNoise noise(2, 3e-4);
  Dataset data = synthetic_runs("c", {0.3}, {0.5, 5}, 8, 0.3, noise);
  for (const std::size_t i : {2u, 9u, 13u}) {
    const Point& p = data.points[i];
    data.points[i] = {p.line, p.curve, p.P, p.T, 1.6 * p.A};
  }
  const auto fit_with = [&](Loss loss) {
    return fit_model(data, "c", {.objective = Objective::curve, .loss = loss, .intervals = false});
  };
  EXPECT_EQ(fit_with(Loss::none).status, FitStatus::not_identifiable);
  const FitResult robust = fit_with(Loss::cauchy);
  ASSERT_EQ(robust.status, FitStatus::ok) << robust.message.text();
  // three standard errors of the thirteen good points
  EXPECT_NEAR(*robust.parameters[0].value, 0.3, 3 * *robust.parameters[0].stderr_);
  EXPECT_LT(*robust.parameters[0].stderr_, 0.05);
}

/// Model b's cost is stationary at lambda = 2 by symmetry, and mostly highest there.
TEST(Symmetry, OfModelBAtItsUpperBoundIsNoMinimum) {
  for (const double lambda : {1.5, 1.9, 1.94, 1.97, 1.99, 1.998})
    for (const double size : {1e-9, 1e-6, 1e-4}) {
      SeededNoise noise(4, size * (2 - lambda));
      const Dataset data = synthetic_runs("b", {lambda}, {0.5, 5}, 10, 0.9, noise);
      for (const Objective objective : {Objective::toughness, Objective::curve}) {
        const FitResult fit = fit_model(data, "b", {.objective = objective});
        const std::string where =
            std::string(to_string(objective)) + ' ' + std::to_string(lambda) + ' ' + std::to_string(size);
        ASSERT_TRUE(fit.parameters[0].value) << where << ' ' << fit.message.text();
        EXPECT_EQ(fit.status, FitStatus::ok) << where << ' ' << fit.message.text();
        // ln f depends on (2 - lambda)^2, so that an error e of A is one of about e/(2 - lambda) in lambda
        EXPECT_NEAR(*fit.parameters[0].value, lambda, 100 * size + 1e-9) << where;
      }
    }
}

/// Areas below Hertz lie nearest to the curve's end, which moves with lambda.
void expect_least_distance_below_hertz(const std::string& model) {
  SeededNoise noise(6, 0.02);
  Dataset data = synthetic_runs(model, {0.15}, {100}, 10, 0.98, noise);
  for (const std::size_t i : {8u, 9u}) {
    Point& p = data.points[i];
    p.A = (0.97 + 0.01 * static_cast<double>(i - 8)) * area_from_radius(hertz_radius(p.P));
    p.T *= i == 9 ? 1.1 : 1;
  }
  const FitOptions options{.objective = Objective::curve,
                           .sigma_T = *parse_quantity("2%"),
                           .sigma_A = *parse_quantity("2%"),
                           .fitted_errors = false};
  const FitResult fit = fit_model(data, model, options);
  // the points below Hertz do not agree with the rest, and that is said
  ASSERT_EQ(fit.status, FitStatus::suspect) << model << ' ' << fit.message.text();
  const auto problem =
      make_problem(data, options, prepare(data, model_named(model), options, *options.objective, nullptr));
  for (int i = 1; i < 400; ++i)
    EXPECT_GE(cost_at(*problem, i / 400.0 * problem->parameters()[0].upper), fit.sum_of_squares * (1 - 1e-9))
        << model << ' ' << i;
  const auto cost = problem->cost();
  CostValue value;
  const double x = *fit.parameters[0].value;
  for (const double at : {0.9 * x, 0.98 * x, 1.1 * x}) {
    const double h = 1e-6 * x;  // errors h^2 and eps/h
    const double slope = (cost_at(*problem, at + h) - cost_at(*problem, at - h)) / (2 * h);
    cost->at({&at, 1}, {}, value);
    EXPECT_NEAR(2 * value.gradient[0], slope, 1e-5 * std::abs(slope) + 1e-4) << model << ' ' << at;
  }
}

TEST(AreasBelowHertz, AreFittedByTheirDistanceFromTheCurvesEnd) {
  expect_least_distance_below_hertz("b");
  expect_least_distance_below_hertz("c");
}

/// Weighted toughness on the linear scale: each weight is 1/standard error of f_model - f, here by differences of the
/// printed quantities in A and T.
TEST(Weighted, LinearScaleWeighsTheDifferenceItself) {
  SeededNoise noise(5, 0.02);
  const Dataset data = synthetic_runs("c", {0.3}, {0.5, 5}, 12, 0.9, noise);
  const double s_T = 0.01, s_A = 0.02;
  const FitResult fit = fit_model(data, "c",
                                  {.objective = Objective::toughness,
                                   .scale = Scale::linear,
                                   .weighted = true,
                                   .sigma_T = *parse_quantity("1%"),
                                   .sigma_A = *parse_quantity("2%"),
                                   .intervals = false});
  ASSERT_EQ(fit.status, FitStatus::ok) << fit.message.text();
  const double lambda = *fit.parameters[0].value;
  const auto difference = [](double l, double P, double T, double A) {
    const auto measured = toughness_of_area(P, T, A);
    return std::exp(log_f(model_named("c"), {l}, measured->mixity)) - measured->ratio;
  };
  double slope = 0, size = 0;
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    const Point& p = data.points[i];
    const double h = 1e-6;  // of each value: errors h^2 and eps/h
    const double by_A =
        (difference(lambda, p.P, p.T, p.A * (1 + h)) - difference(lambda, p.P, p.T, p.A * (1 - h))) / (2 * h);
    const double by_T =
        (difference(lambda, p.P, p.T * (1 + h), p.A) - difference(lambda, p.P, p.T * (1 - h), p.A)) / (2 * h);
    const double error = std::hypot(by_A * s_A, by_T * s_T);
    EXPECT_NEAR(fit.residuals[i], difference(lambda, p.P, p.T, p.A) / error, 1e-7 * std::abs(fit.residuals[i]) + 1e-9)
        << i;
    const double by_lambda =
        (difference(lambda + h, p.P, p.T, p.A) - difference(lambda - h, p.P, p.T, p.A)) / (2 * h) / error;
    slope += fit.residuals[i] * by_lambda;
    size += by_lambda * by_lambda;
  }
  EXPECT_LT(std::abs(slope), 1e-6 * std::sqrt(size * fit.sum_of_squares));
}

/// As of errors of 0.01 that stand in a column of another unit than their areas.
TEST(Status, OfAValueWhoseErrorExceedsItsRangeIsNotOk) {
  SeededNoise noise(4, 0.001);
  const Dataset data = synthetic_runs("c", {0.15}, {1, 4}, 12, 0.8, [&] { return noise(); });
  FitOptions options;
  options.sigma_A = parse_quantity("1000000%");
  options.sigma_T = parse_quantity("0%");
  const FitResult fit = fit_model(data, "c", options);
  EXPECT_EQ(fit.status, FitStatus::suspect);
  EXPECT_NE(fit.message.text().find("exceeds its whole range"), std::string::npos) << fit.message.text();
}

}  // namespace status_test
}  // namespace mixity
