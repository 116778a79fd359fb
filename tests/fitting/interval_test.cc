#include "fitting/interval.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "fitting/fit.h"
#include "fitting/prepared_fit.h"
#include "fitting/synthetic_runs.h"

namespace mixity {
namespace {

double sum_of_squares(const std::vector<double>& r) {
  double sum = 0;
  for (const double x : r) sum += x * x;
  return sum;
}

/// intercept + slope t, in any range and number of the solver's.
class Line final : public LeastSquares {
 public:
  Line(std::vector<double> data, std::vector<FreeParameter> parameters)
      : data_(std::move(data)), parameters_(std::move(parameters)) {}
  std::size_t residual_count() const override { return data_.size(); }
  const std::vector<FreeParameter>& parameters() const override { return parameters_; }
  bool evaluate(std::span<const double> x, std::span<double> r, std::span<double> J) const override {
    for (std::size_t i = 0; i < data_.size(); ++i) {
      const double t = static_cast<double>(i);
      r[i] = x[0] + x[1] * t - data_[i];
      if (J.empty()) continue;
      J[2 * i] = 1;
      J[2 * i + 1] = t;
    }
    return true;
  }
  double data_norm() const override { return std::sqrt(sum_of_squares(data_)); }

 private:
  std::vector<double> data_;
  std::vector<FreeParameter> parameters_;
};

const std::vector<double> kLine{1.1, 1.4, 2.2, 2.4, 3.1, 3.4, 4.2};

/// Textbook regression of a straight line: estimates, standard errors and the t interval.
struct Regression {
  double value[2], error[2], squares = 0, quantile;
  explicit Regression(const std::vector<double>& data, double confidence = 0.95) {
    const auto n = static_cast<double>(data.size());
    double mean_t = (n - 1) / 2, mean = 0, tt = 0, ty = 0;
    for (const double y : data) mean += y / n;
    for (std::size_t i = 0; i < data.size(); ++i) {
      const double t = static_cast<double>(i) - mean_t;
      tt += t * t;
      ty += t * data[i];
    }
    value[1] = ty / tt;
    value[0] = mean - value[1] * mean_t;
    for (std::size_t i = 0; i < data.size(); ++i)
      squares += std::pow(value[0] + value[1] * static_cast<double>(i) - data[i], 2);
    const double s = std::sqrt(squares / (n - 2));
    error[1] = s / std::sqrt(tt);
    error[0] = s * std::sqrt(1 / n + mean_t * mean_t / tt);
    quantile = boost::math::quantile(boost::math::students_t(n - 2), 0.5 + 0.5 * confidence);
  }
};

TEST(Profile, OfALinearProblemIsTheTInterval) {
  const Line line(kLine, {{"intercept", -10, 10}, {"slope", -10, 10}});
  const Verdict verdict = minimise(line);
  ASSERT_EQ(verdict.status, FitStatus::ok) << verdict.message;
  for (const double confidence : {0.5, 0.95, 0.999}) {
    const Regression known(kLine, confidence);
    const double allowance = cost_allowance(confidence, verdict.best.sum_of_squares, kLine.size(), 2, false);
    for (std::size_t k = 0; k < 2; ++k) {
      const Interval interval = profile_interval(line, verdict.best, k, confidence, allowance, verdict.stderrs[k]);
      const double half = known.quantile * known.error[k];
      EXPECT_EQ(interval.low_status, EndStatus::found);
      EXPECT_EQ(interval.high_status, EndStatus::found);
      // The ends are good to 1e-10 of their distance, and to eps S/S' where the cost is flat in its rounding.
      EXPECT_NEAR(interval.low, known.value[k] - half, 1e-9 * half);
      EXPECT_NEAR(interval.high, known.value[k] + half, 1e-9 * half);
      EXPECT_EQ(interval.confidence, confidence);
    }
  }
}

TEST(Profile, AllowanceIsChiSquareOfKnownErrorsAndFOfUnknownOnes) {
  EXPECT_NEAR(cost_allowance(0.95, 17, 40, 2, true), 3.841458820694124, 1e-13);
  EXPECT_NEAR(cost_allowance(0.6826894921370859, 17, 40, 2, true), 1, 1e-13);
  // t(0.975, 10) = 2.22813885198627...; F(1, m) = t(m)^2
  EXPECT_NEAR(cost_allowance(0.95, 5, 12, 2, false), 5.0 / 10 * std::pow(2.2281388519862744, 2), 1e-13);
}

TEST(Profile, StopsAtABoundThatTheDataDoNotExclude) {
  const Regression known(kLine);
  const double half = known.quantile * known.error[1];
  // the slope's range ends between estimate and upper end; that of the intercept does not matter
  const double upper = known.value[1] + 0.5 * half;
  const Line line(kLine, {{"intercept", -10, 10}, {"slope", -10, upper}});
  const Verdict verdict = minimise(line);
  ASSERT_EQ(verdict.status, FitStatus::ok) << verdict.message;
  const double allowance = cost_allowance(0.95, verdict.best.sum_of_squares, kLine.size(), 2, false);
  const Interval interval = profile_interval(line, verdict.best, 1, 0.95, allowance, verdict.stderrs[1]);
  EXPECT_EQ(interval.high_status, EndStatus::at_bound);
  EXPECT_EQ(interval.high, upper);
  EXPECT_EQ(interval.low_status, EndStatus::found);
  EXPECT_NEAR(interval.low, known.value[1] - half, 1e-9 * half);
}

/// A minimum at its bound has an interval to one side, without a standard error to begin with.
TEST(Profile, FromABoundGoesOneWay) {
  const Regression known(kLine);
  const Line line(kLine, {{"intercept", -10, 10}, {"slope", -10, known.value[1] - known.error[1]}});
  const Verdict verdict = minimise(line);
  ASSERT_EQ(verdict.status, FitStatus::at_bound);
  const Interval interval = profile_interval(line, verdict.best, 1, 0.95, 1, {});
  EXPECT_EQ(interval.high_status, EndStatus::at_bound);
  EXPECT_EQ(interval.low_status, EndStatus::found);
  // cost above the free minimum S: ((b - x)/error)^2 S/(n - 2); from one error to where it has grown by the allowance 1
  const double variance = known.squares / static_cast<double>(kLine.size() - 2);
  const double low = known.value[1] - known.error[1] * std::sqrt(1 + 1 / variance);
  EXPECT_NEAR(interval.low, low, 1e-9 * known.error[1]);
}

/// A constant of the experiment has a wide but arbitrary range: reaching its end says nothing.
TEST(Profile, IsOpenWhereOnlyTheSearchEnds) {
  const Regression known(kLine);
  const double upper = known.value[1] + 0.5 * known.error[1];
  const Line line(kLine, {{"intercept", -10, 10}, {"slope", -10, upper, 0.4}});
  const Verdict verdict = minimise(line);
  ASSERT_EQ(verdict.status, FitStatus::ok) << verdict.message;
  const double allowance = cost_allowance(0.95, verdict.best.sum_of_squares, kLine.size(), 2, false);
  const Interval interval = profile_interval(line, verdict.best, 1, 0.95, allowance, verdict.stderrs[1]);
  EXPECT_EQ(interval.high_status, EndStatus::open);
  EXPECT_EQ(interval.low_status, EndStatus::found);
}

std::vector<double> residuals_at(const LeastSquares& problem, const std::vector<double>& x) {
  std::vector<double> residuals(problem.residual_count());
  EXPECT_TRUE(problem.evaluate(x, residuals, {}));
  return residuals;
}

/// Whatever the objective: at both ends the cost is the minimum plus the allowance.
TEST(Profile, EndsWhereTheCostHasRisenByTheAllowance) {
  SeededNoise noise(5, 0.01);
  const Dataset data = synthetic_runs<WatersGuduru>({0.3}, {0.5, 5, 20}, 15, 0.8, noise);
  for (const Objective objective : {Objective::toughness, Objective::area, Objective::curve})
    for (const bool known : {false, true}) {
      FitOptions options{.objective = objective};
      if (known) options.sigma_A = options.sigma_T = *parse_quantity("1%");
      const FitResult fit = fit_model(data, "b", options);
      ASSERT_EQ(fit.status, FitStatus::ok) << fit.message;
      ASSERT_TRUE(fit.parameters[0].interval);
      const ShownInterval& interval = *fit.parameters[0].interval;
      const auto problem = make_problem<WatersGuduru>(data, options, prepare<WatersGuduru>(data, options, nullptr));
      const double minimum = sum_of_squares(residuals_at(*problem, {*fit.parameters[0].value}));
      const bool size_known = known && objective != Objective::toughness;
      const double limit = minimum + cost_allowance(0.95, minimum, data.points.size(), 1, size_known);
      for (const auto& end : {interval.low, interval.high})
        // 1e-10 of the distance, times the slope of the cost
        EXPECT_NEAR(sum_of_squares(residuals_at(*problem, {end.value()})), limit, 1e-8 * limit)
            << to_string(objective) << known;
      EXPECT_LT(*interval.low, *fit.parameters[0].value);
      EXPECT_GT(*interval.high, *fit.parameters[0].value);
    }
}

/// Two parameters: the other is free on the way. Brute force minimises over it by golden section.
TEST(Profile, OfATwoParameterLawMinimisesOverTheOther) {
  SeededNoise noise(9, 0.004);
  const Parameters<BenzeggaghKenane> p{1.774, 2.284};
  const Dataset data = synthetic_runs<BenzeggaghKenane>(p, {0.5, 5, 20}, 20, 0.9, noise);
  const FitOptions options;
  const FitResult fit = fit_model(data, "bk", options);
  ASSERT_EQ(fit.status, FitStatus::ok) << fit.message;
  const auto problem = make_problem<BenzeggaghKenane>(data, options, prepare<BenzeggaghKenane>(data, options, nullptr));
  const double r = *fit.parameters[0].value, eta = *fit.parameters[1].value;
  const double minimum = sum_of_squares(residuals_at(*problem, {r, eta}));
  const double limit = minimum + cost_allowance(0.95, minimum, data.points.size(), 2, false);
  for (std::size_t k = 0; k < 2; ++k) {
    ASSERT_TRUE(fit.parameters[k].interval);
    const auto& interval = *fit.parameters[k].interval;
    for (const auto& end : {interval.low, interval.high}) {
      ASSERT_TRUE(end);
      const auto cost = [&](double other) {
        return sum_of_squares(residuals_at(*problem, k == 0 ? std::vector{*end, other} : std::vector{other, *end}));
      };
      double low = k == 0 ? 0.5 * eta : 1 + 0.3 * (r - 1), high = k == 0 ? 2 * eta : 1 + 3 * (r - 1);
      const double golden = 0.5 * (std::sqrt(5.0) - 1);
      for (int i = 0; i < 80; ++i) {
        const double one = high - golden * (high - low), other = low + golden * (high - low);
        (cost(one) < cost(other) ? high : low) = cost(one) < cost(other) ? other : one;
      }
      EXPECT_NEAR(cost(0.5 * (low + high)), limit, 1e-8 * limit) << k;  // as above
    }
  }
}

/// Toughness is fitted as a logarithm and shown as itself: its interval is that of the logarithm, taken back.
TEST(Profile, OfALogarithmIsShownAsTheNumberItself) {
  SeededNoise noise(11, 0.005);
  Dataset data = synthetic_runs<PapangeloCiavarella>({0.2}, {0.5, 5, 20}, 15, 0.8, noise);
  const FitOptions options{.objective = Objective::area, .free = {kToughness}, .sigma_A = *parse_quantity("0.5%")};
  const FitResult plain = fit_model(data, "c", options);
  data.contact = Contact{0.01, 2e6, 0.03};
  const FitResult fit =
      fit_model(data, "c", {.objective = Objective::area, .free = {kToughness}, .sigma_A = *parse_quantity("0.5%")});
  ASSERT_EQ(fit.status, FitStatus::ok) << fit.message;
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
  const Dataset data = synthetic_runs<PapangeloCiavarella>({0.2}, {5}, 10, 0.8, SeededNoise(1, 0.01));
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
  for (const std::vector<Correction>& free : {std::vector<Correction>{}, std::vector<Correction>{kToughness}}) {
    FitOptions options;
    options.free = free;
    options.profile_points = 8;
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

}  // namespace
}  // namespace mixity
