// The search of basins against brute force: no value of the range may cost less than the minimum that it leads to.
#include "solver/basins.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fitting/models.h"
#include "fitting/toughness_objective.h"
#include "solver/solve.h"

namespace mixity {
namespace basins_test {

const SolverOptions kWithKernel{.engine = Engine::kernel};

/// Points of which each follows one of two lambdas, up to the last digits before pi/2, with noise of any size.
ToughnessObjective mixture(const ContactModel& model, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform;
  std::normal_distribution<double> normal;
  const double upper = model.parameters()[0].upper, noise = std::pow(10, -4 * uniform(random));
  const double lambdas[] = {upper * std::pow(10, -6 * uniform(random)), upper * uniform(random)};
  std::vector<ToughnessPoint> points;
  for (int i = 0; i < 12; ++i) {
    const double close = std::pow(10, -7 * uniform(random));  // to pi/2
    const auto mixity = mixity_from_angle(i % 2 ? 0.5 * pi<double>() * uniform(random) : 0.5 * pi<double>() - close);
    const double lambda = lambdas[uniform(random) < 0.5];
    points.push_back({mixity, std::exp(log_f(model, {lambda}, mixity) + noise * normal(random))});
  }
  return ToughnessObjective(points, Scale::log, FreeChoice(model, {{0.15}, {}}, {}));
}

/// The same problem with the curvature of Gauss and Newton, which a grid is searched with.
class WithoutCurvature final : public WrappedProblem {
 public:
  using WrappedProblem::WrappedProblem;
  bool evaluate(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian) const override {
    return problem_.evaluate(x, residuals, jacobian);
  }
};

class BasinsOf : public OfModel {};
INSTANTIATE_TEST_SUITE_P(OfLambda, BasinsOf, ::testing::Values("a", "b", "c"));

TEST_P(BasinsOf, LeadToTheLowestCostOfTheRange) {
  int found = 0;
  for (unsigned seed = 1; seed <= 300; ++seed) {
    const auto problem = mixture(model(), seed);
    const Verdict fit = solve(problem, {}, kWithKernel);
    if (fit.status == FitStatus::not_identifiable) continue;
    ASSERT_FALSE(fit.best.x.empty()) << fit.message;
    ++found;
    const double upper = problem.parameters()[0].upper;
    std::vector<double> residuals(problem.residual_count());
    for (int i = 0; i <= 1000; ++i)
      for (const double x : {upper * i / 1000, upper * std::pow(10, -14.0 * i / 1000)})
        if (const auto here = sum_of_squares(problem, {&x, 1}, residuals)) {
          // a slope of 1e-14 of its terms leaves the cost at its least but for rounding
          ASSERT_GE(*here, fit.best.sum_of_squares * (1 - 1e-9) - 1e-24) << "seed " << seed << " at " << x;
        }
  }
  EXPECT_GT(found, 250);
}

/// Costs whose curvature is Gauss-Newton's are looked at in fixed values, with the same result.
TEST_P(BasinsOf, AreThoseOfAGridWithoutExactCurvature) {
  int compared = 0;
  for (unsigned seed = 1; seed <= 50; ++seed) {
    const auto problem = mixture(model(), seed);
    const Verdict fast = solve(problem, {}, kWithKernel), slow = solve(WithoutCurvature(problem), {}, kWithKernel);
    if (fast.status != FitStatus::ok || slow.status != FitStatus::ok) continue;
    ++compared;
    EXPECT_NEAR(slow.best.x[0], fast.best.x[0], 1e-7 * fast.best.x[0])
        << seed;  // the secant ends at sqrt(eps) of the cost
  }
  EXPECT_GT(compared, 25);
}

}  // namespace basins_test
}  // namespace mixity
