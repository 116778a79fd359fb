#include <gtest/gtest.h>

#include "report/figures/layout.h"

namespace mixity {
namespace axis_test {

/// "0.0 0.5 1.0": labels in order, a dot for each tick without one.
std::string labels(double low, double high, bool logarithmic, int most = 6) {
  std::string text;
  for (const Tick& tick : axis_ticks({low, high}, logarithmic, most))
    text += (text.empty() ? "" : " ") + (tick.label.empty() ? "." : tick.label);
  return text;
}

TEST(Axis, LinearTicksAreRoundNumbersWithAsManyDecimals) {
  EXPECT_EQ(labels(-0.1, 2, false), "0.0 0.5 1.0 1.5 2.0");
  EXPECT_EQ(labels(-3, 3, false), "−3 −2 −1 0 1 2 3");
  EXPECT_EQ(labels(0.002262, 0.00235, false), "0.00228 0.00230 0.00232 0.00234");
  EXPECT_EQ(labels(0, 0.9, false, 4), "0.00 0.25 0.50 0.75");
  EXPECT_EQ(labels(0, 5e7, false), "0 10^{7} 2×10^{7} 3×10^{7} 4×10^{7} 5×10^{7}");
}

TEST(Axis, LogarithmicTicksAreDigitsWithinTwoDecadesAndPowersBeyond) {
  EXPECT_EQ(labels(0.9, 12, true), ". 1 2 . . 5 . . . . 10");
  EXPECT_EQ(labels(0.17, 0.57, true), "0.2 0.3 0.4 0.5");
  EXPECT_EQ(labels(1, 1000, true), "10^{0} . . . . . . . . 10^{1} . . . . . . . . 10^{2} . . . . . . . . 10^{3}");
  EXPECT_EQ(labels(1e-9, 1e3, true), ". 10^{−8} . 10^{−6} . 10^{−4} . 10^{−2} . 10^{0} . 10^{2} .");
  EXPECT_EQ(labels(1.01, 1.04, true), "1.01 1.02 1.03 1.04");  // no digit lies there
}

TEST(Axis, EndsThatAreNotStatedLieBeyondThePointsAndTheirBars) {
  Figure figure{"f",
                "",
                {"x"},
                {"y", {}, {}, true},
                {{"", Look::circles, "#000000", {{1, 10}, {3, 20}}, {{0, 2, 8, 10}, {3, 3, 15, 30}}}}};
  const auto x = axis_range(figure, true), y = axis_range(figure, false);
  ASSERT_TRUE(x && y);
  EXPECT_LT(x->low, 0);
  EXPECT_GT(x->high, 3);
  EXPECT_LT(y->low, 8);
  EXPECT_GT(y->low, 0);
  EXPECT_GT(y->high, 30);
  figure.y.low = 0.0;  // has no place on a logarithmic axis
  EXPECT_FALSE(axis_range(figure, false));
  figure.series.clear();
  EXPECT_FALSE(axis_range(figure, true));
}

}  // namespace axis_test
}  // namespace mixity
