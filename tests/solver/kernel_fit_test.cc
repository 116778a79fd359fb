// The kernel and Ceres, which the fit that is shown is made with: the same minimum, the same status.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fitting/models.h"
#include "fitting/toughness_objective.h"
#include "solver/interval.h"
#include "solver/kernel.h"
#include "solver/solve.h"

namespace mixity {
namespace kernel_fit_test {

const SolverOptions kWithKernel{.engine = Engine::kernel};

ToughnessObjective simulated(const ContactModel& model, double lambda, double noise, std::size_t n, std::uint64_t seed,
                             double psi_most) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<ToughnessPoint> points;
  for (std::size_t i = 0; i < n; ++i) {
    const auto mixity = mixity_from_angle(psi_most * (static_cast<double>(i) + 0.5) / static_cast<double>(n));
    points.push_back({mixity, std::exp(log_f(model, {lambda}, mixity) + noise * normal(random))});
  }
  return ToughnessObjective(points, Scale::log, FreeChoice(model, {{0.15}, {}}, {}));
}

/// Both engines on the same problem. Compared only where the answer does not hang by a rounding.
void expect_same(const Problem& problem, const std::string& where) {
  const Verdict shown = solve(problem), kernel = solve(problem, {}, kWithKernel);
  ASSERT_EQ(to_string(kernel.status), to_string(shown.status)) << where << ' ' << shown.message;
  if (shown.status == FitStatus::not_identifiable) return;
  // Both are exact zeros of the same slope, but for the roundings of its sum.
  EXPECT_NEAR(kernel.best.x[0], shown.best.x[0], 1e-10 * std::abs(shown.best.x[0])) << where;
  const double least = shown.best.sum_of_squares;
  EXPECT_NEAR(kernel.best.sum_of_squares, least, 1e-9 * least + 1e-24) << where;
  // without noise the residuals are roundings
  if (shown.standard_errors[0] && least > 1e-20) {
    EXPECT_NEAR(*kernel.standard_errors[0], *shown.standard_errors[0], 1e-8 * *shown.standard_errors[0]) << where;
  }
}

class OneParameter : public OfModel {};
INSTANTIATE_TEST_SUITE_P(OfLambda, OneParameter, ::testing::Values("a", "b", "c"));

TEST_P(OneParameter, KernelAndCeresAgreeInValueAndStatus) {
  int cases = 0;
  for (const double lambda : {1e-4, 0.0023, 0.05, 0.3, 0.7, 0.95})
    for (const double noise : {0.0, 1e-3, 0.02, 0.2})
      for (const double psi_most : {0.3, 1.2, 1.55}) {
        // 0.2 noise at psi up to 0.3 leaves lambda on the edge of being identifiable, where a rounding decides
        if (noise == 0.2 && psi_most == 0.3) continue;
        const auto problem = simulated(model(), lambda, noise, 60, static_cast<std::uint64_t>(++cases), psi_most);
        expect_same(problem, key() + " lambda " + std::to_string(lambda) + " noise " + std::to_string(noise) + " psi " +
                                 std::to_string(psi_most));
      }
  EXPECT_GT(cases, 60);
}

TEST_P(OneParameter, BothFindABoundAndNothingWhereThereIsNoShear) {
  // ln f larger than the model can reach, and 0
  for (const double sign : {1.0, -1.0}) {
    std::vector<ToughnessPoint> points;
    for (int i = 1; i <= 20; ++i) points.push_back({mixity_from_angle(0.07 * i), std::exp(sign * 0.3 * i)});
    expect_same(ToughnessObjective(points, Scale::log, FreeChoice(model(), {{0.15}, {}}, {})), "bound");
  }
  std::vector<ToughnessPoint> points(20, ToughnessPoint{mixity_from_angle(0), 1.1});
  expect_same(ToughnessObjective(points, Scale::log, FreeChoice(model(), {{0.15}, {}}, {})), "no shear");
}

TEST_P(OneParameter, KernelFromAnyStartEndsAtTheMinimumOrSaysThatItDidNot) {
  const auto problem = simulated(model(), 0.3, 0.02, 80, 11, 1.5);
  const Verdict best = solve(problem, {}, kWithKernel);
  ASSERT_EQ(best.status, FitStatus::ok) << best.message;
  Kernel kernel(problem);
  int ended = 0;
  for (int i = 0; i < 200; ++i) {
    const double start = std::pow(10.0, -6 + 6.0 * i / 199);
    const auto minimum = kernel.descend({&start, 1});
    if (!minimum || !minimum->stationary) continue;
    ++ended;
    EXPECT_NEAR(minimum->x[0], best.best.x[0], 1e-10 * best.best.x[0]) << start;
  }
  EXPECT_GT(ended, 190);
}

TEST_P(OneParameter, ProfileEndsLieWhereTheCostHasRisenByTheAllowance) {
  const auto problem = simulated(model(), 0.3, 0.02, 80, 12, 1.5);
  const Verdict fit = solve(problem);
  ASSERT_EQ(fit.status, FitStatus::ok) << fit.message;
  const double least = fit.best.sum_of_squares, allowance = cost_allowance(0.95, least, 80, 1, false);
  const Interval interval = profile_intervals(problem, fit.best, 0.95, allowance, fit.standard_errors)[0];
  ASSERT_EQ(interval.low_status, EndStatus::found);
  ASSERT_EQ(interval.high_status, EndStatus::found);
  std::vector<double> residuals(80);
  for (const double end : {interval.low, interval.high})
    EXPECT_NEAR(sum_of_squares(problem, {&end, 1}, residuals).value(), least + allowance, 1e-9 * least);
}

}  // namespace kernel_fit_test
}  // namespace mixity
