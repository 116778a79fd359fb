#include <gtest/gtest.h>

#include "stress/experiments.h"
#include "stress/fits.h"
#include "stress/short_run.h"

namespace mixity::stress {
namespace stress_test {

TEST(Stress, NoRandomFitClaimsWhatThePrintedCostContradicts) {
  constexpr std::size_t kCases = short_run(600, 60);
  const Tally tally = random_fits(kShortSeed, kCases);
  expect_explained(tally);
  EXPECT_GT(tally.answered, kCases / 4);
}

TEST(Stress, NoRandomFitOfAreasOrCurvesMissesTheLowestCost) {
  constexpr std::size_t kCases = short_run(40, 4);
  const Tally tally = random_experiments(kShortSeed, kCases);
  expect_explained(tally);
  EXPECT_GT(tally.answered, kCases / 4);
  // given up only where the least squares lie at the end of what bk can describe
  for (const std::string& where : tally.first_given_up)
    EXPECT_NE(where.find("the model is not defined"), std::string::npos) << where;
}

/// The judge finds a value that is off, and a claim that the data say nothing.
TEST(Stress, TheJudgeOfFitsFindsWhatIsWrong) {
  Random random(1);
  const RandomData drawn = random_data(random, Kind::usual, 50);
  FitResult fit = fit_model(drawn.data, "b");
  double error = 0;
  ASSERT_EQ(wrong_with_fit(drawn.data, fit, error), "");
  FittedParameter& lambda = fit.parameters[0];
  lambda.interval.reset();
  lambda.value = *lambda.value > 1 ? *lambda.value - 1e-2 : *lambda.value + 1e-2;
  EXPECT_NE(wrong_with_fit(drawn.data, fit, error), "");
  fit.status = FitStatus::not_identifiable;
  fit.message = "nothing is known";
  lambda.value.reset();
  EXPECT_NE(wrong_with_fit(drawn.data, fit, error), "");
}

}  // namespace stress_test
}  // namespace mixity::stress
