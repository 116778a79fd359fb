// What a report leads with.
#include "analysis/answer.h"

#include <gtest/gtest.h>

#include "analysis/judgement.h"
#include "analysis/run.h"
#include "dataset/load_text.h"
#include "report/example_results.h"

namespace mixity {
namespace answer_test {

bool says(const Answer& answer, const std::string& part) {
  return std::any_of(answer.cannot_say.begin(), answer.cannot_say.end(),
                     [&](const std::string& one) { return one.find(part) != std::string::npos; });
}

TEST(Answer, SaysWhereTheInterfaceSlidesBeforeItJumps) {
  Analysis result = shipped("mergel2018");
  EXPECT_TRUE(says(answer_of(result), "slides first, at P = "));
  result.data.metadata.shear_strength = 1e7;
  EXPECT_FALSE(says(answer_of(result), "slides first"));
  result.data.metadata.shear_strength.reset();
  EXPECT_FALSE(says(answer_of(result), "slides first"));
}

TEST(Answer, NamesNoValueWhereEveryOneFits) {
  FitRequest request;
  request.models = {"c"};
  const Dataset data = load_text("curve,P,T,A\n1,2,0,20\n1,2,0.01,20.1\n1,2,0.02,19.9\n");
  const Analysis result = run(request, data);
  ASSERT_NE(result.fits[0].status, FitStatus::ok);
  const Answer answer = answer_of(result);
  EXPECT_TRUE(answer.fit == nullptr || answer.result == "λ is not determined by these data") << answer.result;
}

TEST(Answer, GivesTheIntervalOfEachParameter) {
  Analysis result = shipped("mergel2018");
  FitResult& fit = result.fits[by_merit(result).front()];
  const std::string alone = answer_of(result).interval;
  fit.parameters.push_back(fit.parameters[0]);
  fit.parameters.back().name = "lambda_III";
  EXPECT_EQ(answer_of(result).interval, alone + ", of λ_III" + alone.substr(alone.find(" 0.")));
}

TEST(Answer, PutsModelsThatAreFarBehindInTheOrderOfTheirAicc) {
  Analysis result = shipped("mergel2018");
  ASSERT_EQ(result.comparison.size(), 3u);
  for (ComparedModel& one : result.comparison) one.weight = one.model == "c" ? 1 : 0;  // as with many points
  const std::vector<std::size_t> order = by_merit(result);
  const auto aicc = [&](std::size_t i) {
    for (const ComparedModel& one : result.comparison)
      if (one.model == result.fits[i].model) return *one.aicc;
    return 0.0;
  };
  for (std::size_t i = 1; i < order.size(); ++i) EXPECT_LT(aicc(order[i - 1]), aicc(order[i]));
}

}  // namespace answer_test
}  // namespace mixity
