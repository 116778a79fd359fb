// Standard errors and correlations, against those of a line in closed form; and what has none is named.
#include "solver/covariance.h"

#include <gtest/gtest.h>

#include "solver/descent.h"
#include "solver/line.h"

namespace mixity {
namespace covariance_test {

constexpr double kRounding = 1e-14;  // of a triangle of condition 5

Covariance at_origin(const Problem& problem, const std::vector<bool>& at_bound = {}) {
  const std::size_t p = problem.parameters().size();
  return covariance(problem, {std::vector<double>(p), 1, 0, true}, at_bound.empty() ? std::vector<bool>(p) : at_bound);
}

TEST(Covariance, OfALineIsTheTextbooks) {
  for (const bool known : {true, false}) {
    const auto problem = Line::problem(unbounded("level", 0), unbounded("slope", 0), known);
    const Minimum best = descend(problem, {0, 0}).value();
    const Covariance found = covariance(problem, best, {false, false});
    const double determinant = Line::kN * Line::kSumTT - Line::kSumT * Line::kSumT;
    const double scatter = known ? 1 : std::sqrt(best.sum_of_squares / 5);
    EXPECT_NEAR(found.standard_errors[0].value(), scatter * std::sqrt(Line::kSumTT / determinant), kRounding);
    EXPECT_NEAR(found.standard_errors[1].value(), scatter * std::sqrt(Line::kN / determinant), kRounding);
    ASSERT_EQ(found.correlations.size(), 4);
    EXPECT_NEAR(found.correlations[0], 1, kRounding);
    EXPECT_NEAR(found.correlations[1], -Line::kSumT / std::sqrt(Line::kN * Line::kSumTT), kRounding);
    EXPECT_EQ(found.correlations[1], found.correlations[2]);
    EXPECT_EQ(found.unconstrained, "");
  }
}

TEST(Covariance, LeavesOutWhatIsAtABound) {
  const Covariance found = at_origin(Line::problem(unbounded("level", 0), unbounded("slope", 0)), {true, false});
  EXPECT_FALSE(found.standard_errors[0]);
  EXPECT_NEAR(found.standard_errors[1].value(), 1 / std::sqrt(Line::kSumTT), kRounding);
  EXPECT_TRUE(found.correlations.empty());
}

/// Whatever the units of the parameters: columns of 1e-200 and 1e150 are as independent as those of the line.
TEST(Covariance, DoesNotDependOnUnits) {
  const auto plain = at_origin(Line::problem(unbounded("level", 0), unbounded("slope", 0)));
  const auto scaled = at_origin(
      problem_of<2>(7, {unbounded("level", 0), unbounded("slope", 0)}, {7, true}, [](const auto* b, std::size_t i) {
        return 1e-100 * b[0] + 1e100 * b[1] * static_cast<double>(i) - Line::kY[i];
      }));
  EXPECT_LE(relative_error(scaled.standard_errors[0].value(), 1e100 * plain.standard_errors[0].value()), kRounding);
  EXPECT_LE(relative_error(scaled.standard_errors[1].value(), 1e-100 * plain.standard_errors[1].value()), kRounding);
}

TEST(Covariance, NamesWhatIsNotConstrained) {
  const std::vector<FreeParameter> parameters{unbounded("a", 0), unbounded("b", 0), unbounded("c", 0)};
  const auto unfelt = at_origin(problem_of<3>(7, parameters, {7, true}, [](const auto* b, std::size_t i) {
    return b[0] + b[1] * static_cast<double>(i) - 1.0;
  }));
  EXPECT_EQ(unfelt.unconstrained, "c");
  EXPECT_FALSE(unfelt.standard_errors[0]);
  const auto sum = at_origin(problem_of<3>(7, parameters, {7, true}, [](const auto* b, std::size_t i) {
    return b[0] * static_cast<double>(i) + b[1] - 3.0 * b[2];
  }));
  EXPECT_EQ(sum.unconstrained, "b and c independently");
  const auto few =
      at_origin(problem_of<3>(2, parameters, {7, true}, [](const auto* b, std::size_t i) { return b[i] + b[2]; }));
  EXPECT_NE(few.unconstrained, "");
}

/// A wide range is none that says more: a parameter known to 0.27 of it only (1/sqrt 7 of 1.4) is not known.
TEST(Covariance, NamesWhatIsNotKnownToAPartOfItsWideRange) {
  const auto of_width = [](double width) {
    return at_origin(problem_of<1>(7, {{"level", -width / 2, width / 2, 0.0}}, {7, true},
                                   [](const auto* b, std::size_t i) { return b[0] - Line::kY[i]; }));
  };
  EXPECT_EQ(of_width(1.4).unconstrained, "level");
  EXPECT_EQ(of_width(1.6).unconstrained, "");
}

TEST(Covariance, HasNoErrorsWithoutScatter) {
  const auto exact = at_origin(problem_of<2>(2, {unbounded("a", 0), unbounded("b", 0)}, {1, false},
                                             [](const auto* b, std::size_t i) { return b[i] - 1.0; }));
  EXPECT_FALSE(exact.standard_errors[0]);
  EXPECT_EQ(exact.unconstrained, "");
}

}  // namespace covariance_test
}  // namespace mixity
