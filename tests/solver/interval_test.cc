// Profile intervals, against closed forms and against bisection on costs whose other parameter is eliminated by hand.
#include "solver/interval.h"

#include <gtest/gtest.h>

#include "solver/covariance.h"
#include "solver/descent.h"
#include "solver/jet_problem.h"

namespace mixity {
namespace interval_test {

using std::exp;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const std::vector<double> kTime{0, 1, 2, 3, 4, 5, 6}, kLine{1.1, 1.4, 2.2, 2.4, 3.1, 3.4, 4.2};

/// level + slope t, of errors 1
auto line(FreeParameter level, FreeParameter slope) {
  return problem_of<2>(7, {std::move(level), std::move(slope)}, {norm(kLine), true},
                       [](const auto* b, std::size_t i) { return b[0] + b[1] * kTime[i] - kLine[i]; });
}

struct Fitted {
  Minimum best;
  std::vector<std::optional<double>> errors;
};

Fitted fitted(const Problem& problem, const std::vector<double>& start) {
  const Minimum best = descend(problem, start).value();
  return {best, covariance(problem, best, std::vector<bool>(start.size())).standard_errors};
}

Interval interval(const Problem& problem, const Fitted& fit, std::size_t k, double allowance) {
  return profile_intervals(problem, fit.best, 0.95, allowance, fit.errors)[k];
}

TEST(CostAllowance, IsAQuantile) {
  // chi^2(1) and F(1, 8) at 95 %, to the digits printed
  EXPECT_NEAR(cost_allowance(0.95, 123, 10, 2, true), 3.841458820694124, 1e-14);
  EXPECT_NEAR(cost_allowance(0.95, 16, 10, 2, false), 2 * 5.317655071578714, 1e-13);
}

TEST(ProfileInterval, OfAParabolaIsThatOfTheStandardError) {
  const auto problem = line(unbounded("level", 0), unbounded("slope", 0));
  const Fitted fit = fitted(problem, {0, 0});
  // the textbook's: var slope = 1/28, var level = 1/7 + 9/28
  const double errors[] = {std::sqrt(13.0 / 28), std::sqrt(1.0 / 28)};
  for (const std::size_t k : {0, 1})
    for (const double allowance : {0.01, 1.0, 3.84, 1e4}) {
      const Interval found = interval(problem, fit, k, allowance);
      // Newton's steps are exact here, of a cost with 1e-16 of rounding, whose root is taken: 1e-16/0.01
      const double half = errors[k] * std::sqrt(allowance);
      EXPECT_NEAR(found.low, fit.best.x[k] - half, 1e-12 * half) << k << " " << allowance;
      EXPECT_NEAR(found.high, fit.best.x[k] + half, 1e-12 * half) << k << " " << allowance;
    }
}

TEST(ProfileInterval, StopsAtABoundAndIsOpenWhereAWideRangeEnds) {
  const double slope = 14.2 / 28;  // sum (t - 3) y / sum (t - 3)^2
  for (const bool wide : {false, true}) {
    const std::optional<double> start = wide ? std::optional(0.5) : std::nullopt;
    const auto problem = line(unbounded("level", 0), {"slope", slope - 0.1, slope + 10, start});
    const Interval found = interval(problem, fitted(problem, {0, slope}), 1, 1);
    EXPECT_EQ(found.low_status, wide ? EndStatus::open : EndStatus::at_bound);
    EXPECT_EQ(found.low, slope - 0.1);
    EXPECT_EQ(found.high_status, EndStatus::found);
  }
}

/// The others are held by bounds of theirs on the way: the profile is a parabola with a bend, then another.
TEST(ProfileInterval, FromABoundBeginsNearItsEnd) {
  // The slope would be negative: at 0 it has no standard error, and the cost rises with it from there at once.
  int evaluations = 0;
  const auto problem = problem_of<2>(7, {unbounded("level", 0), {"slope", 0, 1e6}}, {norm(kLine), true},
                                     [&](const auto* b, std::size_t i) {
                                       evaluations += i == 0;
                                       return b[0] + b[1] * kTime[i] + kLine[i];
                                     });
  Fitted fit = fitted(problem, {0, 1});
  EXPECT_EQ(fit.best.x[1], 0);
  const auto evaluations_of = [&] {
    evaluations = 0;
    profile_intervals(problem, fit.best, 0.95, 1, fit.errors);
    return evaluations;
  };
  fit.errors[1] = 0.035;  // where the end is
  const int of_error = evaluations_of();
  fit.errors[1].reset();
  EXPECT_LE(evaluations_of(), of_error);
  const Interval found = interval(problem, fit, 1, 1);
  // without the other parameter: 28 s^2 + 28.4 s = 1
  const double end = 2 / (28.4 + std::sqrt(28.4 * 28.4 + 4 * 28));
  EXPECT_NEAR(found.high, end, 1e-9 * end);
  EXPECT_EQ(found.low_status, EndStatus::at_bound);
}

TEST(ProfileInterval, PassesWhereAnotherParameterReachesItsBound) {
  const auto problem = line({"level", 0.9, 1.1}, unbounded("slope", 0));
  const Fitted fit = fitted(problem, {1, 0});
  const double inner = fit.best.x[1];
  const Interval found = interval(problem, fit, 1, 1);
  // beyond the bend the level stays at a bound: S(slope) is a parabola with sum t^2 = 91
  const auto end = [&](double level, double direction) {
    double linear = 0, constant = 0;
    for (std::size_t i = 0; i < 7; ++i) {
      linear += kTime[i] * (kLine[i] - level);
      constant += (kLine[i] - level) * (kLine[i] - level);
    }
    const double level_rise = fit.best.sum_of_squares + 1 - constant + linear * linear / 91;
    return linear / 91 + direction * std::sqrt(level_rise / 91);
  };
  ASSERT_LT(std::abs(inner - 0.5), 0.1);
  EXPECT_NEAR(found.low, end(1.1, -1), 1e-10);  // ends are to 1e-9 of a distance of 0.1
  EXPECT_NEAR(found.high, end(0.9, 1), 1e-10);
}

/// amplitude exp(-rate t): the best amplitude of a rate in closed form, the rest by bisection.
TEST(ProfileInterval, AgreesWithBisectionOnAnEliminatedCost) {
  const std::vector<double> y{3.2, 2.1, 1.2, 0.9, 0.35, 0.4, 0.1};
  const auto problem = problem_of<2>(7, {{"rate", 0, kInfinity}, unbounded("amplitude", 1)}, {norm(y)},
                                     [&](const auto* b, std::size_t i) { return b[1] * exp(-b[0] * kTime[i]) - y[i]; });
  const Fitted fit = fitted(problem, {0.3, 2});
  const auto eliminated = [&](double rate) {
    double yy = 0, ye = 0, ee = 0;
    for (std::size_t i = 0; i < 7; ++i) {
      const double e = std::exp(-rate * kTime[i]);
      yy += y[i] * y[i];
      ye += y[i] * e;
      ee += e * e;
    }
    return yy - ye * ye / ee;
  };
  for (const double confidence : {0.5, 0.95, 0.999}) {
    const double allowance = cost_allowance(confidence, fit.best.sum_of_squares, 7, 2, false);
    const auto bisect = [&](double inside, double outside) {
      for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (inside + outside);
        (eliminated(middle) < fit.best.sum_of_squares + allowance ? inside : outside) = middle;
      }
      return inside;
    };
    const Interval found = interval(problem, fit, 0, allowance);
    EXPECT_EQ(found.low_status, EndStatus::found);
    EXPECT_EQ(found.high_status, EndStatus::found);
    EXPECT_LE(relative_error(found.low, bisect(fit.best.x[0], 0)), 1e-9) << confidence;
    EXPECT_LE(relative_error(found.high, bisect(fit.best.x[0], 20)), 1e-9) << confidence;
  }
}

TEST(ProfileInterval, IsOpenWhereTheCostStopsBeingFiniteWithinTheAllowance) {
  const auto problem = problem_of<1>(3, {unbounded("x", 1)}, {1, true}, [](const auto* b, std::size_t i) {
    using std::sqrt;
    return sqrt(b[0]) - 0.5 * static_cast<double>(i);
  });
  const Fitted fit = fitted(problem, {1});
  const Interval found = interval(problem, fit, 0, 4);  // 3 (sqrt x - 0.5)^2 = 4: sqrt x = 0.5 + 2/sqrt 3
  EXPECT_EQ(found.low_status, EndStatus::open);
  EXPECT_EQ(found.high_status, EndStatus::found);
  EXPECT_NEAR(found.high, std::pow(0.5 + 2 / std::sqrt(3.0), 2), 1e-9);
}

/// (x^2 - 1)^2 + (x + 1)^2/4: from the higher minimum the search crosses to the lower.
TEST(ProfileInterval, TellsOfALowerCostThanAtTheMinimum) {
  const auto problem = problem_of<1>(2, {unbounded("x", 1)}, {1, true}, [](const auto* b, std::size_t i) {
    using T = std::decay_t<decltype(*b)>;
    return i == 0 ? T(b[0] * b[0] - 1.0) : T(0.5 * (b[0] + 1.0));
  });
  const Interval of_higher = interval(problem, fitted(problem, {1.1}), 0, 6);
  ASSERT_EQ(of_higher.deeper.size(), 1);
  EXPECT_LT(of_higher.deeper[0], 0);
  EXPECT_TRUE(interval(problem, fitted(problem, {-1.1}), 0, 6).deeper.empty());
}

TEST(DrawnProfile, OfAParabolaIsASquare) {
  const auto problem = line(unbounded("level", 0), unbounded("slope", 0));
  const Fitted fit = fitted(problem, {0, 0});
  const DrawnProfile drawn = draw_profile(problem, fit.best, 1, 0, 1, 20, 3.84, 1);
  EXPECT_EQ(drawn.points.size(), 21);
  EXPECT_EQ(drawn.level, 3.84);
  for (const auto& [x, rise] : drawn.points)
    EXPECT_NEAR(rise, 28 * std::pow(x - fit.best.x[1], 2), 1e-12);  // costs of up to 10
}

}  // namespace interval_test
}  // namespace mixity
