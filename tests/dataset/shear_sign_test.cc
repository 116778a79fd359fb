// Shear below zero: noise that is kept and counted, and runs that are reversed.
#include <gtest/gtest.h>

#include <cmath>

#include "dataset/check.h"
#include "dataset/load_text.h"
#include "dataset/signs.h"

namespace mixity {
namespace shear_sign_test {

using Notes = std::vector<std::string>;

std::vector<double> shears(const Dataset& data) {
  std::vector<double> T;
  for (const Point& point : data.points) T.push_back(point.T);
  return T;
}

TEST(ShearSign, NoiseAboutZeroIsUsedAsItIsAndCounted) {
  const Dataset data = load_text("P,T,A\n1,-0.1,19\n1,0.2,19\n1,5,18\n2,-0.3,20\n2,4,19\n");
  EXPECT_EQ(shears(data), (std::vector<double>{-0.1, 0.2, 5, -0.3, 4}));
  EXPECT_TRUE(data.excluded.empty());
  EXPECT_EQ(texts_of(data.notes), Notes{"2 of 5 points have T < 0, used as they are: equilibrium depends on T^2"});
  EXPECT_EQ(texts_of(load_text("P,T,A\n1,-0.1,19\n1,2,19\n").notes),
            Notes{"1 of 2 points has T < 0, used as it is: equilibrium depends on T^2"});
  EXPECT_TRUE(load_text("P,T,A\n1,0,19\n1,-0,19\n1,2,19\n").notes.empty());
}

TEST(ShearSign, DoesNotChangeTheToughness) {
  const Dataset data = load_text("P,T,A\n1,-2,19\n1,2,19\n");
  EXPECT_EQ(data.toughness(0)->ratio, data.toughness(1)->ratio);
  EXPECT_EQ(data.toughness(0)->mixity.cos, data.toughness(1)->mixity.cos);
  EXPECT_EQ(data.toughness(0)->mixity.sin, data.toughness(1)->mixity.sin);
  EXPECT_GT(data.toughness(0)->mixity.sin, 0);
}

TEST(ShearSign, ARunOfTheOtherDirectionIsTurnedRound) {
  const Dataset data =
      load_text("curve,P,T,A\nx,1,0,19\nx,1,3,19\ny,1,0,19\ny,1,0.4,19\ny,1,-4,18\ny,1,-2,18\nz,1,-1,19\nz,1,5,18\n");
  EXPECT_EQ(shears(data), (std::vector<double>{0, 3, 0, -0.4, 4, 2, -1, 5}));
  EXPECT_FALSE(std::signbit(data.points[2].T));
  EXPECT_EQ(texts_of(data.notes), (Notes{"a run sheared in the negative direction was reversed (T -> -T): y",
                                         "2 of 8 points have T < 0, used as they are: equilibrium depends on T^2"}));
}

TEST(ShearSign, ARunIsTurnedUpToATenthAboveZeroAndFromThreePoints) {
  const auto turned = [](const std::string& shear) {
    std::string text = "P,T,A\n";
    for (std::size_t begin = 0; begin < shear.size();) {
      const std::size_t end = std::min(shear.find(' ', begin), shear.size());
      text += "1," + shear.substr(begin, end - begin) + ",19\n";
      begin = end + 1;
    }
    return texts_of(load_text(text).notes)[0].starts_with("a run sheared in the negative direction was reversed");
  };
  EXPECT_TRUE(turned("1 -5 -10"));
  EXPECT_FALSE(turned("1.001 -5 -10"));
  EXPECT_TRUE(turned("-1 -5 -10"));
  EXPECT_FALSE(turned("-5 -10"));
  EXPECT_FALSE(turned("-5"));
  EXPECT_FALSE(turned("-5 5 0"));
}

TEST(ShearSign, NamesOfTurnedRunsAreBoundedInNumberAndLength) {
  std::string text = "curve,P,T,A\n";
  for (int run = 0; run < 7; ++run)
    for (int i = 1; i < 4; ++i)
      text += std::string(run == 1 ? 500 : 1, static_cast<char>('a' + run)) + ",1,-" + std::to_string(i) + ",19\n";
  EXPECT_EQ(texts_of(load_text(text).notes),
            Notes{"7 runs sheared in the negative direction were reversed (T -> -T): a, " + std::string(40, 'b') +
                  "..., c, d and 3 more"});
}

TEST(ShearSign, OfALeftOutPointDoesNotCount) {
  const Dataset data = load_text("P,T,A,include\n1,-1,19,1\n1,-2,19,1\n1,-3,19,1\n1,9,19,0\n");
  EXPECT_EQ(shears(data), (std::vector<double>{1, 2, 3}));
}

TEST(ShearSign, NoiseAboutZeroIsNoFallOfShear) {
  const auto order = [](const std::string& rows) {
    std::string text;
    for (const std::string& line :
         find_oddities(load_text("curve,P,T,A\n" + rows + "y,1,0,19.6\ny,1,1,19.5\ny,1,2,19.4\n")))
      if (line.starts_with("run x: T ")) text += line + "\n";
    return text;
  };
  EXPECT_EQ(order("x,5,0,23.9\nx,5,-0.1,23.9\nx,5,0.1,23.9\nx,5,-0.05,23.9\nx,5,3,23.7\n"), "");
  EXPECT_EQ(order("x,5,0,23.9\nx,5,-1,23.9\nx,5,-2,23.9\nx,5,-3,23.7\n"), "");  // turned
  EXPECT_EQ(order("x,5,0,23.9\nx,5,3,23.7\nx,5,-0.1,23.9\nx,5,2,23.7\n"),
            "run x: T falls once, first at line 5; is unloading, slip or a second run mixed in?\n");
  EXPECT_EQ(order("x,5,0,23.9\nx,5,2,23.8\nx,5,3,23.7\nx,5,-0.5,23.9\n"),
            "run x: T changes its sign, from -0.5 to 3; are runs of both directions mixed?\n");
}

TEST(ShearSign, IsThatOfReadingsWithTheStatedOffset) {
  const std::string units = "radius = \"9.42 mm\"\nmodulus = \"2.133 MPa\"\ntoughness = \"27 mJ/m^2\"\n",
                    rows = "P [mN],T [mN],A [mm^2]\n1,-3,0.3\n1,-2,0.3\n1,-1,0.3\n1,0,0.3\n1,5,0.3\n";
  EXPECT_EQ(texts_of(load_text(rows, units).notes).size(), 1);
  EXPECT_EQ(texts_of(load_text(rows, units + "shear_offset = \"3 mN\"").notes), Notes{});
  EXPECT_TRUE(texts_of(load_text(rows, units + "shear_offset = \"-6 mN\"").notes)[0].starts_with("a run sheared"));
}

TEST(ShearSign, TheAreaToCompareWithJkrIsThatNearestToZero) {
  const auto curves = summarise_curves(load_text("P,T,A\n1,-3,19\n1,0.1,19.614936466006521\n1,-0.2,19.3\n1,4,18\n"));
  ASSERT_EQ(curves.size(), 1);
  EXPECT_EQ(curves[0].T_min, -3);
  EXPECT_EQ(curves[0].T_max, 4);
  // JKR's area has 17 digits here; its radius is a root
  EXPECT_NEAR(curves[0].area_over_jkr.value(), 1, 1e-14);
}

}  // namespace shear_sign_test
}  // namespace mixity
