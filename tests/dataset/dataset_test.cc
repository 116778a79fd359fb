#include "dataset/dataset.h"

#include <gtest/gtest.h>

#include <cmath>

#include "dataset/temporary_folder.h"

namespace mixity {
namespace {

const std::string kMergel = "radius = \"9.42 mm\"\nmodulus = \"2.133 MPa\"\ntoughness = \"27 mJ/m^2\"\n";

Dataset load(const std::string& csv, const std::string& toml = "", const Overrides& overrides = {}) {
  const TemporaryFolder folder;
  folder.write("a.toml", toml);
  return load_dataset(folder.write("a.csv", csv), overrides);
}

/// The error with the folder left out: "a.csv:2:3: ...".
std::string error_of(const std::string& csv, const std::string& toml = "", const Overrides& overrides = {}) {
  const TemporaryFolder folder;
  folder.write("a.toml", toml);
  const std::string path = folder.write("a.csv", csv);
  return folder.left_out_of(input_error([&] { load_dataset(path, overrides); }));
}

std::string excluded_lines(const Dataset& data) {
  std::string text;
  for (const Excluded& excluded : data.excluded) text += std::to_string(excluded.line) + " " + excluded.reason + "\n";
  return text;
}

/// 1e-12 is what the same data in other units must agree to: some ten roundings of 1.1e-16, magnified by the
/// difference y = 4/3 a^3 - P, which loses less than two digits in these points.
void expect_same_points(const Dataset& one, const Dataset& other) {
  const auto near = [](double x, double y) { EXPECT_NEAR(x, y, 1e-12 * std::abs(x)); };
  ASSERT_EQ(one.points.size(), other.points.size());
  for (std::size_t i = 0; i < one.points.size(); ++i) {
    const Point &p = one.points[i], &q = other.points[i];
    near(p.P, q.P);
    near(p.T, q.T);
    near(p.A, q.A);
    near(p.psi, q.psi);
    near(p.ratio, q.ratio);
    near(p.sigma_T, q.sigma_T);
    near(p.sigma_A, q.sigma_A);
    EXPECT_EQ(p.curve, q.curve);
  }
}

TEST(Dataset, APointIsWhatTheEquationsSay) {
  const Dataset data = load("P [mN],T [mN],A [mm^2]\n1,0.5,0.24\n", kMergel);
  ASSERT_EQ(data.points.size(), 1);
  const Point& point = data.points[0];
  // From 40-digit arithmetic. 1e-13: some ten roundings of 1.1e-16, doubled by y = 4/3 a^3 - P and its square.
  const auto near = [](double value, double expected) { EXPECT_NEAR(value, expected, 1e-13 * expected); };
  near(point.P, 3.9317449083903436345);
  near(point.T, 1.9658724541951718173);
  near(point.A, 22.210658372687063104);
  near(point.psi, 0.092758699414844447049);
  near(point.ratio, 0.95343285609058218575);
  EXPECT_EQ(point.line, 2);
}

TEST(Dataset, UnitsMakeNoDifference) {
  const Dataset data =
      load("P [mN],T [mN],A [mm^2],sigma_T [mN],sigma_A [mm^2]\n1,0,0.25,0.01,0.002\n1,0.5,0.24,0.02,0.003\n", kMergel);
  ASSERT_EQ(data.points.size(), 2);
  for (const char* csv : {
           "P [N],T [N],A [m^2],sigma_T [N],sigma_A [m^2]\n1e-3,0,0.25e-6,1e-5,2e-9\n1e-3,5e-4,2.4e-7,2e-5,3e-9\n",
           "A (um²);sigma_A (um²);P (kN);T (nN);sigma_T (µN)\n250000;2000;1e-6;0;10\n240000;3000;1e-6;500000;20\n",
           "T [mN],P [mN],sigma_A [%],A [cm^2],sigma_T [mN]\n0,1,0.8,0.0025,0.01\n0.5,1,1.25,0.0024,0.02\n",
       })
    expect_same_points(data, load(csv, kMergel));
}

TEST(Dataset, ConstantsMayBeStatedInAnyUnit) {
  const std::string csv = "P [mN],T [mN],A [mm^2]\n1,0.5,0.24\n";
  expect_same_points(load(csv, kMergel),
                     load(csv,
                          "radius = \"0.942 cm\"\nyoungs_modulus = \"1599.75 kPa\"\npoisson_ratio = 0.5\n"
                          "toughness = \"2.7e-5 N/mm\"\n"));
}

TEST(Dataset, FlagsStandInForTheToml) {
  const std::string csv = "P [mN],T [mN],A [mm^2]\n1,0.5,0.24\n";
  const Overrides constants{{"radius", "9.42 mm"}, {"modulus", "2.133 MPa"}, {"toughness", "27 mJ/m^2"}};
  expect_same_points(load(csv, kMergel), load(csv, "", constants));
  expect_same_points(load(csv, kMergel), load(csv, "radius = \"1 mm\"\n", constants));
  // One half of the modulus by flag, the other in the file: 1.59975/(1 - 0.5^2) = 2.133
  expect_same_points(load(csv, kMergel),
                     load(csv, "radius = \"9.42 mm\"\nyoungs_modulus = \"1.59975 MPa\"\ntoughness = \"27 mJ/m^2\"\n",
                          {{"poisson_ratio", "0.5"}}));
}

TEST(Dataset, ARadiusServesAsWellAsAnArea) {
  // a = sqrt(0.24/pi) = 0.27639531957706836 mm
  expect_same_points(load("P [mN],T [mN],A [mm^2]\n1,0.5,0.24\n", kMergel),
                     load("a [mm],P [mN],T [mN]\n0.27639531957706836,1,0.5\n", kMergel));
}

TEST(Dataset, DimensionlessPointsNeedNoConstants) {
  const Dataset data = load("P,T,A\n1,0,19.614936466006520661\n");  // the JKR area at P = 1, from 40 digits
  EXPECT_FALSE(data.contact);
  EXPECT_EQ(data.points[0].A, 19.614936466006520661);
  EXPECT_EQ(data.points[0].psi, 0);
  EXPECT_NEAR(data.points[0].ratio, 1, 1e-14);  // a JKR contact has G = G_Ic; a dozen roundings
}

TEST(Dataset, FileUnitsComeBackByTheDisplayScale) {
  const Dataset data = load("P [mN],T [N],A [mm^2]\n1,0.0005,0.24\n", kMergel);
  EXPECT_EQ(data.display.force, "N");
  EXPECT_EQ(data.display.area, "mm^2");
  EXPECT_NEAR(data.points[0].T * data.display.force_scale, 5e-4, 1e-18);  // some roundings of 1.1e-16
  EXPECT_NEAR(data.points[0].A * data.display.area_scale, 0.24, 1e-15);
}

TEST(Dataset, ConvertedPointsNeedNoRadius) {
  const Dataset data = load("psi [deg],Gc_over_GIc\n0,1\n30,1.25\n90,3\n");
  ASSERT_EQ(data.points.size(), 3);
  EXPECT_FALSE(data.has_loads);
  EXPECT_DOUBLE_EQ(data.points[1].psi, 0.52359877559829887308);  // pi/6; 4 ulp of a product, a sine and an arctangent
  EXPECT_EQ(data.points[1].ratio, 1.25);
  EXPECT_EQ(data.points[2].mixity.cos, 0);  // 90 degrees are pi/2, not the double next to it
  // sin^2(pi/6) = 1/4, so these are the same points; without unit an angle is in rad
  for (const char* csv :
       {"psi [rad],Gc_over_GIc\n0.52359877559829887308,1.25\n", "psi,Gc_over_GIc [%]\n0.52359877559829887,125\n",
        "mode_ratio,Gc\n0.25,1.25\n", "Gc,mode_ratio\n1.25,0.25\n"})
    EXPECT_DOUBLE_EQ(load(csv).points[0].psi, data.points[1].psi) << csv;
}

TEST(Dataset, AToughnessWithAUnitIsDividedByGIc) {
  const std::string csv = "mode_ratio,Gc [N/mm],sigma_Gc [J/m^2]\n0.5,1.131,5\n";
  const Dataset data = load(csv, "toughness = \"969 J/m^2\"\n");
  EXPECT_DOUBLE_EQ(data.points[0].ratio, 1131.0 / 969);  // 4 ulp: one product and one quotient
  EXPECT_DOUBLE_EQ(data.points[0].sigma_ratio, 5.0 / 969);
  EXPECT_EQ(error_of(csv),
            "a.csv: needs toughness to be made dimensionless: state it in a.toml or by a flag "
            "(--toughness=...)");
}

TEST(Dataset, WhatIsNeededAndNotStatedIsNamed) {
  const std::string csv = "P [mN],T [mN],A [mm^2]\n1,0.5,0.24\n";
  const auto needs = [](const std::string& key) {
    return "a.csv: needs " + key + " to be made dimensionless: state it in a.toml or by a flag (--" + key + "=...)";
  };
  EXPECT_EQ(error_of(csv), needs("radius"));
  EXPECT_EQ(error_of(csv, "radius = \"1 mm\""), needs("modulus"));
  EXPECT_EQ(error_of(csv, "radius = \"1 mm\"\nmodulus = \"1 MPa\""), needs("toughness"));
  const std::string half = error_of(csv, "radius = \"1 mm\"\nyoungs_modulus = \"1 MPa\"\ntoughness = \"1 J/m^2\"");
  EXPECT_NE(half.find("poisson_ratio"), std::string::npos) << half;
}

TEST(Dataset, PointsThatCannotBeUsedAreListedWithTheirReason) {
  const Dataset data = load(
      "P,T,A,include,sigma_A\n"
      "1,0,19,1,\n"
      "1,1,19,0,\n"         // 3
      "1,text,19,0,\n"      // 4: nobody looks
      "1,-1,19,1,\n"        // 5
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
            "3 include = 0\n4 include = 0\n5 T < 0\n"
            "6 y <= 0: the area does not exceed that of Hertz at this load, so no phase angle exists\n"
            "7 A <= 0\n8 T is not finite\n9 P is not finite\n10 A is not finite\n11 T is empty\n12 A is empty\n"
            "13 A is not finite\n14 sigma_A < 0\n15 the toughness ratio is out of range\n");
  ASSERT_EQ(data.points.size(), 2);
  EXPECT_EQ(data.points[1].line, 16);
  EXPECT_EQ(data.points[0].sigma_A, 0);
  EXPECT_EQ(data.points[1].sigma_A, 0.2);
  EXPECT_EQ(data.rows, data.points.size() + data.excluded.size());
}

TEST(Dataset, ConvertedPointsThatCannotBeUsedAreListedToo) {
  EXPECT_EQ(excluded_lines(load("psi [deg],Gc\n91,1\n-1,1\n45,0\n45,-1\nnan,1\n45,\n45,inf\n45,1\n")),
            "2 psi outside 0..90 degrees\n3 psi outside 0..90 degrees\n4 Gc <= 0\n5 Gc <= 0\n6 psi is not finite\n"
            "7 Gc is empty\n8 Gc is not finite\n");
  EXPECT_EQ(excluded_lines(load("mode_ratio,Gc\n1.01,1\n-0.1,1\n1,1\n")),
            "2 mode_ratio outside 0..1\n3 mode_ratio outside 0..1\n");
}

TEST(Dataset, ABrokenFileIsRefusedWithItsPlace) {
  for (const auto& [csv, error] : std::vector<std::pair<std::string, std::string>>{
           {"", "1:1: is empty: a header row is missing"},
           {"# note\n\n", "1:1: is empty: a header row is missing"},
           {"P,T,A\n", "2:1: has a header but no data rows"},
           {"P,T\n1,2\n", "1:1: column 'A' or 'a' is missing"},
           {"P,T,A,T\n1,2,3,4\n", "1:7: column 'T' stands twice"},
           {"P [mN],T [mm],A [mm^2]\n1,2,3\n",
            "1:8: unit 'mm' of column 'T' does not fit; wanted a force such as mN, or no unit if dimensionless"},
           {"P,T,A\n1,0,20\n1,abc,20\n", "3:3: column 'T': 'abc' is not a number"},
           {"P,T,A\r\n1,0,20\r\n1,0,2o\r\n", "3:5: column 'A': '2o' is not a number"},
           {"P;T;A\n1;0;20\n1;0,5;20\n", "3:3: column 'T': '0,5' is not a number (write a decimal point, not a comma)"},
           {"P,T,A\n1,\"0,5\",20\n", "2:3: column 'T': '0,5' is not a number (write a decimal point, not a comma)"},
           {"P,T,A\n1,0,5,20\n", "2:7: the row has more fields than the header's 3"},
           {"P,T,A\n1,0\n", "2:4: the row has 2 fields, the header 3"},
           {"curve,P,T,A\n\"two\nlines\",1,0,20\nµ,1,x,20\n", "4:5: column 'T': 'x' is not a number"},
           {"P,T,A,include\n1,0,20,yes\n", "2:8: column 'include': 'yes' is neither 0 nor 1"},
           {"P,T,A,include\n1,0,20,\n", "2:8: column 'include': '' is neither 0 nor 1"},
           {"P,T,A,sigma_T\n1,0,20,?\n", "2:8: column 'sigma_T': '?' is not a number"},
           {"P,T,A\n1,\"0,20\n", "2:1: a quote (\") is opened but not closed before the end of the file"},
       })
    EXPECT_EQ(error_of(csv), "a.csv:" + error) << csv;
}

TEST(Dataset, AMessageIsOneLineOfPrintableText) {
  for (const std::string& field : {std::string("\"a\nb\""), std::string("a\0b", 3), std::string("\x1b[31m")}) {
    const std::string error = error_of("P,T,A\n1," + field + ",20\n");
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

TEST(Dataset, EmptyFieldsBeyondTheHeaderAreHarmless) {
  EXPECT_EQ(load("P,T,A\n1,0,20,\n1,1,19,,,\n").points.size(), 2);
}

TEST(Dataset, OnePointIsADataSet) { EXPECT_EQ(load("P,T,A\n1,1,19").points.size(), 1); }

TEST(Dataset, RunsAreThoseOfTheCurveColumnElseOnePerLoad) {
  const Dataset named = load("curve,P,T,A\nx,1,0,20\ny,1,0,20\nx,5,1,25\n");
  EXPECT_EQ(named.curves, (std::vector<std::string>{"x", "y"}));
  EXPECT_EQ(named.points[2].curve, 0);
  EXPECT_EQ(named.curve_loads, (std::vector<double>{1, 1}));
  const Dataset by_load = load("P,T,A\n5,0,25\n1,0,20\n5,1,24\n");
  EXPECT_EQ(by_load.curve_loads, (std::vector<double>{5, 1}));
  EXPECT_EQ(by_load.points[2].curve, 0);
}

TEST(Dataset, AMillionRowsAreRead) {
  std::string csv = "P,T,A\n";
  for (int i = 0; i < 1000000; ++i) csv += "1," + std::to_string(i) + "e-6,19.5\n";
  const Dataset data = load(csv);
  ASSERT_EQ(data.points.size(), 1000000);
  EXPECT_EQ(data.points.back().line, 1000001);
  EXPECT_EQ(data.points.back().T, 0.999999);
  EXPECT_EQ(data.curves.size(), 1);
}

}  // namespace
}  // namespace mixity
