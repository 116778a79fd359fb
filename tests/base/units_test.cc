#include "base/units.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace mixity {
namespace units_test {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Case {
  const char* text;
  double factor;
  Dimension dimension;
};

void expect_unit(const Case& expected) {
  const auto unit = parse_unit(expected.text);
  ASSERT_TRUE(unit) << expected.text;
  // 4 ulp (EXPECT_DOUBLE_EQ): a factor is at most four roundings away, one per multiplication by a power of ten.
  EXPECT_DOUBLE_EQ(unit->factor, expected.factor) << expected.text;
  EXPECT_EQ(unit->dimension, expected.dimension) << expected.text;
}

/// Found by fuzzing: a note that names the unit has to be one line.
TEST(Units, TextOfAUnitIsOneLine) { EXPECT_EQ(parse_unit("N/\tmm")->text, "N/ mm"); }

TEST(Units, ThoseOfContactMechanicsAreKnown) {
  for (const Case& expected : {
           Case{"N", 1, dimension::force},
           Case{"mN", 1e-3, dimension::force},
           Case{"nN", 1e-9, dimension::force},
           Case{"kN", 1e3, dimension::force},
           Case{"dyn", 1e-5, dimension::force},
           Case{"NEWTON", 1, dimension::force},
           Case{"kgF", 9.80665, dimension::force},
           Case{"Sec", 1, dimension::time},
           Case{"Seconds", 1, dimension::time},
           Case{"msec", 1e-3, dimension::time},
           Case{"microns^2", 1e-12, dimension::area},
           Case{"㎟", 1e-6, dimension::area},
           Case{"gf", 9.80665e-3, dimension::force},
           Case{"m", 1, dimension::length},
           Case{"cm", 1e-2, dimension::length},
           Case{"pm", 1e-12, dimension::length},
           Case{"Pa", 1, dimension::stress},
           Case{"GPa", 1e9, dimension::stress},
           Case{"bar", 1e5, dimension::stress},
           Case{"N/mm^2", 1e6, dimension::stress},
           Case{"J/m^2", 1, dimension::energy_per_area},
           Case{"mJ/m^2", 1e-3, dimension::energy_per_area},
           Case{"N/mm", 1e3, dimension::energy_per_area},
           Case{"kJ/m²", 1e3, dimension::energy_per_area},
           Case{"erg/cm^2", 1e-3, dimension::energy_per_area},
           Case{"Pa m", 1, dimension::energy_per_area},
           Case{"rad", 1, dimension::angle},
           Case{"mrad", 1e-3, dimension::angle},
           Case{"deg", 0.017453292519943295, dimension::angle},
           Case{"°", 0.017453292519943295, dimension::angle},
           Case{"%", 0.01, dimension::none},
           Case{"1", 1, dimension::none},
       })
    expect_unit(expected);
}

TEST(Units, MicroIsUnderstoodInThreeSpellings) {
  for (const char* text : {"um", "\u00b5m", "\u03bcm"}) expect_unit({text, 1e-6, dimension::length});
}

TEST(Units, APowerIsUnderstoodInEverySpelling) {
  for (const char* text : {"mm^2", "mm2", "mm²", "mm**2", "mm mm", "mm*mm", "mm·mm", "mm^02"})
    expect_unit({text, 1e-6, dimension::area});
  for (const char* text : {"N/m^2", "N m^-2", "N m-2", "N·m⁻²", "N * m**-2", "N/m/m", "m^-2 N"})
    expect_unit({text, 1, dimension::stress});
}

TEST(Units, ASlashDividesByTheOneUnitThatFollows) {
  expect_unit({"N/m mm", 1e-3, dimension::force});
  expect_unit({"N / m / mm", 1e3, dimension::stress});
}

TEST(Units, APrefixIsNotTakenForAUnitNorAUnitForAPrefix) {
  expect_unit({"m", 1, dimension::length});    // not milli
  expect_unit({"Pa", 1, dimension::stress});   // not pico
  expect_unit({"MN", 1e6, dimension::force});  // mega and milli differ
  expect_unit({"mN", 1e-3, dimension::force});
}

TEST(Units, MayStandBehindAPowerOfTen) {
  EXPECT_EQ(parse_unit("10^-3 N")->factor, parse_unit("mN")->factor);
  EXPECT_EQ(parse_unit("1e-6 m^2")->factor, parse_unit("mm^2")->factor);
  EXPECT_EQ(parse_unit("10⁻³ N")->dimension, dimension::force);
  for (const char* text : {"10^-3", "10^-3 %", "10 N", "10^0 N", "10^-99 N", "10^-3N"})
    EXPECT_FALSE(parse_unit(text)) << text;
}

TEST(Units, OfAClockAreItsForm) {
  for (const char* text : {"hh:mm:ss", "h:mm:ss", "HH:MM:SS.fff", "hh:mm:ss,ms"})
    EXPECT_EQ(parse_unit(text)->dimension, dimension::time) << text;
  for (const char* text : {"hh:mm", "mm:ss", "h:m:s:f", ":"}) EXPECT_FALSE(parse_unit(text)) << text;
}

TEST(Units, KeepTheTextAsWritten) { EXPECT_EQ(parse_unit("  mJ/m² ")->text, "mJ/m²"); }

TEST(Units, OfOriginHaveACaretInPlaceOfItsMarkup) {
  EXPECT_EQ(parse_unit("mm\\+(2)")->text, "mm^2");
  EXPECT_EQ(parse_unit("mJ/m\\+(2)")->text, "mJ/m^2");
  EXPECT_EQ(parse_unit("m\\+(-1)")->text, "m^-1");
}

TEST(Units, OfAForceAndAnAreaSuitTheirSizeInSentences) {
  EXPECT_EQ(readable_unit(0.0077, "N").unit, "mN");
  EXPECT_EQ(readable_unit(7.7, "N").unit, "N");
  EXPECT_EQ(readable_unit(4.5e-7, "m^2").unit, "mm^2");
  EXPECT_EQ(readable_unit(4.5e-7, "m^2").factor, 1e6);
}

TEST(Units, OfAPlainNumberStandAlone) {
  for (const char* text : {"1", "-", "%"}) EXPECT_EQ(parse_unit(text)->dimension, dimension::none) << text;
  EXPECT_EQ(parse_unit("%")->factor, 0.01);
  EXPECT_EQ(parse_unit("1/mm")->dimension, (Dimension{0, -1, 0}));
  EXPECT_DOUBLE_EQ(parse_unit("1/mm")->factor, 1e3);  // 4 ulp: one rounding
}

TEST(Units, WhatIsNoUnitIsRefused) {
  for (const char* text :
       {"",     " ",  "foo",  "mn",  "N/", "/m", "N//m", "mm^",   "mm^x", "mm^0", "mm^2.5", "mm^99", "^2", "2",
        "kdeg", "m%", "[mm]", "mm,", "N*", "µ",  "mmN",  "mm^^2", "1 mm", "mm 1", "- mm",   "mm %",  "1/", "1/1"})
    EXPECT_FALSE(parse_unit(text)) << text;
}

TEST(Quantities, ANumberStandsBeforeItsUnitWithOrWithoutABlank) {
  for (const char* text : {"9.42 mm", "9.42mm", " 9.42  mm ", "+9.42 mm", "942e-2 mm", "0.942 cm"}) {
    const auto quantity = parse_quantity(text);
    ASSERT_TRUE(quantity) << text;
    EXPECT_DOUBLE_EQ(quantity->si(), 9.42e-3) << text;  // 4 ulp: value and factor are rounded once, so is the product
    EXPECT_EQ(quantity->unit.dimension, dimension::length) << text;
  }
}

TEST(Quantities, ABareNumberHasNoDimension) {
  const auto quantity = parse_quantity("-0.5");
  ASSERT_TRUE(quantity);
  EXPECT_EQ(quantity->si(), -0.5);
  EXPECT_EQ(quantity->unit.dimension, dimension::none);
  EXPECT_EQ(quantity->unit.text, "");
}

TEST(Quantities, TheRestIsRefused) {
  for (const char* text : {"", "mm", "9,420 mm", "9.42 furlong", "nan mm", "inf mm", "1e400 mm", "- 3 mm", "--3 mm",
                           "+-3 mm", "9.42 mm mm^", "1 2 mm", "0x10 mm", "1e308 GPa", "9 1 mm", "9 - mm", "9 % mm"})
    EXPECT_FALSE(parse_quantity(text)) << text;
}

TEST(UncertainQuantities, AreReadInEverySpelling) {
  for (const char* text : {"2.133 +/- 0.1 MPa", "2.133 MPa +/- 0.1 MPa", "2.133 +- 0.1 MPa", "2.133±0.1 MPa",
                           "(2.133 ± 0.1) MPa", "2.133 MPa +/- 0.1", "2133 kPa +/- 0.1 MPa"}) {
    const auto quantity = parse_uncertain(text);
    ASSERT_TRUE(quantity) << text;
    EXPECT_DOUBLE_EQ(quantity->quantity.si(), 2.133e6) << text;
    EXPECT_DOUBLE_EQ(quantity->standard_error, 1e5) << text;
  }
  EXPECT_DOUBLE_EQ(parse_uncertain("2 MPa +/- 5%")->standard_error, 1e5);
  EXPECT_DOUBLE_EQ(parse_uncertain("1 +/- 2%")->standard_error, 0.02);
  EXPECT_DOUBLE_EQ(parse_uncertain("0 +/- 0.5 mN")->standard_error, 5e-4);
  EXPECT_DOUBLE_EQ(parse_uncertain("-3 mN ± 10 %")->standard_error, 3e-4);
  EXPECT_EQ(parse_uncertain("27 mJ/m^2")->standard_error, 0);
}

TEST(UncertainQuantities, TheRestIsRefused) {
  for (const char* text : {"", "+/- 1 mN", "1 mN +/-", "1 mN +/- x", "1 mN +/- -1 mN", "1 mN +/- 1 mm", "0 mN +/- 5%",
                           "(1 +/- 2 mN", "1 mN +/- 1 mN +/- 1 mN", "1 mN +/- inf"})
    EXPECT_FALSE(parse_uncertain(text)) << text;
}

TEST(Numbers, AWholeFieldIsRead) {
  for (const auto& [text, value] : {std::pair{"1.5", 1.5},
                                    {" \t-2e3 ", -2000.0},
                                    {"+.5", 0.5},
                                    {"5.", 5.0},
                                    {"1E+2", 100.0},
                                    {"1e400", kInfinity},
                                    {"-1e400", -kInfinity},
                                    {"1e-400", 0.0},
                                    {"-inf", -kInfinity},
                                    {"Infinity", kInfinity}})
    EXPECT_EQ(parse_number(text), value) << text;
  EXPECT_TRUE(std::isnan(parse_number("NaN").value()));
}

TEST(Quantities, UnitsBeyondTheRangeOfNumbersAreNone) {
  for (const char* text : {"Gm^9 Gm^9 Gm^9 Gm^9", "pm^9 pm^9 pm^9 pm^9", "Gm^9 Gm^9 Gm^9 Gm^9/m/Gm^9/Gm^9/Gm^9/Gm^9"})
    EXPECT_FALSE(parse_unit(text)) << text;
}

TEST(Numbers, AnExponentCountsTogetherWithTheDigits) {
  EXPECT_EQ(parse_number(std::string(400, '9') + "e-5"), kInfinity);
  EXPECT_EQ(parse_number("-" + std::string(400, '9') + "e-5"), -kInfinity);
  EXPECT_EQ(parse_number("0." + std::string(400, '0') + "1e+5"), 0.0);
  EXPECT_EQ(parse_number("000." + std::string(400, '0') + "1"), 0.0);
}

TEST(Numbers, TooManyDigitsAreNoObstacle) {
  EXPECT_EQ(parse_number(std::string(400, '9')), kInfinity);
  EXPECT_EQ(parse_number("0." + std::string(400, '0') + "1"), 0.0);
  EXPECT_EQ(parse_number("0.1" + std::string(400, '0')), 0.1);
}

TEST(Numbers, AFieldThatIsNotWhollyANumberIsRefused) {
  for (const char* text :
       {"", " ", "abc", "1,500", "1 2", "0x10", "1e", "1.2.3", "+-1", "++1", "1mm", "\u22121", "1;", "#1"})
    EXPECT_FALSE(parse_number(text)) << text;
}

/// As a German or French lab book has it. A point, or a group of thousands, is never guessed.
TEST(Numbers, HaveADecimalPointOrComma) {
  for (const auto& [text, value] : {std::pair("9,42", 9.42),
                                    {"-0,133", -0.133},
                                    {"+12,5e-3", 12.5e-3},
                                    {"2,1334", 2.1334},
                                    {"1234,567", 1234.567},
                                    {"0,5", 0.5},
                                    {" 1,0 ", 1.0}})
    EXPECT_EQ(parse_number(text), std::optional(value)) << text;
  for (const char* text : {"2,133", "-12,500", "1,2,3", "1.234,5", "1,234.5", ",5", "5,", "1, 2", "1,e5", "a,5"})
    EXPECT_FALSE(parse_number(text)) << text;
  EXPECT_EQ(parse_quantity("9,42 mm")->si(), 9.42e-3);
  EXPECT_FALSE(parse_quantity("2,133 MPa"));
  const auto with_error = parse_uncertain("2,13 +/- 0,05 MPa");
  ASSERT_TRUE(with_error);
  EXPECT_EQ(with_error->quantity.value, 2.13);
  EXPECT_DOUBLE_EQ(with_error->standard_error, 0.05e6);
}

TEST(Numbers, ThatMayHaveAGroupOfThousandsAreAskedFor) {
  EXPECT_EQ(two_readings("2,133 MPa"), "\"2.133 MPa\" or \"2133 MPa\"");
  EXPECT_EQ(two_readings("-12,500"), "\"-12.500\" or \"-12500\"");
  for (const char* text : {"0,133", "2,13", "2,1334", "1,234,567", "2133", "", "mm"})
    EXPECT_EQ(two_readings(text), "") << text;
}

TEST(Units, OfOtherCapitalsAreRecognised) {
  EXPECT_EQ(with_other_capitals("Mpa", dimension::stress), "MPa");
  EXPECT_EQ(with_other_capitals("MJ/M^2", dimension::energy_per_area), "MJ/m^2");
  EXPECT_EQ(with_other_capitals("KPA", dimension::stress), "kPa");
  EXPECT_EQ(with_other_capitals("Mpa", dimension::length), "");
  EXPECT_EQ(with_other_capitals("furlong", dimension::length), "");
  EXPECT_EQ(with_other_capitals("", dimension::none), "");
}

TEST(Units, WhatIsNoneIsFoundInAText) {
  for (const auto& [text, unit] : std::vector<std::pair<std::string, std::string>>{{"2.133 Mpa", "Mpa"},
                                                                                   {"2 Mpa +/- 1 MPa", "Mpa"},
                                                                                   {"2 +/- 1 Mpa", "Mpa"},
                                                                                   {"(2 +/- 1) Mpa", "Mpa"},
                                                                                   {"2.133 MPa", ""},
                                                                                   {"wide", ""},
                                                                                   {"9,42 mm", ""},
                                                                                   {"9 1 mm", ""},
                                                                                   {"2 +/- 5%", ""},
                                                                                   {"1e999 MPa", ""},
                                                                                   {"", ""},
                                                                                   {"+/-", ""}})
    EXPECT_EQ(unknown_unit(text), unit) << text;
}

TEST(Units, ADimensionIsDescribedByAnExample) {
  EXPECT_EQ(describe(dimension::force), "a force such as mN");
  EXPECT_EQ(describe(dimension::none), "a plain number");
  EXPECT_EQ(describe({2, -3, 0}), "N^2 m^-3");
}

}  // namespace units_test
}  // namespace mixity
