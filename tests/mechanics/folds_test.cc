// Folds where the printed curve has them: what drives the contact is stationary there.
#include "mechanics/folds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "mechanics/fold_checks.h"
#include "mechanics/fold_search.h"
#include "mechanics/printed_equation.h"
#include "mechanics/registry.h"
#include "mechanics/roots.h"

namespace mixity {
namespace folds_test {

using truth::Digits50;

/// All over the models: the states found lie on the printed curve, and what drives them is stationary there.
template <class Model>
void expect_stationary(const Parameters<Model>& p, double P, const Control& control, int& checked) {
  const EquilibriumCurve curve(Model{}, p, P);
  double A = 1e300;
  for (const Fold& fold : find_folds(curve, control)) {
    const std::string where = describe(Model{}, p, P, control);
    const double y = fold.place.position.y;
    EXPECT_LT(fold.A, A) << where << ": not in the order of the curve";
    A = fold.A;
    const Digits50 residual = truth::residual_of<Model>(p, P, y, fold.T);
    EXPECT_LE(abs(residual), 1e-13 * 6 * truth::kPi * (y + std::abs(P))) << where;  // T to 1e-13
    // A to 1e-12 means y + P to 1.5e-12: a fold lies between places so far above and below.
    const double shift = 1.5e-12 * (y + P);
    if (!(y - shift > 0)) continue;
    const auto slope = [&](double at) {
      const double tau = std::sqrt(6 * pi<double>() * (at + P) - at * at);
      return printed_slope(Model{}, p, P, control, at, tangential_load(Model{}, p, at, tau));
    };
    EXPECT_LT(slope(y + shift) * slope(y - shift), 0) << where;
    ++checked;
  }
}

TEST(Folds, AreStationaryOnThePrintedCurve) {
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> uniform(0, 1);
  int checked = 0;
  for (int i = 0; i < 300; ++i) {
    const double P = i % 2 ? -4.7 + 9.7 * uniform(random) : std::pow(10, -1 + 4 * uniform(random));
    const double small = std::pow(10, -8 * uniform(random));
    for (const Control& control : {kLoad, kDisplacement, spring(std::pow(10, -2 + 4 * uniform(random)))}) {
      expect_stationary<Johnson>({1 - small}, P, control, checked);
      expect_stationary<WatersGuduru>({i % 2 ? 2 * uniform(random) : 2 * small}, P, control, checked);
      expect_stationary<PapangeloCiavarella>({small}, P, control, checked);
      expect_stationary<BenzeggaghKenane>({1 + uniform(random), 2 + uniform(random)}, P, control, checked);
    }
  }
  EXPECT_GT(checked, 2000);
}

/// What one_fold_at_most rests on, and what it promises: T along the densely drawn first piece turns as often as folds
/// are found.
template <class Model>
void expect_one_fold_at_most(const Parameters<Model>& p, double P, double y, double T) {
  const std::string where = describe(Model{}, p, P, kLoad);
  ASSERT_TRUE(Model::one_fold_at_most(p)) << where;
  EXPECT_GE(Model::shear_term(p, y, T).d2, -2 * (1 + 1e-14)) << where << " y=" << y << " T=" << T;  // a rounding
  const EquilibriumCurve curve(Model{}, p, P);
  const CurvePiece& piece = curve.pieces().front();
  int turns = 0;
  double before = 0;
  for (int i = 0; i <= 1000; ++i) {
    // evenly in phi but for the last stretch, where T may be flat to rounding
    const double phi = curve.phi_begin(piece) + (curve.phi_end(piece) - curve.phi_begin(piece)) * (0.999 * i / 1000);
    const double next = curve.point(phi).T;
    if (turns == 0 && next < before) ++turns;
    EXPECT_TRUE(turns == 0 || next < before) << where << ": turns again at phi=" << phi;
    before = next;
  }
  const auto folds = find_folds(curve, kLoad);
  ASSERT_LE(folds.size(), 1u) << where;
  if (turns > 0) {
    EXPECT_EQ(folds.size(), 1u) << where;
  }
}

TEST(Folds, AreOneAtMostWhereTheModelSaysSo) {
  std::mt19937_64 random(13);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 500; ++i) {
    const double P = i % 2 ? -4.7 + 9.7 * uniform(random) : std::pow(10, -1 + 4 * uniform(random));
    const double y = std::pow(10, -6 + 8 * uniform(random)), T = std::pow(10, -6 + 8 * uniform(random));
    expect_one_fold_at_most<Johnson>({0.8 * uniform(random)}, P, y, T);
    expect_one_fold_at_most<WatersGuduru>({2 * uniform(random)}, P, y, T);
  }
  EXPECT_FALSE(Johnson::one_fold_at_most({0.81}));
}

/// Newton's method in (y, T) against the sign change of the slope along the curve.
TEST(Folds, AreTheSameByNewtonAndByTheSlope) {
  std::mt19937_64 random(14);
  std::uniform_real_distribution<double> uniform(0, 1);
  int compared = 0;
  for (int i = 0; i < 3000; ++i) {
    const double lambda = i % 3 ? std::pow(10, -12 * uniform(random)) : 2 * uniform(random);
    const double P = i % 2 ? -1.5 * pi<double>() * (1 - std::pow(10, -14 * uniform(random)))
                           : std::pow(10, -8 + 16 * uniform(random));
    const EquilibriumCurve curve(WatersGuduru{}, {lambda}, P);
    const double T_start = circle_radius(P) / std::sqrt(WatersGuduru::small_shear({lambda}));
    const auto fold = newton_fold(WatersGuduru{}, {lambda}, P, 0, T_start);
    if (!fold || curve.uncoupled()) continue;
    ++compared;
    const CurvePiece& piece = curve.pieces().front();
    const Driven<WatersGuduru> driven{curve, kLoad};
    const auto slope = [&](double at) { return driven.slope(curve.position(piece, at)); };
    const double v = root_between(slope, kFirstCoordinate, kLastCoordinate<WatersGuduru>);
    const CurvePosition slow = curve.position(piece, v), fast = curve.position_at_offset(fold->v);
    const double T = curve.tangential_load(slow);
    // both to a few roundings, which the inverse of tau multiplies by some
    EXPECT_NEAR(curve.tangential_load(fast), T, 1e-14 * T) << lambda << ' ' << P;
    EXPECT_NEAR(fast.y, slow.y, 1e-14 * (slow.y + std::abs(P))) << lambda << ' ' << P;
  }
  EXPECT_GT(compared, 2000);
}

TEST(Folds, ThroughASpringTendToLoadAndDisplacementControl) {
  const auto check = [](const auto& curve) {
    const auto load = find_folds(curve, kLoad), displacement = find_folds(curve, kDisplacement);
    const auto soft = find_folds(curve, spring(1e-12)), stiff = find_folds(curve, spring(1e12));
    ASSERT_EQ(soft.size(), load.size());
    ASSERT_EQ(stiff.size(), displacement.size());
    // the difference is of first order in k and 1/k, with factors of order 10
    for (std::size_t i = 0; i < load.size(); ++i) EXPECT_NEAR(soft[i].A, load[i].A, 1e-10 * load[i].A);
    for (std::size_t i = 0; i < stiff.size(); ++i) EXPECT_NEAR(stiff[i].A, displacement[i].A, 1e-10 * stiff[i].A);
    const double at_k = find_folds(curve, spring(1e-4))[0].A, at_2k = find_folds(curve, spring(2e-4))[0].A;
    EXPECT_NEAR((load[0].A - at_2k) / (load[0].A - at_k), 2, 0.01);  // next order: 1e-4 of the first
  };
  for (const double P : {-4.0, -1.0, 0.0, 1.0, 5.0}) {
    check(EquilibriumCurve(PapangeloCiavarella{}, {0.15}, P));
    check(EquilibriumCurve(WatersGuduru{}, {0.15}, P));
    check(EquilibriumCurve(Johnson{}, {0.98}, P));
    check(EquilibriumCurve(BenzeggaghKenane{}, {1.774, 2.284}, P));
  }
}

}  // namespace folds_test
}  // namespace mixity
