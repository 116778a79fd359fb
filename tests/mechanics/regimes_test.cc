// What becomes of a sheared contact.
#include "mechanics/regimes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "mechanics/equilibrium.h"
#include "mechanics/printed_equation.h"
#include "mechanics/registry.h"

namespace mixity {
namespace regimes_test {

using truth::Digits50;

template <class Model>
Regime fracture(double lambda, double P) {
  return classify(Model{}, {lambda}, P).fracture;
}

// ---- Model b ----

TEST(Regimes, ModelBTurnsFromJumpToSmoothExactlyAtTheCriticalLoad) {
  for (const double lambda : {1e-6, 0.0023, 0.15, 0.3, 0.7, 1.0, 1.3, 1.7, 1.9}) {
    const double P_c = model_b_critical_load(lambda);
    EXPECT_EQ(fracture<WatersGuduru>(lambda, P_c * (1 - 1e-9)), Regime::jump) << lambda;
    EXPECT_EQ(fracture<WatersGuduru>(lambda, P_c * (1 + 1e-9)), Regime::hertz) << lambda;
    EXPECT_EQ(fracture<WatersGuduru>(lambda, 0.5 * P_c), Regime::jump) << lambda;
    EXPECT_EQ(fracture<WatersGuduru>(lambda, 2 * P_c), Regime::hertz) << lambda;
  }
  for (const double P : {-4.7, 0.0, 30.4, 1e4, 1e8}) EXPECT_EQ(fracture<WatersGuduru>(2, P), Regime::jump) << P;
}

TEST(Regimes, SmoothModelBEndsAtTheHertzLoad) {
  for (const double lambda : {0.15, 1.0})
    for (const double P : {40.0, 100.0, 1e4}) {  // above P_c = 37.7 of lambda = 1
      const RegimeReport report = classify(WatersGuduru{}, {lambda}, P);
      const double T_H = std::sqrt(6 * pi<double>() * P) / std::sin(pi<double>() * lambda / 4);
      EXPECT_NEAR(report.T_end, T_H, 1e-14 * T_H);  // a few roundings
      EXPECT_FALSE(report.jumps_to);
    }
}

// ---- Model a ----

TEST(Regimes, ModelAJumpsExactlyAboveItsBoundary) {
  for (const double P : {-4.7, -3.0, -1.79, -0.8, -0.7, -0.23, -1e-6, 0.0, 0.1, 0.5, 1.0, 3.0, 11.5, 30.4, 1e3, 1e4}) {
    const CuspPoint point = model_a_jump_boundary(P);
    // 1e-6 of the distance from 1: far above the rounding of lambda, and a pair of folds that close lies 1e-3 apart
    const double step = 1e-6 * point.one_minus_lambda;
    EXPECT_EQ(fracture<Johnson>(point.lambda + step, P), Regime::jump) << P;
    EXPECT_EQ(fracture<Johnson>(point.lambda - step, P), Regime::asymptote) << P;
  }
  for (const double P : {-4.7, 0.0, 30.4, 1e8}) EXPECT_EQ(fracture<Johnson>(1, P), Regime::jump) << P;
}

TEST(Regimes, ModelADropsOffAboveTheClosingLineOnly) {
  for (const double P : {-0.6, -0.3, -0.1}) {  // between the cusp and the closing line the jump is to a lower branch
    const double cusp = model_a_jump_boundary(P).lambda, closing = model_a_closing_lambda(P);
    ASSERT_LT(cusp, closing);
    EXPECT_EQ(classify(Johnson{}, {0.5 * (cusp + closing)}, P).jumps_to, Jump::lower_branch) << P;
    EXPECT_EQ(classify(Johnson{}, {0.5 * (1 + closing)}, P).jumps_to, Jump::off_contact) << P;
  }
  EXPECT_EQ(classify(Johnson{}, {0.99}, 1).jumps_to, Jump::lower_branch);
  EXPECT_EQ(classify(Johnson{}, {1.0}, 1).jumps_to, Jump::hertz);
}

// ---- Model c, uncoupled ----

TEST(Regimes, ModelCAlwaysJumps) {
  for (const double lambda : {1e-12, 0.0023, 0.15, 0.5, 1.0})
    for (const double P : {-4.7, -1.0, 0.0, 1e-12, 1.0, 30.4, 1e4, 1e8}) {
      const RegimeReport report = classify(PapangeloCiavarella{}, {lambda}, P);
      EXPECT_EQ(report.fracture, Regime::jump);
      EXPECT_EQ(report.jumps_to, P > 0 ? Jump::hertz : Jump::off_contact);
      const double T_f = std::sqrt(3 * pi<double>() * (3 * pi<double>() + 2 * P) / lambda);
      EXPECT_NEAR(report.T_end, T_f, 4e-14 * T_f) << lambda << ' ' << P;  // 3 pi + 2 P cancels in this line at -4.7
    }
}

TEST(Regimes, WithoutCouplingNothingEverHappens) {
  for (const double P : {-4.7, 0.0, 30.4}) {
    EXPECT_EQ(fracture<Johnson>(0, P), Regime::asymptote);
    EXPECT_EQ(fracture<WatersGuduru>(0, P), Regime::asymptote);
    EXPECT_EQ(fracture<PapangeloCiavarella>(0, P), Regime::asymptote);
    EXPECT_EQ(classify(PapangeloCiavarella{}, {0.0}, P, 1.0).regime, Regime::strength);
  }
}

// ---- Strength ----

/// T = tau0 A on the printed curve, and regime 4 exactly when that comes before the fracture is complete.
template <class Model>
void judge_strength(const Parameters<Model>& p, double P, double tau0, int (&seen)[2]) {
  const RegimeReport report = classify(Model{}, p, P, tau0);
  const LoadedContact contact(Model{}, p, P);
  const auto where = [&] {
    return ::testing::Message() << Model::info.key << ' ' << p[0] << " P " << P << " tau0 " << tau0;
  };
  const StableBranch& branch = contact.branches().front();
  ++seen[report.T_strength.has_value()];
  EXPECT_EQ(report.regime == Regime::strength, report.T_strength.has_value()) << where();
  if (!report.T_strength) {
    EXPECT_EQ(report.regime, report.fracture) << where();
    // the contact is still stronger than its load where the branch ends
    const double A = area_from_radius(radius_from_edge_load(branch.y_bottom, P));
    EXPECT_LT(branch.T_bottom, tau0 * A) << where();
    return;
  }
  const double T = *report.T_strength, A = T / tau0;
  EXPECT_LE(T, branch.T_bottom) << where();
  // The printed equation changes sign about the area T/tau0. T - tau0 A(T) has a slope >= 1, so T is as good as A is,
  // which is eps/sqrt(1 - T/T_f) near a fold.
  const double relative = 1e-13 + 1e-15 / std::sqrt(std::max(1e-16, 1 - T / branch.T_bottom));
  const auto residual = [&](double factor) {
    const Digits50 a = sqrt(Digits50(Digits50(A) * factor / truth::kPi)), y = Digits50(4) / 3 * a * a * a - P;
    return truth::residual_of<Model>(p, P, y, T);
  };
  EXPECT_LT(residual(1 - relative), 0) << where();
  EXPECT_GT(residual(1 + relative), 0) << where();
}

TEST(Strength, IsReachedWhereTheLoadIsStrengthTimesArea) {
  std::mt19937_64 random(21);
  std::uniform_real_distribution<double> uniform(0, 1);
  int seen[2] = {};
  for (int i = 0; i < 400; ++i) {
    const double P = i % 2 ? -4.6 + 9 * uniform(random) : std::pow(10, 3 * uniform(random));
    const double tau0 = std::pow(10, -2 + 4 * uniform(random)), lambda = std::pow(10, -3 * uniform(random));
    judge_strength<PapangeloCiavarella>({lambda}, P, tau0, seen);
    judge_strength<Johnson>({lambda}, P, tau0, seen);
    judge_strength<WatersGuduru>({1.9 * lambda}, P, tau0, seen);
    judge_strength<BenzeggaghKenane>({1 + uniform(random), 2 + uniform(random)}, P, tau0, seen);
  }
  EXPECT_GT(seen[0], 100);
  EXPECT_GT(seen[1], 100);
}

/// Model c, closed form: the fold comes first exactly if T_T < tau0 A_T.
TEST(Strength, ComesFirstForModelCExactlyBelowTheClosedForm) {
  for (const double P : {-4.0, 0.0, 3.0, 30.4})
    for (const double lambda : {0.0023, 0.15, 1.0}) {
      const double q = pi<double>(), T_f = std::sqrt(3 * q * (3 * q + 2 * P) / lambda);
      const double A_f = q * std::pow(0.75 * (3 * q + P), 2.0 / 3), critical = T_f / A_f;
      const auto regime = [&](double tau0) { return classify(PapangeloCiavarella{}, {lambda}, P, tau0).regime; };
      EXPECT_EQ(regime(critical * (1 - 1e-6)), Regime::strength);  // A is known to 1e-8 at the fold
      EXPECT_EQ(regime(critical * (1 + 1e-6)), Regime::jump);
    }
}

template <class Model>
void expect_numbers(const Parameters<Model>& p) {
  for (const double P : {-4.71238898038469, -4.7, -1.0, -1e-300, 0.0, 1e-300, 1.0, 30.4, 1e8})
    for (const double tau0 : {1e-150, 1e-6, 1.0, 1e6, 1e150}) {
      const RegimeReport report = classify(Model{}, p, P, tau0);
      const auto where = [&] {
        return ::testing::Message() << Model::info.key << ' ' << p[0] << " P " << P << " tau0 " << tau0;
      };
      // bk with eta = 0.01 at pull-off: T ends below all doubles
      EXPECT_TRUE(report.T_end > 0 || (report.T_end == 0 && p.size() == 2 && p[1] < 0.02 && P < -4.71)) << where();
      EXPECT_EQ(std::isinf(report.T_end), report.fracture == Regime::asymptote) << where();
      EXPECT_EQ(report.jumps_to.has_value(), report.fracture == Regime::jump) << where();
      if (!report.T_strength) continue;
      EXPECT_TRUE(*report.T_strength > 0 || report.T_end == 0) << where();
      EXPECT_LE(*report.T_strength, report.T_end) << where();
    }
}

TEST(Regimes, AreNumbersAtAnyExtreme) {
  for (const double q : {0.0, 1e-300, 1e-160, 1e-100, 1e-16, 1e-12, 1e-6, 0.15, 8.0 / 9, 1 - 1e-12, 1 - 1e-15, 1.0}) {
    expect_numbers<Johnson>({q});
    expect_numbers<WatersGuduru>({2 * q});
    expect_numbers<PapangeloCiavarella>({q});
  }
  for (const auto& p :
       {std::array{1.0, 1.0}, {2.0, 1.0}, {4.0, 2.0}, {0.7, 1.5}, {0.5, 0.5}, {1e-3, 0.01}, {1e-3, 1.0}})
    expect_numbers<BenzeggaghKenane>(p);
}

}  // namespace regimes_test
}  // namespace mixity
