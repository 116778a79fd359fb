// The kernel ends where Ceres does.
#include "solver/kernel.h"

#include <gtest/gtest.h>

#include "solver/descent.h"
#include "solver/jet_problem.h"

namespace mixity {
namespace kernel_test {

using std::exp, std::sqrt;

const std::vector<double> kTime{0.2, 0.5, 0.9, 1.4, 2, 2.7, 3.5, 4.4},
    kSignal{2.61, 2.1, 1.55, 1.2, 0.71, 0.6, 0.35, 0.41};
const std::vector<double> kWeights{1, 0, 2, 1, 3, 1, 0, 1};
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// amplitude exp(-rate t) + floor: the first `count` of these from x, the others 3, 0.7 and 0.2; rows by sqrt(weight).
template <int count>
auto decay(std::vector<FreeParameter> parameters, std::vector<double> weights = std::vector<double>(8, 1)) {
  return problem_of<count>(8, std::move(parameters), {norm(kSignal)}, [weights](const auto* b, std::size_t i) {
    using T = std::decay_t<decltype(*b)>;
    const auto at = [&](int k, double other) { return k < count ? b[std::min(k, count - 1)] : T(other); };
    return (at(1, 0.2) + at(2, 3) * exp(-at(0, 0.7) * kTime[i]) - kSignal[i]) * sqrt(weights[i]);
  });
}

/// Both stop at a gradient of 1e-10 of the residuals at most; conditions here are below 100.
constexpr double kSame = 1e-8;

void expect_same(const std::optional<Minimum>& kernel, const std::optional<Minimum>& ceres) {
  ASSERT_TRUE(kernel && ceres);
  EXPECT_TRUE(kernel->stationary);
  EXPECT_TRUE(ceres->stationary);
  for (std::size_t k = 0; k < ceres->x.size(); ++k)
    EXPECT_NEAR(kernel->x[k], ceres->x[k], kSame * std::abs(ceres->x[k])) << k;
  EXPECT_NEAR(kernel->sum_of_squares, ceres->sum_of_squares, 1e-13 * ceres->sum_of_squares);  // of second order
}

TEST(Kernel, EndsWhereCeresDoesWithOneParameter) {
  const auto problem = decay<1>({unbounded("rate", 1)});
  for (const double start : {0.1, 1.0, 3.0}) expect_same(Kernel(problem).descend({{start}}), descend(problem, {start}));
}

TEST(Kernel, EndsWhereCeresDoesWithSeveral) {
  const auto problem = decay<3>({unbounded("rate", 1), unbounded("floor", 0), unbounded("amplitude", 1)});
  for (const std::vector<double>& start : {std::vector<double>{1, 0, 1}, {0.2, 1, 5}, {3, 0, 2}})
    expect_same(Kernel(problem).descend(start), descend(problem, start));
}

/// (x + 1, c x^2 + x - 1) of Dennis & Schnabel 1983, 10.2, beside y: at the minimum x = 0 an undamped Gauss-Newton step
/// multiplies the distance by c. Counts its evaluations.
auto swinging(double c, int& evaluations) {
  return problem_of<2>(3, {unbounded("x", 0), unbounded("y", 0)}, {1, true},
                       [c, &evaluations](const auto* b, std::size_t i) {
                         evaluations += i == 0;
                         if (i == 0) return b[0] + 1.0;
                         return i == 1 ? c * b[0] * b[0] + b[0] - 1.0 : b[1] - b[0];
                       });
}

TEST(Kernel, ConvergesFastWhereGaussNewtonStepsSwing) {
  // By c alone, 1e-10 of the start would take 2 ln(10^10)/-ln 0.97 = 1,500 steps; by 1.2 they lead away.
  for (const double c : {-0.97, -1.2}) {
    int evaluations = 0;
    const auto problem = swinging(c, evaluations);
    const auto found = Kernel(problem).descend({{0.1, 0.5}});
    ASSERT_TRUE(found && found->stationary) << c;
    EXPECT_NEAR(found->x[0], 0, 1e-9) << c;
    EXPECT_NEAR(found->x[1], 0, 1e-9) << c;
    EXPECT_LT(evaluations, 40) << c;
  }
}

TEST(Kernel, EndsAtTheBoundWhereCeresDoes) {
  const auto one = decay<1>({{"rate", 1, 4}});
  expect_same(Kernel(one).descend({{2.0}}), descend(one, {2}));
  EXPECT_EQ(Kernel(one).descend({{2.0}})->x[0], 1);
  // the floor at its upper bound, the others free
  const auto three = decay<3>({{"rate", 0, 5}, {"floor", 0, 0.1}, {"amplitude", 0, kInfinity}});
  const auto kernel = Kernel(three).descend({{1.0, 0.05, 1.0}});
  expect_same(kernel, descend(three, {1, 0.05, 1}));
  EXPECT_EQ(kernel->x[1], 0.1);
}

TEST(Kernel, HoldsAParameterAsAProblemWithoutItDoes) {
  // floor and amplitude held is what decay<1> has for constants
  const auto two = decay<2>({unbounded("rate", 1), unbounded("floor", 0)});
  const auto one = decay<1>({unbounded("rate", 1)});
  const auto held = Kernel(two).descend({{1.0, 0.2}}, {}, 1);
  const auto free = descend(one, {1});
  ASSERT_TRUE(held && free);
  EXPECT_TRUE(held->stationary);
  EXPECT_EQ(held->x[1], 0.2);
  EXPECT_NEAR(held->x[0], free->x[0], kSame * free->x[0]);
  EXPECT_NEAR(held->sum_of_squares, free->sum_of_squares, 1e-13 * free->sum_of_squares);
}

TEST(Kernel, WeighsResidualsAsRootsOfWeightsDo) {
  const std::vector<FreeParameter> parameters{unbounded("rate", 1), unbounded("floor", 0), unbounded("amplitude", 1)};
  const auto plain = decay<3>(parameters), weighted = decay<3>(parameters, kWeights);
  expect_same(Kernel(plain).descend({{1.0, 0.0, 1.0}}, kWeights), descend(weighted, {1, 0, 1}));
  const auto one = decay<1>({unbounded("rate", 1)});
  const auto one_weighted = decay<1>({unbounded("rate", 1)}, kWeights);
  expect_same(Kernel(one).descend({{1.0}}, kWeights), descend(one_weighted, {1}));
}

/// Rows are summed 128 at a time.
TEST(Kernel, HasTheCostOfAllRowsOfANarrowJacobian) {
  constexpr std::size_t kRows = 300;
  const auto problem = problem_of<5>(
      kRows, {unbounded("a", 1), unbounded("b", 1), unbounded("c", 1), unbounded("d", 1), unbounded("e", 1)}, {1},
      [](const auto* b, std::size_t i) {
        const double t = static_cast<double>(i) / kRows;
        return b[0] + b[1] * t + b[2] * exp(-b[3] * t) + b[4] * t * t - t * t * t;
      });
  const std::vector<double> x{0.3, 1, 2, 0.7, -1};
  std::vector<double> residuals(kRows), jacobian(kRows * x.size());
  ASSERT_TRUE(problem.evaluate(x, residuals, jacobian));
  const CostValue cost = Kernel(problem).at(x);
  const auto J = as_matrix(jacobian, x.size());
  const auto r = as_vector(residuals);
  EXPECT_NEAR(cost.value, r.squaredNorm(), 1e-13 * cost.value);  // of another order of summation
  EXPECT_LT((cost.gradient - J.transpose() * r).norm(), 1e-13 * J.norm() * r.norm());
  EXPECT_LT((cost.hessian - J.transpose() * J).norm(), 1e-13 * J.squaredNorm());
}

TEST(Kernel, HasNoMinimumWhereTheStartIsNotFinite) {
  const auto problem = problem_of<1>(2, {unbounded("x", 1)}, {},
                                     [](const auto* b, std::size_t i) { return sqrt(b[0]) - static_cast<double>(i); });
  EXPECT_FALSE(Kernel(problem).descend({{-1.0}}));
  EXPECT_FALSE(descend(problem, {-1}));
}

/// x^2 + 0.2 (x - 1) i against 1: two basins, and a start so close to one minimum that a step is lost in rounding.
TEST(Kernel, StaysInTheBasinOfItsStart) {
  const auto problem = problem_of<1>(4, {{"x", -2, 2}}, {}, [](const auto* b, std::size_t i) {
    return b[0] * b[0] - 1.0 + 0.2 * (b[0] - 1.0) * static_cast<double>(i) + (i % 2 ? 0.001 : -0.001);
  });
  const double minimum = descend(problem, {1})->x[0];
  for (const double start : {0.5, 0.9, 1.0, minimum, 1.1, 1.9}) {
    const auto found = Kernel(problem).descend({{start}});
    EXPECT_TRUE(found->stationary);
    EXPECT_NEAR(found->x[0], minimum, 1e-12) << start;  // residuals of 1e-3, a slope of 2
  }
}

TEST(Kernel, NeverEndsAboveItsStart) {
  const auto problem = problem_of<1>(6, {{"x", 0.05, 12}}, {}, [](const auto* b, std::size_t i) {
    using std::sin;
    const double t = 0.3 + 0.5 * static_cast<double>(i);
    return sin(b[0] * t) - std::sin(4.3 * t) + (i % 2 ? 0.05 : -0.05);
  });
  std::vector<double> residuals(6);
  for (int i = 1; i < 120; ++i) {
    const double start = 0.1 * i;
    const auto found = Kernel(problem).descend({{start}});
    ASSERT_TRUE(found);
    EXPECT_LE(found->sum_of_squares, *sum_of_squares(problem, {&start, 1}, residuals)) << start;
  }
}

/// Beyond x[0] = 1 the residuals are not finite, and up to there the cost falls: no step gains, none is undamped.
TEST(Kernel, IsNotStationaryWhereStepsAreDampedToNothing) {
  const auto problem = problem_of<2>(3, {unbounded("x", 0), unbounded("y", 0)}, {}, [](const auto* b, std::size_t i) {
    using T = std::decay_t<decltype(*b)>;
    return i == 0 ? T(3.0 - b[0]) : i == 1 ? T(b[1] - 1.0) : T(0.1 * sqrt(1.0 - b[0]) + b[1]);
  });
  const auto minimum = Kernel(problem).descend({{0.0, 0.0}});
  ASSERT_TRUE(minimum);
  EXPECT_FALSE(minimum->stationary) << minimum->x[0] << " " << minimum->stationarity;
}

}  // namespace kernel_test
}  // namespace mixity
