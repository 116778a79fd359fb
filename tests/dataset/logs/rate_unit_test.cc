// Units of rates and intervals.
#include "dataset/logs/rate_unit.h"

#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <vector>

namespace mixity {
namespace rate_unit_test {

TEST(RateUnit, CountsInTimeOrTakesTimeForACount) {
  const Dimension rate = dimension::frequency, interval = dimension::time;
  for (const auto& [text, factor, dimension] :
       std::vector<std::tuple<std::string, double, Dimension>>{{"Hz", 1, rate},
                                                               {"[kHz]", 1e3, rate},
                                                               {"S/s", 1, rate},
                                                               {"kS/s", 1e3, rate},
                                                               {"MSa/s", 1e6, rate},
                                                               {"fps", 1, rate},
                                                               {"samples/min", 1.0 / 60, rate},
                                                               {"samples per minute", 1.0 / 60, rate},
                                                               {"per hour", 1.0 / 3600, rate},
                                                               {"readings / ms", 1e3, rate},
                                                               {"Werte pro Sekunde", 1, rate},
                                                               {"ms", 1e-3, interval},
                                                               {"ms/sample", 1e-3, interval},
                                                               {"s per point", 1, interval},
                                                               {"minutes", 60, interval}}) {
    const auto unit = rate_unit(text);
    ASSERT_TRUE(unit) << text;
    EXPECT_DOUBLE_EQ(unit->factor, factor) << text;
    EXPECT_TRUE(unit->dimension == dimension) << text;
  }
}

TEST(RateUnit, IsNotGuessed) {
  for (const char* text : {"", "furlongs", "baud", "samples", "mN/s", "mm/min", "samples/rev", "per", "/", "kHz/s"})
    EXPECT_FALSE(rate_unit(text)) << text;
}

}  // namespace rate_unit_test
}  // namespace mixity
