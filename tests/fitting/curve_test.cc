// Objective curve on loads and areas: its residuals against what they are called, its Jacobian against differences.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "fitting/curve_objective.h"
#include "fitting/problem_checks.h"

namespace mixity {
namespace curve_test {

class CurveOf : public OfModel {};
INSTANTIATE_TEST_SUITE_P(EachModel, CurveOf, ::testing::ValuesIn(published_keys()));

/// A residual of size 1 to 10 is good to some 1e-13 (nearest points to 1e-15 over errors of 2 %), which h makes 1e-9 of
/// it for lambda = 0.0023; h^4 = 1e-14 of a fifth derivative that reaches 1e4 near the fold.
TEST_P(CurveOf, JacobianMatchesDifferences) {
  for (const ParameterValues& p : typical_cases(model()))
    for (const Constants& c : kSomeConstants)
      expect_jacobian(CurveObjective(points_off(key(), p), everything_free(model())), solver_point(p, c), 1e-8,
                      std::to_string(p[0]));
}

/// Where T is nearly exact the distance is A's; for small errors of T it differs by (sigma_T dA/dT/sigma_A)^2.
TEST_P(CurveOf, DistanceTendsToThatInAWhereTIsExact) {
  for (const ParameterValues& p : typical_cases(model()))
    for (const double sigma_T : {1e-2, 3e-3, 1e-6}) {
      const auto measured = points_off(key(), p, sigma_T, 0.6);
      const auto r = residuals_of(CurveObjective(measured, everything_free(model())), solver_point(p, {}));
      // |dA/dT| is below A/T_scale there, so that the errors' ratio is below sigma_T/0.02, and its square halves into
      // the secant of a small angle; residuals reach 3. Areas are good to 4e-15, of which 50 are a standard error.
      const double off = 3 * 0.5 * std::pow(sigma_T / 0.02, 2) + 1e-12;
      for (std::size_t i = 0; i < r.size(); ++i) {
        const MeasuredPoint& q = measured[i];
        const double y = model().equilibria(p, q.P, {&q.T, 1}).at[0].y;
        const double in_A = (area_from_radius(radius_from_edge_load(y, q.P)) - q.A) / q.sigma_A;
        EXPECT_NEAR(r[i], in_A, off) << sigma_T << ' ' << i;
      }
    }
}

/// Constants that put misread data right: the same contact in other units has the same residuals.
TEST_P(CurveOf, ConstantsUndoWhatWrongOnesDo) {
  const ParameterValues p = typical_cases(model())[1];
  const auto right = points_off(key(), p);
  const CurveObjective one(right, everything_free(model())),
      other(misread(right, kWrongConstants), everything_free(model()));
  const auto r = residuals_of(one, solver_point(p, {})), s = residuals_of(other, solver_point(p, kWrongConstants));
  for (std::size_t i = 0; i < r.size(); ++i) EXPECT_NEAR(r[i], s[i], 1e-11);  // roundings over errors of 2 %
}

/// Points are looked at by load, and in blocks on several threads: residuals and rows stay in the order of the points.
TEST_P(CurveOf, ResidualsStandInTheOrderOfThePoints) {
  const ParameterValues p = typical_cases(model())[1];
  const auto few = points_off(key(), p);
  std::vector<MeasuredPoint> many;
  while (many.size() < 40000) many.push_back(few[many.size() * 7 % few.size()]);
  const auto choice = everything_free(model());
  const CurveObjective one(few, choice), other(many, choice);
  const std::vector<double> x = solver_point(p, kSomeConstants[1]);
  std::vector<double> r(few.size()), J(few.size() * x.size()), s(many.size()), K(many.size() * x.size());
  ASSERT_TRUE(one.evaluate(x, r, J));
  ASSERT_TRUE(other.evaluate(x, s, K));
  for (std::size_t i = 0; i < many.size(); ++i) {
    const std::size_t same = i * 7 % few.size();
    ASSERT_EQ(s[i], r[same]) << i;
    for (std::size_t k = 0; k < x.size(); ++k) ASSERT_EQ(K[i * x.size() + k], J[same * x.size() + k]) << i << ' ' << k;
  }
}

/// Equilibrium depends on T^2: readings below zero are noise about zero, and as far from the curve as those above.
/// Whatever the parameters were before, bounds among them, and whatever the constants.
TEST_P(CurveOf, PlacesRememberedFromOtherParametersChangeNoResidual) {
  const auto measured = points_off(key(), typical_cases(model())[1]);
  const CurveObjective objective(measured, everything_free(model()));
  const std::size_t n = objective.residual_count();
  std::vector<ParameterValues> walk = typical_cases(model());
  if (parameter_count() == 1)
    for (const double share : {0.0, 0.9, 1.0, 1e-3, 0.3, 0.0, 0.31})
      walk.push_back({share * model().parameters()[0].upper});
  else
    for (const double r : {0.5, 1.5, 1.6, 1.0, 3.0}) walk.push_back({r, 2.5});
  std::vector<double> memory, jacobian(n * (walk[0].size() + kConstantNames.size())), warm(n);
  for (const Constants& c : kSomeConstants)
    for (const ParameterValues& p : walk) {
      const std::vector<double> x = solver_point(p, c);
      ASSERT_TRUE(objective.evaluate_again(x, warm, jacobian, memory)) << p[0];
      const std::vector<double> cold = residuals_of(objective, x);
      // some roundings of T and A over errors of 2 %; of a place far off 1e-12 of the distance
      for (std::size_t i = 0; i < n; ++i)
        EXPECT_NEAR(warm[i], cold[i], 1e-11 * (1 + std::abs(cold[i]))) << p[0] << ' ' << i;
    }
}

/// Model a's curve ends at Hertz at lambda = 1 and nowhere below: points after the jump must not make the cost jump
/// there.
TEST(CurveObjective, OfModelAIsContinuousAtItsBound) {
  const std::vector<MeasuredPoint> slid{{4, 12, 9.5, 0.5, 0.3}, {4, 40, 6.7, 2, 0.3}};
  const CurveObjective objective(slid, FreeChoice(model_named("a"), {{0.5}, {}}, {false}));
  const auto at_bound = residuals_of(objective, {1}), below = residuals_of(objective, {1 - 1e-13});
  for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(at_bound[i], below[i], 1e-5) << i;  // the root of 1 - lambda
}

/// Parts are of whole blocks of points sorted by load. One after the other they have each row once, to the last digit.
TEST_P(CurveOf, PartsHaveTheRowsOfTheWholeByLoad) {
  const ParameterValues p = typical_cases(model())[1];
  const auto few = points_off(key(), p);
  std::vector<MeasuredPoint> many;
  while (many.size() < 70000) many.push_back(few[many.size() * 7 % few.size()]);
  std::vector<double> expected(many.size());
  for (std::size_t i = 0; i < many.size(); ++i) expected[i] = 0.001 * static_cast<double>(i);
  const CurveObjective objective(many, everything_free(model()), expected);
  ASSERT_GT(objective.parts(), 2u);
  const std::vector<double> x = solver_point(p, kSomeConstants[1]);
  std::vector<double> r(many.size()), J(many.size() * x.size()), part_r, part_J;
  ASSERT_TRUE(objective.evaluate(x, r, J));
  std::vector<std::size_t> by_load(many.size());
  std::iota(by_load.begin(), by_load.end(), std::size_t{0});
  std::ranges::stable_sort(by_load, {}, [&](std::size_t i) { return many[i].P; });
  std::size_t rank = 0;
  for (std::size_t part = 0; part < objective.parts(); ++part) {
    ASSERT_TRUE(objective.evaluate_part(part, x, part_r, part_J));
    ASSERT_EQ(part_J.size(), part_r.size() * x.size());
    for (std::size_t i = 0; i < part_r.size(); ++i, ++rank) {
      ASSERT_LT(rank, many.size());
      const std::size_t same = by_load[rank];
      ASSERT_EQ(part_r[i], r[same]) << rank;
      for (std::size_t k = 0; k < x.size(); ++k)
        ASSERT_EQ(part_J[i * x.size() + k], J[same * x.size() + k]) << rank << ' ' << k;
    }
  }
  EXPECT_EQ(rank, many.size());
}

/// What a whitening does to one row depends on the rows before it.
TEST_P(CurveOf, RowsThatDependOnEachOtherAreOnePart) {
  const ParameterValues p = typical_cases(model())[1];
  const auto few = points_off(key(), p);
  std::vector<MeasuredPoint> many;
  while (many.size() < 70000) many.push_back(few[many.size() % few.size()]);
  EXPECT_EQ(CurveObjective(few, everything_free(model())).parts(), 1u);
  const auto whitening = std::make_shared<const Whitening>(std::nullopt, std::nullopt);
  EXPECT_GT(CurveObjective(many, everything_free(model())).parts(), 1u);
  EXPECT_EQ(CurveObjective(many, everything_free(model()), {}, whitening).parts(), 1u);
}

TEST_P(CurveOf, DistanceOfANegativeShearIsThatOfAPositiveOne) {
  const ParameterValues p = typical_cases(model())[1];
  const auto right = points_off(key(), p);
  auto mirrored = right;
  for (MeasuredPoint& q : mirrored) q.T = -q.T;
  const std::vector<double> x = solver_point(p, {});
  const auto r = residuals_of(CurveObjective(right, everything_free(model())), x),
             s = residuals_of(CurveObjective(mirrored, everything_free(model())), x);
  EXPECT_EQ(r, s);
}

/// With eta < 1 the curve leaves JKR straight down: a point above that has its nearest place at this corner, where the
/// curve's normal says nothing of the distance.
TEST(CurveObjective, AboveTheCornerOfASmallExponentTheDistanceCounts) {
  for (const double eta : {0.1, 0.36, 0.45}) {
    const double P = 17, A = area_from_radius(jkr_radius(P));
    for (const double T : {0.0, 0.01}) {
      const CurveObjective problem(std::vector<MeasuredPoint>{{P, T, A + 0.6, 1, 1}},
                                   FreeChoice(model_named("bk"), {}, {}));
      EXPECT_NEAR(residuals_of(problem, {0.68, eta})[0], -std::hypot(T, 0.6), 1e-9) << eta << ' ' << T;
    }
  }
}

/// Below pull-off no curve exists: no residual, and nothing thrown.
TEST(CurveObjective, IsNotFiniteWhereALoadHasNoCurve) {
  const CurveObjective problem(std::vector<MeasuredPoint>{{-5, 1, 20, 1, 1}, {1, 1, 20, 1, 1}},
                               FreeChoice(model_named("c"), {}, {}));
  std::vector<double> residuals(2);
  const double lambda = 0.3;
  EXPECT_FALSE(problem.evaluate({&lambda, 1}, residuals, {}));
}

}  // namespace curve_test
}  // namespace mixity
