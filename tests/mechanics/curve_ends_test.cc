// Where the curve begins and ends: zero shear, Hertz, the unstable JKR state, the asymptote of model a.
#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "mechanics/curve.h"
#include "mechanics/printed_equation.h"
#include "mechanics/registry.h"

namespace mixity {
namespace curve_ends_test {

using truth::Digits50;
using truth::kEps;
const double kPi = pi<double>();

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
    check(EquilibriumCurve(Johnson{}, {0.15}, P));
    check(EquilibriumCurve(WatersGuduru{}, {0.15}, P));
    check(EquilibriumCurve(PapangeloCiavarella{}, {0.15}, P));
    check(EquilibriumCurve(BenzeggaghKenane{}, {1.774, 2.284}, P));
  }
}

TEST(CurveEnds, ModelBReachesHertzAtAFiniteLoad) {
  for (const double lambda : {1e-6, 0.0023, 0.15, 0.3, 1.0, 1.7, 2.0})
    for (const double P : {1e-6, 0.5, 5.5, 30.4, 1e4}) {
      const EquilibriumCurve curve(WatersGuduru{}, {lambda}, P);
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
    const EquilibriumCurve c(PapangeloCiavarella{}, {0.15}, P);
    const EquilibriumCurve b(WatersGuduru{}, {0.15}, P);
    const EquilibriumCurve a(Johnson{}, {0.99999999}, P);
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
      const EquilibriumCurve curve(Johnson{}, {lambda}, P);
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
      const Number& q = boost::math::constants::pi<Number>();
      const Number m = 1 - Number(lambda);
      const Number square = 9 * q * q + 6 * q * P / m, S0 = sqrt(Number(9 * q * q + 6 * q * P));
      if (square < 0) continue;
      const Number phi = acos(Number((m * (3 * q + sqrt(square)) - 3 * q) / S0));
      const EquilibriumCurve curve(Johnson{}, {lambda}, P);
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
      const EquilibriumCurve curve(Johnson{}, {closing * part}, P);
      ASSERT_EQ(curve.pieces().size(), 2u) << P << ' ' << part;
      EXPECT_FALSE(curve.pieces()[0].from_asymptote);
      EXPECT_TRUE(curve.pieces()[1].from_asymptote);
      EXPECT_EQ(curve.pieces()[1].end, CurveEnd::unstable_jkr);
      EXPECT_LT(curve.pieces()[1].y_top, curve.pieces()[0].y_end);
    }
    const EquilibriumCurve closed(Johnson{}, {closing + (1 - closing) * 1e-3}, P);
    EXPECT_EQ(closed.pieces().size(), 1u) << P;
    EXPECT_EQ(closed.pieces()[0].end, CurveEnd::unstable_jkr);
  }
  EXPECT_EQ(EquilibriumCurve(Johnson{}, {0.5}, 0).pieces().size(), 1u);
}

}  // namespace curve_ends_test
}  // namespace mixity
