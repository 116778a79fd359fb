#include "fitting/bends.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "fitting/prepared_fit.h"
#include "fitting/synthetic_runs.h"

namespace mixity {
namespace {

Dataset data_of(const std::vector<MeasuredPoint>& points) {
  Dataset data;
  data.path = data.name = "made";
  data.has_loads = true;
  for (const MeasuredPoint& point : points) {
    auto run = static_cast<std::size_t>(std::find(data.curve_loads.begin(), data.curve_loads.end(), point.P) -
                                        data.curve_loads.begin());
    if (run == data.curves.size()) {
      data.curves.push_back("P=" + shortest(point.P));
      data.curve_loads.push_back(point.P);
    }
    data.points.push_back({data.points.size() + 2, run, point.P, point.T, point.A});
    data.errors.push_back({0, point.sigma_A, 0});
  }
  data.rows = data.points.size();
  return data;
}

/// S0^2 of the equilibrium circle; model c's load at the fold is its root over lambda's.
double circle(double P) { return 9 * pi<double>() * pi<double>() + 6 * pi<double>() * P; }

/// Model c's cost of areas in closed form, beyond the fold with the area there.
double cost(const std::vector<MeasuredPoint>& points, double lambda) {
  double sum = 0;
  for (const MeasuredPoint& point : points) {
    const double y = 3 * pi<double>() + std::sqrt(std::max(circle(point.P) - lambda * point.T * point.T, 0.0));
    sum += std::pow((pi<double>() * std::pow(0.75 * (y + point.P), 2.0 / 3) - point.A) / point.sigma_A, 2);
  }
  return sum;
}

/// The least of the cost between all neighbouring bends, evenly in the square root of the distance from the upper.
double least_cost(const std::vector<MeasuredPoint>& points) {
  std::vector<double> ends{0, 1};
  for (const MeasuredPoint& point : points)
    if (const double bend = circle(point.P) / (point.T * point.T); bend < 1) ends.push_back(bend);
  std::sort(ends.begin(), ends.end());
  double least = HUGE_VAL;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    constexpr int kPlaces = 4000;
    for (int k = 0; k <= kPlaces; ++k)
      least = std::min(
          least, cost(points, ends[i + 1] - std::pow(static_cast<double>(k) / kPlaces, 2) * (ends[i + 1] - ends[i])));
  }
  return least;
}

const FitOptions kArea{.objective = Objective::area, .intervals = false};

TEST(Bends, OfModelCAreWhereItsFoldSaysSo) {
  std::vector<double> shears, places;
  for (const double lambda : {0.9, 0.15, 0.0023, 1e-6}) shears.push_back(std::sqrt(circle(3) / lambda));
  for (int i = -40; i <= 0; ++i) places.push_back(std::pow(2, i));
  const std::vector<std::size_t> points{3, 7, 1, 0};
  const std::vector<LoadEnds> load{
      {[](double lambda) { return std::vector{std::sqrt(circle(3) / lambda)}; }, shears, points}};
  const auto always = [](std::size_t, const std::vector<std::size_t>&) { return true; };
  const std::vector<Bend> bends = find_bends(load, places, 10, always);
  EXPECT_EQ(find_bends(load, places, 2, always).size(), 3u);
  const auto large = [&](std::size_t k, const std::vector<std::size_t>& passing) {
    EXPECT_GE(passing.size(), 1u);
    return places[k] > 0.1;
  };
  EXPECT_EQ(find_bends(load, places, 10, large).size(), 2u);
  ASSERT_EQ(bends.size(), 4u);
  std::size_t i = 0;
  for (const double lambda : {0.9, 0.15, 0.0023, 1e-6}) {
    const auto found = std::min_element(bends.begin(), bends.end(), [&](const Bend& one, const Bend& other) {
      return std::abs(one.x - lambda) < std::abs(other.x - lambda);
    });
    EXPECT_NEAR(found->x, lambda, 1e-14 * lambda);  // bracketed to 1e-15, the load rounded
    EXPECT_TRUE(found->root_below);
    EXPECT_EQ(found->point, points[i++]);
  }
}

template <class Model>
class BendsOf : public testing::Test {};
using Laws = testing::Types<Johnson, WatersGuduru, PapangeloCiavarella>;
TYPED_TEST_SUITE(BendsOf, Laws);

/// Model a's curves fold twice at some loads, and have no fold at all below some lambda.
TYPED_TEST(BendsOf, AreWhereAPointPassesAFold) {
  const double range = TypeParam::parameters[0].upper;
  std::vector<MeasuredPoint> points;
  for (const double P : {-3.0, 0.0, 0.5, 5.0})
    for (const double T : {3.0, 11.0, 14.0, 20.0, 60.0}) points.push_back({P, T, 20, 0, 0.1});
  const Dataset data = data_of(points);
  const auto problem = make_problem<TypeParam>(data, kArea, prepare<TypeParam>(data, kArea, nullptr));
  std::vector<double> places;
  for (int i = 0; i <= 64; ++i) places.push_back(range * i / 64);
  const std::vector<Bend> bends =
      find_bends(problem->load_ends(), places, 1000, [](std::size_t, const std::vector<std::size_t>&) { return true; });
  EXPECT_TRUE(std::is_sorted(bends.begin(), bends.end(), [](auto& one, auto& other) { return one.x < other.x; }));
  ASSERT_GT(bends.size(), 5u);
  const auto passed = [&](double x) { return problem->bends_passed({&x, 1}); };
  for (const Bend& bend : bends) {
    const std::size_t below = passed(bend.x * (1 - 1e-9)), above = passed(std::min(bend.x * (1 + 1e-9), range));
    EXPECT_NE(below, above) << bend.x;
    EXPECT_EQ(bend.root_below, above > below) << bend.x;
  }
}

TEST(DipPlaces, ShowEachParabolaInTheRoot) {
  for (const auto& [bend, other] : {std::pair(0.2, 0.0), std::pair(0.5, 0.2), std::pair(0.7, 1.0)})
    for (int step = 0; step <= 73; ++step) {
      const double dip = std::pow(0.83, step);  // to 1.2e-6
      double least = std::pow(1 - dip, 2);  // at the other end
      for (const double x : dip_places(bend, other))
        least = std::min(least, std::pow(std::sqrt((bend - x) / (bend - other)) - dip, 2));
      EXPECT_LT(least, 0.99 * dip * dip) << bend << " " << dip;  // than at the bend itself
    }
}

/// Few points, one or two of a run next to its fold: basins narrower than those of any grid.
TEST(FitOfAreas, FindsTheLeastCostBetweenAnyBends) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::normal_distribution<double> normal(0, 1);
  constexpr double kNoises[] = {1e-4, 1e-3, 0.01, 0.05};
  std::size_t judged = 0;
  for (int round = 0; round < 400; ++round) {
    const double lambda = round % 2 ? uniform(random) : std::pow(10, -4 * uniform(random));
    const double noise = kNoises[random() % 4];
    const std::size_t runs = 1 + random() % 4, of_each = 2 + random() % 7;
    const double last = 0.95 + 0.2 * uniform(random);
    std::vector<MeasuredPoint> points;
    for (std::size_t run = 0; run < runs; ++run) {
      const double P = -4 + 14 * uniform(random), fold = std::sqrt(circle(P) / lambda);
      for (std::size_t i = 1; i <= of_each; ++i) {
        const double T = last * fold * static_cast<double>(i) / static_cast<double>(of_each);
        const double y = 3 * pi<double>() + std::sqrt(std::max(circle(P) - lambda * T * T, 0.0));
        const double A = pi<double>() * std::pow(0.75 * (y + P), 2.0 / 3);
        points.push_back({P, T * (1 + noise * normal(random)), A * (1 + noise * normal(random)), 0, noise * 20});
      }
    }
    const FitResult fit = fit_model(data_of(points), "c", kArea);
    if (!fit.has_values()) continue;
    ++judged;
    EXPECT_NE(fit.status, FitStatus::not_converged) << round << ": " << fit.message;
    const double found = cost(points, *fit.parameters[0].value), least = least_cost(points);
    // a thousandth of a standard error; next to a bend the last three bits of lambda may be worth more
    double last_bits = 0;
    for (int bits = -8; bits <= 8; ++bits)
      last_bits = std::max(last_bits, std::abs(cost(points, *fit.parameters[0].value * (1 + bits * 1.1e-16)) - found));
    EXPECT_LE(found, least + 1e-6 + 1e-9 * least + last_bits)
        << round << ": " << found - least << " above, at " << shortest(*fit.parameters[0].value);
  }
  EXPECT_GT(judged, 350u);
}

/// Its last loads are those of the folds, to the last digit: no slope leads to the least squares, which are 0.
TEST(FitOfAreas, OfExactDataThatEndAtTheFoldIsExact) {
  for (const double lambda : {0.2673491, 0.0695609, 0.9920213, 1.885382e-4}) {
    std::vector<MeasuredPoint> points;
    for (const double P : {-2.0, 3.8811})
      for (const double part : {0.5, 1.0}) {
        const double T = part * std::sqrt(circle(P) / lambda);
        const double y = 3 * pi<double>() + std::sqrt(std::max(circle(P) - lambda * T * T, 0.0));
        points.push_back({P, T, pi<double>() * std::pow(0.75 * (y + P), 2.0 / 3), 0, 0.03});
      }
    const FitResult fit = fit_model(data_of(points), "c", kArea);
    EXPECT_EQ(fit.status, FitStatus::ok) << lambda << ": " << fit.message;
    ASSERT_TRUE(fit.parameters[0].value);
    EXPECT_NEAR(*fit.parameters[0].value, lambda, 1e-9 * lambda);  // the root of the loads' rounding
  }
}

/// Within a standard error of a bend lies a minimum a hair wide: its curvature says nothing of the interval.
TEST(FitOfAreas, BesideABendHasAnIntervalAndNoStandardError) {
  FitOptions options = kArea;
  options.intervals = true;
  const std::vector<MeasuredPoint> points{{-3.5111, 41.05813548255005, 11.498331883869191, 0, 0.5883687565836967},
                                          {-3.5111, 86.81158701323395, 8.564897353189389, 0, 0.5883687565836967},
                                          {-0.8927, 72.29628546595329, 15.886288674152249, 0, 0.5883687565836967},
                                          {-0.8927, 149.79663213513743, 10.244310308067334, 0, 0.5883687565836967},
                                          {1.7942, 0.0, 18.97908230490339, 0, 0.5883687565836967},
                                          {1.7942, 184.3510958275972, 14.113323150644321, 0, 0.5883687565836967}};
  const FitResult fit = fit_model(data_of(points), "c", options);
  EXPECT_EQ(fit.status, FitStatus::ok) << fit.message;
  EXPECT_NEAR(fit.sum_of_squares, least_cost(points), 1e-6);
  EXPECT_FALSE(fit.parameters[0].stderr_);
  EXPECT_EQ(fit.message, "the cost of lambda bends within its interval: no standard error");
  ASSERT_TRUE(fit.parameters[0].interval && fit.parameters[0].interval->low && fit.parameters[0].interval->high);
  for (const double end : {*fit.parameters[0].interval->low, *fit.parameters[0].interval->high})
    EXPECT_NEAR(cost(points, end), fit.sum_of_squares + 3.841458820694124, 1e-6);
}

}  // namespace
}  // namespace mixity
