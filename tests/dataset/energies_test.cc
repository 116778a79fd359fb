// Energies of the two modes: what they are converted to, in which unit, and what is said of them.
#include "dataset/energies.h"

#include <gtest/gtest.h>

#include <cmath>

#include "dataset/check.h"
#include "dataset/load_text.h"

namespace mixity {
namespace energies_test {

void near(double value, double wanted) {
  EXPECT_NEAR(value, wanted, 1e-15 * std::abs(wanted));  // a few roundings of 1.1e-16
}

TEST(Energies, AreAToughnessAtAModeRatio) {
  const std::string toml = "toughness = \"0.5 N/mm\"";
  const Dataset energies = load_text("G_I [N/mm],G_II [kJ/m^2],curve\n0.6,0.2,x\n0.3,1.2,y\n", toml),
                converted = load_text("mode_ratio,Gc [N/mm]\n0.25,0.8\n0.8,1.5\n", toml);
  EXPECT_TRUE(energies.has_energies);
  EXPECT_FALSE(energies.has_loads);
  EXPECT_TRUE(energies.toughness_known);
  ASSERT_EQ(energies.points.size(), 2);
  ASSERT_EQ(energies.energies.size(), 2);
  for (std::size_t i = 0; i < 2; ++i) {
    near(energies.toughness(i)->ratio, converted.toughness(i)->ratio);
    near(energies.toughness(i)->mixity.cos, converted.toughness(i)->mixity.cos);
    near(energies.toughness(i)->mixity.sin, converted.toughness(i)->mixity.sin);
  }
  near(energies.energies[0].G_I, 1.2);
  near(energies.energies[0].G_II, 0.4);
  EXPECT_EQ(energies.curves, (std::vector<std::string>{"x", "y"}));
  EXPECT_EQ(energies.points[1].curve, 1);
  EXPECT_EQ(energies.display.energy, "N/mm");
  near(energies.display.energy_scale, 0.5);
  EXPECT_TRUE(energies.errors.empty());
  EXPECT_FALSE(converted.has_energies);
  EXPECT_TRUE(converted.energies.empty());
  near(converted.display.energy_scale, 0.5);
}

TEST(Energies, KeepTheirStandardErrorsInUnitsOfTheToughness) {
  const Dataset data = load_text(
      "G_I [J/m^2],G_II [J/m^2],sigma_GI [mJ/m^2],sigma_GII [%]\n"
      "60,40,6000,20\n60,40,,\n60,-4,,10\n60,40,-1,\n60,40,,-1\n",
      "toughness = \"20 J/m^2\"");
  ASSERT_EQ(data.energies.size(), 3);
  near(data.energies[0].sigma_GI, 0.3);
  near(data.energies[0].sigma_GII, 0.4);
  near(data.errors_of(0).ratio, 0.5);  // 3, 4, 5
  EXPECT_EQ(data.energies[1].sigma_GI, kNotStated);
  EXPECT_EQ(data.errors_of(1).ratio, 0);
  near(data.energies[2].sigma_GII, 0.02);
  EXPECT_EQ(excluded_lines(data), "5 sigma_GI < 0\n6 sigma_GII < 0\n");
}

TEST(Energies, BelowZeroAreNoiseAboutIt) {
  const Dataset data = load_text("G_I,G_II\n1,-0.01\n-0.02,2\n1,1\n0,0\n-1,0.5\n1,-1\n");
  ASSERT_EQ(data.points.size(), 3);
  EXPECT_EQ(data.toughness(0)->mixity.cos, 1);
  EXPECT_EQ(data.toughness(0)->mixity.sin, 0);
  EXPECT_EQ(data.toughness(0)->ratio, 0.99);
  EXPECT_EQ(data.toughness(1)->mixity.cos, 0);
  EXPECT_EQ(data.toughness(1)->mixity.sin, 1);
  EXPECT_EQ(data.toughness(1)->ratio, 1.98);
  EXPECT_EQ(data.energies[0].G_II, -0.01);
  EXPECT_EQ(data.energies[1].G_I, -0.02);
  EXPECT_EQ(excluded_lines(data), "5 G_I + G_II <= 0\n6 G_I + G_II <= 0\n7 G_I + G_II <= 0\n");
  EXPECT_EQ(texts_of(data.notes),
            std::vector<std::string>{"2 of 3 points have G_I or G_II < 0 (noise about zero): they are used as pure "
                                     "mode II or I with toughness G_I + G_II"});
}

TEST(Energies, ThatCannotBeUsedAreListed) {
  EXPECT_EQ(excluded_lines(load_text("G_I,G_II,include\n,1,1\n1,nan,1\n1,1,0\n1e80,1,1\n1,-1e80,1\n1e-80,1e-90,1\n"
                                     "1,2,1\n")),
            "2 G_I is empty\n3 G_II is not finite\n4 include = 0\n5 G_I is out of range\n6 G_II is out of range\n"
            "7 the toughness ratio is out of range\n");
}

TEST(Energies, WithoutAUnitAreThoseOverTheToughness) {
  const Dataset data = load_text("G_I,G_II\n1.5,0.5\n");
  EXPECT_TRUE(data.toughness_known);
  EXPECT_EQ(data.toughness(0)->ratio, 2);
  EXPECT_EQ(data.display.energy, "");
  EXPECT_EQ(data.display.energy_scale, 1);
}

TEST(Energies, TakeTheLargestOfModeOneForAToughnessThatIsNotStated) {
  const std::string text = "G_I [N/mm],G_II [N/mm],sigma_GI [N/mm]\n0.1,0.3,0.02\n0.5,-0.1,0.04\n0.2,0.1,0\n";
  const Dataset open = load_text(text), stated = load_text(text, "toughness = \"0.5 N/mm\"");
  EXPECT_FALSE(open.toughness_known);
  EXPECT_FALSE(open.metadata.toughness);
  ASSERT_EQ(open.energies.size(), 3);
  EXPECT_EQ(open.energies[1].G_I, 1);
  for (std::size_t i = 0; i < 3; ++i) {
    near(open.energies[i].G_I, stated.energies[i].G_I);
    near(open.energies[i].G_II, stated.energies[i].G_II);
    near(open.energies[i].sigma_GI, stated.energies[i].sigma_GI);
    near(open.toughness(i)->ratio, stated.toughness(i)->ratio);
    near(open.toughness(i)->mixity.sin, stated.toughness(i)->mixity.sin);
    near(open.errors_of(i).ratio, stated.errors_of(i).ratio);
  }
  near(open.display.energy_scale, 0.5);
  ASSERT_EQ(open.notes.size(), 3);
  EXPECT_EQ(
      texts_of(open.notes)[0],
      "toughness is not stated and has to be fitted (--free=toughness); where it is not, the largest G_I, 0.5 N/mm, "
      "stands for it");
  EXPECT_EQ(texts_of(open.notes)[2],
            "1 error of G_I or G_II is stated as 0: objective curve replaces it by 0.01 % of the largest energy");
}

TEST(Energies, ThatTheUnitOfOthersPutsOutOfRangeAreListedInTheOrderOfTheFile) {
  const Dataset data = load_text("G_I [J/m^2],G_II [J/m^2]\n1e60,0\n1e-30,0\n,1\n1,1\n");
  EXPECT_EQ(excluded_lines(data), "3 the toughness ratio is out of range\n4 G_I is empty\n");
  ASSERT_EQ(data.points.size(), 2);
  EXPECT_EQ(data.points[1].line, 5);
  near(data.energies[1].G_I, 1e-60);
  EXPECT_EQ(data.rows, 4);
}

TEST(Energies, OfModeTwoAloneNeedAToughness) {
  const std::string csv = "G_I [J/m^2],G_II [J/m^2]\n0,1\n-0.1,2\n";
  EXPECT_EQ(
      load_error(csv),
      "a.csv: the constant toughness is missing, and no G_I above 0 can stand for it: state it in a.toml or by a flag "
      "(--toughness=...)");
  EXPECT_EQ(load_text(csv, "toughness = \"1 J/m^2\"").points.size(), 2);
  EXPECT_EQ(load_text("G_I [J/m^2],G_II [J/m^2]\n,1\n").points.size(), 0);  // nothing to make dimensionless
}

TEST(Energies, AreOddWhereTheyRepeatOrStartOffTheToughness) {
  const std::string csv = "G_I [J/m^2],G_II [J/m^2]\n9,0\n3,-0.5\n3,-0.4\n3,-0.5\n",
                    measured = "provenance = \"measured\"\n";
  const auto odd = find_oddities(load_text(csv, measured + "toughness = \"3 J/m^2\""));
  ASSERT_EQ(odd.size(), 3);
  EXPECT_EQ(odd[0], "line 2: Gc/GIc is 3 near psi = 0, where it must be 1; is toughness (G_Ic) right?");
  EXPECT_EQ(odd[1], "line 5 repeats line 3");
  const auto open = find_oddities(load_text(csv, measured));  // no G_Ic to be off
  ASSERT_EQ(open.size(), 3);
  EXPECT_EQ(open[0], "line 5 repeats line 3");
  EXPECT_TRUE(open[1].starts_with("toughness is not stated")) << open[1];
}

TEST(Energies, AndOtherSetsOfColumnsAreNotMixed) {
  const std::string mixes = "a.csv:1:1: the header mixes ";
  EXPECT_EQ(load_error("G_I,P\n1,1\n"), mixes + "loads (P, T, A) with energies (G_I, G_II); give one set");
  EXPECT_EQ(load_error("G_I,G_II,Gc\n1,1,1\n"), mixes + "toughness (psi, Gc) with energies (G_I, G_II); give one set");
  EXPECT_EQ(load_error("G_I,G_II,Gc,T\n1,1,1,1\n"),
            mixes + "loads (P, T, A) with toughness (psi, Gc) with energies (G_I, G_II); give one set");
  EXPECT_EQ(load_error("G_II\n1\n"), "a.csv:1:1: column 'G_I' is missing");
  EXPECT_EQ(load_error("G_I\n1\n"), "a.csv:1:1: column 'G_II' is missing");
  EXPECT_EQ(load_error("G_I [J/m^2],G_II\n1,1\n"),
            "a.csv:1:13: column 'G_II' has no unit while G_I has one; G_I and G_II either both have a unit or neither "
            "has; say its unit: --columns=\"G_II=G_II (J/m^2)\"");
  EXPECT_EQ(load_error("G_I,G_II,sigma_GII [J/m^2]\n1,1,1\n"),
            "a.csv:1:10: column 'sigma_GII' has a unit while G_II has none; a standard error has the kind of unit of "
            "its quantity, or %");
  EXPECT_EQ(load_error("G_I [mN],G_II\n1,1\n"),
            "a.csv:1:1: unit 'mN' of column 'G_I' does not fit; wanted an energy per area such as mJ/m^2, or no unit "
            "if dimensionless");
  EXPECT_EQ(load_error("G_I [mJ/m^2],G_II [mJ/m^2]\n1,1\n", "toughness = \"1e75 J/m^2\""),
            "a.csv: the unit of G_I is out of range beside the toughness");
}

}  // namespace energies_test
}  // namespace mixity
