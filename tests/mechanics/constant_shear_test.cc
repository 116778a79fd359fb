// a(P) at constant T: the same equation, read along the other axis.
#include "mechanics/constant_shear.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mechanics/equilibrium.h"
#include "mechanics/model_types.h"
#include "mechanics/printed_equation.h"

namespace mixity {
namespace constant_shear_test {

using truth::Digits50;
using truth::kEps;
using truth::residual_of;

template <class Model>
class ConstantShear : public ::testing::Test {};
TYPED_TEST_SUITE(ConstantShear, ModelTypes);

/// lambda log-uniform from 1e-8 to its largest value; for bk a box inside its domain.
template <class Model>
Parameters<Model> random_parameters(std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  if constexpr (parameter_count<Model> == 2)
    return {0.3 + 1.5 * uniform(random), 1 + 2 * uniform(random)};
  else
    return {Model::parameters[0].upper * std::pow(10, -8 * uniform(random))};
}

/// Calls judge(p, T, y, point) for random states, y and T over many decades.
template <class Model, class Judge>
void for_random_states(std::uint64_t seed, Judge judge) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 2000; ++i) {
    const auto p = random_parameters<Model>(random);
    const double y = std::pow(10, -4 + 7 * uniform(random));
    const double T = i % 20 == 0 ? 0 : std::pow(10, -4 + 8 * uniform(random));
    judge(p, T, y, constant_shear_point(Model{}, p, T, y));
  }
}

TYPED_TEST(ConstantShear, PointsFulfilThePrintedEquation) {
  for_random_states<TypeParam>(31, [](const auto& p, double T, double y, const ConstantShearPoint& q) {
    const auto where = [&] {
      return ::testing::Message() << TypeParam::info.key << ' ' << p[0] << ' ' << T << ' ' << y;
    };
    EXPECT_EQ(q.y, y);
    // 8 pi a^3 f from the a returned, independent of P; then y = 4/3 a^3 - P
    const Digits50 a = q.a, P = Digits50(4) / 3 * a * a * a - y;
    const Digits50 sum = 6 * truth::kPi * (P + y);
    EXPECT_LE(abs(residual_of<TypeParam>(p, P, y, T)), 12 * kEps * sum) << where();  // a few roundings, of a threefold
    EXPECT_LE(abs(Digits50(q.P) - P), 8 * kEps * (abs(P) + 2 * y)) << where();       // P is the difference of sum and y
  });
}

/// dP/dy = d(y^2 g)/dy/(6 pi) - 1, the first by central differences of the printed residual at fixed P.
TYPED_TEST(ConstantShear, SlopeIsThatOfThePrintedEquation) {
  for_random_states<TypeParam>(32, [](const auto& p, double T, double y, const ConstantShearPoint& q) {
    const Digits50 h = Digits50(y) * Digits50(1e-15);
    const Digits50 slope = (residual_of<TypeParam>(p, 0, y + h, T) - residual_of<TypeParam>(p, 0, y - h, T)) / (2 * h);
    // The residual is y^2 g - 6 pi (y + P): its slope over 6 pi is dP/dy. Roundings are of y, 1 and d(tau^2)/dy; the
    // last is a difference of terms of the size of min(y, T).
    const Digits50 truth = slope / (6 * truth::kPi);
    EXPECT_LE(abs(q.dP_dy - truth), 16 * kEps * (1 + y + std::min(y, T) + abs(truth)))
        << TypeParam::info.key << ' ' << p[0] << ' ' << T << ' ' << y;
  });
}

/// The stable state of a loaded contact, asked for its own y, gives back its load and is stable here, too.
TYPED_TEST(ConstantShear, AgreesWithTheLoadedContact) {
  std::mt19937_64 random(33);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 300; ++i) {
    const auto p = random_parameters<TypeParam>(random);
    const double P = i % 2 ? -4.6 + 9 * uniform(random) : std::pow(10, 4 * uniform(random));
    const LoadedContact contact(TypeParam{}, p, P);
    if (!contact.obstacle().empty()) continue;
    const double end = contact.branches().front().T_bottom;
    const double T = 0.9 * uniform(random) * std::min(end, 1e5), y = contact.at(T).y;
    if (!(y > 0)) continue;
    const ConstantShearPoint q = constant_shear_point(TypeParam{}, p, T, y);
    // y is right to a few roundings of y + |P|; P follows with slope dP/dy.
    EXPECT_NEAR(q.P, P, 8 * kEps * (y + std::abs(P)) * (2 + std::abs(q.dP_dy)))
        << TypeParam::info.key << ' ' << p[0] << ' ' << P << ' ' << T;
    EXPECT_GT(q.dP_dy, 0) << TypeParam::info.key << ' ' << p[0] << ' ' << P << ' ' << T;
  }
}

TYPED_TEST(ConstantShear, WithoutShearIsJkr) {
  Parameters<TypeParam> ones;
  ones.fill(1);
  for (const double y : {1e-9, 0.1, 1.0, 30.0, 1e4}) {
    const auto q = constant_shear_point(TypeParam{}, ones, 0, y);
    EXPECT_NEAR(q.P, y * y / (6 * pi<double>()) - y, 4 * kEps * (y + y * y));
    EXPECT_EQ(q.dP_dy > 0, y > 3 * pi<double>());  // pull-off at y = 3 pi
  }
}

/// Model c pulls off at y = 3 pi under any shear: P = lambda T^2/(6 pi) - 3 pi/2.
TEST(ConstantShear, ModelCPullsOffAtTheClosedFormLoad) {
  for (const double lambda : {0.0023, 0.15, 1.0})
    for (const double T : {0.0, 1.0, 10.0, 40.0}) {
      const auto q = constant_shear_point(PapangeloCiavarella{}, {lambda}, T, 3 * pi<double>());
      EXPECT_NEAR(q.dP_dy, 0, 4 * kEps);
      EXPECT_NEAR(q.P, lambda * T * T / (6 * pi<double>()) - 1.5 * pi<double>(), 1e-13);  // sums of up to 100
    }
}

TYPED_TEST(ConstantShear, IsFiniteAtAnyExtreme) {
  std::vector<Parameters<TypeParam>> list;
  if constexpr (parameter_count<TypeParam> == 2)
    list = {{1, 1}, {2, 1}, {4, 2}, {0.7, 1.5}, {0.5, 0.5}, {1e-3, 0.01}};
  else
    for (const double q : {0.0, 1e-300, 1e-16, 1e-6, 0.15, 1 - 1e-15, 1.0})
      list.push_back({TypeParam::parameters[0].upper * q});
  for (const auto& p : list)
    for (const double T : {0.0, 1e-300, 1e-160, 1e-8, 1.0, 1e4, 1e150})
      for (const double y : {1e-300, 1e-160, 1e-8, 1.0, 1e4, 1e150}) {
        const ConstantShearPoint q = constant_shear_point(TypeParam{}, p, T, y);
        EXPECT_TRUE(std::isfinite(q.P) && std::isfinite(q.a) && std::isfinite(q.dP_dy))
            << TypeParam::info.key << ' ' << p[0] << " T " << T << " y " << y << ": P " << q.P << ", a " << q.a
            << ", dP/dy " << q.dP_dy;
      }
}

}  // namespace constant_shear_test
}  // namespace mixity
