// Fits that others have published, against their values in 40-digit arithmetic: Puromycin and BOD (D. M. Bates,
// D. G. Watts: Nonlinear Regression Analysis, 1988), Pearson's points with York's weights (D. York, Can. J. Phys. 44,
// 1966; errors: D. York et al., Am. J. Phys. 72, 2004) and the first driver of ODRPACK (P. T. Boggs et al., 1992).
#include <gtest/gtest.h>

#include "solver/interval.h"
#include "solver/jet_problem.h"
#include "solver/solve.h"

namespace mixity {
namespace published_fits_test {

// The minima are to their last digits, and these cost a few of condition; an interval's end promises 1e-9.
constexpr double kValue = 1e-10, kEnd = 1e-9;

using std::exp, std::expm1, std::sqrt;

Verdict fit(const Problem& problem, Engine engine = Engine::ceres) {
  std::vector<double> start;
  for (const FreeParameter& parameter : problem.parameters()) start.push_back(*parameter.start);
  return solve(problem, {.near = start}, {.engine = engine});
}

void expect_values(const Verdict& verdict, const std::vector<double>& values, const std::vector<double>& errors) {
  ASSERT_EQ(verdict.status, FitStatus::ok) << verdict.message;
  for (std::size_t k = 0; k < values.size(); ++k) EXPECT_LE(relative_error(verdict.best.x[k], values[k]), kValue);
  for (std::size_t k = 0; k < errors.size(); ++k)
    EXPECT_LE(relative_error(verdict.standard_errors[k].value(), errors[k]), kValue);
}

Interval interval_of(const Problem& problem, const Verdict& verdict, std::size_t k, double confidence,
                     double allowance) {
  return profile_intervals(problem, verdict.best, confidence, allowance, verdict.standard_errors)[k];
}

double scatter_allowance(const Problem& problem, const Verdict& verdict, double confidence) {
  return cost_allowance(confidence, verdict.best.sum_of_squares, problem.residual_count(), problem.parameters().size(),
                        false);
}

void expect_ends(const Interval& interval, double low, double high) {
  EXPECT_EQ(interval.low_status, EndStatus::found);
  EXPECT_EQ(interval.high_status, EndStatus::found);
  EXPECT_LE(relative_error(interval.low, low), kEnd);
  EXPECT_LE(relative_error(interval.high, high), kEnd);
  EXPECT_TRUE(interval.deeper.empty());
}

class Published : public ::testing::TestWithParam<Engine> {};

/// y = Vm c/(K + c)
TEST_P(Published, PuromycinHasItsProfileIntervals) {
  const std::vector<double> c{.02, .02, .06, .06, .11, .11, .22, .22, .56, .56, 1.1, 1.1};
  const std::vector<double> y{76, 47, 97, 107, 123, 139, 159, 152, 191, 201, 207, 200};
  const auto problem = problem_of<2>(12, {unbounded("Vm", 200), unbounded("K", 0.1)}, {norm(y)},
                                     [&](const auto* b, std::size_t i) { return b[0] * c[i] / (b[1] + c[i]) - y[i]; });
  const Verdict verdict = fit(problem, GetParam());
  expect_values(verdict, {212.683743142536069, 0.0641212816815670725}, {6.94715516004071995, 0.00828094949848035221});
  EXPECT_LE(relative_error(verdict.best.sum_of_squares, 1195.44881443935927), kValue);
  const double allowance = scatter_allowance(problem, verdict, 0.95);
  expect_ends(interval_of(problem, verdict, 0, 0.95, allowance), 197.301932900283954, 229.289055055053250);
  expect_ends(interval_of(problem, verdict, 1, 0.95, allowance), 0.0469203420351707509, 0.0861569134271387224);
}

const std::vector<double> kBodTime{1, 2, 3, 4, 5, 7}, kBodDemand{8.3, 10.3, 19, 16, 15.6, 19.8};

/// y = A (1 - exp(-k t))
TEST_P(Published, BodHasItsIntervalAt95PercentAndNoneAboveAt99) {
  const auto problem = problem_of<2>(
      6, {unbounded("A", 20), unbounded("k", 0.5)}, {norm(kBodDemand)},
      [](const auto* b, std::size_t i) { return b[0] * (1.0 - exp(-b[1] * kBodTime[i])) - kBodDemand[i]; });
  const Verdict verdict = fit(problem, GetParam());
  expect_values(verdict, {19.1425752846178676, 0.531091376965210029}, {});
  EXPECT_LE(relative_error(verdict.best.sum_of_squares, 25.9902672819413347), kValue);
  expect_ends(interval_of(problem, verdict, 1, 0.95, scatter_allowance(problem, verdict, 0.95)), 0.131397746702412,
              1.80816959473445);
  const Interval wide = interval_of(problem, verdict, 1, 0.99, scatter_allowance(problem, verdict, 0.99));
  EXPECT_EQ(wide.high_status, EndStatus::open);
}

/// (1 - exp(-z))/z, through z = 0
template <class T>
T mean_decay(const T& z) {
  if (z < 1e-3) return 1.0 - z / 2.0 * (1.0 - z / 3.0 * (1.0 - z / 4.0 * (1.0 - z / 5.0 * (1.0 - z / 6.0))));
  return (1.0 - exp(-z)) / z;
}

/// The same with A k for A, which is regular at k = 0; and as above, where A grows beyond all bounds on the way.
TEST_P(Published, BodReachesABoundAtZero) {
  const std::vector<FreeParameter> parameters{unbounded("c", 10), {"k", 0, std::numeric_limits<double>::infinity()}};
  const auto check = [&](const Problem& problem, double first) {
    const Verdict verdict = solve(problem, {.near = {first, 0.5}}, {.engine = GetParam()});
    ASSERT_EQ(verdict.status, FitStatus::ok) << verdict.message;
    EXPECT_LE(relative_error(verdict.best.x[1], 0.531091376965210029), kValue);
    expect_ends(interval_of(problem, verdict, 1, 0.95, scatter_allowance(problem, verdict, 0.95)), 0.131397746702412,
                1.80816959473445);
    const Interval wide = interval_of(problem, verdict, 1, 0.99, scatter_allowance(problem, verdict, 0.99));
    EXPECT_EQ(wide.low_status, EndStatus::at_bound);
    EXPECT_EQ(wide.low, 0);
    EXPECT_EQ(wide.high_status, EndStatus::open);
  };
  check(problem_of<2>(6, parameters, {norm(kBodDemand)},
                      [](const auto* b, std::size_t i) {
                        return b[0] * kBodTime[i] * mean_decay(b[1] * kBodTime[i]) - kBodDemand[i];
                      }),
        10);
  check(problem_of<2>(6, parameters, {norm(kBodDemand)},
                      [](const auto* b, std::size_t i) { return -b[0] * expm1(-b[1] * kBodTime[i]) - kBodDemand[i]; }),
        20);
}

/// y = intercept + slope x; the distance of a point from the line, in standard errors along its shortest way.
TEST_P(Published, PearsonsPointsWithYorksWeightsHaveErrorsInBothAxes) {
  const std::vector<double> x{0, .9, 1.8, 2.6, 3.3, 4.4, 5.2, 6.1, 6.5, 7.4};
  const std::vector<double> y{5.9, 5.4, 4.4, 4.6, 3.5, 3.7, 2.8, 2.8, 2.4, 1.5};
  const std::vector<double> wx{1000, 1000, 500, 800, 200, 80, 60, 20, 1.8, 1},
      wy{1, 1.8, 4, 8, 20, 20, 70, 70, 100, 500};
  double squares = 0;
  for (std::size_t i = 0; i < 10; ++i) squares += wy[i] * y[i] * y[i];
  const auto problem = problem_of<2>(10, {unbounded("intercept", 5), unbounded("slope", -0.4)},
                                     {std::sqrt(squares), true}, [&](const auto* b, std::size_t i) {
                                       return (y[i] - b[0] - b[1] * x[i]) / sqrt(1 / wy[i] + b[1] * b[1] / wx[i]);
                                     });
  const Verdict verdict = fit(problem, GetParam());
  expect_values(verdict, {5.47991022403286536, -0.480533407446201987}, {0.294970735493108564, 0.0579850090007744364});
  EXPECT_LE(relative_error(verdict.best.sum_of_squares, 11.8663531940614453), kValue);
  const double chi_square = cost_allowance(0.95, verdict.best.sum_of_squares, 10, 2, true);
  expect_ends(interval_of(problem, verdict, 1, 0.683, 1), -0.540235934533822, -0.425165940287338);
  expect_ends(interval_of(problem, verdict, 1, 0.95, chi_square), -0.601441332467526, -0.376302196730043);
  expect_ends(interval_of(problem, verdict, 1, 0.95, scatter_allowance(problem, verdict, 0.95)), -0.658612774159460,
              -0.336752323750298);
}

/// y = b1 + b2 (exp(b3 x) - 1)^2. The true x of nine points are parameters, too; those of three are exact.
TEST_P(Published, OdrpacksFirstDriverHasErrorsInMostAbscissas) {
  const std::vector<double> x{0, 0, 5, 7, 7.5, 10, 16, 26, 30, 34, 34.5, 100};
  const std::vector<double> y{1265, 1263.6, 1258, 1254, 1253, 1249.8, 1237, 1218, 1220.6, 1213.8, 1215.5, 1212};
  std::vector<FreeParameter> parameters{unbounded("b1", 1500), unbounded("b2", -50), unbounded("b3", -0.1)};
  for (std::size_t i = 2; i < 11; ++i) parameters.push_back(unbounded("x" + std::to_string(i + 1), x[i]));
  const auto problem = problem_of<12>(21, parameters, {norm(y)}, [&](const auto* b, std::size_t i) {
    using T = std::decay_t<decltype(*b)>;
    if (i >= 12) return b[i - 9] - x[i - 10];
    const T at = i >= 2 && i < 11 ? b[i + 1] : T(x[i]), grown = exp(b[2] * at) - 1.0;
    return b[0] + b[1] * grown * grown - y[i];
  });
  const Verdict verdict = fit(problem, GetParam());
  expect_values(verdict, {1264.65481050061939, -54.0183868226886378, -0.0878498517620776498},
                {1.03492723483578, 1.58399671240039, 0.0063322190368379});
  EXPECT_LE(relative_error(verdict.best.sum_of_squares, 21.4455016594015455), kValue);
}

INSTANTIATE_TEST_SUITE_P(Engines, Published, ::testing::Values(Engine::ceres, Engine::kernel),
                         [](const auto& of) { return of.param == Engine::ceres ? "Ceres" : "Kernel"; });

}  // namespace published_fits_test
}  // namespace mixity
