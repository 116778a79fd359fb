// Values rounded to their errors, by the rule and the examples of the Review of Particle Physics (section 5.3).
#include "base/rounding.h"

#include <gtest/gtest.h>

namespace mixity {
namespace {

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

}  // namespace
}  // namespace mixity
