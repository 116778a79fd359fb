// Logs whose clock is coarser than their rows, stands still or runs back.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "dataset/logs/read_log.h"

namespace mixity {
namespace recording_clock_test {

using read_log::error_of, read_log::read;

/// Rows at `rate` a second, whose times are cut to whole steps of the clock, with an area that tells them apart.
std::string coarse(double rate, double step, int rows, int first = 0, int pause_at = -1) {
  std::string text = "time [s],P [mN],T [mN],A [mm^2]\n";
  for (int i = first; i < first + rows; ++i) {
    const double time = (i + (pause_at >= 0 && i >= pause_at ? 100 : 0)) / rate;
    text += std::to_string(step * std::floor(time / step + 1e-9)) + ",1,2," + std::to_string(i) + "\n";
  }
  return text;
}

TEST(RecordingClocks, CoarserThanTheirRowsHaveTheirTimesSpread) {
  for (const double step : {0.1, 1.0})
    for (const int first : {0, 3}) {  // the first stamp is whole, or cut
      const Recording log = read(coarse(40, step, 397, first));
      EXPECT_NEAR(log.clock.stamp, step, 1e-12);
      EXPECT_GE(log.clock.shared, 390u);
      for (std::size_t i = 0; i < 397; ++i)
        ASSERT_NEAR(log.time[i], (first + static_cast<double>(i)) / 40, 1e-9) << step << " " << i;
    }
  const Recording log = read(coarse(128, 0.1, 500));  // 12 or 13 rows a stamp
  for (std::size_t i = 0; i < 500; ++i) ASSERT_NEAR(log.time[i], static_cast<double>(i) / 128, 1.0 / 128) << i;
}

TEST(RecordingClocks, WhoseTimesDifferKeepThemToTheLastDigit) {
  const Recording log = read("time [s],P [mN],T [mN],A [mm^2]\n0.013,1,2,3\n0.0239,1,2,3\n0.035,1,2,3\n9.1,1,2,3\n");
  EXPECT_EQ(log.time, (std::vector<double>{0.013, 0.0239, 0.035, 9.1}));
  EXPECT_EQ(log.clock.shared, 0u);
}

TEST(RecordingClocks, WithRowsTwiceHaveThemOnce) {
  const Recording log = read("time [s],P [mN],T [mN],A [mm^2]\n0,1,2,3\n0,1,2,3\n1,1,2,4\n2,1,2,4\n2,1,2,4\n3,1,2,4\n");
  EXPECT_EQ(log.time, (std::vector<double>{0, 1, 2, 3}));
  EXPECT_EQ(log.A.size(), 4u);
  EXPECT_EQ(log.clock.repeated, 2u);
}

TEST(RecordingClocks, ThatTellNoTimesAreRefused) {
  const std::string header = "time [s],P [mN],T [mN],A [mm^2]\n",
                    own = "give each row its own time: row number divided by the sampling rate";
  const auto rows = [&](const std::vector<std::pair<double, int>>& stamps) {
    std::string text = header;
    int row = 0;
    for (const auto& [time, count] : stamps)
      for (int i = 0; i < count; ++i) text += std::to_string(time) + ",1,2," + std::to_string(row++) + "\n";
    return text;
  };
  EXPECT_EQ(error_of(rows({{7, 20}})),
            "log.csv:2:1: column 'time': only 1 stamp for 20 rows: the rows do not come at a constant rate; " + own);
  EXPECT_EQ(error_of(rows({{0, 1}, {1, 1}, {2, 1}, {3, 30}, {4, 1}, {5, 1}})),
            "log.csv:5:1: column 'time': 30 rows share the stamp 3 s, where some 1 would be usual: the rows do not "
            "come at a constant rate; " +
                own);
  EXPECT_EQ(error_of(rows({{0, 4}, {1, 1}, {2, 9}, {3, 2}, {4, 7}, {5, 4}})),
            "log.csv:6:1: column 'time': the stamp 1 s has 1 row for the 1 s up to the next one, where some 7 would be "
            "usual: the rows do not come at a constant rate; " +
                own);
  EXPECT_EQ(error_of("# a note\n" + coarse(40, 0.1, 100, 0, 41)),
            "log.csv:43:1: column 'time': the stamp 1 s has 1 row for the 2.5 s up to the next one, where some 100 "
            "would be usual: the rows do not come at a constant rate; " +
                own);
  EXPECT_EQ(error_of(header + "0,1,2,3\n1,1,2,3\n0.5,1,2,3\n1,1,2,3\n"),
            "log.csv:4:1: column 'time': 0.5 s after 1 s: the clock goes back, and not to the start of the "
            "log; split the file there");
  EXPECT_EQ(error_of(header + "0,1,2,3\n\n# a comment\n,1,2,3\n2,1,2,3\n"),
            "log.csv:5:1: column 'time': the row has no time; leave it out, or " + own);
}

}  // namespace recording_clock_test
}  // namespace mixity
