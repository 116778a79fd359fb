// The search of the range finds every basin of some depth that a fine grid of values shows.
#include "solver/multistart.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "solver/basins.h"
#include "solver/descent.h"
#include "solver/jet_problem.h"
#include "solver/kernel.h"
#include "solver/solve.h"

namespace mixity {
namespace multistart_test {

using std::sin;

const std::vector<double> kTime{0.3, 0.7, 1.1, 1.6, 2.2, 2.9};

/// sin(x t) against that of 4.3, off by 0.05: many basins. Its curvature is exact if asked for.
class Sine final : public Problem {
 public:
  Sine(double lower, double upper, bool exact) : parameters_{{"x", lower, upper}}, exact_(exact) {}
  std::size_t residual_count() const override { return kTime.size(); }
  const std::vector<FreeParameter>& parameters() const override { return parameters_; }
  double data_norm() const override { return 2; }
  static double data(std::size_t i) { return std::sin(4.3 * kTime[i]) + (i % 2 ? 0.05 : -0.05); }
  bool evaluate(std::span<const double> x, std::span<double> r, std::span<double> J) const override {
    for (std::size_t i = 0; i < kTime.size(); ++i) {
      r[i] = std::sin(x[0] * kTime[i]) - data(i);
      if (!J.empty()) J[i] = kTime[i] * std::cos(x[0] * kTime[i]);
    }
    return true;
  }
  std::unique_ptr<Cost> cost() const override {
    if (exact_) return std::make_unique<ExactCost>();
    return Problem::cost();
  }

 private:
  class ExactCost final : public Cost {
   public:
    bool exact_curvature() const override { return true; }
    void at(std::span<const double> x, std::span<const double> weights, CostValue& cost) override {
      cost.value = 0;
      cost.gradient.setZero(1);
      cost.hessian.setZero(1, 1);
      cost.slope_size.setZero(1);
      cost.finite = true;
      for (std::size_t i = 0; i < kTime.size(); ++i) {
        const double w = weights.empty() ? 1 : weights[i], t = kTime[i], s = std::sin(x[0] * t),
                     c = t * std::cos(x[0] * t);
        const double r = s - data(i);
        cost.value += w * r * r;
        cost.gradient[0] += w * r * c;
        cost.hessian(0, 0) += w * (c * c - r * t * t * s);
        cost.slope_size[0] += w * c * c;
      }
      cost.slope_size = cost.slope_size.cwiseSqrt();
    }
  };

  std::vector<FreeParameter> parameters_;
  bool exact_;
};

/// Minima on a grid of 20000 from which the cost rises by a tenth of its whole range before it falls lower.
std::vector<double> minima_on_a_grid(const Problem& problem) {
  const FreeParameter& parameter = problem.parameters()[0];
  std::vector<double> residuals(problem.residual_count()), found, costs;
  constexpr int kValues = 20000;
  const auto at = [&](int i) { return parameter.lower + parameter.width() * i / kValues; };
  for (int i = 0; i <= kValues; ++i) {
    const double x = at(i);
    costs.push_back(*sum_of_squares(problem, {&x, 1}, residuals));
  }
  const auto [least, most] = std::minmax_element(costs.begin(), costs.end());
  const double rise = 0.1 * (*most - *least);
  const auto rises = [&](int from, int step) {
    for (int i = from + step; i >= 0 && i <= kValues; i += step) {
      if (costs[i] < costs[from]) return false;
      if (costs[i] > costs[from] + rise) return true;
    }
    return false;
  };
  for (int i = 1; i < kValues; ++i)
    if (costs[i] < costs[i - 1] && costs[i] <= costs[i + 1] && rises(i, -1) && rises(i, 1)) found.push_back(at(i));
  return found;
}

class EveryBasin : public ::testing::TestWithParam<std::pair<double, double>> {};

TEST_P(EveryBasin, IsFound) {
  const auto [lower, upper] = GetParam();
  for (const bool exact : {false, true}) {
    const Sine problem(lower, upper, exact);
    std::vector<double> ends;
    for (const Start& start : find_starts(problem).list)
      if (const auto minimum = descend(problem, start.x)) ends.push_back(minimum->x[0]);
    const std::vector<double> expected = minima_on_a_grid(problem);
    ASSERT_GE(expected.size(), 2);
    // Over several periods values, slopes and curvatures may agree by chance: by those, the lowest only.
    for (const double x : expected) {
      if (exact && std::abs(x - 4.3) > 0.1) continue;
      EXPECT_TRUE(std::any_of(ends.begin(), ends.end(),
                              [&](double end) { return std::abs(end - x) <= (upper - lower) / 20000; }))  // the step
          << x << (exact ? " by curvature" : " by a grid");
    }
    const Verdict verdict = solve(problem);
    EXPECT_EQ(verdict.status, FitStatus::ok) << verdict.message;
    EXPECT_NEAR(verdict.best.x[0], 4.3, 0.1);
  }
}

INSTANTIATE_TEST_SUITE_P(Ranges, EveryBasin,
                         ::testing::Values(std::pair(0.0, 10.0), std::pair(0.05, 12.0), std::pair(2.0, 9.0),
                                           std::pair(-9.9, 8.0)));

TEST(KernelWithExactCurvature, EndsWhereTheOtherDoes) {
  const Sine exact(0, 10, true), other(0, 10, false);
  for (const double start : {4.2, 4.4}) {
    const auto one = Kernel(exact).descend({{start}}), two = Kernel(other).descend({{start}}),
               ceres = descend(other, {start});
    EXPECT_NEAR(one->x[0], ceres->x[0], 1e-13);  // the kernel stops at a gradient of 1e-14
    EXPECT_NEAR(two->x[0], ceres->x[0], 1e-13);
    EXPECT_NEAR(one->sum_of_squares, ceres->sum_of_squares, 1e-14);
  }
}

TEST(FindStarts, OverTwoParametersLeadToTheLowestOfSeveralBasins) {
  const auto problem =
      problem_of<2>(6, {{"frequency", 0, 10}, {"amplitude", 0, 3}}, {2}, [](const auto* b, std::size_t i) {
        return b[1] * sin(b[0] * kTime[i]) - 1.5 * std::sin(4.3 * kTime[i]) + (i % 2 ? 0.01 : -0.01);
      });
  const Verdict verdict = solve(problem);
  ASSERT_EQ(verdict.status, FitStatus::ok) << verdict.message;
  EXPECT_NEAR(verdict.best.x[0], 4.3, 0.05);
  EXPECT_NEAR(verdict.best.x[1], 1.5, 0.05);
}

TEST(FindStarts, AreThoseOfParametersThatHaveOne) {
  const auto problem = problem_of<2>(3, {unbounded("a", 3), unbounded("b", 4)}, {},
                                     [](const auto* b, std::size_t i) { return b[0] + b[1] * static_cast<double>(i); });
  const Starts starts = find_starts(problem);
  ASSERT_EQ(starts.list.size(), 1u);
  EXPECT_EQ(starts.list[0].x, (std::vector<double>{3, 4}));
  EXPECT_TRUE(starts.dearest.empty());
}

TEST(LowestAtBound, SeesWhatAZeroSlopeHides) {
  const auto cosine = [](double sign) {
    return problem_of<1>(1, {{"x", 0, 2}}, {}, [=](const auto* b, std::size_t) {
      using std::cos;
      return 2.0 + sign * cos(b[0]);
    });
  };
  EXPECT_FALSE(lowest_at_bound(cosine(1), 0));
  EXPECT_TRUE(lowest_at_bound(cosine(-1), 0));
}

}  // namespace multistart_test
}  // namespace mixity
