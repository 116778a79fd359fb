#include "dataset/check.h"

#include <gtest/gtest.h>

#include "dataset/load_text.h"
#include "dataset/temporary_folder.h"

namespace mixity {
namespace check_test {

using Lines = std::vector<std::string>;

// JKR areas at two dimensionless loads, from 40-digit arithmetic.
constexpr double kJkr1 = 19.614936466006520661, kJkr5 = 23.887269575794426095;

Dataset load(const std::string& csv, Overrides overrides = {}) {
  overrides.emplace_back("provenance", "measured");
  return load_text(csv, "", overrides);
}

Lines oddities(const std::string& csv, const Overrides& overrides = {}) { return find_oddities(load(csv, overrides)); }

/// Two healthy runs at P = 1 and P = 5, with all loads and all areas multiplied by a factor.
std::string two_runs(double load_factor = 1, double area_factor = 1) {
  std::string csv = "P,T,A\n";
  for (const auto& [P, A] : {std::pair{1.0, kJkr1}, {5.0, kJkr5}})
    for (const double T : {0.0, 1.0, 2.0, 3.0})
      csv += std::to_string(P * load_factor) + "," + std::to_string(T * load_factor) + "," +
             std::to_string(A * (1 - 0.001 * T * T) * area_factor) + "\n";
  return csv;
}

bool any_mentions(const Lines& lines, std::string_view words) {
  for (const std::string& line : lines)
    if (line.find(words) != std::string::npos) return true;
  return false;
}

std::string joined(const Lines& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

TEST(Check, NothingIsOddAboutHealthyRuns) { EXPECT_EQ(joined(oddities(two_runs())), ""); }

TEST(Check, ASummaryHoldsTheRangesOfEachRun) {
  const auto curves = summarise_curves(load(two_runs()));
  ASSERT_EQ(curves.size(), 2);
  EXPECT_EQ(curves[1].points, 4);
  EXPECT_EQ(curves[1].P, 5);
  EXPECT_EQ(curves[1].T_min, 0);
  EXPECT_EQ(curves[1].T_max, 3);
  // 1e-6: the areas in the file have six decimals
  EXPECT_NEAR(curves[1].A_max, kJkr5, 1e-6);
  EXPECT_NEAR(curves[1].A_min, kJkr5 * 0.991, 1e-6);
  EXPECT_NEAR(curves[1].area_over_jkr.value(), 1, 1e-7);
}

TEST(Check, ConvertedPointsHaveNoRuns) { EXPECT_TRUE(summarise_curves(load("psi,Gc\n0,1\n0.5,1.2\n")).empty()); }

TEST(Check, AreasThatAreTooLargeByAPowerOfTenAreAQuestionOfUnits) {
  for (const auto& [factor, power] : {std::pair{10.0, "10^1"}, {100.0, "10^2"}, {1000.0, "10^3"}, {1e6, "10^6"}}) {
    const Lines odd = oddities(two_runs(1, factor));
    ASSERT_EQ(odd.size(), 1) << joined(odd);
    EXPECT_EQ(odd[0],
              "units: the areas at the smallest T are about " + std::string(power) +
                  " times those of JKR; a unit of A, P, radius, modulus or toughness is probably off by a power "
                  "of ten");
  }
}

// Below Hertz no point has a phase angle.
TEST(Check, AreasThatAreTooSmallByAPowerOfTenAreAQuestionOfUnits) {
  for (const double factor : {0.1, 0.01, 1e-3, 1e-6}) {
    const Lines odd = oddities(two_runs(1, factor));
    EXPECT_TRUE(any_mentions(odd, "unit")) << factor << "\n" << joined(odd);
  }
}

TEST(Check, LoadsThatAreOffByAThousandAreNoticed) {
  EXPECT_TRUE(any_mentions(oddities(two_runs(1e3)), "unit"));
  // Loads a thousand times too small compare the area of P = 5 with that of P = 0.005: 23.887/18.374 = 1.3000.
  EXPECT_EQ(joined(oddities(two_runs(1e-3))),
            "run P=0.005: the area at the smallest T is 1.3 times that of JKR at this load\n"
            "units: psi stays below 0.005 rad, as if there were no shear; the unit of T is probably off by a power of "
            "ten\n");
}

TEST(Check, ADataSetWithoutAUsablePointIsOdd) {
  EXPECT_FALSE(oddities("P,T,A\n1,nan,20\n1,1,-20\n").empty());
  EXPECT_FALSE(oddities("psi,Gc\nnan,1\n0.1,-1\n").empty());
}

TEST(Check, AreasThatDoNotExceedThoseOfHertzAreCounted) {
  // Hertz has 2.5933 at P = 1
  EXPECT_EQ(joined(oddities(two_runs() + "1,4,2.59\n1,5,2.6\n")),
            "areas that do not exceed that of Hertz at their load (y <= 0): 1 of 10, first in line 10; objective "
            "toughness leaves such points out\n");
  EXPECT_TRUE(any_mentions(oddities("P,T,A\n1,0,2.5\n1,1,2.4\n1,2,2.7\n"),
                           "units: 2 of 3 areas do not exceed that of Hertz at their load; a unit of A"));
}

TEST(Check, FallingShearIsReportedWithItsFirstLine) {
  const Lines odd = oddities(
      "curve,P,T,A\nup,1,0,19.6\nup,1,1,19.5\nother,5,0,23.9\nup,1,0.5,19.55\nother,5,1,23.8\n"
      "up,1,2,19.4\nup,1,1.5,19.45\nother,5,2,23.7\n");
  ASSERT_EQ(odd.size(), 1) << joined(odd);
  EXPECT_EQ(odd[0], "run up: T falls 2 times, first at line 5; is unloading, slip or a second run mixed in?");
}

TEST(Check, APointThatStandsTwiceIsReportedWithBothLines) {
  EXPECT_EQ(joined(oddities(two_runs() + "5,3,23.672284\n# comment\n5,4,23.5\n5,4,23.5\n")),
            "line 10 repeats line 9\nline 13 repeats line 12\n");
  EXPECT_EQ(joined(oddities("psi,Gc\n0,1\n0.5,1.2\n0.5,1.3\n0.5,1.2\n")), "line 5 repeats line 3\n");
}

TEST(Check, RunsOfTooFewPointsAreNamed) {
  const std::string odd = joined(oddities(two_runs() + "2,0,20.7\n3,0,21.8\n3,1,21.7\n"));
  EXPECT_EQ(odd, "run P=2 has only 1 usable point\nrun P=3 has only 2 usable points\n");
}

TEST(Check, ARunWithoutAPointNearNoShearIsNamed) {
  EXPECT_EQ(joined(oddities(two_runs() + "2,1,20.7\n2,2,20.6\n2,3,20.5\n")),
            "run P=2 has no point near T = 0 to compare with JKR\n");
}

TEST(Check, AnAreaUnlikeThatOfJkrIsNamed) {
  EXPECT_EQ(joined(oddities(two_runs() + "2,0,40\n2,1,39\n2,2,38\n")),
            // JKR at P = 2 has 20.774557 (40 digits): 40/20.774557 = 1.92543
            "run P=2: the area at the smallest T is 1.93 times that of JKR at this load\n");
}

TEST(Check, ALoadThatVariesWithinARunIsNamed) {
  EXPECT_EQ(joined(oddities("curve,P,T,A\nx,1,0,19.6\nx,1.5,1,20\nx,1,2,19.5\ny,5,0,23.9\ny,5,1,23.8\ny,5.1,2,23.7\n")),
            "run x: the load varies from 1 to 1.5 within the run\n");
}

TEST(Check, ManyRunsOfOnePointDoNotHideALoadThatVaries) {
  std::string csv = "curve,P,T,A\n";
  for (int i = 0; i < 8; ++i) csv += std::to_string(i) + ",1,1,19\n";
  const std::string odd = joined(find_oddities(load_text(csv + "mixed,1,0,19\nmixed,9,1,30\n")));
  EXPECT_NE(odd.find("8 of 9 runs have one point"), std::string::npos) << odd;
  EXPECT_NE(odd.find("run mixed: the load varies from 1 to 9"), std::string::npos) << odd;
}

TEST(Check, ALoadBelowPullOffIsNamed) {
  // Pull-off is at -3 pi/2 = -4.712
  EXPECT_EQ(joined(oddities(two_runs() + "-5,0,9\n-5,1,8.9\n-5,2,8.8\n")),
            "run P=-5: the load lies below the JKR pull-off load, -3 pi/2 R G_Ic; if the file has compression as "
            "negative, its P are to be multiplied by -1\n");
}

TEST(Check, OneLoadAloneIsAMissedChance) {
  EXPECT_EQ(joined(oddities("P,T,A\n1,0,19.6\n1,1,19.5\n1,2,19.4\n")),
            "there is only one load, so a dependence of lambda on load cannot be detected\n");
}

TEST(Check, AnglesBeyondARightAngleAreAQuestionOfDegrees) {
  EXPECT_EQ(joined(oddities("psi,Gc\n0,1\n20,1.1\n40,1.4\n")),
            "psi leaves 0..90 degrees 2 times; is its unit rad where deg was meant?\n");
}

TEST(Check, ToughnessAtPureModeOneIsOne) {
  EXPECT_EQ(joined(oddities("psi [deg],Gc\n0,1\n30,1.2\n")), "");
  EXPECT_EQ(joined(oddities("psi [deg],Gc\n0,969\n30,1103\n")),
            "line 2: Gc/GIc is 969 near psi = 0, where it must be 1; is toughness (G_Ic) right?\n");
}

TEST(Check, StandardErrorsOfSomePointsOnlyAreMentioned) {
  EXPECT_EQ(joined(oddities("psi,Gc\n0,1\n1,2\n")), "");
  EXPECT_EQ(joined(oddities("G_I,G_II,sigma_GI,sigma_GII\n1,0,0.1,0.1\n1,1,0.1,\n1,2,0,\n")),
            "sigma_GII is empty at 2 of 3 points, first in line 3; a fit that needs it refuses the file\n"
            "1 error of G_I or G_II is stated as 0: objective curve replaces it by 0.01 % of the largest energy\n");
}

TEST(Check, UnusedColumnsAndUnstatedProvenanceAreMentioned) {
  const TemporaryFolder folder;
  EXPECT_EQ(joined(find_oddities(load_dataset(folder.write("a.csv", "psi,Gc,temperature [C]\n0,1,20\n")))),
            "column 'temperature' is not used\nthe provenance of the data is not stated\n");
}

}  // namespace check_test
}  // namespace mixity
