#include "base/number_text.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace mixity {
namespace number_text_test {

TEST(NumberText, RoundedAvoidsExponentsAReaderDoesNotNeed) {
  EXPECT_EQ(rounded(1696.4, 2), "1700");
  EXPECT_EQ(rounded(-2160.4, 3), "-2160");
  EXPECT_EQ(rounded(9999999, 3), "1e+07");
  EXPECT_EQ(rounded(1.234567e9, 3), "1.23e+09");
  EXPECT_EQ(rounded(0.000012345, 2), "1.2e-05");
  EXPECT_EQ(rounded(0.00230603, 4), "0.002306");
  EXPECT_EQ(rounded(0, 3), "0");
}

TEST(NumberText, RoundedHasNoNegativeZero) { EXPECT_EQ(rounded(-0.0, 3), "0"); }

TEST(NumberText, RoundingErrorsOfDifferencesAreZero) {
  EXPECT_EQ(rounded_difference(-5.7e-17, 0.45, 3), "0");
  EXPECT_EQ(rounded_difference(5.7e-12, 0.45, 3), "5.7e-12");
  EXPECT_EQ(rounded_difference(5.7e-17, 1e-6, 3), "5.7e-17");  // of areas in m^2
  EXPECT_EQ(chi_squared_text(1.03e-27), "0");
  EXPECT_EQ(chi_squared_text(0.0558), "0.0558");
}

TEST(NumberText, DecimalTakesOffTheRoundingsOfAConversionOnly) {
  for (const char* text : {"1.2", "3.7", "0.3", "-2.6", "0.115838", "7.73194", "1e-05"}) {
    const double right = std::strtod(text, nullptr);
    EXPECT_EQ(as_decimal(right), right);
    for (const double unit : {1e-3, 1e-6, 27e-3 * 9.42e-3}) EXPECT_EQ(as_decimal(right * unit / unit), right) << text;
  }
  EXPECT_EQ(as_decimal(1.1999999999999997), 1.2);
  for (const double other : {1.19999999999999, 1.0 / 3, 0.0, 4.71238898038469, 1e300, 5e-324})
    EXPECT_EQ(as_decimal(other), other);
}

TEST(NumberText, SignificantKeepsExponents) {
  EXPECT_EQ(significant(1696.4, 2), "1.7e+03");
  EXPECT_EQ(significant(0.25, 4), "0.25");
}

TEST(NumberText, ResolvedShowsAChangeInTheLastDigitButOne) {
  EXPECT_EQ(resolved(0.0023061, 0.00002), "0.002306");
  EXPECT_EQ(resolved(1234.5678, 10), "1235");
  EXPECT_EQ(resolved(0, 1), "0");
  EXPECT_EQ(resolved(0.123456, 0), "0.1235");
}

TEST(NumberText, R2ShowsAllItsNines) {
  EXPECT_EQ(r2_text(0.9999), "0.9999");
  EXPECT_EQ(r2_text(0.99994), "0.99994");
  EXPECT_EQ(r2_text(0.5), "0.5");
}

TEST(NumberText, UnitsStandInBracketsOrBehindABlank) {
  EXPECT_EQ(bracketed("T", "mN"), "T [mN]");
  EXPECT_EQ(bracketed("T", ""), "T");
  EXPECT_EQ(unit_text("mN"), " mN");
  EXPECT_EQ(unit_text(""), "");
}

TEST(NumberText, ShortestReadsBackToTheSameDouble) {
  for (const double value : {0.1, 1.0 / 3, 5e-324, 1.7976931348623157e308, -0.0})
    EXPECT_EQ(std::strtod(shortest(value).c_str(), nullptr), value);
}

std::string shown(double value, double error) {
  const RoundedToError both = rounded_to_error(value, error);
  return both.value + " +/- " + both.error;
}

TEST(RoundedToError, FollowsTheParticleDataGroup) {
  EXPECT_EQ(shown(0.827, 0.119), "0.83 +/- 0.12");
  EXPECT_EQ(shown(0.827, 0.367), "0.8 +/- 0.4");
  EXPECT_EQ(shown(0.827, 0.0967), "0.83 +/- 0.10");
  EXPECT_EQ(shown(0.004031, 4.4e-05), "0.00403 +/- 0.00004");
  EXPECT_EQ(shown(0.00402, 0.000354), "0.00402 +/- 0.00035");
  EXPECT_EQ(shown(2.1334e6, 51234), "2130000 +/- 50000");
  EXPECT_EQ(shown(1, 1), "1.0 +/- 1.0");
}

TEST(RoundedToError, HasNoNegativeZero) { EXPECT_EQ(shown(-0.0001, 0.28), "0.00 +/- 0.28"); }

TEST(RoundedToError, LeavesWhatNoErrorRounds) {
  EXPECT_EQ(shown(0.5, 0), "0.5 +/- 0");
  EXPECT_EQ(shown(1e-20, 1e-21), "1e-20 +/- 1e-21");
}

}  // namespace number_text_test
}  // namespace mixity
