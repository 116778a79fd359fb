// What counts as a point at the fold, and that no unit decides it.
#include "fitting/predicted_area.h"

#include <gtest/gtest.h>

#include "dataset/load_text.h"
#include "fitting/comparison.h"
#include "fitting/models.h"

namespace mixity {
namespace predicted_area_test {

TEST(PredictedAreas, HaveAPointWithinRoundingsOfTheFoldAtTheFold) {
  for (const double P : {-3.0, 0.5, 30.0}) {
    const ParameterValues p{0.3};
    const ContactModel model = model_named("c");
    const StableBranch last = model.equilibria(p, P, std::vector{kLargestLoad}).last.value();
    const double fold_area = area_from_radius(radius_from_edge_load(last.y_bottom, P));
    const std::vector<double> loads{P, P}, shears{last.T_bottom * (1 + 5e-10), last.T_bottom * (1 + 2e-9)};
    const auto areas = predicted_areas(model, {p, {}}, loads, shears);
    const PredictedArea at = areas[0], beyond = areas[1];
    EXPECT_EQ(at.state, PredictedArea::State::equilibrium);
    EXPECT_EQ(beyond.state, PredictedArea::State::beyond_fold);
    EXPECT_DOUBLE_EQ(at.value, fold_area);
    EXPECT_DOUBLE_EQ(beyond.value, fold_area);
  }
}

/// Areas with scatter, up to the folds that lambda = 0.7 or so has.
std::string runs_in(double per_mN, const char* force, double per_mm2, const char* area) {
  struct Run {
    double P;
    std::vector<std::pair<double, double>> points;
  };
  const std::vector<Run> runs{
      {12.717,
       {{0, 0.58561105661}, {3.2134348655, 0.5683617399}, {6.4838400511, 0.5209731728}, {9.7558541402, 0.3986356831}}},
      {5.0868,
       {{0, 0.3716583014}, {2.0989646598, 0.3474518207}, {4.2457324900, 0.3574767503}, {6.4101490401, 0.2570071845}}},
      {-0.76302,
       {{0, 0.1408366902}, {0.5222063464, 0.1423071978}, {1.0393316405, 0.1343600081}, {1.6118212598, 0.0963751056}}},
      {0,
       {{0, 0.1975728622}, {0.8819230177, 0.1876677421}, {1.7714099327, 0.1888485026}, {2.6511930219, 0.1197246313}}}};
  std::ostringstream csv;
  csv.precision(17);
  csv << "curve,P [" << force << "],T [" << force << "],A [" << area << "]\n";
  for (std::size_t r = 0; r < runs.size(); ++r)
    for (const auto& [T, A] : runs[r].points)
      csv << 'r' << r << ',' << runs[r].P * per_mN << ',' << T * per_mN << ',' << A * per_mm2 << '\n';
  return csv.str();
}

/// Each run's last load in turn at the fold, for which rounding differs from unit to unit; and the fit of all.
TEST(PredictedAreas, AndTheirGoodnessDoNotDependOnTheUnit) {
  const std::string contact = "radius=\"9.42 mm\"\nmodulus=\"2.133 MPa\"\ntoughness=\"27 mJ/m^2\"\n";
  const std::vector<std::tuple<double, const char*, double, const char*>> units{
      {1, "mN", 1, "mm^2"}, {1 / 9.80665, "gf", 0.01, "cm^2"}, {1e3, "uN", 1e6, "um^2"}, {1e-3, "N", 1e-6, "m^2"}};
  const Dataset in_mN = load_text(runs_in(1, "mN", 1, "mm^2"), contact);
  std::vector<FitOptions> cases(1);
  for (const std::size_t last : {3u, 7u, 11u, 15u}) {
    const Point& point = in_mN.points[last];
    // S0^2/T^2: the load at the fold is model c's S0/sqrt(lambda)
    const double lambda = std::pow(circle_radius(point.P) / point.T, 2);
    cases.push_back({.hold = {{"lambda", lambda}}});
  }
  for (const FitOptions& options : cases) {
    std::optional<FitResult> first;
    std::optional<LeftOut> first_left_out;
    for (const auto& [per_mN, force, per_mm2, area] : units) {
      const Dataset data = load_text(runs_in(per_mN, force, per_mm2, area), contact);
      const FitResult fit = fit_model(data, "c", options);
      const auto left_out = leave_one_load_out(data, fit, options);
      ASSERT_TRUE(fit.area && fit.area->r2 && left_out) << force;
      if (!first) first = fit, first_left_out = left_out;
      EXPECT_EQ(fit.area->predicted, first->area->predicted) << force;
      // lambda and loads are right to 1e-14 or so, and just before the fold the area goes with the square root of that
      EXPECT_NEAR(*fit.area->r2, *first->area->r2, 1e-6) << force;
      EXPECT_NEAR(left_out->rmse_area / per_mm2, first_left_out->rmse_area, 1e-6 * first_left_out->rmse_area) << force;
      EXPECT_EQ(left_out->beyond_fold, first_left_out->beyond_fold) << force;
    }
  }
}

}  // namespace predicted_area_test
}  // namespace mixity
