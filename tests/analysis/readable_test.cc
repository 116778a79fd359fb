#include "analysis/readable.h"

#include <gtest/gtest.h>

namespace mixity {
namespace readable_test {

TEST(Readable, ForeignTextLosesItsMarkup) { EXPECT_EQ(plain("run_1^{x}@&~"), "run\\_1\\^\\{x\\}\\@\\&\\~"); }

TEST(Readable, AParameterHasAllItsNumbersInOneUnit) {
  FittedParameter modulus{"modulus", 1.4e6, 1.7e3, 1e6, 2e6};
  modulus.unit = "Pa";
  modulus.profile.emplace();
  modulus.profile->points = {{1.3e6, 4}, {1.4e6, 0}};
  const FittedParameter shown = readable(modulus);
  EXPECT_EQ(shown.unit, "MPa");
  EXPECT_DOUBLE_EQ(*shown.value, 1.4);
  EXPECT_DOUBLE_EQ(*shown.stderr_, 0.0017);
  EXPECT_DOUBLE_EQ(shown.profile->points[0].first, 1.3);
  EXPECT_EQ(shown.profile->points[0].second, 4);
}

}  // namespace readable_test
}  // namespace mixity
