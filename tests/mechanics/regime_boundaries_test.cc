// The boundaries between the regimes: the critical load of model b, the jump boundary of model a.
#include <gtest/gtest.h>

#include <cmath>

#include "mechanics/printed_equation.h"
#include "mechanics/regimes.h"

namespace mixity {
namespace regime_boundaries_test {

using truth::Digits50;

TEST(ModelBCriticalLoad, IsTheDerivedOne) {
  // 3 pi/2/(k cos(pi l/4))^2 in 50 digits; the cosine loses digits towards l = 2, where P_c -> infinity as (2 - l)^-4
  for (const double lambda : {0.0, 1e-12, 0.15, 0.3, 1.0, 1.7, 1.99}) {
    const Digits50 l = lambda, kc = (1 - l / 2) * cos(Digits50(truth::kPi * l / 4));
    const double P_c = static_cast<double>(Digits50(3 * truth::kPi / 2 / (kc * kc)));
    EXPECT_NEAR(model_b_critical_load(lambda), P_c, 4e-15 / (2 - lambda) * P_c) << lambda;
  }
  EXPECT_NEAR(model_b_critical_load(0.15), 5.58469, 5e-6);  // the published digits
  EXPECT_NEAR(model_b_critical_load(0.3), 6.89827, 5e-6);
}

/// Not on our own derivation: T on the printed curve at small y falls towards Hertz below P_c and rises above.
TEST(ModelBCriticalLoad, IsWhereThePrintedCurveTurnsAtHertz) {
  for (const double lambda : {0.01, 0.15, 0.3, 1.0, 1.7})
    for (const double side : {-1e-9, 1e-9}) {
      const double P = model_b_critical_load(lambda) * (1 + side);
      const auto T_at = [&](const Digits50& y) {  // the printed equation at this y has one T: bisection
        Digits50 low = 0, high = 1e6;
        for (int i = 0; i < 170; ++i) {
          const Digits50 T = (low + high) / 2;
          (truth::printed_residual<Digits50>("b", lambda, 0, P, y, T) > 0 ? high : low) = T;
        }
        return low;
      };
      // quadratic terms in y are 1e-14 of the linear ones, which are 1e-9
      EXPECT_EQ(T_at(2e-14) < T_at(1e-14), side > 0) << lambda << ' ' << side;
    }
}

struct Boundary {
  double P, lambda, tolerance;
};
// The smallest lambda with a fold, from brute force on the printed equation, to the digits given.
const Boundary kBoundary[] = {{0.1, 0.8934587, 1e-7},  {0.5, 0.9091920, 1e-7},  {1, 0.9244261, 1e-7},
                              {3, 0.9587142, 1e-7},    {11.5, 0.9908208, 1e-7}, {30.4, 0.9980709, 1e-7},
                              {-0.23, 0.8771914, 1e-7}};

TEST(ModelAJumpBoundary, IsThatOfTheTable) {
  for (const Boundary& row : kBoundary)
    EXPECT_NEAR(model_a_jump_boundary(row.P).lambda, row.lambda, row.tolerance) << row.P;
  EXPECT_NEAR(model_a_jump_boundary(1000).one_minus_lambda, 2.32e-6, 5e-9);
  EXPECT_NEAR(model_a_jump_boundary(0).lambda, 8.0 / 9, 4e-16);
}

TEST(ModelAJumpBoundary, IsTheClosingLineAtStrongPull) {
  for (const double P : {-0.74, -1.79, -3.0, -4.7, -4.71238898038469})
    EXPECT_NEAR(model_a_jump_boundary(P).lambda, 1 + 2 * P / (3 * pi<double>()), 4e-16) << P;
}

TEST(ModelAJumpBoundary, HasItsTwoPartsMeetWhereDerived) {
  const CuspPoint meeting = model_a_cusp(0.5);
  EXPECT_NEAR(meeting.P, -15 * pi<double>() / 64, 4e-16);
  EXPECT_NEAR(meeting.lambda, 27.0 / 32, 4e-16);
  EXPECT_NEAR(model_a_closing_lambda(meeting.P), 27.0 / 32, 4e-16);
  const double above = model_a_jump_boundary(meeting.P + 1e-9).lambda;
  EXPECT_NEAR(above, model_a_jump_boundary(meeting.P - 1e-9).lambda, 1e-8);  // continuous
}

TEST(ModelAJumpBoundary, RisesWithTheLoadAndKeepsItsComplement) {
  double last_complement = 2, P = -4.7;
  while (P < 1e8) {
    const CuspPoint point = model_a_jump_boundary(P);
    EXPECT_EQ(point.P, P);
    EXPECT_GT(point.one_minus_lambda, 0) << P;
    EXPECT_LT(point.one_minus_lambda, last_complement) << P;
    EXPECT_NEAR(point.lambda + point.one_minus_lambda, 1, 3e-16) << P;
    last_complement = point.one_minus_lambda;
    P = P < 5 ? P + 0.05 : P * 1.3;
  }
}

}  // namespace regime_boundaries_test
}  // namespace mixity
