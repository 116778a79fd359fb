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

TEST(ClockTimes, HaveDatesAsLoggersWriteThem) {
  for (const char* text : {"2026-05-01 10:05:00", "2026/05/01 10:05:00", "2026.05.01 10:05:00", "01.05.2026 10:05:00",
                           "2026/05/01 10:05:00 AM"}) {
    const auto time = parse_clock(text);
    ASSERT_TRUE(time) << text;
    EXPECT_TRUE(time->dated) << text;
    EXPECT_EQ(time->seconds, 1777629900) << text;
  }
  // the fourth of March or the third of April
  for (const char* text : {"4/3/2026 22:05:00.5", "04/03/2026 10:05:00.5 PM", "22:05:00:500", "10:05:00.500 p.m."}) {
    const auto time = parse_clock(text);
    ASSERT_TRUE(time) << text;
    EXPECT_FALSE(time->dated) << text;
    EXPECT_EQ(time->seconds, 79500) << text;
    EXPECT_EQ(time->fraction, 0.5) << text;
  }
  EXPECT_EQ(parse_clock("12:00:01 AM")->seconds, 1);
  EXPECT_EQ(parse_clock("12:00:01 PM")->seconds, 43201);
}

TEST(ClockTimes, AreNothingElse) {
  for (const char* text : {"", "10", "10:05", "10:65:00", "24:00:00", "10:05:00.", "10:05:00Z", "13:05:00 pm",
                           "0:05:00 AM", "2026-13-01T10:05:00", "32.05.2026 10:05:00", "13/13/2026 10:05:00",
                           "2026-05-01", "2026/05/01T", "10:05:00:25", "10:05:00.5x", "10:05:00 xm"})
    EXPECT_FALSE(parse_clock(text)) << text;
}

}  // namespace clock_time_test
}  // namespace mixity
