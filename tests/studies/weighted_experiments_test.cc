// Fits whose weights depend on their parameters.
#include <gtest/gtest.h>

#include "fitting/fit.h"
#include "studies/simulate.h"

namespace mixity {
namespace weighted_experiments_test {

/// Under a wrong model the weights may swing for ever. What is shown then must belong to one set of weights: the interval,
/// found from the last, is as wide as the standard error says.
TEST(WeightedExperiments, ShowTheFitOfTheirLastWeights) {
  Plan plan;
  plan.parameters = {0.3};
  plan.constants.radius = 9.42e-3;
  plan.constants.modulus = 2.133e6;
  plan.constants.toughness = 0.027;
  plan.loads = {1e-3, 3e-3, 6e-3};
  plan.points = 15;
  plan.sigma_T = *parse_quantity("1%");
  plan.sigma_A = *parse_quantity("3%");
  const Dataset data = simulate(plan, 7, 0);
  for (const char* sigma_A : {"0.5%", "0.62%", "0.66%", "0.68%", "0.69%", "0.7%", "0.71%", "0.8%", "2%"}) {
    FitOptions options;
    options.objective = Objective::toughness;
    options.weighted = true;
    options.scale = Scale::linear;
    options.sigma_T = *parse_quantity("10%");
    options.sigma_A = *parse_quantity(sigma_A);
    const FitResult fit = fit_model(data, "a", options);
    const FittedParameter& lambda = fit.parameters.front();
    if (fit.status == FitStatus::not_converged) continue;
    ASSERT_TRUE(lambda.stderr_ && lambda.interval && lambda.interval->low && lambda.interval->high) << sigma_A;
    EXPECT_GT(*lambda.interval->high - *lambda.interval->low, *lambda.stderr_) << sigma_A;
    EXPECT_LE(*lambda.interval->low, *lambda.value) << sigma_A;
    EXPECT_GE(*lambda.interval->high, *lambda.value) << sigma_A;
  }
}

}  // namespace weighted_experiments_test
}  // namespace mixity
