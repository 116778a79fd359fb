#include "base/number_text.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace mixity {
namespace {

TEST(NumberText, RoundedAvoidsExponentsAReaderDoesNotNeed) {
  EXPECT_EQ(rounded(1696.4, 2), "1700");
  EXPECT_EQ(rounded(-2160.4, 3), "-2160");
  EXPECT_EQ(rounded(9999999, 3), "1e+07");
  EXPECT_EQ(rounded(1.234567e9, 3), "1.23e+09");
  EXPECT_EQ(rounded(0.000012345, 2), "1.2e-05");
  EXPECT_EQ(rounded(0.00230603, 4), "0.002306");
  EXPECT_EQ(rounded(0, 3), "0");
}

TEST(NumberText, ShortestReadsBackToTheSameDouble) {
  for (const double value : {0.1, 1.0 / 3, 5e-324, 1.7976931348623157e308, -0.0})
    EXPECT_EQ(std::strtod(shortest(value).c_str(), nullptr), value);
}

}  // namespace
}  // namespace mixity
