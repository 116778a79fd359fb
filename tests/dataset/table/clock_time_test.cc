#include <gtest/gtest.h>

#include "dataset/table/number.h"

namespace mixity {
namespace clock_time_test {

TEST(ClockTimes, AreReadToTheFractionOfASecond) {
  const auto time = parse_clock("10:05:07.250");
  ASSERT_TRUE(time);
  EXPECT_FALSE(time->dated);
  EXPECT_EQ(time->seconds, 36307);
  EXPECT_EQ(time->fraction, 0.25);
  EXPECT_EQ(parse_clock("9:05:07,5")->fraction, 0.5);
  EXPECT_EQ(parse_clock("1970-01-02T00:00:01Z")->seconds, 86401);
  EXPECT_EQ(parse_clock("2026-05-01 10:05:00")->seconds, 1777629900);
  EXPECT_EQ(parse_clock("2026-05-01T10:05:00.5+02:00")->seconds, 1777629900 - 7200);
}

TEST(ClockTimes, AreNothingElse) {
  for (const char* text : {"", "10", "10:05", "10:65:00", "24:00:00", "10:05:00.", "10:05:00Z", "10:05:00 pm",
                           "2026-13-01T10:05:00", "01.05.2026 10:05:00", "2026-05-01", "10:05:00.5x"})
    EXPECT_FALSE(parse_clock(text)) << text;
}

}  // namespace clock_time_test
}  // namespace mixity
