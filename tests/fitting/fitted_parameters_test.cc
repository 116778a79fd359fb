// What a fit says of its parameters: intervals and profiles, whatever the objective and the unit.
#include "fitting/fitted_parameters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fitting/fit.h"
#include "fitting/prepare.h"
#include "fitting/synthetic_runs.h"
#include "solver/interval.h"

namespace mixity {
namespace fitted_parameters_test {

double cost_at(const Problem& problem, const std::vector<double>& x) {
  std::vector<double> residuals(problem.residual_count());
  return sum_of_squares(problem, x, residuals).value_or(HUGE_VAL);
}

/// Whatever the objective: at both ends the cost is the minimum plus the allowance.
TEST(Profile, EndsWhereTheCostHasRisenByTheAllowance) {
  SeededNoise noise(5, 0.01);
  const Dataset data = synthetic_runs("b", {0.3}, {0.5, 5, 20}, 15, 0.8, noise);
  for (const Objective objective : {Objective::toughness, Objective::curve})
    for (const bool known : {false, true}) {
      FitOptions options{.objective = objective, .fitted_errors = false};
      if (known) options.sigma_A = options.sigma_T = *parse_quantity("1%");
      const FitResult fit = fit_model(data, "b", options);
      ASSERT_EQ(fit.status, FitStatus::ok) << fit.message.text();
      ASSERT_TRUE(fit.parameters[0].interval);
      const ShownInterval& interval = *fit.parameters[0].interval;
      const auto problem =
          make_problem(data, options, prepare(data, model_named("b"), options, *options.objective, nullptr));
      const double minimum = cost_at(*problem, {*fit.parameters[0].value});
      const bool size_known = known && objective != Objective::toughness;
      const double limit = minimum + cost_allowance(0.95, minimum, data.points.size(), 1, size_known);
      for (const auto& end : {interval.low, interval.high})
        // 1e-10 of the distance, times the slope of the cost
        EXPECT_NEAR(cost_at(*problem, {end.value()}), limit, 1e-8 * limit) << to_string(objective) << known;
      EXPECT_LT(*interval.low, *fit.parameters[0].value);
      EXPECT_GT(*interval.high, *fit.parameters[0].value);
    }
}

/// Two parameters: the other is free on the way. Brute force minimises over it by golden section.
TEST(Profile, OfATwoParameterLawMinimisesOverTheOther) {
  SeededNoise noise(9, 0.004);
  const ParameterValues p{1.774, 2.284};
  const Dataset data = synthetic_runs("bk", p, {0.5, 5, 20}, 20, 0.9, noise);
  for (const Objective objective : {Objective::toughness, Objective::curve}) {
    const FitOptions options{.objective = objective, .fitted_errors = false, .checks = false};
    const FitResult fit = fit_model(data, "bk", options);
    ASSERT_EQ(fit.status, FitStatus::ok) << fit.message.text();
    const auto problem = make_problem(data, options, prepare(data, model_named("bk"), options, objective, nullptr));
    const double r = *fit.parameters[0].value, eta = *fit.parameters[1].value;
    const double minimum = cost_at(*problem, {r, eta});
    const double limit = minimum + cost_allowance(0.95, minimum, data.points.size(), 2, false);
    for (std::size_t k = 0; k < 2; ++k) {
      ASSERT_TRUE(fit.parameters[k].interval);
      const auto& interval = *fit.parameters[k].interval;
      for (const auto& end : {interval.low, interval.high}) {
        ASSERT_TRUE(end);
        const auto cost = [&](double other) {
          return cost_at(*problem, k == 0 ? std::vector{*end, other} : std::vector{other, *end});
        };
        double low = k == 0 ? 0.5 * eta : 1 + 0.3 * (r - 1), high = k == 0 ? 2 * eta : 1 + 3 * (r - 1);
        const double golden = 0.5 * (std::sqrt(5.0) - 1);
        for (int i = 0; i < 80; ++i) {
          const double one = high - golden * (high - low), other = low + golden * (high - low);
          (cost(one) < cost(other) ? high : low) = cost(one) < cost(other) ? other : one;
        }
        EXPECT_NEAR(cost(0.5 * (low + high)), limit, 1e-8 * limit) << to_string(objective) << k;  // as above
      }
    }
  }
}

/// Toughness is fitted as a logarithm and shown as itself: its interval is that of the logarithm, taken back.
TEST(Profile, OfALogarithmIsShownAsTheNumberItself) {
  SeededNoise noise(11, 0.005);
  Dataset data = synthetic_runs("c", {0.2}, {0.5, 5, 20}, 15, 0.8, noise);
  const FitOptions options{.objective = Objective::curve, .free = {kToughness}, .sigma_A = *parse_quantity("0.5%")};
  const FitResult plain = fit_model(data, "c", options);
  data.contact = Contact{0.01, 2e6, 0.03};
  const FitResult fit =
      fit_model(data, "c", {.objective = Objective::curve, .free = {kToughness}, .sigma_A = *parse_quantity("0.5%")});
  ASSERT_EQ(fit.status, FitStatus::ok) << fit.message.text();
  const FittedParameter &found = fit.parameters[1], &factor = plain.parameters[1];
  EXPECT_EQ(found.name, "toughness");
  EXPECT_EQ(found.unit, "J/m^2");
  EXPECT_EQ(factor.unit, "");
  // The same fit in other units; ends to 1e-10 of their distance.
  EXPECT_NEAR(*found.value, 0.03 * *factor.value, 1e-13);
  EXPECT_NEAR(*found.interval->low, 0.03 * *factor.interval->low, 1e-11);
  EXPECT_NEAR(*found.interval->high, 0.03 * *factor.interval->high, 1e-11);
  EXPECT_NEAR(*found.stderr_, 0.03 * *factor.stderr_, 1e-13);
  // In the solver's numbers both ends lie about 1.96 standard errors away; of a cost that is nearly a parabola.
  const double error = *found.stderr_ / *found.value;
  EXPECT_NEAR(std::log(*found.interval->high / *found.value) / error, 1.96, 0.1);
  EXPECT_NEAR(std::log(*found.value / *found.interval->low) / error, 1.96, 0.1);
}

TEST(Profile, IsLeftOutWhereItIsNotAskedForOrCannotBe) {
  const Dataset data = synthetic_runs("c", {0.2}, {5}, 10, 0.8, SeededNoise(1, 0.01));
  EXPECT_FALSE(fit_model(data, "c", {.intervals = false}).parameters[0].interval);
  const FitResult held = fit_model(data, "c", {.hold = {{"lambda", 0.2}}});
  EXPECT_FALSE(held.parameters[0].interval);
  const std::vector<std::size_t> one{3};
  EXPECT_FALSE(fit_model(data, "c", {}, &one).parameters[0].interval);
}

/// Sum of squares of a fit with lambda held; the other free parameters take their best values.
double cost_with_lambda(const Dataset& data, FitOptions options, double lambda) {
  options = value_only(options);
  options.hold = {{"lambda", lambda}};
  const FitResult fit = fit_model(data, "c", options);
  return static_cast<double>(fit.used.size()) * *fit.rmse * *fit.rmse;
}

TEST(DrawnProfile, IsTheCostOfFitsWithTheParameterHeld) {
  const Dataset data = load_dataset(MIXITY_ROOT "/data/mergel2018.csv");
  struct Case {
    Objective objective;
    std::vector<Constant> free;
  };
  for (const Case& one : {Case{Objective::toughness, {}}, Case{Objective::toughness, {kToughness}},
                          Case{Objective::curve, {}}, Case{Objective::curve, {kToughness}}}) {
    const FitOptions options{
        .objective = one.objective, .free = one.free, .fitted_errors = false, .checks = false, .profile_points = 8};
    const FitResult fit = fit_model(data, "c", options);
    const FittedParameter& lambda = fit.parameters[0];
    ASSERT_TRUE(lambda.profile);
    ASSERT_EQ(lambda.profile->points.size(), 9u);
    EXPECT_TRUE(std::is_sorted(lambda.profile->points.begin(), lambda.profile->points.end()));
    const double freedom = static_cast<double>(fit.used.size() - fit.free_parameters);
    const double least = static_cast<double>(fit.used.size()) * *fit.rmse * *fit.rmse;
    for (const auto& [value, rise] : lambda.profile->points)
      // the held fits' costs are known to 1e-10, of which the variance is a share of 1/freedom
      EXPECT_NEAR(rise, (cost_with_lambda(data, options, value) - least) / (least / freedom), 1e-6) << value;
    // four half-widths, so that the interval's ends are points: there the rise is the level
    EXPECT_NEAR(lambda.profile->points[2].first, *lambda.interval->low, 1e-8);
    EXPECT_NEAR(lambda.profile->points[2].second, lambda.profile->level, 1e-5 * lambda.profile->level);
  }
}

TEST(DrawnProfile, IsLeftOutUnlessAskedFor) {
  const Dataset data = load_dataset(MIXITY_ROOT "/data/mergel2018.csv");
  EXPECT_FALSE(fit_model(data, "c").parameters[0].profile);
}

}  // namespace fitted_parameters_test
}  // namespace mixity
