// The statistics of a fit as text. After a deliberate change of the text, run the test once with
// MIXITY_UPDATE_GOLDEN=1 and read the difference before committing it.
#include <gtest/gtest.h>

#include "report/fit_text.h"
#include "report/golden_file.h"

namespace mixity {
namespace fit_statistics_text_test {

ShownInterval found(double low, double high) {
  return {"profile", 0.95, low, high, EndStatus::found, EndStatus::found};
}

/// A fit of the curve with the toughness free, in 3 runs.
Analysis example() {
  Analysis result;
  result.data.path = "data/example.csv";
  result.data.name = "example";
  result.data.metadata.provenance = Provenance::measured;
  result.data.has_loads = true;
  result.data.rows = 40;
  result.data.points.resize(40);
  result.data.curves = {"P=1", "P=3", "P=9"};
  result.data.display = {"mN", "mm^2", "", 0.25, 0.01};

  FitResult fit;
  fit.model = "c";
  fit.model_name = "Papangelo-Ciavarella 2019";
  fit.formula = "f = 1/(1 + (lambda-1) sin^2(psi))";
  fit.objective = Objective::curve;
  fit.status = FitStatus::ok;
  fit.parameters = {{"lambda", 0.0023456789, 1.2345e-5, 0, 1}, {"toughness", 0.0269759, 3.2e-5, 2.7e-5, 27}};
  fit.parameters[0].interval = found(0.00232134, 0.00237089);
  fit.parameters[1].interval = found(0.0269123, 0.0270401);
  fit.parameters[1].unit = "J/m^2";
  fit.used = PointIndices(40);
  fit.free_parameters = 2;
  fit.correlations = {1, 0.7361, 0.7361, 1};
  fit.sum_of_squares = 41.2;
  fit.errors = std::make_shared<StandardErrors>(StandardErrors{{}, {}, ErrorSource::columns, ErrorSource::stated, {}});
  fit.r2 = 0.99935;
  fit.rmse = 1.015;
  fit.max_abs_residual = 2.71;
  result.fits = {fit};
  return result;
}

TEST(FitStatisticsText, IntervalsAndKnownErrors) { expect_golden(example(), "known_errors.txt"); }

TEST(FitStatisticsText, ThePapersFitAndErrorsThatWereRaised) {
  Analysis result = example();
  FitResult& fit = result.fits[0];
  StandardErrors errors = *fit.errors;
  errors.source_T = ErrorSource::exact;
  errors.raised_T = 40;
  errors.raised_A = 1;
  fit.errors = std::make_shared<StandardErrors>(errors);
  fit.paper = PaperFit{FitStatus::ok, {{"lambda", 0.00230604, {}, 0, 1}}, 0.99990826, 39};
  expect_golden(result, "paper_and_raised_errors.txt");
}

TEST(FitStatisticsText, ThePapersFitSaysHowItEnded) {
  FitResult fit;
  EXPECT_EQ(paper_text(fit), "");
  fit.paper = PaperFit{FitStatus::at_bound, {{"r", 2, {}, 0, 9, false, true}, {"eta", 0.01, {}, 0.01, 9}}, 0.5, 7};
  EXPECT_EQ(paper_text(fit),
            "    the paper's fit (ln(Gc/GIc) against psi, unweighted): r = 2, eta = 0.01 (at bound), R^2 = 0.5, 7 "
            "points\n");
  fit.paper = PaperFit{FitStatus::not_identifiable, {{"lambda", {}, {}, 0, 1}}, {}, 1};
  EXPECT_EQ(paper_text(fit),
            "    the paper's fit (ln(Gc/GIc) against psi, unweighted): lambda not determined (not identifiable)\n");
}

TEST(FitStatisticsText, EstimatedErrorsWithARobustLossAndOneEndedIntervals) {
  Analysis result = example();
  FitResult& fit = result.fits[0];
  fit.status = FitStatus::at_bound;
  fit.message = "lambda is at its lower bound 0";
  StandardErrors errors{{}, {}, ErrorSource::scatter, ErrorSource::scatter, 0.00721};
  errors.model_A = {0.25, 0.00721};
  errors.model_T = {0, 0.0123};
  fit.errors = std::make_shared<StandardErrors>(errors);
  fit.loss_scale = 1.345;
  fit.parameters[0] = {"lambda", 0.0, {}, 0, 1, true};
  fit.parameters[0].interval = ShownInterval{"profile", 0.95, 0.0, 0.000123456, EndStatus::at_bound, EndStatus::found};
  fit.parameters[1].interval->high.reset();
  fit.parameters[1].interval->high_status = EndStatus::open;
  fit.correlations.clear();
  expect_golden(result, "estimated_errors.txt");
}

TEST(FitStatisticsText, EstimatedErrorsNameTheStepsOfTheReadings) {
  StandardErrors errors{{}, {}, ErrorSource::scatter, ErrorSource::scatter, 0.01};
  errors.model_A = {0, 0.01};
  errors.step_A = 0.5;
  errors.model_T = {0, 0};
  errors.step_T = 2;
  DisplayUnits units;
  units.area = "mm^2";
  units.area_scale = 0.1;
  units.force = "mN";
  EXPECT_EQ(estimated_errors(errors, units), "A 1 % + steps of 0.05 mm^2, T steps of 2 mN, from scatter");
}

TEST(FitStatisticsText, ComparisonIsSortedByTheErrorOnLoadsLeftOut) {
  Analysis result = example();
  result.fits.clear();
  result.comparison = {{"a", 321.5, 330.25, 2.3e-62, LeftOut{0.0123456, 0, {}}},
                       {"bk", {}, {}, {}, {}},
                       {"c", 38.25, 40.5, 1, LeftOut{0.00216, 3, {}}}};
  expect_golden(result, "comparison.txt");
}

TEST(FitStatisticsText, EachRunAndTheTestOfOneValue) {
  Analysis result = example();
  PerCurve per_curve;
  per_curve.model = "c";
  for (std::size_t c = 0; c < 3; ++c) {
    CurveFit one{result.data.curves[c], 1.0 + 2.0 * static_cast<double>(c), result.fits[0]};
    one.fit.parameters.resize(1);
    per_curve.curves.push_back(one);
  }
  FitResult& last = per_curve.curves[2].fit;
  last.status = FitStatus::not_identifiable;
  last.parameters[0] = {"lambda", {}, {}, 0, 1};
  per_curve.fitted = 2;
  per_curve.test = PerCurve::Test{false, 4.321, 1, 24, 0.0486, -101.25, -103.5};
  PerCurve shared = per_curve;
  shared.model = "b";
  shared.test = PerCurve::Test{true, 0.1234, 1, 24, 0.7254, 12.5, 14.75};
  PerCurve untested = per_curve;
  untested.model = "a";
  untested.test.reset();
  untested.untested = "too few points";
  result.fits.clear();
  result.per_curve = {per_curve, shared, untested};
  expect_golden(result, "per_curve.txt");
}

/// Digits follow the width of the interval, to a tenth of its decade.
TEST(FitStatisticsText, IntervalsAreRoundedToTheirOwnWidth) {
  FittedParameter parameter{"lambda", 0.5, 0.1, 0, 1};
  EXPECT_EQ(interval_text(parameter), "");
  parameter.interval = found(0.3456789, 0.7891234);
  EXPECT_EQ(interval_text(parameter), "   95% 0.35 .. 0.79");
  parameter.interval = found(0.50000012, 0.50000045);
  EXPECT_EQ(interval_text(parameter), "   95% 0.50000012 .. 0.50000045");
  parameter.interval->confidence = 0.6827;
  EXPECT_EQ(interval_text(parameter), "   68.27% 0.50000012 .. 0.50000045");
}

TEST(FitStatisticsText, AnIntervalOfCausesThatExcludesTheValueSaysSo) {
  FittedParameter parameter{"lambda", 0.5, 0.1, 0, 1};
  parameter.interval = found(0.6, 0.8);
  parameter.interval->method = "explanations";
  EXPECT_EQ(interval_text(parameter), "   95% 0.6 .. 0.8 if a cause is fitted");
  parameter.value = 0.7;
  EXPECT_EQ(interval_text(parameter), "   95% 0.6 .. 0.8");
}

/// Errors that the scatter belies are said so; those that it bears out are not.
TEST(FitStatisticsText, SaysWhenTheScatterIsLargerThanTheErrors) {
  FitResult fit = example().fits[0];
  EXPECT_EQ(errors_text(fit, {}, in_neutral_words).find("too narrow"), std::string::npos);
  fit.sum_of_squares = 77;  // 38 degrees of freedom, twice that is 76
  EXPECT_NE(errors_text(fit, {}, in_neutral_words).find("too narrow"), std::string::npos);
  fit.loss_scale = 1;  // then it is no chi^2
  EXPECT_EQ(errors_text(fit, {}, in_neutral_words).find("chi^2"), std::string::npos);
}

/// A distance from the curve always uses the errors of the file, also where there are too few points for a fit.
TEST(FitStatisticsText, RecommendsWeightsOnlyWhereAFitHasNone) {
  FitResult fit = example(FitStatus::not_identifiable).fits[0];
  Dataset data = example(FitStatus::ok).data;
  data.errors.resize(data.points.size());
  fit.objective = Objective::toughness;
  EXPECT_NE(errors_text(fit, data, in_neutral_words).find("weighted"), std::string::npos);
  fit.objective = Objective::curve;
  EXPECT_EQ(errors_text(fit, data, in_neutral_words), "");
}

TEST(FitStatisticsText, NamesTheFarthestOutliersFirst) {
  Analysis result = example();
  FitResult& fit = result.fits[0];
  for (std::size_t i = 0; i < 40; ++i) result.data.points[i].line = static_cast<Point::Index>(i + 2);
  fit.consistency.emplace();
  EXPECT_TRUE(consistency_lines(fit, result.data).empty());
  fit.outliers = {{3, -4.26}, {10, 17.3}};
  result.data.points[10].curve = 2;
  EXPECT_EQ(
      consistency_lines(fit, result.data).back(),
      "2 outliers: line 12 of run P=9 (17 standard errors off), line 5 of run P=1 (4.3); 1 % of fits to clean data "
      "have any");
  fit.outliers.assign(6, {4, 5.0});
  EXPECT_NE(consistency_lines(fit, result.data).back().find("line 6 of run P=1 (5), 1 more; 1 % of fits"),
            std::string::npos);
  result.data.curves[0] = "";
  fit.outliers.resize(1);
  EXPECT_EQ(consistency_lines(fit, result.data).back(),
            "1 outlier: line 6 (5 standard errors off); 1 % of fits to clean data have any");
  fit.objective = Objective::toughness;
  EXPECT_TRUE(consistency_lines(fit, result.data).back().ends_with("have any where all points scatter alike"));
}

}  // namespace fit_statistics_text_test
}  // namespace mixity
