// Profiles, single runs, residuals and laws against the numbers of the fits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "report/example_results.h"
#include "report/figures/data_figures.h"
#include "report/figures/read_back.h"
#include "statistics/distributions.h"

namespace mixity {
namespace parameter_figures_test {

const FitResult& fit_of(const std::string& data, const std::string& model) {
  for (const FitResult& fit : shipped(data).fits)
    if (fit.model == model) return fit;
  throw std::runtime_error(model);
}

TEST(ProfileFigures, CrossTheLevelAtTheEndsOfTheInterval) {
  for (const char* model : {"a", "b", "c"}) {
    const ReportedData reported = reported_data(shipped("mergel2018"), "m");
    const std::vector<Figure> drawn = profile_figures(reported);
    const auto& points = series_named(figure_named(drawn, std::string("m_profile_") + model), "profile").points;
    const FittedParameter& lambda = fit_of("mergel2018", model).parameters[0];
    EXPECT_NEAR(points.front().first, *lambda.value - 2 * (*lambda.value - *lambda.interval->low), 1e-9);
    for (const double end : {*lambda.interval->low, *lambda.interval->high}) {
      const auto after =
          std::find_if(points.begin(), points.end(), [&](const auto& point) { return point.first >= end - 1e-12; });
      ASSERT_NE(after, points.end());
      // 80 points span four half-widths: the ends are points of the profile
      EXPECT_NEAR(after->first, end, 1e-6 * end);
      EXPECT_NEAR(after->second, lambda.profile->level, 1e-6 * lambda.profile->level) << model;
    }
  }
}

TEST(AxesFigures, SayWhetherTheCouplingsAreEqual) {
  Analysis result = example(FitStatus::ok);
  const ReportedData reported{.result = result, .stem = "m"};
  FitResult& fit = result.fits[0];
  fit.model = "c-ellipse";
  fit.parameters = {
      {"lambda_II", 0.05, 0.003, 0, 1}, {"lambda_III", 0.04, 0.004, 0, 1}, {"poisson_ratio", 0.5, {}, 0, 0.5}};
  fit.correlations = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  const auto caption = [&] { return figure_named(axes_figures(reported), "m_couplings_c-ellipse").caption; };
  EXPECT_NE(caption().find(" lambda_II - lambda_III is 0.010 +/- 0.005: the couplings differ."), std::string::npos);
  fit.correlations[1] = fit.correlations[3] = -0.5;  // an error of 0.0061
  EXPECT_NE(caption().find(" is 0.010 +/- 0.006: they may be equal."), std::string::npos) << caption();
}

TEST(RunFigures, ShowTheValueAndIntervalOfEachRun) {
  const ReportedData reported = reported_data(shipped("mergel2018"), "m");
  const std::vector<Figure> drawn = run_figures(reported);
  const Series& runs = series_named(figure_named(drawn, "m_runs_c"), "each run");
  const PerCurve& own = reported.result.per_curve.at(0);
  ASSERT_EQ(own.model, "c");
  ASSERT_EQ(runs.points.size(), own.curves.size());
  for (std::size_t i = 0; i < runs.points.size(); ++i) {
    const FittedParameter& lambda = own.curves[i].fit.parameters[0];
    EXPECT_EQ(runs.points[i].second, *lambda.value);
    EXPECT_EQ(runs.bars[i].y_low, *lambda.interval->low);
    EXPECT_EQ(runs.bars[i].y_high, *lambda.interval->high);
    EXPECT_NE(runs.hover[i].find("run " + own.curves[i].curve), std::string::npos);
  }
  const Series& pooled = series_named(figure_named(drawn, "m_runs_c"), "all runs");
  EXPECT_EQ(pooled.points[0].second, *fit_of("mergel2018", "c").parameters[0].value);
}

TEST(LeftOutFigures, AgreeWithTheErrorOverAllLoads) {
  const ReportedData reported = reported_data(shipped("mergel2018"), "m");
  const Figure figure = left_out_figures(reported).at(0);
  for (const ComparedModel& model : reported.result.comparison) {
    const Series& series = series_named(figure, "model " + model.model);
    double squares = 0, points = 0;
    for (std::size_t i = 0; i < series.points.size(); ++i) {
      const auto n = static_cast<double>(model.left_out->runs[i].points);
      squares += n * series.points[i].second * series.points[i].second;
      points += n;
    }
    EXPECT_NEAR(std::sqrt(squares / points), model.left_out->rmse_area, 1e-14);
  }
}

TEST(ResidualFigures, ShowTheResidualsOfTheFits) {
  const ReportedData reported = reported_data(shipped("waters_guduru2010"), "w");
  const std::vector<Figure> drawn = residual_figures(reported);
  for (const FitResult& fit : reported.result.fits) {
    const Series& series = series_named(figure_named(drawn, "w_residuals_psi"), "model " + fit.model);
    ASSERT_EQ(series.points.size(), fit.residuals.size());
    for (std::size_t i = 0; i < series.points.size(); ++i) {
      EXPECT_EQ(series.points[i].second, fit.residuals[i]);
      EXPECT_DOUBLE_EQ(series.points[i].first,
                       reported.result.data.toughness(fit.used[i])->psi() * 180 / std::numbers::pi);
    }
  }
}

TEST(NormalFigures, ShowTheSortedResidualsInStandardErrors) {
  const ReportedData reported = reported_data(shipped("mergel2018"), "m");
  const Figure figure = normal_figures(reported).at(0);
  EXPECT_EQ(figure.name, "m_residuals_qq");
  const FitResult& fit = fit_of("mergel2018", "c");
  const Points& points = series_named(figure, "model c").points;
  ASSERT_EQ(points.size(), 200U);
  EXPECT_TRUE(std::is_sorted(points.begin(), points.end()));
  EXPECT_EQ(points.front().second, *std::ranges::min_element(fit.residuals) / fit.standard_error);
  // quantile of 0.5/200, from tables of the normal distribution
  EXPECT_NEAR(points.front().first, -2.80703, 1e-5);
  EXPECT_NEAR(points.back().first, 2.80703, 1e-5);
}

/// The largest of 200 normal numbers is below x with probability Phi(x)^200.
TEST(NormalFigures, HaveABandThatHoldsMostOfCleanPoints) {
  const Figure figure = normal_figures(reported_data(shipped("mergel2018"), "m")).at(0);
  const Series& band = figure.series.front();
  ASSERT_EQ(band.look, Look::band);
  ASSERT_EQ(band.points.size(), 400U);
  // the upper line runs back from the last point
  EXPECT_NEAR(band.points[200].second, normal_quantile(std::pow(0.975, 1 / 200.0)), 1e-9);
  EXPECT_NEAR(band.points[199].second, normal_quantile(std::pow(0.025, 1 / 200.0)), 1e-9);
}

TEST(NormalFigures, LeaveOutModelsThatAnotherLeavesFarBehind) {
  Analysis result = shipped("mergel2018");
  for (FitResult& fit : result.fits) fit.outdone_by = fit.model == "c" ? "" : "c";
  EXPECT_EQ(normal_figures(reported_data(result, "m")).at(0).series.size(), 3U);  // with band and line
  for (FitResult& fit : result.fits) fit.innovations.resize(7);
  EXPECT_TRUE(normal_figures(reported_data(result, "m")).empty());
}

TEST(ToughnessFigures, FollowThePrintedLawAndBandsTheIntervals) {
  const ReportedData reported = reported_data(shipped("waters_guduru2010"), "w");
  const Figure figure = toughness_figures(reported).at(0);
  const FittedParameter& lambda = fit_of("waters_guduru2010", "c").parameters[0];
  const auto f = [](double l, double psi) { return 1 / (1 + (l - 1) * std::pow(std::sin(psi), 2)); };
  EXPECT_EQ(figure.x.label, "ψ [°]");
  for (const Series& series : figure.series) {
    if (series.look == Look::solid) {
      for (const auto& [degrees, value] : series.points)
        EXPECT_NEAR(value, f(*lambda.value, degrees * std::numbers::pi / 180), 1e-12);
    }
    if (series.look != Look::band || series.color != model_color("c")) continue;
    for (std::size_t i = 0; i < series.points.size(); ++i) {
      // out at the low end of lambda (the tougher), back at the high end
      const auto& [degrees, value] = series.points[i];
      const double psi = degrees * std::numbers::pi / 180;
      const double low = f(*lambda.interval->low, psi), high = f(*lambda.interval->high, psi);
      EXPECT_LT(std::min(std::abs(value - low), std::abs(value - high)), 1e-12);
    }
  }
}

TEST(SahliFigures, ReferenceLinesHaveTheirExponents) {
  const ReportedData reported = reported_data(shipped("mergel2018"), "m");
  const Figure figure = sahli_figures(reported).at(0);
  for (const auto& [label, exponent] : {std::pair("exponent -5/4", -1.25), std::pair("exponent -3/2", -1.5)}) {
    const auto& points = series_named(figure, label).points;
    EXPECT_NEAR(std::log(points[1].second / points[0].second) / std::log(points[1].first / points[0].first), exponent,
                1e-12);
  }
  EXPECT_EQ(series_named(figure, "each run").points.size(), 8u);
}

TEST(RegimeFigures, ShowTheRegimeThatTheClassificationGives) {
  const ReportedData reported = reported_data(shipped("mergel2018"), "m");
  std::vector<MissingFigure> left_out;
  const std::vector<Figure> drawn = regime_figures(reported, left_out);
  ASSERT_EQ(drawn.size(), 3u);
  // Of model c without a strength every contact jumps; with it, small lambda slides first: two regions.
  const Figure& c = figure_named(drawn, "m_regimes_c");
  EXPECT_EQ(series_named(c, "these data").points.size(), 8u);
  // Together the regions cover the whole map: their areas in the plane of P and log lambda add up.
  double covered = 0;
  for (const Series& series : c.series) {
    if (series.look != Look::band) continue;
    double area = 0;
    for (std::size_t i = 0; i < series.points.size(); ++i) {
      const auto& [x0, y0] = series.points[i];
      const auto& [x1, y1] = series.points[(i + 1) % series.points.size()];
      area += 0.5 * (x0 * std::log(y1) - x1 * std::log(y0));
    }
    covered += std::abs(area);
  }
  const double whole = (*c.x.high - *c.x.low) * std::log(*c.y.high / *c.y.low);
  EXPECT_NEAR(covered / whole, 1, 0.01);  // the corner where a region begins between two columns
}

std::vector<Figure> figures_of(const PeakForces& peaks) {
  const Analysis no_fits;
  ReportedData reported{no_fits, "w"};
  reported.peaks = peaks;
  return peak_figures(reported);
}

TEST(PeakFigures, StressesAreForcesOverTheAreaOfHertz) {
  PeakForces peaks;
  peaks.force_unit = "mN";
  peaks.stress_unit = "kPa";
  peaks.rows = {{2, 1.0, 30.0, 10.0}, {3, 4.0, 20.0, 10.1}, {4, 5.0, {}, 9.9}};
  const Figure figure = figures_of(peaks).at(0);
  EXPECT_EQ(series_named(figure, "first maximum").points,
            (std::vector<std::pair<double, double>>{{1.0, 30.0}, {4.0, 20.0}}));
  EXPECT_EQ(series_named(figure, "following minimum").points.size(), 3u);
  EXPECT_NE(figure.caption.find("At the first maximum of each load it varies by a factor of 1.5."), std::string::npos);
  EXPECT_TRUE(figures_of({}).empty());
}

TEST(PeakFigures, CompareTheFirstCycleOfEachLoadAndShowLaterOnesApart) {
  PeakForces peaks;
  peaks.rows = {{2, 1.0, 30.0, 10.0}, {3, 1.0, 12.0, 9.0}, {4, 4.0, 20.0, 10.1}, {5, 4.0, 11.0, 9.0}};
  const Figure figure = figures_of(peaks).at(0);
  EXPECT_EQ(series_named(figure, "first maximum").points,
            (std::vector<std::pair<double, double>>{{1.0, 30.0}, {4.0, 20.0}}));
  EXPECT_EQ(series_named(figure, "maxima of later cycles").points,
            (std::vector<std::pair<double, double>>{{1.0, 12.0}, {4.0, 11.0}}));
  EXPECT_NE(figure.caption.find("first maximum of each load it varies by a factor of 1.5."), std::string::npos);
}

TEST(PeakFigures, LeaveOutAModelThatJumpsAtOneLoadOnly) {
  const Analysis no_fits;
  ReportedData reported{no_fits, "w"};
  reported.peaks = PeakForces{};
  reported.peaks->rows = {{2, 1.0, 30.0, 10.0}, {4, 4.0, 20.0, 10.1}};
  reported.predicted_peaks.push_back({"b", {PredictedPeak{4.0, 1700, 1600, 1800}}});
  reported.predicted_peaks.push_back({"c", {PredictedPeak{1.0, 31, 30, 32}, PredictedPeak{4.0, 21, 20, 22}}});
  const Figure figure = peak_figures(reported).at(0);
  std::vector<std::string> labels;
  for (const Series& series : figure.series) labels.push_back(series.label);
  EXPECT_EQ(labels, (std::vector<std::string>{"", "jump of model c", "first maximum", "following minimum"}));
}

TEST(SahliFigures, DrawAModelInItsColour) {
  const Analysis no_fits;
  ReportedData reported{no_fits, "w"};
  reported.sahli_model = "a";
  reported.sahli =
      SahliResult{{{"1", 1, 9, 20, 0.01, {}, {}, 0.011}, {"2", 3, 9, 25, 0.02, {}, {}, 0.021}}, {}, {}, {}};
  EXPECT_EQ(series_named(sahli_figures(reported).at(0), "model a").color, model_color("a"));
}

}  // namespace parameter_figures_test
}  // namespace mixity
