// Which figures a case gets, and why it does not get the others.
#include "report/figures/data_figures.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "dataset/load_text.h"
#include "dataset/temporary_folder.h"
#include "report/example_results.h"

namespace mixity {
namespace data_figures_test {

std::set<std::string> names(const DataFigures& figures) {
  std::set<std::string> all;
  for (const FigureGroup& group : figures.groups)
    for (const Figure& figure : group.figures) EXPECT_TRUE(all.insert(figure.name).second) << figure.name;
  return all;
}

std::string reason(const DataFigures& figures, const std::string& what) {
  for (const MissingFigure& figure : figures.left_out)
    if (figure.what == what) return figure.why;
  return "not left out";
}

TEST(DataFigures, OfLoadsAndAreasAreAllThereAre) {
  const ReportedData reported = reported_data(shipped("mergel2018"), "m");
  const DataFigures figures = data_figures(reported);
  EXPECT_EQ(names(figures),
            (std::set<std::string>{"m_area_models",  "m_area_a",    "m_area_b",      "m_area_c",      "m_toughness",
                                   "m_profile_a",    "m_profile_b", "m_profile_c",   "m_runs_a",      "m_runs_b",
                                   "m_runs_c",       "m_left_out",  "m_residuals_T", "m_residuals_P", "m_residuals_psi",
                                   "m_residuals_qq", "m_u_T",       "m_A_u",         "m_a_P",         "m_regimes_a",
                                   "m_regimes_b",    "m_regimes_c", "m_alpha_A0"}));
  ASSERT_EQ(figures.left_out.size(), 1u);
  EXPECT_EQ(figures.left_out[0].what, "mean shear stress at peak and minimum");
}

TEST(DataFigures, OfPsiAndGcHaveNoAreaMapOrLoads) {
  const ReportedData reported = reported_data(shipped("waters_guduru2010"), "w");
  const DataFigures figures = data_figures(reported);
  EXPECT_EQ(names(figures), (std::set<std::string>{"w_toughness", "w_profile_a", "w_profile_b", "w_profile_c",
                                                   "w_residuals_psi", "w_residuals_qq"}));
  for (const char* what : {"contact area against tangential load", "parameter against normal load", "regime map",
                           "error on loads left out", "displacement and radius curves", "alpha against A0"})
    EXPECT_EQ(reason(figures, what), "the data are (psi, Gc): they have no loads and areas") << what;
}

TEST(DataFigures, GiveARunOneColourInAll) {
  FitRequest request;
  request.models = {"c-ellipse"};
  const Analysis result =
      run_for_report(request, load_text("P [mN],T [mN],a_par [mm],a_perp [mm]\n"
                                        "3,0.019551,0.32036,0.32082\n"
                                        "3,8.9055,0.32058,0.31902\n"
                                        "3,17.795,0.31672,0.31738\n"
                                        "3,26.741,0.31131,0.31243\n"
                                        "3,35.766,0.29924,0.303\n"
                                        "3,42.908,0.28829,0.29264\n"
                                        "6,-0.0098579,0.36305,0.36173\n"
                                        "6,11.539,0.36174,0.36124\n"
                                        "6,23.292,0.35653,0.35705\n"
                                        "6,35.076,0.35137,0.35111\n"
                                        "6,46.476,0.34311,0.34452\n"
                                        "6,55.442,0.32781,0.33299\n"
                                        "12,0.017218,0.41814,0.41716\n"
                                        "12,15.777,0.42006,0.41933\n"
                                        "12,31.178,0.413,0.41708\n"
                                        "12,46.955,0.41117,0.41316\n"
                                        "12,63.615,0.40138,0.40619\n"
                                        "12,75.188,0.38727,0.39268\n",
                                        "radius = \"9.42 mm\"\nmodulus = \"2.133 MPa\"\ntoughness = \"27 mJ/m^2\""));
  const ReportedData reported = reported_data(result, "e");
  std::map<std::string, std::string> area, ratio;
  for (const FigureGroup& group : data_figures(reported).groups)
    for (const Figure& figure : group.figures) {
      auto& colors = figure.name == "e_area_c-ellipse" ? area : ratio;
      if (&colors == &ratio && figure.name != "e_axes_c-ellipse") continue;
      for (const Series& series : figure.series)
        if (series.look == Look::circles) colors[series.label] = series.color;
    }
  EXPECT_EQ(area.size(), 3u);
  EXPECT_EQ(area, ratio);
}

TEST(DataFigures, WithoutAValueShowTheDataOnly) {
  Analysis result = shipped("waters_guduru2010");
  for (FitResult& fit : result.fits) {
    for (FittedParameter& parameter : fit.parameters) {
      parameter.value.reset();
      parameter.profile.reset();
    }
    fit.residuals.clear();
  }
  const DataFigures figures = data_figures(reported_data(result, "w"));
  EXPECT_EQ(names(figures), std::set<std::string>{"w_toughness"});
  EXPECT_EQ(reason(figures, "residuals"), "no fit has a value");
}

TEST(DataFigures, OfOneModelAndOneRunHaveNothingToCompare) {
  const TemporaryFolder folder;
  folder.write("one.csv", "P,T,A\n3,0,20\n3,5,19.6\n3,10,18\n3,15,16\n");
  FitRequest request;
  request.data_path = folder.path("one.csv");
  request.models = {"c"};
  const Analysis result = run_for_report(request);
  const DataFigures figures = data_figures(reported_data(result, "one"));
  EXPECT_EQ(names(figures),
            (std::set<std::string>{"one_area_c", "one_toughness", "one_profile_c", "one_residuals_T",
                                   "one_residuals_psi", "one_u_T", "one_A_u", "one_a_P", "one_regimes_c"}));
  EXPECT_EQ(reason(figures, "normal probability plot of the residuals"), "it needs 8 points or more, which scatter");
}

TEST(DataFigures, EveryFigureSaysInWordsWhatItShows) {
  for (const char* name : {"mergel2018", "waters_guduru2010", "as4_peek_mmb"}) {
    const ReportedData reported = reported_data(shipped(name), name);
    for (const FigureGroup& group : data_figures(reported).groups)
      for (const Figure& figure : group.figures) {
        EXPECT_GT(figure.caption.size(), 20u) << figure.name;
        EXPECT_NE(figure.x.label, "") << figure.name;
        EXPECT_NE(figure.y.label, "") << figure.name;
      }
  }
}

TEST(DataFigures, OfManyRunsAndPointsShowAShareThatHoldsBothEnds) {
  Analysis result;
  for (int i = 0; i < 30; ++i) result.data.curve_loads.push_back(i);
  const std::vector<std::size_t> runs = figured_models(result).runs;
  EXPECT_EQ(runs.size(), 8u);
  EXPECT_EQ(runs.front(), 29u);
  EXPECT_EQ(runs.back(), 0u);
  std::vector<std::size_t> points(100000);
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = i;
  const std::vector<std::size_t> shown = shown_points(points);
  EXPECT_EQ(shown.size(), 2000u);
  EXPECT_EQ(shown.back(), 99999u);
  EXPECT_EQ(shown_points(points, 8).size(), 250u);
  EXPECT_EQ(shown_note(250, 100000), " 250 of 100000 points are shown.");
  EXPECT_EQ(shown_note(5, 5), "");
}

}  // namespace data_figures_test
}  // namespace mixity
