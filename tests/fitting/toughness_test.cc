#include <ceres/jet.h>
#include <gtest/gtest.h>

#include <cmath>

#include "fitting/problem_checks.h"
#include "fitting/toughness_objective.h"
#include "mechanics/model_types.h"

namespace mixity {
namespace toughness_test {

std::vector<ToughnessPoint> points() {
  std::vector<ToughnessPoint> list;
  for (const double psi : {0.0, 1e-6, 0.1, 0.5, 0.8, 1.1, 1.4, 1.56}) list.push_back({mixity_from_angle(psi), 1 + psi});
  return list;
}

template <class Law>
class ToughnessOfLaw : public ::testing::Test {};
TYPED_TEST_SUITE(ToughnessOfLaw, ModelTypes);

class ToughnessOf : public OfModel {};
INSTANTIATE_TEST_SUITE_P(EachModel, ToughnessOf, ::testing::ValuesIn(published_keys()));

/// The analytic Jacobian against autodiff of the same expression: equal but for rounding.
TYPED_TEST(ToughnessOfLaw, JacobianMatchesAutodiff) {
  constexpr int N = static_cast<int>(parameter_count<TypeParam>);
  using Jet = ceres::Jet<double, N>;
  for (const Scale scale : {Scale::log, Scale::linear})
    for (const double q : {0.01, 0.3, 0.8}) {
      ParameterValues p = ParameterValues::zeros(N);
      for (int k = 0; k < N; ++k) p[k] = TypeParam::parameters[k].typical * (0.5 + q);
      const ContactModel model = model_named(std::string(TypeParam::info.key));
      const ToughnessObjective objective(points(), scale, FreeChoice(model, {p, {}}, {}));
      const std::size_t n = objective.residual_count();
      std::vector<double> residuals(n), jacobian(n * N);
      ASSERT_TRUE(objective.evaluate(p, residuals, jacobian));
      for (std::size_t i = 0; i < n; ++i) {
        std::array<Jet, parameter_count<TypeParam>> jets;
        for (int k = 0; k < N; ++k) jets[k] = Jet(p[k], k);
        const auto mixity = points()[i].mixity;
        const Jet log_f = TypeParam::log_toughness(jets, Mixity<Jet>{Jet(mixity.cos), Jet(mixity.sin)}).value;
        const Jet f = scale == Scale::log ? log_f : exp(log_f);
        for (int k = 0; k < N; ++k)
          // a few roundings of terms that are at most as large as the entry itself, or as 1e-3
          EXPECT_NEAR(jacobian[i * N + k], f.v[k], 1e-13 * (std::abs(f.v[k]) + 1e-3)) << i << ' ' << k;
      }
    }
}

/// Against central differences: right to h^2 of the third derivative.
TEST_P(ToughnessOf, JacobianMatchesFiniteDifferences) {
  const std::size_t N = parameter_count();
  ParameterValues p = ParameterValues::zeros(N);
  for (std::size_t k = 0; k < N; ++k) p[k] = model().parameters()[k].typical;
  for (const Scale scale : {Scale::log, Scale::linear}) {
    const ToughnessObjective objective(points(), scale, FreeChoice(model(), {p, {}}, {}));
    const std::size_t n = objective.residual_count();
    std::vector<double> residuals(n), low(n), high(n), jacobian(n * N);
    ASSERT_TRUE(objective.evaluate(p, residuals, jacobian));
    for (std::size_t k = 0; k < N; ++k) {
      const double h = 1e-5 * p[k];
      ParameterValues below = p, above = p;
      below[k] -= h;
      above[k] += h;
      ASSERT_TRUE(objective.evaluate(below, low, {}));
      ASSERT_TRUE(objective.evaluate(above, high, {}));
      for (std::size_t i = 0; i < n; ++i) {
        const double difference = (high[i] - low[i]) / (2 * h), entry = jacobian[i * N + k];
        // h^2 = 2e-12 of a third derivative that reaches 1e3 of the entry near psi = pi/2, and eps |r|/h of rounding
        EXPECT_NEAR(entry, difference, 1e-8 * std::abs(entry) + 1e-9) << i;
      }
    }
  }
}

/// The same residuals from loads and areas with their constants, Jacobian included.
TEST_P(ToughnessOf, LoadsIsThatOfThePhaseAngles) {
  const ParameterValues p = typical_cases(model())[0];
  const auto measured = points_off(key(), p);
  std::vector<ToughnessPoint> converted;
  converted.reserve(measured.size());
  for (const MeasuredPoint& q : measured) converted.push_back(*toughness_of_area(q.P, q.T, q.A));
  const FreeChoice choice(model(), {p, {}}, {});
  const ToughnessObjective plain(converted, Scale::log, choice);
  const ToughnessOfLoads loaded(measured, choice);
  const std::vector<double> x(p.begin(), p.end()), one = residuals_of(plain, x), other = residuals_of(loaded, x);
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_NEAR(one[i], other[i], 1e-13) << i;  // roundings of ln f
}

/// A residual is of order one, good to some eps, which h makes 1e-9 of it for lambda = 0.0023.
TEST_P(ToughnessOf, LoadsHasTheJacobianOfItsDifferences) {
  for (const ParameterValues& p : typical_cases(model()))
    for (const Constants& c : kSomeConstants)
      expect_jacobian(ToughnessOfLoads(points_off(key(), p), everything_free(model())), solver_point(p, c), 1e-8,
                      std::to_string(p[0]));
}

TEST_P(ToughnessOf, LoadsWithTheRightConstantsIsThatOfRightData) {
  const ParameterValues p = typical_cases(model())[1];
  const auto right = points_off(key(), p);
  const ToughnessOfLoads one(right, everything_free(model())),
      other(misread(right, kWrongConstants), everything_free(model()));
  const auto r = residuals_of(one, solver_point(p, {})), s = residuals_of(other, solver_point(p, kWrongConstants));
  for (std::size_t i = 0; i < r.size(); ++i) EXPECT_NEAR(r[i], s[i], 1e-12);  // roundings of ln f, some of them
}

TEST(ToughnessObjective, LeavesHeldParametersAlone) {
  const ToughnessObjective objective(points(), Scale::linear,
                                     FreeChoice(model_named("bk"), {{1.774, 2}, {}}, {true, false}));
  ASSERT_EQ(objective.parameters().size(), 1u);
  EXPECT_EQ(objective.parameters()[0].name, "eta");
  const double eta = 2.284;
  EXPECT_EQ(objective.candidate({&eta, 1}).parameters, (ParameterValues{1.774, 2.284}));
}

/// The search computes values alone; below eta = 1/2 these come from other terms than those with derivatives.
TEST(ToughnessObjective, HasTheSameResidualsWithoutDerivatives) {
  std::vector<ToughnessPoint> all;
  for (const double psi : {1e-200, 1e-9, 0.05, 0.4, 0.8, 1.2, 1.57}) all.push_back({mixity_from_angle(psi), 1.0});
  const ToughnessObjective objective(all, Scale::log, FreeChoice(model_named("bk"), {{2, 2}, {}}, {false, false}));
  std::vector<double> with(all.size()), alone(all.size()), roughly(all.size()), slopes(2 * all.size());
  for (const double r : {1e-3, 0.3, 1.0, 3.0, 1e3})
    for (const double eta : {0.01, 0.1, 0.4999, 0.5, 2.0, 100.0}) {
      const std::vector<double> x{r, eta};
      ASSERT_TRUE(objective.evaluate(x, with, slopes));
      ASSERT_TRUE(objective.evaluate(x, alone, {}));
      ASSERT_TRUE(objective.evaluate_roughly(x, roughly));
      for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_NEAR(alone[i], with[i], 1e-13 * (1 + std::abs(with[i]))) << r << ' ' << eta << ' ' << i;
        EXPECT_EQ(roughly[i], alone[i]);
      }
    }
}

TEST(ToughnessObjective, ReportsAnInfiniteValueInsteadOfReturningIt) {
  const ToughnessObjective objective({{Mixity<double>{0, 1}, 5.0}}, Scale::log,
                                     FreeChoice(model_named("c"), {{0.5}, {}}, {false}));
  std::vector<double> residual(1);
  const double zero = 0, small = 1e-3;
  EXPECT_FALSE(objective.evaluate({&zero, 1}, residual, {}));
  EXPECT_TRUE(objective.evaluate({&small, 1}, residual, {}));
}

}  // namespace toughness_test
}  // namespace mixity
