// Points that carry a fit because their stated errors are far below the others' are named before any constant.
#include "fitting/heavy_points.h"

#include <gtest/gtest.h>

#include <numeric>

#include "dataset/load_text.h"
#include "fitting/fit.h"
#include "fitting/measured_runs.h"

namespace mixity {
namespace heavy_points_test {

/// Runs with errors of 1 % in columns; point `at` has an error of A that is smaller by `factor`, and is off by `off`
/// of the others' errors.
Dataset with_one_error(std::size_t at, double factor, double off) {
  Dataset data = measured_runs(3);
  for (const Point& point : data.points) data.errors.push_back({0.01 * point.shear() + 1e-3, 0.01 * point.A, 0});
  data.points[at].A += off * data.errors[at].A;
  data.errors[at].A *= factor;
  return data;
}

TEST(HeavyPoints, AreNamedBeforeAConstant) {
  const Dataset data = with_one_error(3, 1.0 / 400, 1.5);
  const FitResult fit = fit_model(data, "c");
  ASSERT_EQ(fit.status, FitStatus::suspect);
  ASSERT_TRUE(fit.consistency && fit.consistency->heavy);
  const HeavyPoints& heavy = *fit.consistency->heavy;
  EXPECT_EQ(heavy.points, std::vector<std::size_t>{3});
  EXPECT_EQ(heavy.column, "sigma_A");
  EXPECT_GT(heavy.share, 0.5);
  EXPECT_LT(heavy.share, 1);
  const std::string line = std::to_string(data.points[3].line);
  EXPECT_TRUE(fit.message.text().starts_with("line " + line + " carries ")) << fit.message.text();
  EXPECT_TRUE(fit.message.text().ends_with("exclude = \"" + line + "\"")) << fit.message.text();
}

/// The remedy leads to a fit that is believed.
TEST(HeavyPoints, LeftOutLeaveAFitThatIsBelieved) {
  const Dataset data = with_one_error(3, 1.0 / 400, 1.5);
  std::vector<std::size_t> others(data.points.size());
  std::iota(others.begin(), others.end(), std::size_t{0});
  others.erase(others.begin() + 3);
  const FitResult fit = fit_model(data, "c", {}, &others);
  EXPECT_EQ(fit.status, FitStatus::ok) << fit.message.text();
  EXPECT_FALSE(fit.consistency->heavy);
}

TEST(HeavyPoints, AreNoneWhereErrorsDifferAsThoseOfOneInstrument) {
  EXPECT_FALSE(fit_model(with_one_error(3, 0.5, 0), "c").consistency->heavy);
}

/// An error of A that is tiny carries nothing where that of T decides how far the point is from the curve.
TEST(HeavyPoints, AreWeighedByBothErrors) {
  constexpr std::size_t kSteep = 13;  // near the end of the first run
  Dataset data = with_one_error(kSteep, 1.0 / 400, 0);
  data.errors[kSteep].T *= 100;
  const FitResult fit = fit_model(data, "c");
  ASSERT_TRUE(fit.consistency);
  EXPECT_FALSE(fit.consistency->heavy);
}

TEST(HeavyPoints, OfEnergiesAreNamed) {
  const Dataset data = load_text(
      "G_I [J/m^2],G_II [J/m^2],sigma_GI [J/m^2],sigma_GII [J/m^2]\n"
      "300,0.1,10,10\n290,40,10,10\n260,120,10,10\n220,250,0.02,0.02\n150,420,10,10\n60,700,10,10\n1,850,10,10\n",
      "toughness = \"300 J/m^2\"\n");
  FitOptions options;
  options.objective = Objective::curve;
  const FitResult fit = fit_model(data, "c", options);
  ASSERT_TRUE(fit.consistency && fit.consistency->heavy) << fit.message.text();
  EXPECT_EQ(fit.consistency->heavy->points, std::vector<std::size_t>{3});
  EXPECT_DOUBLE_EQ(fit.consistency->heavy->ratio, 0.002);
}

}  // namespace heavy_points_test
}  // namespace mixity
