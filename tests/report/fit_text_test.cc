// The text report, one golden file for each status. After a deliberate change of the text, run the test once with
// MIXITY_UPDATE_GOLDEN=1 and read the difference before committing it.
#include "report/fit_text.h"

#include <gtest/gtest.h>

#include "report/example_results.h"
#include "report/golden_file.h"

namespace mixity {
namespace fit_text_test {

TEST(FitText, Ok) { expect_golden(example(FitStatus::ok), "ok.txt"); }

TEST(FitText, AtBound) { expect_golden(example(FitStatus::at_bound), "at_bound.txt"); }
TEST(FitText, NotIdentifiable) { expect_golden(example(FitStatus::not_identifiable), "not_identifiable.txt"); }
TEST(FitText, Multimodal) { expect_golden(example(FitStatus::multimodal), "multimodal.txt"); }
TEST(FitText, NotConverged) { expect_golden(example(FitStatus::not_converged), "not_converged.txt"); }

TEST(FitText, ReconstructedWithManyExclusionsAndAHeldParameter) {
  Analysis result = example(FitStatus::ok);
  result.data.metadata.provenance = Provenance::reconstructed;
  for (std::size_t line = 10; line < 20; ++line) result.data.excluded.push_back({line, "T is not finite"});
  result.fits[0].scale = Scale::linear;
  result.fits[0].parameters = {{"r", 1.774, {}, 1e-3, 1e3, false, true}, {"eta", 2.284, 0.41, 1e-2, 1e2}};
  result.fits[0].excluded = {{30, "model a has an infinite toughness at this psi"}};
  expect_golden(result, "reconstructed.txt");
}

TEST(FitText, TheRangeOfAnUndeterminedConstantIsInAReadableUnit) {
  Analysis result = example(FitStatus::not_identifiable);
  result.fits[0].parameters.push_back({"toughness", {}, {}, 2.7e-5, 27, false, false, {}, {}, "J/m^2"});
  const std::string text = to_text(result);
  EXPECT_NE(text.find("not determined   range 0.027..27000 mJ/m^2\n"), std::string::npos) << text;
}

TEST(FitText, ListsTheFirstOfThePointsThatAModelLeavesOut) {
  Analysis result = example(FitStatus::ok);
  result.request.words = cli::in_flags;
  for (std::size_t line = 30; line < 50; ++line) result.fits[0].excluded.push_back({line, kNoPhaseAngle});
  const std::string text = to_text(result);
  EXPECT_NE(text.find("    without line 37: y <= 0"), std::string::npos) << text;
  EXPECT_EQ(text.find("    without line 38"), std::string::npos) << text;
  EXPECT_NE(text.find("    and 12 more (all of them with --format=json)\n"), std::string::npos) << text;
}

}  // namespace fit_text_test
}  // namespace mixity
