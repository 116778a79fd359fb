#include "report/figures/polyline.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mixity {
namespace polyline_test {

std::vector<Polyline> cut(const Polyline& line, bool closed) { return cut_to_frame(line, closed, {0, 0}, {10, 10}); }

TEST(Polyline, IsCutIntoThePartsWithinTheFrame) {
  EXPECT_EQ(cut({{1, 1}, {2, 3}}, false), (std::vector<Polyline>{{{1, 1}, {2, 3}}}));
  EXPECT_EQ(cut({{-5, 5}, {15, 5}}, false), (std::vector<Polyline>{{{0, 5}, {10, 5}}}));
  EXPECT_EQ(cut({{1, 1}, {1, 20}, {3, 20}, {3, 1}}, false),
            (std::vector<Polyline>{{{1, 1}, {1, 10}}, {{3, 10}, {3, 1}}}));
  EXPECT_TRUE(cut({{-1, -1}, {-2, 5}}, false).empty());
  EXPECT_TRUE(cut({{5, 5}}, false).empty());
  const double nan = std::nan("");
  EXPECT_EQ(cut({{1, 1}, {nan, 3}, {2, 2}}, false), (std::vector<Polyline>{{{1, 1}, {2, 2}}}));
}

TEST(Polyline, OfAnAreaIsCutToOneOutline) {
  const auto area = [](const Polyline& outline) {
    double twice = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const auto& [x0, y0] = outline[i];
      const auto& [x1, y1] = outline[(i + 1) % outline.size()];
      twice += x0 * y1 - x1 * y0;
    }
    return std::abs(0.5 * twice);
  };
  const auto whole = cut({{-5, -5}, {20, -5}, {20, 20}, {-5, 20}}, true);
  ASSERT_EQ(whole.size(), 1u);
  EXPECT_DOUBLE_EQ(area(whole[0]), 100);
  const auto corner = cut({{5, 5}, {15, 5}, {5, 15}}, true);  // a triangle beyond x = 10 and y = 10
  ASSERT_EQ(corner.size(), 1u);
  EXPECT_DOUBLE_EQ(area(corner[0]), 25);
  EXPECT_TRUE(cut({{20, 20}, {30, 20}, {30, 30}}, true).empty());
}

TEST(Polyline, SimplifiedStaysWithinItsTolerance) {
  Polyline circle;
  for (int i = 0; i <= 1000; ++i)
    circle.emplace_back(100 * std::cos(0.002 * M_PI * i), 100 * std::sin(0.002 * M_PI * i));
  const Polyline kept = simplified(circle, 0.05);
  // a chord that is off by 0.05 spans 2 acos(1 - 0.0005) = 0.063 of 2 pi
  EXPECT_LT(kept.size(), 200u);
  EXPECT_GE(kept.size(), 100u);
  EXPECT_EQ(kept.front(), circle.front());
  EXPECT_EQ(kept.back(), circle.back());
  for (std::size_t i = 1; i < kept.size(); ++i)
    EXPECT_GT(std::hypot(kept[i].first + kept[i - 1].first, kept[i].second + kept[i - 1].second) / 2, 100 - 0.0501);
  EXPECT_EQ(simplified({{0, 0}, {1, 0}, {2, 0}}, 0.1), (Polyline{{0, 0}, {2, 0}}));
  EXPECT_EQ(simplified({{0, 0}, {3, 0}, {2, 0}}, 0.1).size(), 3u);  // it turns back
}

}  // namespace polyline_test
}  // namespace mixity
