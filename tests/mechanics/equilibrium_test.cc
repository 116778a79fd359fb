// Areas against brute force, and the closed results of the design.
#include "mechanics/equilibrium.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mechanics/printed_equation.h"
#include "mechanics/states.h"

namespace mixity {
namespace equilibrium_test {

using truth::Digits50;
const double kPi = pi<double>();

const double kLoads[] = {-4.7, -1.79, -0.23, -1e-6, 0, 1e-12, 0.5, 3, 5.5, 7, 30.4, 1e3, 1e8};

/// Largest relative error of A over the loads and fractions of the first instability (or of the given end where the
/// curve has none).
template <class Model>
double worst_area_error(const std::vector<Parameters<Model>>& list, std::initializer_list<double> fractions) {
  double worst = 0;
  for (const auto& p : list)
    for (const double P : kLoads) {
      const LoadedContact contact(Model{}, p, P);
      const double fold = contact.branches().front().T_bottom;
      for (const double fraction : fractions) {
        const double T = fraction * (std::isinf(fold) ? 100.0 : fold);
        if (T > 1e30) continue;
        const Equilibrium found = contact.at(T);
        EXPECT_EQ(found.status, EquilibriumStatus::ok) << Model::info.key << ' ' << p[0] << ' ' << P << ' ' << T;
        // bracket the root of the printed equation tightly enough that it is this root, loosely enough to be one
        const Digits50 expected = truth::printed_area(Model::info.key, p[0], p.size() > 1 ? p[1] : 0.0, P, T,
                                                      Digits50(found.y) * (1 - 1e-9), Digits50(found.y) * (1 + 1e-9));
        const double A = contact_state(P, T, found.y).A;
        worst = std::max(worst, std::abs(static_cast<double>((A - expected) / expected)));
      }
    }
  return worst;
}

const std::vector<Parameters<Johnson>> kLambdas{{0.0}, {1e-12},   {1e-6}, {0.0023}, {0.15},
                                                {0.5}, {8.0 / 9}, {0.95}, {1.0}};

// Away from folds the area is right to a few roundings; 4e-15 is 18 of them.
TEST(Equilibrium, AreasAreRightToTheLastDigitsAwayFromFolds) {
  const auto fractions = {0.0, 1e-8, 0.1, 0.5, 0.9, 0.99};
  EXPECT_LT(worst_area_error<Johnson>(kLambdas, fractions), 4e-15);
  EXPECT_LT(worst_area_error<WatersGuduru>(kLambdas, fractions), 4e-15);
  EXPECT_LT(worst_area_error<WatersGuduru>({{1.3}, {1.7}, {2.0}}, fractions), 4e-15);
  EXPECT_LT(worst_area_error<PapangeloCiavarella>(kLambdas, fractions), 4e-15);
  EXPECT_LT(worst_area_error<BenzeggaghKenane>({{1.774, 2.284}, {1.5, 1}, {3, 2.5}, {0.7, 1.5}}, fractions), 4e-15);
}

// One rounding of T moves the area by eps/sqrt(1 - T/T_f): 7e-15 here.
TEST(Equilibrium, AreasKeepWhatConditioningLeavesNearFolds) {
  EXPECT_LT(worst_area_error<Johnson>(kLambdas, {0.999}), 2e-14);
  EXPECT_LT(worst_area_error<WatersGuduru>(kLambdas, {0.999}), 2e-14);
  EXPECT_LT(worst_area_error<PapangeloCiavarella>(kLambdas, {0.999}), 2e-14);
}

TEST(Equilibrium, ModelCBecomesUnstableAtTheClosedFormLoad) {
  for (const double P : {-4.0, 0.0, 3.0, 30.4})
    for (const double lambda : {1e-6, 0.0023, 0.15, 1.0}) {
      const double T_f = std::sqrt(3 * kPi * (3 * kPi + 2 * P) / lambda);
      const LoadedContact contact(PapangeloCiavarella{}, {lambda}, P);
      EXPECT_NEAR(contact.last_load(), T_f, 1e-14 * T_f);
      EXPECT_EQ(contact.at(T_f * (1 - 1e-13)).status, EquilibriumStatus::ok);
      EXPECT_EQ(contact.at(T_f * (1 + 1e-13)).status, EquilibriumStatus::no_equilibrium);
      // A_T = pi (3/4)^(2/3) (3 pi + P)^(2/3); near the fold A falls as the square root of what is left of T
      const double A_T = kPi * std::pow(0.75 * (3 * kPi + P), 2.0 / 3);
      EXPECT_NEAR(contact_state(P, T_f, contact.at(T_f * (1 - 1e-13)).y).A, A_T, 1e-5 * A_T);
    }
}

TEST(Equilibrium, ModelAShrinksToItsNonHertzianAsymptote) {
  for (const double lambda : {1e-6, 0.15, 0.5, 0.8})
    for (const double P : {-0.2, 0.0, 3.0, 1e4}) {
      const double m = 1 - lambda;
      const LoadedContact contact(Johnson{}, {lambda}, P);
      EXPECT_TRUE(std::isinf(contact.last_load()));
      const double asymptote = m * (3 * kPi + std::sqrt(9 * kPi * kPi + 6 * kPi * P / m));
      EXPECT_NEAR(contact.at(1e150).y, asymptote, 1e-14 * asymptote);  // rounding of both sides
    }
}

/// At P = 0 the fold equation is m x^2 + (2m - l) x + 1 = 0, whose discriminant l (9 l - 8) changes sign at 8/9.
TEST(Equilibrium, ModelAJumpsAtZeroLoadExactlyAboveEightNinths) {
  for (const double lambda : {0.1, 0.8, 8.0 / 9 - 1e-4, 8.0 / 9 - 1e-9})
    EXPECT_EQ((LoadedContact(Johnson{}, {lambda}, 0).branches().size()), 1u) << lambda;
  for (const double lambda : {8.0 / 9 + 1e-9, 8.0 / 9 + 1e-4, 0.9, 0.99, 1 - 1e-9})
    EXPECT_EQ((LoadedContact(Johnson{}, {lambda}, 0).branches().size()), 2u) << lambda;
}

TEST(Equilibrium, ModelAFindsItsLowerBranchAfterTheJump) {
  const double lambda = 0.99, m = 0.01;
  const LoadedContact contact(Johnson{}, {lambda}, 0);
  const StableBranch& upper = contact.branches()[0];
  const double x = ((lambda - 2 * m) - std::sqrt(lambda * (9 * lambda - 8))) / (2 * m);  // tan^2 psi at the fold
  const double y = 6 * kPi * (1 + m * x) / (1 + x);
  EXPECT_NEAR(upper.y_bottom, y, 1e-7 * y);  // the position of an extremum is known to sqrt(eps)
  EXPECT_NEAR(upper.T_bottom, y * std::sqrt(x), 1e-13 * y * std::sqrt(x));
  const double above = contact.at(upper.T_bottom * (1 - 1e-6)).y, below = contact.at(upper.T_bottom * (1 + 1e-6)).y;
  EXPECT_GT(above, y);
  EXPECT_LT(below, 0.5 * y);
  EXPECT_LT(
      truth::printed_residual<truth::Digits50>("a", lambda, 0, 0, below * (1 - 1e-13), upper.T_bottom * (1 + 1e-6)), 0);
  EXPECT_GT(
      truth::printed_residual<truth::Digits50>("a", lambda, 0, 0, below * (1 + 1e-13), upper.T_bottom * (1 + 1e-6)), 0);
}

/// Derived in the design: P_c = (3 pi/2)/(k cos(pi l/4))^2.
TEST(Equilibrium, ModelBJumpsBelowItsCriticalLoadAndIsSmoothAbove) {
  for (const auto& [lambda, P_c] : {std::pair{0.15, 5.58469}, std::pair{0.3, 6.89827}}) {
    const auto ends_in_fold = [&, l = lambda](double P) {
      return LoadedContact(WatersGuduru{}, {l}, P).branches().front().ends_in_fold;
    };
    EXPECT_TRUE(ends_in_fold(P_c - 1e-5));
    EXPECT_FALSE(ends_in_fold(P_c + 1e-5));  // printed to 1e-5
    const LoadedContact smooth(WatersGuduru{}, {lambda}, 2 * P_c);
    const double T_H = std::sqrt(6 * kPi * 2 * P_c) / std::sin(kPi * lambda / 4);
    EXPECT_NEAR(smooth.last_load(), T_H, 1e-14 * T_H);
    EXPECT_LT(smooth.at(T_H * (1 - 1e-9)).y, 1e-6);
  }
}

TEST(Equilibrium, SmallShearLowersTheAreaByAlphaTSquared) {
  const double P = 3, T = 1e-3, lambda = 0.15, S0 = std::sqrt(9 * kPi * kPi + 6 * kPi * P);
  const auto loss = [&](auto contact) {
    return contact_state(P, 0, contact.at(0).y).A - contact_state(P, T, contact.at(T).y).A;
  };
  const auto alpha = [&](double l) {
    return kPi * std::pow(0.75, 2.0 / 3) * l / (3 * S0 * std::cbrt(3 * kPi + P + S0));
  };
  // A is 22 and its rounding 4e-15, the loss 1e-8: six digits remain; the next order in T is 1e-7 of the loss.
  EXPECT_NEAR(loss(LoadedContact(PapangeloCiavarella{}, {lambda}, P)) / (T * T), alpha(lambda), 1e-5 * alpha(lambda));
  EXPECT_NEAR(loss(LoadedContact(Johnson{}, {lambda}, P)) / (T * T), alpha(lambda), 1e-5 * alpha(lambda));
  const double l_b = lambda - lambda * lambda / 4;
  EXPECT_NEAR(loss(LoadedContact(WatersGuduru{}, {lambda}, P)) / (T * T), alpha(l_b), 1e-5 * alpha(l_b));
}

TEST(Equilibrium, SaysWhatCannotBeAnswered) {
  const auto contact = [](double lambda, double P) { return LoadedContact(PapangeloCiavarella{}, {lambda}, P); };
  EXPECT_EQ(contact(1.1, 0).at(1).status, EquilibriumStatus::invalid);
  EXPECT_EQ(contact(std::nan(""), 0).at(1).status, EquilibriumStatus::invalid);
  EXPECT_EQ(contact(0.5, std::nan("")).at(1).status, EquilibriumStatus::invalid);
  EXPECT_EQ(contact(0.5, 0).at(-1).status, EquilibriumStatus::invalid);
  EXPECT_EQ(contact(0.5, 0).at(std::nan("")).status, EquilibriumStatus::invalid);
  EXPECT_EQ(contact(0.5, -4.72).at(0).status, EquilibriumStatus::no_equilibrium);
  EXPECT_EQ((LoadedContact(BenzeggaghKenane{}, {9, 2}, 0).at(0).status), EquilibriumStatus::invalid);
}

}  // namespace equilibrium_test
}  // namespace mixity
