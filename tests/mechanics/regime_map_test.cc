// Maps of regimes against the regime of each contact by itself.
#include "mechanics/regime_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

namespace mixity {
namespace regime_map_test {

using Outline = std::vector<std::pair<double, double>>;

bool inside(const Outline& outline, double x, double y) {
  bool in = false;
  for (std::size_t i = 0, k = outline.size() - 1; i < outline.size(); k = i++) {
    const auto& [xi, yi] = outline[i];
    const auto& [xk, yk] = outline[k];
    if ((yi > y) != (yk > y) && x < (xk - xi) * (y - yi) / (yk - yi) + xi) in = !in;
  }
  return in;
}

RegimeMap finished(const ContactModel& model, const RegimeMapFrame& frame, std::optional<double> tau0) {
  RegimeMap map(model, std::vector<double>(model.parameters().size(), 0.5), frame, tau0);
  while (map.add_line()) continue;
  return map;
}

/// The share of random places of a map that are in no region, in several, or in one of another regime than theirs.
double wrong_share(const ContactModel& model, const RegimeMapFrame& frame, std::optional<double> tau0) {
  const std::vector<RegimeRegion> regions = finished(model, frame, tau0).regions();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(0, 1);
  constexpr int kPlaces = 3000;
  int wrong = 0;
  for (int i = 0; i < kPlaces; ++i) {
    const double P = frame.P_low + part(random) * (frame.P_high - frame.P_low), v = part(random);
    const double lambda =
        frame.logarithmic ? frame.low * std::pow(frame.high / frame.low, v) : frame.low + v * (frame.high - frame.low);
    std::size_t of_its_own = 0, all = 0;
    for (const RegimeRegion& region : regions) {
      if (!inside(region.outline, P, lambda)) continue;
      ++all;
      of_its_own += region.regime == model.regime(ParameterValues{lambda}, P, tau0)->regime;
    }
    wrong += all != 1 || of_its_own != 1;
  }
  return static_cast<double>(wrong) / kPlaces;
}

TEST(RegimeMap, HasTheRegimeOfEachContact) {
  for (const char* key : {"a", "b", "c"}) {
    const ContactModel model = *ContactModel::find(key);
    const double high = model.parameters()[0].upper;
    for (const std::optional<double> tau0 : {std::optional<double>(), std::optional(0.5), std::optional(4.0)}) {
      EXPECT_LT(wrong_share(model, {0, 0, high, false, -4.5, 40}, tau0), 0.005) << key << ' ' << tau0.value_or(0);
      EXPECT_LT(wrong_share(model, {0, 2e-4, high, true, -4.5, 40}, tau0), 0.005) << key << ' ' << tau0.value_or(0);
    }
  }
}

TEST(RegimeMap, OfModelCWithoutAStrengthIsOneRegion) {
  const auto regions = finished(*ContactModel::find("c"), {0, 0.001, 1, false, -4, 30}, {}).regions();
  ASSERT_EQ(regions.size(), 1u);
  EXPECT_EQ(regions[0].regime, Regime::jump);
  for (const auto& [P, lambda] : regions[0].outline) {
    EXPECT_TRUE(P == -4 || P == 30);
    EXPECT_TRUE(lambda >= 0.001 && lambda <= 1);
  }
}

TEST(RegimeMap, NeedsAModelItsParametersAndRisingEnds) {
  const ContactModel c = *ContactModel::find("c");
  const std::vector<double> one{0.5}, two{0.5, 0.5};
  EXPECT_THROW(RegimeMap(c, two, {}), std::invalid_argument);
  EXPECT_THROW(RegimeMap(c, one, {1, 0, 1, false, 0, 1}), std::invalid_argument);
  EXPECT_THROW(RegimeMap(c, one, {0, 1, 0, false, 0, 1}), std::invalid_argument);
  EXPECT_THROW(RegimeMap(c, one, {0, 0, 1, false, 1, 1}), std::invalid_argument);
  EXPECT_THROW(RegimeMap(c, one, {0, 0, 1, true, 0, 1}), std::invalid_argument);
}

}  // namespace regime_map_test
}  // namespace mixity
