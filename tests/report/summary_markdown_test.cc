// The summary for a lab book, one golden file for each status and one of a shipped data set; MIXITY_UPDATE_GOLDEN=1
// writes them anew.
#include <gtest/gtest.h>

#include "analysis/run.h"
#include "report/example_results.h"
#include "report/golden_file.h"
#include "report/report.h"

namespace mixity {
namespace summary_markdown_test {

/// Without the last line, which names versions.
std::string summary(const Analysis& result) {
  const ReportedData data = without_figures(result, "example");
  const std::string text = summary_markdown({{"mixity report example.toml", {}}, {{&data, &data, {}}}, {}});
  return text.substr(0, text.rfind("with "));
}

TEST(SummaryMarkdown, OfEachStatus) {
  for (const FitStatus status : {FitStatus::ok, FitStatus::at_bound, FitStatus::not_identifiable, FitStatus::multimodal,
                                 FitStatus::not_converged})
    expect_golden_text(summary(example(status)), "summary_" + std::string(to_string(status)) + ".md");
}

/// By the distance from the curve, which is what data with loads get.
TEST(SummaryMarkdown, OfTheCurveHoldsThePapersFit) {
  FitRequest request = read_fit_definition(MIXITY_ROOT "/fits/mergel2018.toml");
  request.options.objective.reset();
  request.published.clear();
  expect_golden_text(summary(run(request)), "summary_mergel2018_curve.md");
}

TEST(SummaryMarkdown, OfAShippedDataSet) {
  expect_golden_text(summary(shipped("mergel2018")), "summary_mergel2018.md");
}

TEST(SummaryMarkdown, OfSeveralSetsBeginsWithATableThatComparesThem) {
  const Analysis good = example(FitStatus::ok), none = example(FitStatus::not_identifiable);
  const ReportedData first = without_figures(good, "a"), second = without_figures(none, "b");
  const std::string text =
      summary_markdown({{"mixity report", {}}, {{&first, &first, {}}, {&second, &second, {}}}, {}});
  EXPECT_TRUE(text.starts_with(
      "# Mode-mixity fits\n\n"
      "| Data set | Best model | Parameters | Status |\n|---|---|---|---|\n"
      "| example; 40 points, in 2 loading runs; provenance: measured | c; Papangelo-Ciavarella 2019 | "
      "lambda = 0.002346 ± 0.000012 | ok |\n"
      "| example; 40 points, in 2 loading runs; provenance: measured |  |  | **no fit has a value** |\n\n"
      "## example\n"))
      << text;
}

TEST(SummaryMarkdown, ForeignTextDoesNotBreakTheTable) {
  Analysis result = example(FitStatus::ok);
  result.data.name = "a|b_c*d";
  result.fits[0].model_name = "x|y";
  const std::string text = summary(result);
  EXPECT_NE(text.find("## a\\|b\\_c\\*d"), std::string::npos) << text;
  EXPECT_NE(text.find("c; x\\|y |"), std::string::npos) << text;
}

}  // namespace summary_markdown_test
}  // namespace mixity
