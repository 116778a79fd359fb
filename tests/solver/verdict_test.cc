// Each of the solver's findings, by a problem of a line or two.
#include "solver/verdict.h"

#include <gtest/gtest.h>

#include "solver/jet_problem.h"
#include "solver/solve.h"

namespace mixity {
namespace verdict_test {

using std::cos, std::exp, std::sqrt;

std::string text(const Verdict& verdict) { return std::string(to_string(verdict.status)) + ": " + verdict.message; }

class Findings : public ::testing::TestWithParam<Engine> {
 protected:
  Verdict judge(const Problem& problem, const StartingPoints& starting = {}) {
    return solve(problem, starting, {.engine = GetParam()});
  }
};

double sign(std::size_t i) { return i % 2 ? 1 : -1; }

TEST_P(Findings, TooFewPoints) {
  const auto problem = problem_of<2>(2, {unbounded("a", 0), unbounded("b", 0)}, {},
                                     [](const auto* b, std::size_t i) { return b[i] - 1.0; });
  EXPECT_EQ(text(judge(problem, {.near = {0, 0}})),
            "not_identifiable: 2 usable points cannot determine 2 parameters and their errors");
}

TEST_P(Findings, NowhereFinite) {
  const auto problem = problem_of<1>(3, {{"x", 0, 1}}, {}, [](const auto* b, std::size_t) { return sqrt(b[0] - 2.0); });
  EXPECT_EQ(text(judge(problem)), "not_converged: the model is not finite at these points for any parameter value");
}

TEST_P(Findings, EveryValueFits) {
  const auto problem = problem_of<1>(
      4, {{"x", 0, 1}}, {}, [](const auto* b, std::size_t i) { return 0.1 * b[0] * static_cast<double>(i) + sign(i); });
  EXPECT_EQ(text(judge(problem)),
            "not_identifiable: the data do not constrain x: no value in the range fits better than another");
}

TEST_P(Findings, NothingFound) {
  const auto problem = problem_of<1>(3, {unbounded("x", -1)}, {},
                                     [](const auto* b, std::size_t i) { return sqrt(b[0]) - static_cast<double>(i); });
  EXPECT_EQ(text(judge(problem, {.near = {-1}})), "not_converged: no start led to a minimum");
}

TEST_P(Findings, Unconstrained) {
  const auto problem = problem_of<2>(4, {unbounded("a", 1), unbounded("b", 1)}, {},
                                     [](const auto* b, std::size_t i) { return b[0] * b[1] - static_cast<double>(i); });
  EXPECT_EQ(text(judge(problem, {.near = {1, 1}})),
            "not_identifiable: the data do not constrain a and b independently");
}

/// The cost falls for ever towards large b: in a range that is only wide, that is no value.
TEST_P(Findings, AValleyWithoutEndIsNotOk) {
  const auto problem =
      problem_of<2>(4, {unbounded("a", 1), {"b", -100, 100, 1.0}}, {}, [](const auto* b, std::size_t i) {
        return b[0] * exp(-b[1] * static_cast<double>(i)) - (i == 0 ? 1 : i == 2 ? -0.2 : 0);
      });
  EXPECT_EQ(text(judge(problem, {.near = {1, 1}})), "not_identifiable: the data do not constrain b");
}

/// NIST's BoxBOD from its far start: the rate runs to where nothing feels it, and ends well above the minimum.
TEST_P(Findings, AFlatPlaceFarFromTheMinimumIsNotOk) {
  const std::vector<double> x{1, 2, 3, 5, 7, 10}, y{109, 149, 149, 191, 213, 224};
  const auto problem =
      problem_of<2>(6, {unbounded("b1", 1), unbounded("b2", 1)}, {norm(y)},
                    [&](const auto* b, std::size_t i) { return b[0] * (1.0 - exp(-b[1] * x[i])) - y[i]; });
  const Verdict verdict = judge(problem, {.near = {1, 1}});
  EXPECT_TRUE(verdict.status == FitStatus::not_converged || verdict.status == FitStatus::not_identifiable);
  EXPECT_FALSE(verdict.standard_errors[0]);
}

/// The cost falls up to where the model ends.
TEST_P(Findings, StoppedAtTheEndOfItsDefinition) {
  const auto problem = problem_of<1>(2, {{"x", 0, 2}}, {1, true}, [](const auto* b, std::size_t i) {
    using T = std::decay_t<decltype(*b)>;
    return i == 0 ? T(sqrt(1.0 - b[0]) + 1.0) : T(3.0 - b[0]);
  });
  const Verdict verdict = judge(problem);
  EXPECT_TRUE(verdict.status == FitStatus::at_bound || verdict.status == FitStatus::not_converged) << text(verdict);
  EXPECT_FALSE(verdict.standard_errors[0]);
}

/// A kink: the gradient jumps from -2 to 2 and is zero nowhere.
TEST_P(Findings, AKinkIsNoStationaryPointOfTwoParameters) {
  const auto problem = problem_of<2>(3, {unbounded("x", 0.3), unbounded("y", 0)}, {}, [](const auto* b, std::size_t i) {
    using std::abs;
    using T = std::decay_t<decltype(*b)>;
    return i == 0 ? T(1.0 + abs(b[0] - 0.1234)) : i == 1 ? T(b[1] - 1.0) : T(b[1] + 1.0);
  });
  EXPECT_EQ(judge(problem, {.near = {0.3, 0}}).status, FitStatus::not_converged);
}

TEST_P(Findings, AtABound) {
  const auto problem = problem_of<1>(4, {{"x", 0, 1}}, {1, true},
                                     [](const auto* b, std::size_t i) { return b[0] + 2.0 + 0.1 * sign(i); });
  const Verdict verdict = judge(problem);
  EXPECT_EQ(text(verdict), "at_bound: x is at its lower bound 0");
  EXPECT_EQ(verdict.at_bound, std::vector<bool>{true});
  EXPECT_FALSE(verdict.standard_errors[0]);
}

/// cos x is stationary at 0, where it is farthest from the data.
TEST_P(Findings, APeakAtABoundBySymmetryIsNone) {
  const auto problem = problem_of<1>(4, {{"x", 0, 2}}, {},
                                     [](const auto* b, std::size_t i) { return cos(b[0]) - 0.5 + 0.01 * sign(i); });
  const Verdict verdict = judge(problem);
  ASSERT_EQ(verdict.status, FitStatus::ok) << text(verdict);
  EXPECT_NEAR(verdict.best.x[0], std::acos(0.5), 1e-12);
  EXPECT_TRUE(verdict.others.empty());
  // of two parameters, from a start on the bound and one beside it
  const auto two = problem_of<2>(4, {{"x", 0, 2}, unbounded("y", 0)}, {}, [](const auto* b, std::size_t i) {
    return cos(b[0]) - 0.5 + (b[1] + 0.01) * sign(i) + (i == 3 ? 0.02 : 0.0);
  });
  const Verdict judged = judge(two, {.near = {0, 0}, .guesses = {{0.5, 0}}});
  ASSERT_EQ(judged.status, FitStatus::ok) << text(judged);
  EXPECT_TRUE(judged.others.empty());
}

TEST_P(Findings, AnotherMinimumFitsAsWell) {
  const auto problem = problem_of<1>(4, {{"x", -2, 2}}, {}, [](const auto* b, std::size_t i) {
    return b[0] * b[0] - 1.0 + 0.01 * b[0] + 0.1 * sign(i);
  });
  const Verdict verdict = judge(problem);
  EXPECT_EQ(verdict.status, FitStatus::multimodal) << text(verdict);
  ASSERT_EQ(verdict.others.size(), 1);
  EXPECT_NEAR(verdict.best.x[0] + verdict.others[0].x[0], -0.01, 1e-10);  // the roots of x^2 + 0.01 x - 1
  EXPECT_NE(verdict.message.find("within the scatter: x = "), std::string::npos);
}

/// A constant that is known to be zero within 1 does not have two values because they are -1e-8 and 1e-8.
TEST_P(Findings, MinimaWithinAShareOfAStatedErrorAreOne) {
  for (const double prior : {0.0, 1.0}) {
    FreeParameter y = unbounded("y", 0);
    y.prior = prior;
    const auto problem = problem_of<2>(8, {{"x", 0, 2}, y}, {}, [](const auto* b, std::size_t i) {
      const auto shared = 1e16 * b[1] * b[1] - 1.0;
      return i % 4 < 2 ? b[0] - 1.0 + 0.1 * sign(i) : shared + 0.1 * sign(i);
    });
    const Verdict verdict = judge(problem, {.near = {1, 1e-8}, .guesses = {{1, -1e-8}}});
    EXPECT_EQ(verdict.status, prior > 0 ? FitStatus::ok : FitStatus::multimodal) << text(verdict);
    EXPECT_NEAR(std::abs(verdict.best.x[1]), 1e-8, 1e-12);
  }
}

TEST_P(Findings, AWorseMinimumIsOnlyNamed) {
  const auto problem = problem_of<1>(4, {{"x", -2, 2}}, {}, [](const auto* b, std::size_t i) {
    return b[0] * b[0] - 1.0 + 0.2 * b[0] * static_cast<double>(i) + 0.001 * sign(i) - 0.2 * static_cast<double>(i);
  });
  const Verdict verdict = judge(problem);
  ASSERT_EQ(verdict.status, FitStatus::ok) << text(verdict);
  EXPECT_NEAR(verdict.best.x[0], 1, 0.01);
  EXPECT_EQ(verdict.others.size(), 1);
}

/// The start is at the best of two basins, but the descent from a guess in the other finds less.
TEST_P(Findings, AGuessFindsTheLowerBasin) {
  const auto problem = problem_of<1>(4, {unbounded("x", 1)}, {}, [](const auto* b, std::size_t i) {
    return b[0] * b[0] - 1.0 + 0.2 * (b[0] + 1.0) * static_cast<double>(i) + 0.001 * sign(i);
  });
  const Verdict verdict = judge(problem, {.near = {1}, .guesses = {{-1.5}}});
  ASSERT_EQ(verdict.status, FitStatus::ok) << text(verdict);
  EXPECT_NEAR(verdict.best.x[0], -1, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Engines, Findings, ::testing::Values(Engine::ceres, Engine::kernel),
                         [](const auto& of) { return of.param == Engine::ceres ? "Ceres" : "Kernel"; });

TEST(FitTolerance, IsChiSquareOfOneParameterInUnitsOfTheErrors) {
  for (const bool known : {true, false}) {
    const auto problem =
        problem_of<1>(5, {unbounded("x", 0)}, {1, known}, [](const auto* b, std::size_t) { return b[0]; });
    EXPECT_DOUBLE_EQ(fit_tolerance(problem, 8), 3.841458820694124 * (known ? 1 : 2));
  }
}

}  // namespace verdict_test
}  // namespace mixity
