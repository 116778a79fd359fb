// The whole curve against the printed equation in 50 digits: values, derivatives, ends and extremes.
#include "mechanics/curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <sstream>
#include <string>

#include "mechanics/equilibrium.h"
#include "mechanics/model_types.h"
#include "mechanics/printed_equation.h"

namespace mixity {
namespace {

using truth::Digits50;
using truth::kEps;
const double kPi = pi<double>();

template <class Model>
std::string at(const Parameters<Model>& p, double P, double phi) {
  std::ostringstream text;
  text.precision(17);
  text << Model::info.key << " p0=" << p[0] << " p1=" << (p.size() > 1 ? p[1] : 0) << " P=" << P << " phi=" << phi;
  return text.str();
}

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
    const EquilibriumCurve<Model> curve(random_parameters<Model>(random), random_load(random));
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

template <class Model>
class WholeCurve : public ::testing::Test {};
TYPED_TEST_SUITE(WholeCurve, ModelTypes);

TYPED_TEST(WholeCurve, EveryPointFulfilsThePrintedEquation) {
  int points = 0;
  for_random_points<TypeParam>(1, [&](const auto& curve, const CurvePoint& q) {
    const double P = curve.load();
    const Printed<TypeParam> printed{curve.parameters(), P};
    // y and T carry a few roundings each, the equation is a sum of terms of this size.
    const double tolerance = 16 * kEps * 6 * kPi * (q.y + std::abs(P));
    EXPECT_LE(abs(printed(q.y, q.T)), tolerance) << at<TypeParam>(curve.parameters(), P, q.phi);
    ++points;
  });
  EXPECT_GT(points, 1500);
}

TYPED_TEST(WholeCurve, ValuesAreThoseOfTheirDefinitions) {
  for_random_points<TypeParam>(2, [](const auto& curve, const CurvePoint& q) {
    const double P = curve.load();
    const std::string where = at<TypeParam>(curve.parameters(), P, q.phi);
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
    const std::string where = at<TypeParam>(curve.parameters(), P, q.phi);
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

// dT, du and dpsi at T = 0 are limits: against differences of the curve itself, whose error is O(h^2) = 1e-8.
TEST(CurveEnds, DerivativesAtZeroShearAreTheLimits) {
  for (const double P : {-4.0, -1.0, 0.0, 3.0, 1e3}) {
    const auto check = [&](const auto& curve) {
      const CurvePoint at_zero = curve.point(0), next = curve.point(1e-4);
      EXPECT_NEAR(at_zero.dT, next.T / 1e-4, 1e-6 * at_zero.dT) << P;
      EXPECT_NEAR(at_zero.du, next.u / 1e-4, 1e-6 * at_zero.du) << P;
      EXPECT_NEAR(at_zero.dpsi, next.psi / 1e-4, 1e-6 * at_zero.dpsi) << P;
      EXPECT_EQ(at_zero.dA, 0);
    };
    check(EquilibriumCurve<Johnson>({0.15}, P));
    check(EquilibriumCurve<WatersGuduru>({0.15}, P));
    check(EquilibriumCurve<PapangeloCiavarella>({0.15}, P));
    check(EquilibriumCurve<BenzeggaghKenane>({1.774, 2.284}, P));
  }
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
    EXPECT_NEAR(tangential_load<TypeParam>(p, y, std::sqrt(term.value)), T, 8 * kEps * T * (1 + 1 / slope))
        << at<TypeParam>(p, y, T);
  }
}

// ---- Ends ----

TEST(CurveEnds, ModelBReachesHertzAtAFiniteLoad) {
  for (const double lambda : {1e-6, 0.0023, 0.15, 0.3, 1.0, 1.7, 2.0})
    for (const double P : {1e-6, 0.5, 5.5, 30.4, 1e4}) {
      const EquilibriumCurve<WatersGuduru> curve({lambda}, P);
      ASSERT_EQ(curve.pieces().size(), 1u);
      EXPECT_EQ(curve.pieces()[0].end, CurveEnd::hertz);
      const CurvePoint q = curve.point(curve.phi_end(curve.pieces()[0]));
      const double T_H = std::sqrt(6 * kPi * P) / std::sin(kPi * lambda / 4);
      // phi is rounded: cos phi = -3 pi/S0 is met to eps, so y to eps S0 and, at P -> 0, tau^2 = 6 pi P to that
      const double lost = kEps * (1 + 100 / P);
      EXPECT_NEAR(q.T, T_H, (1e-14 + lost) * T_H) << lambda << ' ' << P;
      EXPECT_NEAR(q.y, 0, 4 * kEps * circle_radius(P)) << lambda << ' ' << P;
    }
}

TEST(CurveEnds, AtPullingLoadsTheCurveEndsInUnstableJkr) {
  for (const double P : {-4.712, -4.7, -2.0, -0.23, -1e-6}) {
    const EquilibriumCurve<PapangeloCiavarella> c({0.15}, P);
    const EquilibriumCurve<WatersGuduru> b({0.15}, P);
    const EquilibriumCurve<Johnson> a({0.99999999}, P);
    const auto check = [&](const auto& curve) {
      const CurvePiece& piece = curve.pieces().back();
      const CurvePoint q = curve.point(curve.phi_end(piece));
      EXPECT_EQ(piece.end, CurveEnd::unstable_jkr);
      EXPECT_EQ(q.T, 0) << P;
      const Digits50 y = 3 * truth::kPi - sqrt(9 * truth::kPi * truth::kPi + 6 * truth::kPi * Digits50(P));
      EXPECT_NEAR(q.y, static_cast<double>(y), 1e-14 * static_cast<double>(y)) << P;  // a few roundings
      EXPECT_LT(q.dT, 0);
    };
    check(c);
    check(b);
    check(a);
  }
}

TEST(CurveEnds, ModelAEndsInItsAsymptote) {
  for (const double lambda : {1e-6, 0.15, 0.5, 0.8})
    for (const double P : {-0.2, 0.0, 3.0, 1e4}) {
      const double m = 1 - lambda;
      const EquilibriumCurve<Johnson> curve({lambda}, P);
      EXPECT_EQ(curve.pieces()[0].end, CurveEnd::asymptote);
      const double y = m * (3 * kPi + std::sqrt(9 * kPi * kPi + 6 * kPi * P / m));
      EXPECT_NEAR(curve.pieces()[0].y_end, y, 1e-14 * y) << lambda << ' ' << P;  // rounding of both sides
      const double begin = curve.phi_begin(curve.pieces()[0]), end = curve.phi_end(curve.pieces()[0]);
      EXPECT_GT(curve.point(begin + (end - begin) * (1 - 1e-8)).T, 1e3);  // T grows as (1 - 1e-8)^(-1/2)
    }
}

/// The piece is of width lambda for small lambda; its angle, sqrt(lambda), must not follow from a difference of y.
TEST(CurveEnds, TheAngleOfTheAsymptoteKeepsItsDigits) {
  for (const double lambda : {0.15, 1e-4, 1e-8, 1e-12, 1e-16, 1e-100})
    for (const double P : {-4.7, 0.0, 3.0, 1e4}) {
      using Number = truth::Digits700;  // the width cancels by 200 digits in this line
      const Number q = boost::math::constants::pi<Number>(), m = 1 - Number(lambda);
      const Number square = 9 * q * q + 6 * q * P / m, S0 = sqrt(Number(9 * q * q + 6 * q * P));
      if (square < 0) continue;
      const Number phi = acos(Number((m * (3 * q + sqrt(square)) - 3 * q) / S0));
      const EquilibriumCurve<Johnson> curve({lambda}, P);
      // 9 pi^2 + 6 pi P/m keeps as many digits fewer as it is smaller than its terms
      const double lost = static_cast<double>(Number(9 * q * q / square));
      EXPECT_NEAR(curve.phi_end(curve.pieces()[0]), static_cast<double>(phi),
                  (4e-15 + kEps * lost) * static_cast<double>(phi))
          << lambda << ' ' << P;
    }
}

/// P < 0 and lambda < 1 + 2P/(3 pi): the asymptote cuts the curve in two; above, it closes.
TEST(CurveEnds, ModelAHasTwoPiecesBelowTheClosingLine) {
  for (const double P : {-4.7, -3.0, -1.79, -0.23, -1e-6}) {
    const double closing = 1 + 2 * P / (3 * kPi);
    for (const double part : {0.01, 0.5, 0.999999}) {
      const EquilibriumCurve<Johnson> curve({closing * part}, P);
      ASSERT_EQ(curve.pieces().size(), 2u) << P << ' ' << part;
      EXPECT_FALSE(curve.pieces()[0].from_asymptote);
      EXPECT_TRUE(curve.pieces()[1].from_asymptote);
      EXPECT_EQ(curve.pieces()[1].end, CurveEnd::unstable_jkr);
      EXPECT_LT(curve.pieces()[1].y_top, curve.pieces()[0].y_end);
    }
    const EquilibriumCurve<Johnson> closed({closing + (1 - closing) * 1e-3}, P);
    EXPECT_EQ(closed.pieces().size(), 1u) << P;
    EXPECT_EQ(closed.pieces()[0].end, CurveEnd::unstable_jkr);
  }
  EXPECT_EQ(EquilibriumCurve<Johnson>({0.5}, 0).pieces().size(), 1u);
}

TYPED_TEST(WholeCurve, WithoutShearOnTheAreaIsOnePoint) {
  if constexpr (parameter_count<TypeParam> == 1) {
    for (const double P : {-4.71238898038469, -1.0, 0.0, 30.4, 1e8}) {
      const EquilibriumCurve<TypeParam> curve({0.0}, P);
      EXPECT_TRUE(curve.uncoupled());
      const CurvePoint q = curve.point(0);
      EXPECT_EQ(q.T, 0);
      EXPECT_DOUBLE_EQ(q.a, jkr_radius(P));
    }
  }
}

// ---- Extremes ----

const std::vector<double> kLoads{
    -4.71238898038469, -4.7123889803799, -4.7, -1.0, -1e-12, -1e-300, 0.0, 1e-300, 1e-12, 1.0, 30.4, 1e4, 1e8};

template <class Model>
std::vector<Parameters<Model>> parameters_of(std::initializer_list<double> fractions) {
  if constexpr (parameter_count<Model> == 2) {
    return {{1, 1}, {2, 1}, {2, 100}, {4, 2}, {0.7, 1.5}, {0.5, 0.5}, {1e-3, 0.1}, {1e-3, 1}, {1e-3, 100}, {1, 1e-2}};
  } else {
    std::vector<Parameters<Model>> list;
    for (const double fraction : fractions) list.push_back({Model::parameters[0].upper * fraction});
    return list;
  }
}

/// Points at these parts of every piece are finite and none of their values is negative.
template <class Model>
void expect_finite(const std::vector<Parameters<Model>>& list, const std::vector<double>& parts) {
  for (const auto& p : list)
    for (const double P : kLoads) {
      const EquilibriumCurve<Model> curve(p, P);
      for (const CurvePiece& piece : curve.pieces())
        for (const double part : parts) {
          const double begin = curve.phi_begin(piece), end = curve.phi_end(piece);
          const double phi = part == 1 ? end : begin + (end - begin) * part;
          if (piece.end == CurveEnd::asymptote && !(phi < end)) continue;  // T is infinite there
          if (piece.from_asymptote && !(phi > begin)) continue;
          const CurvePoint q = curve.point(phi);
          bool finite = true;
          for (const double x : {q.y, q.T, q.a, q.A, q.u, q.psi, q.f, q.dy, q.dT, q.da, q.dA, q.du, q.dpsi, q.df})
            finite = finite && std::isfinite(x);
          EXPECT_TRUE(finite && q.y >= 0 && q.T >= 0 && q.psi >= 0 && q.f > 0)
              << at<Model>(p, P, phi) << ": y " << q.y << ", T " << q.T << ", u " << q.u << ", psi " << q.psi << ", f "
              << q.f << ", dT " << q.dT << ", du " << q.du << ", dpsi " << q.dpsi;
        }
    }
}

const auto kFractions = {0.0, 1e-12, 1e-6, 0.0023, 0.15, 8.0 / 9, 1 - 1e-12, 1 - 1e-15, 1.0};

TYPED_TEST(WholeCurve, IsFiniteInside) {
  std::vector<double> parts{1e-15, 1e-12, 1e-9, 1e-6, 1 - 1e-6, 1 - 1e-9};
  for (int i = 1; i < 40; ++i) parts.push_back(i / 40.0);
  expect_finite<TypeParam>(parameters_of<TypeParam>(kFractions), parts);
}

TYPED_TEST(WholeCurve, IsFiniteAtBothEnds) { expect_finite<TypeParam>(parameters_of<TypeParam>(kFractions), {0, 1}); }

TYPED_TEST(WholeCurve, IsFiniteWhereTheSquareOfTheShearUnderflows) {
  expect_finite<TypeParam>(parameters_of<TypeParam>(kFractions), {1e-300, 1e-200, 1e-160, 1e-100});
}

/// T is up to 1e154 here, and f = T^2 beyond every double.
TYPED_TEST(WholeCurve, IsFiniteWhereLambdaIsNearlyZero) {
  if constexpr (parameter_count<TypeParam> == 1)
    expect_finite<TypeParam>(parameters_of<TypeParam>({1e-300, 1e-160, 1e-100, 1e-50, 1e-20, 1e-16}),
                             {1e-9, 1e-3, 0.1, 0.3, 0.5, 0.7, 0.9, 0.999});
}

}  // namespace
}  // namespace mixity
