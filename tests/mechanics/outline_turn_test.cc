// The lower bound of a point's distance from a part of a curve, against points along that part.
#include "mechanics/vector_math.h"
// after the declarations of the vector forms
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mechanics/outline_turn.h"
#include "mechanics/registry.h"

namespace mixity {
namespace {

template <class Law>
void expect_bound(const Parameters<Law>& p, double P) {
  const nearest_detail::CurveFamily<Law> family(Law{}, p);
  RayTable<Law> table(family);
  const nearest_detail::CurveBounds ends = curve_bounds(family, P);
  table.set_load(P, {ends.T, ends.A});
  ASSERT_TRUE(table.is_along_rays());
  const std::vector<PlanePlace>& outline = table.places();
  const double T = outline[1].T, A = outline[0].A;
  std::mt19937_64 random(22);
  std::uniform_real_distribution<double> share(0.02, 2);
  for (int i = 0; i < 200; ++i) {
    const PlanePlace point{100 * T * share(random), A * share(random)};
    const double per_T = 1 / (T * share(random)), per_A = 100 / (A * share(random));
    const int segment = static_cast<int>(random() % static_cast<unsigned>(table.last()));
    double nearest = std::numeric_limits<double>::infinity();
    for (double u = std::max(segment - 1, 0); u <= std::min(segment + 2, table.last()); u += 1.0 / 64) {
      const PlanePlace place = table.at(u);
      nearest = std::min(nearest, std::hypot((place.T - point.T) * per_T, (place.A - point.A) * per_A));
    }
    // the rounding of places on the curve
    EXPECT_LE(least_distance(outline, segment, point, per_T, per_A), nearest * (1 + 1e-9)) << P << " " << segment;
  }
}

TEST(LeastDistance, IsBelowThatOfEveryPointOfTheCurveAlongTheSegments) {
  for (const double P : {1e-3, 0.5, 7.0, 30.0, 300.0}) {
    expect_bound<Johnson>({0.97}, P);
    expect_bound<WatersGuduru>({0.15}, P);
    expect_bound<PapangeloCiavarella>({0.0023}, P);
  }
}

TEST(LeastDistance, FromALongSegmentFarAwayIsNotItsLength) {
  const std::vector<PlanePlace> outline{{0, 3}, {1, 2}, {100, 1}, {1000, 0.5}};
  EXPECT_NEAR(least_distance(outline, 2, {1, 50}, 1, 1), 48, 1e-12);  // rounding
}

TEST(NodesOfAreas, EncloseThePartThatReachesThemAndASegmentMore) {
  const std::vector<PlanePlace> outline{{0, 9}, {1, 8}, {2, 7}, {3, 5}, {4, 4}, {5, 2}, {6, 1}};
  const auto nodes = [&](double lowest, double highest) {
    const std::span<const PlanePlace> part = nodes_of_areas(outline, lowest, highest);
    return std::pair(part.front().A, part.back().A);
  };
  EXPECT_EQ(nodes(5.5, 6.5), std::pair(8.0, 4.0));  // between two nodes
  EXPECT_EQ(nodes(5.0, 7.0), std::pair(9.0, 2.0));  // at nodes
  EXPECT_EQ(nodes(0.0, 10.0), std::pair(9.0, 1.0));
  EXPECT_EQ(nodes(9.5, 9.9), std::pair(9.0, 8.0));  // beyond an end
}

}  // namespace
}  // namespace mixity
