// The axes of elliptic contacts in the forms that cameras and image programs write.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "dataset/dataset.h"
#include "dataset/temporary_folder.h"

namespace mixity {
namespace axes_test {

constexpr const char* kConstants = "radius = \"9.42 mm\"\nmodulus = \"2 MPa\"\ntoughness = \"27 mJ/m^2\"\n";

Dataset read(const std::string& table) {
  const TemporaryFolder folder;
  folder.write("a.toml", kConstants);
  return load_dataset(folder.write("a.csv", table));
}

/// Semi-axes of 0.27 and 0.3 mm, along and across the shear.
void expect_the_axes(const Dataset& data, const std::string& what) {
  ASSERT_EQ(data.axes.size(), 1u) << what;
  EXPECT_NEAR(data.axes[0].q, std::log(0.27 / 0.3), 1e-12) << what;
  EXPECT_NEAR(data.points[0].A * data.contact->area_unit(), std::numbers::pi * 0.27e-3 * 0.3e-3, 1e-12) << what;
}

TEST(Axes, AreReadInAnyForm) {
  expect_the_axes(read("P [mN],T [mN],a_par [mm],a_perp [mm]\n4,2,0.27,0.3\n"), "semi-axes");
  expect_the_axes(read("P [mN],T [mN],d_par [um],d_perp [mm]\n4,2,540,0.6\n"), "diameters");
  expect_the_axes(read("P [mN],T [mN],Major [mm],Minor [mm],Angle\n4,2,0.6,0.54,90\n"), "ImageJ, across");
  expect_the_axes(read("P [mN],T [mN],Major [mm],Minor [mm],Angle [rad]\n4,2,0.6,0.54,1.5707963267948966\n"),
                  "radians");
  expect_the_axes(read("P [mN],T [mN],Major [mm],Minor [mm]\n4,2,0.6,0.54\n"), "without an angle");
  expect_the_axes(read("P [mN],T [mN],Area [mm^2],Major,Minor,Angle\n4,2,0.254469004940773,0.6,0.54,90\n"),
                  "beside an area, without a unit");
  expect_the_axes(read("P [mN],T [mN],a [mm],b [mm]\n4,2,0.27,0.3\n"), "as predict writes them");
  const Dataset along = read("P [mN],T [mN],Major [mm],Minor [mm],Angle\n4,2,0.6,0.54,180\n");
  EXPECT_NEAR(along.axes[0].q, std::log(0.6 / 0.54), 1e-12);
}

TEST(Axes, HaveTheErrorsThatAreStated) {
  const Dataset data =
      read("P [mN],T [mN],a_par [mm],a_perp [mm],sigma_a_par [mm],sigma_a_perp [%]\n4,2,0.27,0.3,0.0027,2\n");
  EXPECT_NEAR(data.axes[0].sigma_q, std::hypot(0.01, 0.02), 1e-12);
  EXPECT_NEAR(data.axes[0].correlation, (0.01 * 0.01 - 0.02 * 0.02) / (0.01 * 0.01 + 0.02 * 0.02), 1e-12);
  EXPECT_NEAR(data.errors_of(0).A / data.points[0].A, std::hypot(0.01, 0.02), 1e-12);
  EXPECT_EQ(texts_of(data.notes).size(),
            1u);  // on the axes: these errors stand in columns, not in the fields of values
  const Dataset of_cells = read("P [mN],T [mN],d_par [mm],d_perp [mm]\n4,2,0.54 +/- 0.0054,0.6 +/- 2%\n");
  EXPECT_NEAR(of_cells.axes[0].sigma_q, std::hypot(0.01, 0.02), 1e-12);
  // under the names of the axes: those of whole axes are twice as large
  for (const std::string table :
       {"a [mm],b [mm],sigma_a [mm],sigma_b [%]\n4,2,0.27,0.3,0.0027,2",
        "d_par [mm],d_perp [mm],sigma_d_par [mm],sigma_d_perp [%]\n4,2,0.54,0.6,0.0054,2",
        "Minor [mm],Major [mm],sigma_Minor [um],sigma_Major [mm]\n4,2,0.54,0.6,5.4,0.012",
        "d_par [mm],d_perp [mm],sigma_a_par [mm],sigma_a_perp [mm]\n4,2,0.54,0.6,0.0027,0.006"})
    EXPECT_NEAR(read("P [mN],T [mN]," + table + "\n").axes[0].sigma_q, std::hypot(0.01, 0.02), 1e-12) << table;
  EXPECT_TRUE(std::isnan(read("P [mN],T [mN],a_par [mm],a_perp [mm]\n4,2,0.27,0.3\n").axes[0].sigma_q));
}

TEST(Axes, WhoseErrorIsOfNoColumnSaySo) {
  const Dataset data = read("P [mN],T [mN],a [mm],sigma_a [mm]\n4,2,0.27,0.0027\n");
  ASSERT_FALSE(data.notes.empty());
  EXPECT_EQ(data.notes.back().text(),
            "column 'sigma_a' is not used: it is the standard error of no column that is read");
}

/// The image is turned by 30 degrees: the axes lie at 30 and 120. Nearly round contacts have any direction.
TEST(Axes, OfTurnedImagesAreNamed) {
  const auto says = [](const std::string& rows) {
    const Dataset data = read("P [mN],T [mN],Major [mm],Minor [mm],Angle\n" + rows);
    for (const std::string& note : texts_of(data.notes))
      if (note.find("degrees from the shear") != std::string::npos) return note;
    return std::string();
  };
  EXPECT_NE(says("4,0,0.6,0.598,35\n4,2,0.6,0.56,120\n4,3,0.6,0.54,120\n").find("30 degrees"), std::string::npos);
  EXPECT_EQ(says("4,0,0.6,0.598,35\n4,2,0.6,0.56,91\n4,3,0.6,0.54,88\n"), "");
  EXPECT_EQ(says("4,0,0.6,0.598,20\n4,1,0.6,0.598,80\n4,2,0.6,0.598,40\n4,3,0.6,0.598,150\n"), "");
}

/// Half of the difference of axes at 30 degrees lies along the shear: as ratios of a and b they would be wrong.
TEST(Axes, OfTurnedImagesAreNotUsed) {
  std::string turned = "P [mN],T [mN],Major [mm],Minor [mm],Angle\n", round = turned;
  for (int i = 0; i < 20; ++i) {
    const std::string row = "4," + std::to_string(i) + ",0.6,0.5" + std::to_string(99 - 2 * i) + ",";
    turned += row + std::to_string(i < 4 ? 120 - 30 * i : 120 + i % 3) + "\n";
    round += row + std::to_string(15 * i) + "\n";
  }
  const Dataset data = read(turned);
  EXPECT_TRUE(data.axes.empty());
  EXPECT_EQ(data.points.size(), 20u);
  EXPECT_TRUE(texts_of(data.notes).back().ends_with("until then only the areas are used"));
  EXPECT_EQ(read(round).axes.size(), 20u);
}

/// Those of scikit-image's regionprops, in rad: as degrees every contact would be long along the shear.
TEST(Axes, WhoseAnglesMayBeInRadiansAreNotUsedUntilTheUnitIsStated) {
  const auto table = [](const std::string& heading) {
    std::string text = "P [mN],T [mN],major_axis_length [mm],minor_axis_length [mm]," + heading + "\n";
    for (int i = 0; i < 8; ++i)
      text += "4," + std::to_string(i) + ",0.6,0.5" + std::to_string(99 - 2 * i) + ",1.5" + std::to_string(i) + "\n";
    return read(text);
  };
  const Dataset unstated = table("orientation");
  EXPECT_TRUE(unstated.axes.empty());
  EXPECT_EQ(unstated.points.size(), 8u);
  EXPECT_NE(texts_of(unstated.notes).back().find("no angle exceeds 1.57"), std::string::npos)
      << texts_of(unstated.notes).back();
  ASSERT_EQ(table("orientation [rad]").axes.size(), 8u);
  EXPECT_LT(table("orientation [rad]").axes[0].q, 0);
  ASSERT_EQ(table("Angle [deg]").axes.size(), 8u);
  EXPECT_GT(table("Angle [deg]").axes[0].q, 0);
}

/// A table's `b` of another kind leaves `a` a radius.
TEST(Axes, AreNotMadeOfARadiusAndANumber) {
  EXPECT_TRUE(read("P [mN],T [mN],a [mm],b [N]\n4,2,0.27,0.3\n").axes.empty());
  EXPECT_TRUE(read("P [mN],T [mN],a [mm],b\n4,2,0.27,0.3\n").axes.empty());
}

TEST(Axes, WhoseAreaIsNotThatOfTheColumnSaySo) {
  const std::string header = "P [mN],T [mN],A [mm^2],a_par [mm],a_perp [mm]\n4,0,0.2545,0.27,0.3\n";
  EXPECT_EQ(texts_of(read(header + "4,2,0.28,0.27,0.3\n4,3,0.27,0.27,0.3\n").notes).back(),
            "the area A is up to 10% larger than pi a b of the axes (line 3); A is used, and of the axes only their "
            "ratio");
  EXPECT_NE(texts_of(read("P [mN],T [mN],A [mm^2],a [um],b [mm]\n4,0,0.2545,540,0.6\n").notes)
                .back()
                .find("the area A is up to 75% smaller than pi a b of the axes (line 2)"),
            std::string::npos);
  // two measurements of one contact scatter; axes in pixels have no area
  for (const std::string& table : {header + "4,2,0.26,0.27,0.3\n",
                                   std::string("P [mN],T [mN],Area [mm^2],Major,Minor,Angle\n4,2,0.28,600,540,90\n")})
    EXPECT_EQ(texts_of(read(table).notes).back().find("pi a b"), std::string::npos) << table;
}

TEST(Axes, OfTablesWithoutAreNotThere) { EXPECT_TRUE(read("P [mN],T [mN],A [mm^2]\n4,2,0.27\n").axes.empty()); }

}  // namespace axes_test
}  // namespace mixity
