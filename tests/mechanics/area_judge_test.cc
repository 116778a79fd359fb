// The judge of areas acquits nobody: it finds what is wrong, to the size that its tolerances promise. And the cases
// that it once found.
#include "mechanics/area_judge.h"

#include <gtest/gtest.h>

namespace mixity {
namespace area_judge_test {

template <class Model>
std::string verdict(const Parameters<Model>& p, double P, double T) {
  double error = 0;
  return wrong_with_area(LoadedContact(Model{}, p, P), Judge<Model>{p, P, T}, error);
}

/// The same if the edge load were found at `factor` times where it is.
template <class Model>
std::string verdict_on(const Parameters<Model>& p, double P, double T, double factor) {
  const LoadedContact contact(Model{}, p, P);
  Equilibrium found = contact.at(T);
  found.y *= factor;
  double error = 0;
  return wrong_with_area(contact, Judge<Model>{p, P, T}, found, error);
}

template <class Model>
std::string verdict_if_denied(const Parameters<Model>& p, double P, double T) {
  double error = 0;
  return wrong_with_area(LoadedContact(Model{}, p, P), Judge<Model>{p, P, T}, {EquilibriumStatus::no_equilibrium},
                         error);
}

using Bk = BenzeggaghKenane;

TEST(AreaJudge, FindsAnErrorOfAFewRoundings) {
  EXPECT_EQ(verdict<Johnson>({0.5}, 1, 5), "");
  for (const double off : {1e-14, 1e-12, 1e-6, 1e-2}) {
    EXPECT_NE(verdict_on<Johnson>({0.5}, 1, 5, 1 + off), "") << off;
    EXPECT_NE(verdict_on<WatersGuduru>({0.5}, 1, 5, 1 - off), "") << off;
    EXPECT_NE(verdict_on<Bk>({2, 3}, 1, 5, 1 + off), "") << off;
  }
}

TEST(AreaJudge, FindsAnErrorAtAFoldBeyondTheRootOfARounding) {
  const LoadedContact contact(Bk{}, {0.5, 0.01}, -4.7);
  const double T = contact.last_load();
  EXPECT_EQ(verdict<Bk>({0.5, 0.01}, -4.7, T), "");
  EXPECT_NE(verdict_on<Bk>({0.5, 0.01}, -4.7, T, 1 + 1e-6), "");
  EXPECT_NE(verdict_on<Bk>({0.5, 0.01}, -4.7, T, 1 - 1e-6), "");
  // The fold's area is right where T is the fold's load to rounding, e/(2 eta) = 2e-13, and no further.
  const Equilibrium of_fold{EquilibriumStatus::ok, contact.branches().back().y_bottom};
  const auto verdict_at = [&](double shear) {
    double error = 0;
    return wrong_with_area(contact, Judge<Bk>{{0.5, 0.01}, -4.7, shear}, of_fold, error);
  };
  EXPECT_EQ(verdict_at(T * (1 + 1e-13)), "");
  EXPECT_NE(verdict_at(T * (1 + 1e-12)), "");
}

TEST(AreaJudge, FindsTheLowerOfTwoRoots) {
  const LoadedContact contact(PapangeloCiavarella{}, {0.5}, -2);
  const double y = contact.at(1).y, low = 6 * pi<double>() - y;  // mirrored at the centre of the circle
  EXPECT_EQ(verdict_on<PapangeloCiavarella>({0.5}, -2, 1, low / y), "a root lies above");
}

TEST(AreaJudge, FindsThatAnEquilibriumWasDenied) {
  EXPECT_NE(verdict_if_denied<Johnson>({0.5}, 1, 5), "");
  // bk's fold at a load that is no normal double
  const Parameters<Bk> p{0.09725924626008292, 0.022515796723066264};
  EXPECT_NE(verdict_if_denied<Bk>(p, -4.7123889, 1e-260), "");
  const LoadedContact contact(WatersGuduru{}, {0.5}, 1);
  EXPECT_NE(verdict_if_denied<WatersGuduru>({0.5}, 1, contact.last_load() * (1 - 1e-12)), "");
}

/// At R'' = 0 a step of Euler's method, judged by R'', looks settled too soon.
TEST(AreaRegressions, WhereTheResidualHasNoCurvature) {
  EXPECT_EQ(verdict<Bk>({7.461518030871367, 19.476907762574463}, 1.5250184493798807e-115, 9.424892946361185), "");
}

/// B^(eta-1) above 1/(r-1): a sum that cancelled.
TEST(AreaRegressions, TowardsTheFoldOfASteepLaw) {
  EXPECT_EQ(verdict<Bk>({5.14627787732419, 4.3427036172671265}, 9.056609029965053e-279, 20.70804368846543), "");
  EXPECT_EQ(verdict<Bk>({5.515294673001992, 8.267732378583545}, 0, 16.734217560178323), "");
}

/// T/y in a denormal number, or in none.
TEST(AreaRegressions, AtLoadsBelowAllNormalDoubles) {
  EXPECT_EQ(verdict<Bk>({0.001, 0.01}, -4.401668741716605, 1.389e-320), "");
  EXPECT_EQ(verdict<Bk>({0.001, 0.01}, -4.2352357675101935, 1e-323), "");
  EXPECT_EQ(verdict<Bk>({0.001, 0.01}, 1e140, 1e-200), "");
}

/// Where the curve just closes, at a lambda of a few roundings.
TEST(AreaRegressions, BelowAllAsymptotesOfModelA) {
  EXPECT_EQ(verdict<Johnson>({1.0271375885606103e-14}, -4.712388980384642, 344450916.6023813), "");
}

/// Folds at loads down to the least double, with a condition of 1/(2 eta).
TEST(AreaRegressions, AtFoldsOfASmallExponent) {
  EXPECT_EQ(verdict<Bk>({0.0010000000026792583, 0.010000004091040767}, -4.429171534373107, 8.188144755529783e-61), "");
  EXPECT_EQ(verdict<Bk>({0.0010000131037076233, 0.01}, -4.712373193633454, 8.849169438698366e-285), "");
  const LoadedContact contact(Bk{}, {0.09725924626008292, 0.022515796723066264}, -4.712388980384678);
  const double fold = contact.last_load();
  EXPECT_GT(fold, 0);
  EXPECT_LT(fold, 1e-322);
  EXPECT_EQ(verdict<Bk>({0.09725924626008292, 0.022515796723066264}, -4.712388980384678, fold), "");
}

}  // namespace area_judge_test
}  // namespace mixity
