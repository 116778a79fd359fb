// The order of causes that explain the points about as well.
#include "fitting/plausible_size.h"

#include <gtest/gtest.h>

#include "fitting/measured_runs.h"

namespace mixity {
namespace plausible_size_test {

TEST(PlausibleSize, IsThatOfWhatLaboratoriesDifferBy) {
  const Dataset data = measured_runs(1);
  const auto size = [&](const char* quantity, double deviation) {
    return implausibility(data, quantity, deviation, 0.15);
  };
  EXPECT_NEAR(size("toughness", 0.1), 1, 1e-12);
  EXPECT_NEAR(size("modulus", -0.1), 4, 1e-12);
  EXPECT_NEAR(size("area_scale", 0.02), 1, 1e-12);
  EXPECT_NEAR(size("load_offset", 0.3), 1, 1e-12);  // the largest load is 30
  EXPECT_NEAR(size("lambda", 0.045), 1, 1e-12);
  EXPECT_LT(size("toughness", 0.05), size("area_scale", 0.05));
}

}  // namespace plausible_size_test
}  // namespace mixity
