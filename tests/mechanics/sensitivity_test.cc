// The gradient of the equilibrium condition against central differences of the printed equation in 50 digits, and what
// follows from it against finite differences of the areas found.
#include "mechanics/sensitivity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "mechanics/equilibrium.h"
#include "mechanics/model_types.h"
#include "mechanics/printed_equation.h"

namespace mixity {
namespace sensitivity_test {

using truth::Digits50;

template <class Model>
std::vector<Parameters<Model>> cases() {
  if constexpr (parameter_count<Model> == 2) {
    return {{1.774, 2.284}, {3, 2.5}, {0.7, 1.5}, {0.5, 0.5}, {1.8, 1.05}};
  } else {
    std::vector<Parameters<Model>> list;
    for (const double lambda : {1e-6, 0.0023, 0.15, 0.9, 1.0}) list.push_back({lambda});
    if (Model::parameters[0].upper == 2) list.push_back({1.7});
    return list;
  }
}

/// The printed condition as a function of what the gradient differentiates in: the area, not the edge load.
template <class Model>
Digits50 printed_F(const Digits50& A, const Digits50& T, const Digits50& P, const Digits50& p0, const Digits50& p1) {
  const Digits50 a = sqrt(Digits50(A / truth::kPi));
  return truth::printed_residual<Digits50>(Model::info.key, p0, p1, P, Digits50(Digits50(4) / 3 * a * a * a - P), T);
}

/// Central difference with a step of 1e-12: h^2 and the rounding of 50 digits leave 20 digits.
template <class F>
double slope(F&& f, const Digits50& x) {
  const Digits50 h = Digits50(1e-12) * (x == 0 ? Digits50(1) : Digits50(abs(x)));
  return static_cast<double>(Digits50((f(Digits50(x + h)) - f(Digits50(x - h))) / (2 * h)));
}

template <class Model>
class Sensitivity : public ::testing::Test {};
TYPED_TEST_SUITE(Sensitivity, ModelTypes);

/// States of the whole quarter plane of (y, T), on the equilibrium curve or far from it.
TYPED_TEST(Sensitivity, GradientIsThatOfThePrintedEquation) {
  using Model = TypeParam;
  constexpr std::size_t N = parameter_count<Model>;
  for (const Parameters<Model>& p : cases<Model>())
    for (const double P : {-2.0, 0.0, 3.0, 300.0})
      for (const double y : {2.5, 9.0, 18.0, 150.0})
        for (const double T : {0.01, 3.0, 20.0, 400.0}) {
          const EquilibriumGradient<Model> found = equilibrium_gradient(Model{}, p, P, T, y);
          const Digits50 a = cbrt(Digits50(Digits50(3) / 4 * (Digits50(y) + P))), A = truth::kPi * a * a;
          const Digits50 p0 = p[0], p1 = p[N - 1];
          const ShearTerm<double> tau2 = Model::shear_term(p, y, T);
          const auto where = [&] {
            return ::testing::Message() << Model::info.key << " p0=" << p[0] << " P=" << P << " y=" << y << " T=" << T;
          };
          // A few roundings of the terms that each derivative is the sum of; tau^2 itself is good to a few.
          const double eps = 32 * truth::kEps, da = 2 * radius_from_edge_load(y, P) / pi<double>();
          const double change = 2 * y + 6 * pi<double>() + std::abs(tau2.d1);
          const double by_A = slope([&](const Digits50& x) { return printed_F<Model>(x, T, P, p0, p1); }, A);
          EXPECT_NEAR(found.A, by_A, eps * change * da) << where();
          const double by_T = slope([&](const Digits50& x) { return printed_F<Model>(A, x, P, p0, p1); }, T);
          EXPECT_NEAR(found.T, by_T, eps * (2 * tau2.value + y * std::abs(tau2.d1)) / T) << where();
          const double by_P = slope([&](const Digits50& x) { return printed_F<Model>(A, T, x, p0, p1); }, P);
          EXPECT_NEAR(found.P, by_P, eps * change) << where();
          const double by_0 =
              slope([&](const Digits50& x) { return printed_F<Model>(A, T, P, x, N == 1 ? x : p1); }, p0);
          EXPECT_NEAR(found.parameters[0], by_0, eps * std::abs(by_0)) << where();
          if (N == 1) continue;
          const double by_1 = slope([&](const Digits50& x) { return printed_F<Model>(A, T, P, p0, x); }, p1);
          EXPECT_NEAR(found.parameters[N - 1], by_1, eps * std::abs(by_1)) << where();
        }
}

TYPED_TEST(Sensitivity, WithoutShearNeitherTNorTheModelMatters) {
  const EquilibriumGradient<TypeParam> found = equilibrium_gradient(TypeParam{}, cases<TypeParam>()[0], 3, 0, 18);
  EXPECT_EQ(found.T, 0);
  for (const double slope : found.parameters) EXPECT_EQ(slope, 0);
  EXPECT_EQ(found.held, 18.0 * 18.0);
}

/// Area of the loaded contact; finite differences of it need no derivative at all.
template <class Model>
double area(const Parameters<Model>& p, double P, double T) {
  const Equilibrium found = LoadedContact(Model{}, p, P).at(T);
  EXPECT_EQ(found.status, EquilibriumStatus::ok);
  return area_from_radius(radius_from_edge_load(found.y, P));
}

/// Shear T as a fraction of the first fold, or of a natural scale where there is none.
template <class Model>
double shear_of(const Parameters<Model>& p, double P, double fraction) {
  const double fold = LoadedContact(Model{}, p, P).branches().front().T_bottom;
  return fraction * std::min(fold, 2 * circle_radius(P) / std::sqrt(std::min(Model::small_shear(p), 1.0)));
}

/// (8 (f(h) - f(-h)) - (f(2h) - f(-2h)))/12h
template <class F>
double five_points(F&& f, double x, double h) {
  return (8 * (f(x + h) - f(x - h)) - (f(x + 2 * h) - f(x - 2 * h))) / (12 * h);
}

TYPED_TEST(Sensitivity, AreasChangeWithShearAndParametersAsTheGradientSays) {
  using Model = TypeParam;
  for (const Parameters<Model>& p : cases<Model>())
    for (const double P : {-1.0, 0.5, 30.0})
      for (const double fraction : {0.2, 0.6, 0.9}) {
        if (p[0] == Model::parameters[0].upper) continue;  // no room for a difference
        const double T = shear_of<Model>(p, P, fraction);
        const Equilibrium found = LoadedContact(Model{}, p, P).at(T);
        ASSERT_EQ(found.status, EquilibriumStatus::ok);
        const EquilibriumGradient<Model> F = equilibrium_gradient(Model{}, p, P, T, found.y);
        const double A = area<Model>(p, P, T), eps = 4e-15 * A;  // rounding of each area
        // h = 1e-3 leaves h^4 = 1e-12 of a fifth derivative that grows as (1 - T/T_fold)^-4.5, 1e5 at 0.9.
        const double h = 1e-3;
        const double by_T = five_points([&](double x) { return area<Model>(p, P, x); }, T, h * T);
        EXPECT_NEAR(-F.T / F.A, by_T, 1e-6 * std::abs(by_T) + eps / (h * T)) << Model::info.key << p[0] << ' ' << P;
        for (std::size_t k = 0; k < p.size(); ++k) {
          const auto area_at = [&](double x) {
            Parameters<Model> q = p;
            q[k] = x;
            return area<Model>(q, P, T);
          };
          const double by_p = five_points(area_at, p[k], h * p[k]);
          EXPECT_NEAR(-F.parameters[k] / F.A, by_p, 1e-6 * std::abs(by_p) + eps / (h * p[k]))
              << Model::info.key << p[0] << ' ' << P << ' ' << fraction << ' ' << k;
        }
      }
}

}  // namespace sensitivity_test
}  // namespace mixity
