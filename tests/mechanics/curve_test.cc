// The whole curve against the printed equation in 50 digits: values and derivatives.
#include "mechanics/curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <string>

#include "mechanics/model_types.h"
#include "mechanics/printed_equation.h"
#include "mechanics/whole_curve.h"

namespace mixity {
namespace curve_test {

using truth::Digits50;
using truth::kEps;
const double kPi = pi<double>();

/// Random parameters in the domain of the model: lambda log-uniform from 1e-8 to its largest value, for bk the box.
template <class Model>
Parameters<Model> random_parameters(std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  if constexpr (parameter_count<Model> == 2) {
    Parameters<Model> p;
    do {
      p = {std::pow(10, -1 + 1.8 * uniform(random)), std::pow(10, -0.5 + 1.2 * uniform(random))};
    } while (!Model::equilibrium_domain(p).empty());
    return p;
  } else {
    return {Model::parameters[0].upper * std::pow(10, -8 * uniform(random))};
  }
}

/// From -4.7 to 1e4, half of them below 5.
double random_load(std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  return uniform(random) < 0.5 ? -4.7 + 9.7 * uniform(random) : std::pow(10, -1 + 5 * uniform(random));
}

/// Calls judge(curve, point) for places all over random curves, a third each near the beginning and the end of a piece.
template <class Model, class Judge>
void for_random_points(std::uint64_t seed, Judge judge) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 300; ++i) {
    const EquilibriumCurve curve(Model{}, random_parameters<Model>(random), random_load(random));
    for (const CurvePiece& piece : curve.pieces())
      for (int j = 0; j < 6; ++j) {
        const double small = std::pow(10, -6 * uniform(random));
        const double part = j % 3 == 0 ? uniform(random) : j % 3 == 1 ? small : 1 - small;
        const double begin = curve.phi_begin(piece), end = curve.phi_end(piece), phi = begin + (end - begin) * part;
        if (phi > begin && phi < end) judge(curve, curve.point(phi));
      }
  }
}

/// The printed equation over f, y^2 g - 6 pi (y + P), and its derivatives by central differences whose step, 1e-15 of y
/// and T, leaves 20 of the 50 digits.
template <class Model>
struct Printed {
  Parameters<Model> p;
  double P;
  Digits50 operator()(const Digits50& y, const Digits50& T) const { return truth::residual_of<Model>(p, P, y, T); }
  Digits50 d_y(const Digits50& y, const Digits50& T) const {
    const Digits50 h = y * Digits50(1e-15);
    return ((*this)(y + h, T) - (*this)(y - h, T)) / (2 * h);
  }
  Digits50 d_T(const Digits50& y, const Digits50& T) const {
    const Digits50 h = T * Digits50(1e-15);
    return ((*this)(y, T + h) - (*this)(y, T - h)) / (2 * h);
  }
};

TYPED_TEST_SUITE(WholeCurve, ModelTypes);

TYPED_TEST(WholeCurve, EveryPointFulfilsThePrintedEquation) {
  int points = 0;
  for_random_points<TypeParam>(1, [&](const auto& curve, const CurvePoint& q) {
    const double P = curve.load();
    const Printed<TypeParam> printed{curve.parameters(), P};
    // y and T carry a few roundings each, the equation is a sum of terms of this size.
    const double tolerance = 16 * kEps * 6 * kPi * (q.y + std::abs(P));
    EXPECT_LE(abs(printed(q.y, q.T)), tolerance) << describe<TypeParam>(curve.parameters(), P, q.phi);
    ++points;
  });
  EXPECT_GT(points, 1500);
}

TYPED_TEST(WholeCurve, ValuesAreThoseOfTheirDefinitions) {
  for_random_points<TypeParam>(2, [](const auto& curve, const CurvePoint& q) {
    const double P = curve.load();
    const std::string where = describe<TypeParam>(curve.parameters(), P, q.phi);
    const Digits50 y = q.y, T = q.T, a = cbrt(Digits50(Digits50(3) / 4 * (y + P))), psi = atan2(T, y);
    // Where y + P cancels, one rounding of that sum; a handful of roundings besides.
    const double tolerance = 8 * kEps + kEps * (q.y + std::abs(P)) / (q.y + P);
    const auto expect = [&](double value, const Digits50& truth, double allowed, const char* name) {
      EXPECT_LE(abs(Digits50(value) - truth), allowed * abs(truth)) << name << ' ' << where;
    };
    expect(q.a, a, tolerance, "a");
    expect(q.A, truth::kPi * a * a, tolerance, "A");
    expect(q.u, Digits50(3) / 4 * T / a, tolerance, "u");
    expect(q.psi, psi, tolerance, "psi");
    const Digits50 f = (y * y + T * T) / (8 * truth::kPi * a * a * a);
    expect(q.f, f, tolerance, "f");
  });
}

// With F(y, T) = 0: dT/dphi = -F_y/F_T dy/dphi, and dy/dphi = -S0 sin phi from the circle's definition.
TYPED_TEST(WholeCurve, DerivativesMatchTheImplicitOnesInFiftyDigits) {
  for_random_points<TypeParam>(3, [](const auto& curve, const CurvePoint& q) {
    const double P = curve.load();
    const std::string where = describe<TypeParam>(curve.parameters(), P, q.phi);
    const Printed<TypeParam> printed{curve.parameters(), P};
    const Digits50 y = q.y, T = q.T, phi = q.phi, S0 = sqrt(9 * truth::kPi * truth::kPi + 6 * truth::kPi * Digits50(P));
    const Digits50 dy = -S0 * sin(phi), F_y = printed.d_y(y, T), F_T = printed.d_T(y, T);
    const Digits50 dT = -F_y / F_T * dy;
    // F_y = 2 (y - 3 pi) + d(tau^2)/dy cancels at a fold: the roundings are those of its terms, y among them. Towards
    // an asymptote one rounding of phi moves T by dT eps phi, and dT, a power -3/2 of the distance, by thrice that.
    const Digits50 terms = 2 * y + 6 * truth::kPi + abs(F_y - 2 * (y - 3 * truth::kPi));
    const double spread = 3 * kEps * q.phi * std::abs(q.dT / q.T);
    // y itself is known to one rounding of S0 only, which counts where y is small; what it does to T is allowed for.
    const double rounding = 40 * kEps + 8 * spread + 8 * kEps * static_cast<double>(S0) / q.y;
    const double error_T = rounding * static_cast<double>(abs(dT) + terms / abs(F_T) * abs(dy));
    const auto expect = [&](double value, const Digits50& truth, double allowed, const char* name) {
      EXPECT_LE(abs(Digits50(value) - truth), allowed) << name << ' ' << where << " is " << value << " not " << truth;
    };
    const Digits50 sum = y + P, a = cbrt(Digits50(Digits50(3) / 4 * sum)), da = dy / (4 * a * a);
    const Digits50 square = y * y + T * T, f = square / (6 * truth::kPi * sum);
    const auto size = [](const Digits50& x) { return static_cast<double>(abs(x)); };
    const double r = rounding + 4 * kEps * (q.y + std::abs(P)) / (q.y + P);  // y + P cancels
    expect(q.dy, dy, rounding * size(dy), "dy");
    expect(q.dT, dT, error_T, "dT");
    expect(q.da, da, r * size(da), "da");
    expect(q.dA, 2 * truth::kPi * a * da, r * size(2 * truth::kPi * a * da), "dA");
    const Digits50 u_T = dT / a * 3 / 4, u_a = T * da / (a * a) * 3 / 4;
    expect(q.du, u_T - u_a, error_T / q.a + r * (size(u_T) + size(u_a)), "du");
    const Digits50 psi_T = y * dT / square, psi_y = T * dy / square;
    expect(q.dpsi, psi_T - psi_y, error_T * q.y / size(square) + r * (size(psi_T) + size(psi_y)), "dpsi");
    const Digits50 f_y = f * 2 * y * dy / square, f_T = f * 2 * T * dT / square, f_sum = f * dy / sum;
    expect(q.df, f_y + f_T - f_sum, 2 * q.f * q.T * error_T / size(square) + r * (size(f_y) + size(f_T) + size(f_sum)),
           "df");
  });
}

TYPED_TEST(WholeCurve, TangentialLoadInvertsTheShearTerm) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 3000; ++i) {
    const auto p = random_parameters<TypeParam>(random);
    const double y = std::pow(10, -6 + 10 * uniform(random)), T = y * std::pow(10, -6 + 12 * uniform(random));
    const ShearTerm<double> term = TypeParam::shear_term(p, y, T);
    // d ln tau/d ln T: one rounding of tau is so many of T. Towards the asymptote of model a it tends to 0.
    const double slope = 1 - 0.5 * y * term.d1 / term.value;
    if (slope < 1e-6) continue;
    EXPECT_NEAR(tangential_load(TypeParam{}, p, y, std::sqrt(term.value)), T, 8 * kEps * T * (1 + 1 / slope))
        << describe<TypeParam>(p, y, T);
  }
}

TYPED_TEST(WholeCurve, WithoutShearOnTheAreaIsOnePoint) {
  if constexpr (parameter_count<TypeParam> == 1) {
    for (const double P : {-4.71238898038469, -1.0, 0.0, 30.4, 1e8}) {
      const EquilibriumCurve curve(TypeParam{}, {0.0}, P);
      EXPECT_TRUE(curve.uncoupled());
      const CurvePoint q = curve.point(0);
      EXPECT_EQ(q.T, 0);
      EXPECT_DOUBLE_EQ(q.a, jkr_radius(P));
    }
  }
}

}  // namespace curve_test
}  // namespace mixity
