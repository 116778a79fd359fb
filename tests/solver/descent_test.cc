// The first-order condition at one point.
#include "solver/descent.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "solver/jet_problem.h"
#include "solver/linear_algebra.h"

namespace mixity {
namespace descent_test {

TEST(Descent, OfManyRowsHasTheStepAndTheStationarityOfOneDecomposition) {
  constexpr std::size_t kRows = 70000;  // more than two parts of 32,768 rows, the last of them short
  // Columns that differ by a hundredth, so that the step is not theirs taken singly.
  const auto problem = problem_of<2>(kRows, {unbounded("a", 0), unbounded("b", 0)}, {}, [](const auto* x, auto i) {
    const double t = static_cast<double>(i);
    return x[0] * std::cos(t) + x[1] * (std::cos(t) + 0.01 * std::sin(3 * t)) - std::sin(0.7 * t) - 0.1 * std::cos(t);
  });
  Linearised at;
  ASSERT_TRUE(linearise(problem, Eigen::Vector2d(0.2, -0.3), {}, at));
  const Eigen::Vector2d size = at.J.colwise().norm();
  const Projection whole = project(at.J * size.cwiseInverse().asDiagonal(), at.r, SolverOptions().independent);
  // A rounding of each row, times the hundred by which the columns' likeness enlarges it.
  const double rounding = 100 * std::sqrt(double{kRows}) * std::numeric_limits<double>::epsilon();
  EXPECT_NEAR(at.stationarity, whole.along.norm() / at.r.norm(), rounding);
  for (Eigen::Index k = 0; k < 2; ++k) {
    const double step = -whole.solution[k] / size[k];
    EXPECT_NEAR(at.step[k], step, rounding * std::abs(step)) << k;
  }
}

}  // namespace descent_test
}  // namespace mixity
