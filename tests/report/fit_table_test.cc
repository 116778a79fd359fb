#include "report/fit_table.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "report/example_results.h"

namespace mixity {
namespace fit_table_test {

std::string cell(const FitTable& table, std::size_t row, const std::string& heading) {
  const auto found = std::find(table.headings.begin(), table.headings.end(), heading);
  if (found == table.headings.end()) return "no such column";
  std::string text;
  for (const std::string& line : table.rows[row][static_cast<std::size_t>(found - table.headings.begin())].lines)
    text += (text.empty() ? "" : "; ") + line;
  return text;
}

TEST(FitTable, RoundsToTheErrorOfEachNumber) {
  const FitTable table = fit_table(shipped("mergel2018"));
  EXPECT_EQ(cell(table, 0, "Parameters (95 % interval)"), "lambda = 0.002306 ± 0.000011 (0.002285 .. 0.002328)");
  EXPECT_EQ(cell(table, 0, "R² in the fitted space"), "0.9999083");
  EXPECT_EQ(cell(table, 0, "Published"), "lambda = 0.0023 agrees; r2 = 0.9999 agrees");
  EXPECT_EQ(cell(table, 1, "AICc weight"), "< 0.0001");
}

TEST(FitTable, ShowsThePapersFitBesideThatOfTheCurve) {
  Analysis result = example(FitStatus::ok);
  const std::string heading = "The paper's fit: ln(Gc/GIc) against psi";
  EXPECT_EQ(cell(fit_table(result), 0, heading), "no such column");
  result.fits[0].objective = Objective::curve;
  result.fits[0].paper = PaperFit{FitStatus::ok, {{"lambda", 0.0023060412, {}, 0, 1}}, 0.99990826, 40};
  EXPECT_EQ(cell(fit_table(result), 0, heading), "lambda = 0.002306; R² = 0.9999083");
  result.fits[0].paper = PaperFit{FitStatus::at_bound, {{"lambda", 0.0, {}, 0, 1, true}}, {}, 40};
  EXPECT_EQ(cell(fit_table(result), 0, heading), "lambda = 0; at bound");
  result.fits[0].paper = PaperFit{FitStatus::not_identifiable, {{"lambda", {}, {}, 0, 1}}, {}, 1};
  EXPECT_EQ(cell(fit_table(result), 0, heading), "lambda = not determined");
}

TEST(FitTable, HasNoColumnThatSaysNothing) {
  const FitTable table = fit_table(shipped("waters_guduru2010"));
  EXPECT_EQ(table.headings, (std::vector<std::string>{"Model", "Parameters (95 % interval)", "Status",
                                                      "R² in the fitted space", "AICc weight", "Published"}));
  for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.headings.size());
}

TEST(FitTable, ShowsOpenAndBoundEndsHeldValuesAndStandardErrors) {
  Analysis result = example(FitStatus::ok);
  FitResult& fit = result.fits[0];
  const auto text = [&] { return cell(fit_table(result), 0, fit_table(result).headings[1]); };
  EXPECT_EQ(text(), "lambda = 0.002346 ± 0.000012");
  fit.parameters[0].interval = ShownInterval{"profile", 0.9, 0.0, {}, EndStatus::at_bound, EndStatus::open};
  EXPECT_EQ(text(), "lambda = 0.002346 ± 0.000012 (0 bound .. open)");
  fit.parameters[0] = {"lambda", 0.5, {}, 0, 1, false, true};
  EXPECT_EQ(text(), "lambda = 0.5 (held)");
}

TEST(FitTable, ForATerminalIsAligned) {
  Analysis result = example(FitStatus::ok);
  result.fits.push_back(result.fits[0]);
  result.fits[1].model = "bk";
  result.fits[1].model_name = "B & K";
  result.fits[1].status = FitStatus::not_converged;
  EXPECT_EQ(
      table_text(result),
      "Model  Parameters                    Status         R² fit     R² A(T)  RMS A(T)                 Published\n"
      "c      lambda = 0.002346 ± 0.000012  ok             0.9999083  0.99935  0.00216 mm^2             lambda = "
      "0.0023 agrees\n"
      "                                                                        without 2 past the fold  r2 = "
      "0.9999 agrees\n"
      "bk     lambda = 0.002346 ± 0.000012  not converged  0.9999083  0.99935  0.00216 mm^2\n"
      "                                                                        without 2 past the fold\n");
}

TEST(Findings, NameTheBestPredictionAndWhatDidNotEndOk) {
  const std::vector<std::string> sentences = findings(shipped("mergel2018"));
  ASSERT_EQ(sentences.size(), 2u);
  EXPECT_EQ(sentences[0],
            "Model c predicts the areas at loads left out of the fit best (RMS error 0.00276 mm^2); b errs 4.6 times "
            "as much, a errs 8.1 times as much.");
  EXPECT_EQ(sentences[1], "AICc prefers model c (weight > 0.9999).");
  EXPECT_EQ(
      findings(example(FitStatus::multimodal)),
      std::vector<std::string>{"Model c, multimodal: another minimum fits as well within the scatter: lambda = 0.41."});
  EXPECT_TRUE(findings(example(FitStatus::ok)).empty());
}

/// The same law under two names.
TEST(Findings, CallATieATie) {
  Analysis result = example(FitStatus::ok);
  result.comparison = {{"b", 90.0, {}, 1e-9, LeftOut{0.02, 0, {}}, {}},
                       {"c", 50.0, {}, 0.5, LeftOut{0.01, 0, {}}, {}},
                       {"linear", 50.0, {}, 0.5 + 1e-12, LeftOut{0.01, 0, {}}, {}}};
  EXPECT_EQ(findings(result), (std::vector<std::string>{
                                  "Models c and linear predict the areas at loads left out of the fit best (RMS error "
                                  "0.01 mm^2); b errs 2 times as much.",
                                  "AICc finds models c and linear equal (weight 0.5 each)."}));
  result.comparison[0].left_out->rmse_area = 0.001;
  EXPECT_EQ(findings(result), std::vector<std::string>{
                                  "Here the criteria disagree, and no model is named best: AICc prefers c and linear "
                                  "alike, the loads left out b."});
}

TEST(Findings, SayWhenAiccDoesNotDecide) {
  EXPECT_EQ(findings(shipped("waters_guduru2010")),
            std::vector<std::string>{"AICc does not decide between the models (weight of b 0.95)."});
}

TEST(Assumptions, NameTheConstantsAndTheObjective) {
  const std::vector<std::string> list = assumptions(shipped("mergel2018"));
  const auto holds = [&](const char* part) {
    return std::any_of(list.begin(), list.end(),
                       [&](const std::string& s) { return s.find(part) != std::string::npos; });
  };
  EXPECT_TRUE(holds("R = 9.42 mm, E* = 2.133 MPa (plane strain) and G_Ic = 27 mJ/m² are exact."));
  EXPECT_TRUE(holds("ln(Gc/GIc)"));
  EXPECT_FALSE(holds("dimensionless"));
  EXPECT_FALSE(holds("paper"));
}

TEST(Assumptions, OfTheCurveNameThePapersFitAndErrorsThatWereRaised) {
  Analysis result = example(FitStatus::ok);
  result.request.options.objective = Objective::curve;
  result.fits[0].paper = PaperFit{};
  result.fits[0].errors =
      std::make_shared<StandardErrors>(StandardErrors{{}, {}, ErrorSource::exact, ErrorSource::columns, {}, 40, 0});
  std::string all;
  for (const std::string& sentence : assumptions(result)) all += sentence + "\n";
  for (const char* part :
       {"distances of the points from the curve", "The paper's fit, every point with the same weight, stands beside it",
        "0.01% of the largest T stands for 40 errors of 0"})
    EXPECT_NE(all.find(part), std::string::npos) << all;
  EXPECT_EQ(all.find("largest A"), std::string::npos);
}

}  // namespace fit_table_test
}  // namespace mixity
