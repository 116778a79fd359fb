// The scan against brute force: no place of the range may lie below the minimum that it leads to.
#include "fitting/single_scan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fitting/single_fit.h"
#include "fitting/toughness_objective.h"
#include "mechanics/registry.h"

namespace mixity {
namespace {

/// Points of which each follows one of two lambdas, up to the last digits before pi/2, with noise of any size.
template <class Model>
ToughnessObjective<Model> mixture(unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform;
  std::normal_distribution<double> normal;
  const double upper = Model::parameters[0].upper, noise = std::pow(10, -4 * uniform(random));
  const double lambdas[] = {upper * std::pow(10, -6 * uniform(random)), upper * uniform(random)};
  std::vector<ToughnessPoint> points;
  for (int i = 0; i < 12; ++i) {
    const double close = std::pow(10, -7 * uniform(random));  // to pi/2
    const auto mixity = mixity_from_angle(i % 2 ? 0.5 * pi<double>() * uniform(random) : 0.5 * pi<double>() - close);
    const double lambda = lambdas[uniform(random) < 0.5];
    points.push_back({mixity, std::exp(Model::log_toughness({lambda}, mixity).value + noise * normal(random))});
  }
  return ToughnessObjective<Model>(std::move(points), Scale::log, FreeChoice<Model>({{0.15}, {}}, {}));
}

template <class Model>
class SingleScanOf : public ::testing::Test {};
using OneParameterModels = ::testing::Types<Johnson, WatersGuduru, PapangeloCiavarella>;
TYPED_TEST_SUITE(SingleScanOf, OneParameterModels);

TYPED_TEST(SingleScanOf, LeadsToTheLowestCostOfTheRange) {
  for (unsigned seed = 1; seed <= 300; ++seed) {
    const auto problem = mixture<TypeParam>(seed);
    const auto cost = problem.single_cost();
    const SingleFit fit = solve_single(*cost, problem);
    if (fit.status == FitStatus::not_identifiable) continue;
    const double upper = problem.parameters()[0].upper;
    for (int i = 0; i <= 1000; ++i)
      for (const double x : {upper * i / 1000, upper * std::pow(10, -14.0 * i / 1000)})
        if (const auto here = cost->value(x)) {
          // a slope of 1e-14 of its terms leaves the cost at its least but for rounding
          ASSERT_GE(*here, fit.sum_of_squares * (1 - 1e-9) - 1e-24) << "seed " << seed << " at " << x;
        }
  }
}

/// Costs whose curvature is Gauss-Newton's are looked at in fixed places, with the same result.
TYPED_TEST(SingleScanOf, FindsTheSameThroughTheJacobian) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    const auto problem = mixture<TypeParam>(seed);
    GeneralCost general(problem);
    const SingleFit fast = solve_single(*problem.single_cost(), problem), slow = solve_single(general, problem);
    if (fast.status != FitStatus::ok || slow.status != FitStatus::ok) continue;
    EXPECT_NEAR(slow.x, fast.x, 1e-7 * fast.x) << seed;  // the secant ends at sqrt(eps) of the cost
  }
}

}  // namespace
}  // namespace mixity
