// Files of pull-off loads: which columns are read, in which unit, with which sign.
#include "dataset/pull_off.h"

#include <gtest/gtest.h>

#include "dataset/load_text.h"
#include "dataset/pooled.h"

namespace mixity {
namespace pull_off_test {

// R = 10 mm, E* = 1 MPa, G_Ic = 0.1 J/m^2: a unit of force is 1 mN, one of displacement R/xi^2, xi = (E* R/G)^(1/3) =
// 46.4159
const std::string kConstants = "radius = \"10 mm\"\nmodulus = \"1 MPa\"\ntoughness = \"0.1 J/m^2\"\n";

TEST(PullOffData, AreReadWithTheirErrorsAndUnits) {
  const Dataset data = load_text("P_c [mN],T [N],sigma_P [uN],sigma_T [%]\n-4.7,0,50,1\n-4.0,0.005,60,1\n", kConstants);
  EXPECT_TRUE(data.has_loads);
  EXPECT_TRUE(data.points.empty());
  ASSERT_EQ(data.pull_off.size(), 2u);
  const PullOffReading& one = data.pull_off[1];
  EXPECT_EQ(one.line, 3u);
  EXPECT_EQ(one.held, HeldShear::load);
  // the units' roundings
  EXPECT_NEAR(one.P, -4.0, 1e-14);
  EXPECT_NEAR(one.shear, 5.0, 1e-14);
  EXPECT_NEAR(one.sigma_P, 0.06, 1e-15);
  EXPECT_NEAR(one.sigma_shear, 0.05, 1e-15);
  EXPECT_EQ(data.display.force, "mN");
}

TEST(PullOffData, MayHaveADisplacementHeld) {
  const Dataset data = load_text("P_c [mN],u [um]\n-4.7,0\n-4.0 +/- 0.1,9.283\n", kConstants);
  ASSERT_EQ(data.pull_off.size(), 2u);
  EXPECT_EQ(data.pull_off[1].held, HeldShear::displacement);
  EXPECT_NEAR(data.pull_off[1].shear, 2.0, 1e-4);  // 10 mm/46.4159^2 = 4.6416 um, to the digits written here
  EXPECT_NEAR(data.pull_off[1].sigma_P, 0.1, 1e-14);
  EXPECT_EQ(data.pull_off[0].sigma_P, kNotStated);
  EXPECT_EQ(data.display.length, "um");
}

TEST(PullOffData, HaveManyNames) {
  for (const char* header :
       {"Pull-off force [mN],Shear force [mN]", "pull off load (mN);Tangential force (mN)", "P_pull_off [mN],T [mN]",
        "P_pulloff [mN],F_T [mN]", "Abreißkraft [mN],Tangentialkraft [mN]", "Pc [mN],T [mN]"}) {
    const bool semicolons = std::string(header).find(';') != std::string::npos;
    const std::string rows = semicolons ? "-4.7;0\n-4.2;3\n" : "-4.7,0\n-4.2,3\n";
    const Dataset data = load_text(header + ("\n" + rows), kConstants);
    ASSERT_EQ(data.pull_off.size(), 2u) << header;
    EXPECT_NEAR(data.pull_off[1].P, -4.2, 1e-14) << header;
    EXPECT_NEAR(data.pull_off[1].shear, 3, 1e-14) << header;
  }
  const Dataset by_displacement = load_text("pull-off force [mN],lateral displacement [mm]\n-4.7,0\n", kConstants);
  EXPECT_EQ(by_displacement.pull_off.at(0).held, HeldShear::displacement);
}

TEST(PullOffData, WithTensionPositiveAreReversed) {
  const Dataset data = load_text("P_c,T\n4.7,0\n4.0,5\n1,12\n");
  EXPECT_EQ(data.pull_off[0].P, -4.7);
  EXPECT_EQ(data.pull_off[2].P, -1);
  ASSERT_FALSE(data.notes.empty());
  EXPECT_NE(data.notes.back().text().find("tension positive"), std::string::npos);
  // at large shear pull-off under compression
  EXPECT_EQ(load_text("P_c,T\n-1,8\n2,14\n").pull_off[1].P, 2);
  EXPECT_EQ(load_text("P_c,T\n0.5,12\n2,14\n").pull_off[1].P, 2);
}

TEST(PullOffData, LeaveFilesOfAreasAsTheyAre) {
  const Dataset data = load_text("P,T,A,u,P_c\n1,0,9,0,-4\n1,2,8.9,1,-4\n");
  EXPECT_TRUE(data.pull_off.empty());
  EXPECT_EQ(data.points.size(), 2u);
  EXPECT_EQ(data.ignored_columns, (std::vector<std::string>{"u", "P_c"}));
  EXPECT_TRUE(data.notes.empty());
}

TEST(PullOffData, WithoutAShearAreRefused) {
  EXPECT_NE(load_error("P_c [mN],t [s]\n-4.7,0\n", kConstants).find("a.csv:1"), std::string::npos);
  const std::string units = load_error("P_c [mN],T\n-4.7,0\n", kConstants);
  EXPECT_NE(units.find("P_c and T or u are either all dimensionless or none is"), std::string::npos) << units;
  EXPECT_EQ(excluded_lines(load_text("P_c,T\n-4.7,0\n,1\n-4,nan\n")), "3 P_c is empty\n4 T is not finite\n");
}

TEST(PullOffData, ArePooledWithAreas) {
  const TemporaryFolder folder;
  folder.write("areas.toml", kConstants);
  const std::string areas = folder.write("areas.csv", "P [mN],T [mN],A [mm^2]\n1,0,0.5\n1,2,0.49\n"),
                    pull_off = folder.write("pull.csv", "P_c [mN],u [um]\n-4.7,0\n-4.2,5\n");
  const Dataset data = load_pooled({{areas}, {pull_off}}, {});
  EXPECT_EQ(data.points.size(), 2u);
  ASSERT_EQ(data.pull_off.size(), 2u);
  EXPECT_EQ(data.curves.size(), 1u);
  EXPECT_EQ(data.line_text(data.pull_off[1].line), "pull.csv line 3");
  EXPECT_EQ(data.display.length, "um");
  EXPECT_EQ(load_pooled({{pull_off}, {areas}}, {}).points.size(), 2u);
}

}  // namespace pull_off_test
}  // namespace mixity
