// Points that are left out with their reason, and files that are refused.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "dataset/dataset.h"
#include "dataset/load_text.h"
#include "dataset/temporary_folder.h"

namespace mixity {
namespace dataset_refusals_test {

TEST(Dataset, WhatIsNeededAndNotStatedIsNamed) {
  const std::string csv = "P [mN],T [mN],A [mm^2]\n1,0.5,0.24\n";
  EXPECT_EQ(load_error(csv),
            "a.csv: the constants radius, modulus, toughness are missing: state them in a.toml or by flags "
            "(--radius=..., --modulus=..., --toughness=...)");
  EXPECT_EQ(load_error(csv, "radius = \"1 mm\""),
            "a.csv: the constants modulus, toughness are missing: state them in a.toml or by flags "
            "(--modulus=..., --toughness=...)");
  EXPECT_EQ(load_error(csv, "radius = \"1 mm\"\nmodulus = \"1 MPa\""),
            "a.csv: the constant toughness is missing: state it in a.toml or by a flag (--toughness=...)");
  const std::string half = load_error(csv, "radius = \"1 mm\"\nyoungs_modulus = \"1 MPa\"\ntoughness = \"1 J/m^2\"");
  EXPECT_NE(half.find("poisson_ratio"), std::string::npos) << half;
}

TEST(Dataset, ConstantsInUnitsBesideColumnsWithoutAreRefusedWithTheUnitsToBeSaid) {
  const auto message = [](const std::string& constants, const std::string& columns,
                          const std::string& kind = "columns") {
    return "the columns have no units, but the data state " + constants + "; say the units, such as --" + kind + "=\"" +
           columns + "\", or leave out what is stated if the columns are dimensionless";
  };
  const std::string constants = "radius = \"9.42 mm\"\nmodulus = \"2 MPa\"\ntoughness = \"27 mJ/m^2\"\n";
  EXPECT_EQ(load_error("P,T,A\n1,1,19", constants),
            "a.csv:1:3: " + message("radius, modulus, toughness", "P=P (mN),T=T (mN),A=A (mm^2)"));
  EXPECT_EQ(load_error("Normal force,Shear force,diameter,T_err\n1,1,19,1", "radius = \"9 mm\""),
            "a.csv:1:14: " +
                message("radius", "P=Normal force (mN),T=Shear force (mN),diameter=diameter (mm),sigma_T=T_err (mN)"));
  EXPECT_EQ(load_error("T,A\n1,19", "load = \"5 mN\""), "a.csv:1:1: " + message("load", "T=T (mN),A=A (mm^2)"));
  EXPECT_EQ(load_error("P,T,A\n1,1,19", "load_offset = \"0 +/- 1 mN\""),
            "a.csv:1:3: " + message("load_offset", "P=P (mN),T=T (mN),A=A (mm^2)"));
  EXPECT_EQ(load_error("psi,Gc\n0.1,1", "toughness = \"27 mJ/m^2\""),
            "a.csv:1:5: " + message("toughness", "Gc=Gc (mJ/m^2)"));
  EXPECT_EQ(load_error("G_I,G_II\n1,1", "toughness = \"27 mJ/m^2\""),
            "a.csv:1:1: " + message("toughness", "G_I=G_I (mJ/m^2),G_II=G_II (mJ/m^2)"));
  // followed as it stands, the remedy is enough
  EXPECT_EQ(load_error("P,T,A\n1,1,19", constants + "columns = {P=\"P (mN)\", T=\"T (mN)\", A=\"A (mm^2)\"}\n"), "");
  for (const char* fine : {"psi,Gc_over_GIc\n0.1,1", "P [mN],T [mN],A [mm^2]\n1,1,19", "psi,Gc [J/m^2]\n0.1,1"})
    EXPECT_EQ(load_error(fine, constants), "") << fine;
  EXPECT_EQ(load_error("P,T,A\n1,1,19", "toughness = \"27 mJ/m^2\"\ntoughness_II = \"90 mJ/m^2\""), "");  // lambda
}

TEST(Dataset, PointsThatCannotBeUsedAreListedWithTheirReason) {
  const Dataset data = load_text(
      "P,T,A,include,sigma_A\n"
      "1,0,19,1,\n"
      "1,1,19,0,\n"         // 3
      "1,text,19,0,\n"      // 4: nobody looks
      "1,-1,19,1,\n"        // 5: noise about zero
      "1,1,2.59,1,\n"       // 6: Hertz has 2.5933
      "1,1,0,1,\n"          // 7
      "1,nan,19,1,\n"       // 8
      "inf,1,19,1,\n"       // 9
      "1,1,-Infinity,1,\n"  // 10
      "1,,19,1,\n"          // 11
      "1,1,,1,\n"           // 12
      "1,1,1e400,1,\n"      // 13
      "1,1,19,1,-0.1\n"     // 14
      "1,1e200,19,1,\n"     // 15
      "1,2,18,1,0.2\n");
  EXPECT_EQ(excluded_lines(data),
            "3 include = 0\n4 include = 0\n7 A <= 0\n8 T is not finite\n9 P is not finite\n10 A is not finite\n11 T is "
            "empty\n12 A is empty\n"
            "13 A is not finite\n14 sigma_A < 0\n15 P, T or A is out of range\n");
  ASSERT_EQ(data.points.size(), 4);
  EXPECT_EQ(data.points[1].line, 5);
  EXPECT_EQ(data.points[1].T, -1);
  EXPECT_EQ(data.points[2].line, 6);
  EXPECT_EQ(data.points[3].line, 16);
  EXPECT_EQ(data.errors_of(0).A, kNotStated);
  EXPECT_EQ(data.errors_of(3).A, 0.2);
  EXPECT_EQ(data.rows, data.points.size() + data.excluded.size());
}

TEST(Dataset, PointsBeyondTheRangeOfNumbersAreListed) {
  EXPECT_EQ(excluded_lines(load_text("P,T,a,sigma_T [%]\n1,1,1e200,\n1,1,1e-200,\n1,1e5,2.5,1e306\n1,1,2.5,1\n")),
            "2 P, T or A is out of range\n3 P, T or A is out of range\n4 sigma_T is out of range\n");
  // whose fourth powers are no doubles
  EXPECT_EQ(excluded_lines(load_text("P,T,A\n1,2e75,19\n-2e75,1,19\n1,1,2e75\n1,1,5e-76\n1,1,19\n1,-2e75,19\n")),
            "2 P, T or A is out of range\n3 P, T or A is out of range\n4 P, T or A is out of range\n"
            "5 P, T or A is out of range\n7 P, T or A is out of range\n");
  EXPECT_EQ(excluded_lines(load_text("psi,Gc [N/m]\n1,1e300\n1,1\n", "toughness = \"1e-20 J/m^2\"")),
            "2 the toughness ratio is out of range\n");
}

TEST(Dataset, ConstantsThatTogetherLeaveTheRangeOfNumbersAreRefused) {
  const std::string csv = "P [mN],T [mN],A [mm^2]\n1,0.5,0.24\n";
  EXPECT_EQ(load_error(csv, "radius = \"1e-200 m\"\nmodulus = \"1 Pa\"\ntoughness = \"1e-200 J/m^2\""),
            "a.csv: radius, modulus and toughness together are out of range");
  EXPECT_EQ(load_error(csv, "radius = \"1e308 GPa\""),
            "a.toml:1:10: radius is \"1e308 GPa\"; it must be a number with a unit, such as \"9.42 mm\"");
}

TEST(Dataset, AnAreaBelowHertzIsReadAndHasNoToughness) {
  const Dataset data = load_text("P,T,A\n1,1,19\n1,2,2.59\n1,3,0\n");
  EXPECT_EQ(excluded_lines(data), "4 A <= 0\n");
  ASSERT_EQ(data.points.size(), 2);
  EXPECT_EQ(data.points[1].A, 2.59);
  EXPECT_TRUE(data.toughness(0));
  EXPECT_FALSE(data.toughness(1));
}

TEST(Dataset, PhaseAnglesBelowZeroAreLeftOutWithANoteUnlessThereAreNoOthers) {
  const auto notes = [](const Dataset& data) {
    std::string text;
    for (const Message& note : data.notes) text += note.text() + "\n";
    return text;
  };
  const std::string right =
      "phase angles lie below 0 and are left out, as others lie above: whether the toughness is the "
      "same for K_II of the other sign is not known; written without their sign they are used\n";
  const Dataset both = load_text("psi [deg],Gc_over_GIc,curve\n-50,4.4,n\n-20,4.1,n\n0,4,p\n30,5.1,p\n60,11,p\n");
  EXPECT_EQ(excluded_lines(both), "2 psi < 0 beside positive phase angles\n3 psi < 0 beside positive phase angles\n");
  EXPECT_EQ(notes(both), "2 " + right);
  EXPECT_EQ(both.curves, std::vector<std::string>{"p"});
  EXPECT_EQ(both.points[2].line, 6u);
  EXPECT_EQ(both.converted.size(), 3u);
  const Dataset turned = load_text("psi [deg],Gc_over_GIc,sigma_Gc\n0,4,0.1\n-30,5.1,0.1\n-60,11,0.1\n");
  EXPECT_EQ(turned.points.size(), 3u);
  EXPECT_NEAR(turned.converted[2].psi(), std::acos(-1.0) / 3, 1e-12);  // the digits of pi
  EXPECT_EQ(notes(turned),
            "all phase angles are negative: read without their sign, as the sign of K_II does not matter\n");
  EXPECT_EQ(excluded_lines(load_text("psi [rad],Gc_over_GIc\n-2,4\n0.1,5\n")), "2 psi outside 0..90 degrees\n");
}

TEST(Dataset, ConvertedPointsThatCannotBeUsedAreListedToo) {
  EXPECT_EQ(
      excluded_lines(load_text("psi [deg],Gc\n91,1\n-1,1\n45,0\n45,-1\nnan,1\n45,\n45,inf\n45,1\n")),
      "2 psi outside 0..90 degrees\n3 psi < 0 beside positive phase angles\n4 Gc <= 0\n5 Gc <= 0\n6 psi is not finite\n"
      "7 Gc is empty\n8 Gc is not finite\n");
  EXPECT_EQ(excluded_lines(load_text("mode_ratio,Gc\n1.01,1\n-0.1,1\n1,1\n")),
            "2 mode_ratio outside 0..1\n3 mode_ratio outside 0..1\n");
}

TEST(Dataset, ABrokenFileIsRefusedWithItsPlace) {
  for (const auto& [csv, error] : std::vector<std::pair<std::string, std::string>>{
           {"", "1:1: is empty: a header row is missing"},
           {"# note\n\n", "1:1: is empty: a header row is missing"},
           {"P,T,A\n", "2:1: has a header but no data rows"},
           {"P,T\n1,2\n", "1:1: column 'A' or 'a' is missing"},
           {"P,T,A,T\n1,2,3,4\n",
            "1:7: column 'T' stands twice, in columns 2 and 4; --columns=\"T=4\" says which; if these are runs side "
            "by side, put them below one another with a column 'curve'"},
           {"P [mN],T [mm],A [mm^2]\n1,2,3\n",
            "1:8: unit 'mm' of column 'T' does not fit; wanted a force such as mN, or no unit if dimensionless"},
           {"P,T,A\n1,0,20\n1,abc,20\n", "3:3: column 'T': 'abc' is not a number"},
           {"P,T,A\r\n1,0,20\r\n1,0,2o\r\n", "3:5: column 'A': '2o' is not a number"},
           {"P,T,A\n1,0,5,20\n",
            "2:7: the row has more fields than the header's 3 (separating commas cannot be distinguished from "
            "decimal commas)"},
           {"P,T,A\n1,0\n", "2:4: the row has 2 fields, the header 3"},
           {"curve,P,T,A\n\"two\nlines\",1,0,20\nµ,1,x,20\n", "4:5: column 'T': 'x' is not a number"},
           {"P,T,A,include\n1,0,20,yes\n", "2:8: column 'include': 'yes' is neither 0 nor 1"},
           {"P,T,A,include\n1,0,20,\n", "2:8: column 'include': '' is neither 0 nor 1"},
           {"P,T,A,sigma_T\n1,0,20,?\n", "2:8: column 'sigma_T': '?' is not a number"},
           {"P,T,A\n1,\"0,20\n", "2:1: a quote (\") is opened but not closed before the end of the file"},
       })
    EXPECT_EQ(load_error(csv), "a.csv:" + error) << csv;
}

TEST(Dataset, AMessageIsOneLineOfPrintableText) {
  for (const std::string& field : {std::string("\"a\nb\""), std::string("a\0b", 3), std::string("\x1b[31m")}) {
    const std::string error = load_error("P,T,A\n1," + field + ",20\n");
    EXPECT_TRUE(error.starts_with("a.csv:2:3: column 'T': '")) << error;
    EXPECT_TRUE(error.ends_with("is not a number")) << error;
    for (const char c : error) EXPECT_FALSE(c >= 0 && c < ' ') << static_cast<int>(c);
  }
}

TEST(Dataset, FilesThatAreNotThereAreNamed) {
  const TemporaryFolder folder;
  const std::string missing = folder.path("none.csv"), too_long = folder.path(std::string(300, 'x') + ".csv");
  EXPECT_EQ(input_error([&] { load_dataset(missing); }), missing + ": cannot be opened: No such file or directory");
  EXPECT_EQ(input_error([&] { load_dataset(folder.path()); }), folder.path() + ": cannot be read: Is a directory");
  EXPECT_NO_THROW(EXPECT_NE(input_error([&] { load_dataset(too_long); }), ""));
}

}  // namespace dataset_refusals_test
}  // namespace mixity
