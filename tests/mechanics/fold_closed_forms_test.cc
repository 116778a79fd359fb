// The folds of model c, which are closed forms, and the erratum of the paper.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "mechanics/fold_checks.h"
#include "mechanics/fold_search.h"
#include "mechanics/printed_equation.h"
#include "mechanics/registry.h"

namespace mixity {
namespace fold_closed_forms_test {

using truth::Digits50;

/// Model c in closed form, 50 digits (the design's, minus branch).
struct ClosedForm {
  Digits50 T_load, a_load, T_disp, a_disp, a_plus;
  ClosedForm(double lambda, double load) {
    const Digits50 l = lambda, P = load, q = truth::kPi, c = Digits50(3) / 4;
    T_load = sqrt(Digits50(3 * q * (3 * q + 2 * P) / l));
    a_load = cbrt(Digits50(c * (3 * q + P)));
    const Digits50 root = sqrt(Digits50(3 * pow(3 * q + P, 2) * (3 * q * q + 2 * q * P + 3 * P * P)));
    T_disp = sqrt(Digits50(Digits50(3) / 2 * (9 * q * q + 6 * q * P - 3 * P * P + root) / l)) / 2;
    const Digits50 v = sqrt(Digits50(9 * q * q + 6 * q * P - l * T_disp * T_disp));
    a_disp = cbrt(Digits50(c * (3 * q + P - v)));
    a_plus = cbrt(Digits50(c * (3 * q + P + v)));
  }
};

// T is at an extremum and holds to a few roundings; A and u carry those of y besides.
TEST(ModelCFolds, AreTheClosedForms) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 1000; ++i) {
    const double lambda = std::pow(10, -8 * uniform(random));
    const double P = i % 2 ? -4.7 + 9.7 * uniform(random) : std::pow(10, -1 + 5 * uniform(random));
    const ClosedForm closed(lambda, P);
    const EquilibriumCurve curve(PapangeloCiavarella{}, {lambda}, P);
    const auto check = [&](const Control& control, const Digits50& T, const Digits50& a) {
      const std::string where = describe(PapangeloCiavarella{}, {lambda}, P, control);
      const auto folds = find_folds(curve, control);
      ASSERT_EQ(folds.size(), 1u) << where;
      expect_near(folds[0].A, truth::kPi * a * a, 1e-14, "A " + where);
      expect_near(folds[0].u, Digits50(3) / 4 * T / a, 1e-14, "u " + where);
      // and as the searches find them that the other models need
      FoundFolds along{10}, by_angle{10};
      folds_by_position(curve, control, along);
      std::vector<std::vector<FoldPlace>> found{locate_folds(curve, control), along.places};
      if (control.kind == Control::Kind::load) {
        EXPECT_TRUE(folds_by_angle(curve, by_angle)) << where;
        found.push_back(by_angle.places);
      }
      for (const auto& places : found) {
        ASSERT_EQ(places.size(), 1u) << where;
        EXPECT_TRUE(places[0].maximum);
        expect_near(places[0].T, T, 4e-15, "T " + where);
        const double radius = radius_from_edge_load(places[0].position.y, P);
        expect_near(area_from_radius(radius), truth::kPi * a * a, 1e-14, "A " + where);
      }
    };
    check(kLoad, closed.T_load, closed.a_load);
    check(kDisplacement, closed.T_disp, closed.a_disp);
  }
}

/// The erratum: at the printed u_u (+ branch) the displacement is not stationary, on the minus branch it is.
TEST(ModelCFolds, TheDisplacementFoldLiesOnTheMinusBranchNotOnThePrintedOne) {
  for (const double lambda : {0.0023, 0.15, 1.0})
    for (const double P : {-4.0, -1.0, 0.0, 1.0, 5.0, 100.0}) {
      const ClosedForm closed(lambda, P);
      const auto slope = [&](const Digits50& a) {
        const Digits50 y = Digits50(4) / 3 * a * a * a - P;
        return printed_slope(PapangeloCiavarella{}, {lambda}, P, kDisplacement, y, closed.T_disp);
      };
      EXPECT_LT(abs(slope(closed.a_disp)), 1e-25) << lambda << ' ' << P;  // the error of the differences
      EXPECT_GT(abs(slope(closed.a_plus)), 0.01) << lambda << ' ' << P;
      const Fold fold = find_folds(EquilibriumCurve(PapangeloCiavarella{}, {lambda}, P), kDisplacement)[0];
      const double u_plus = static_cast<double>(Digits50(3) / 4 * closed.T_disp / closed.a_plus);
      EXPECT_GT(fold.u, 1.01 * u_plus) << lambda << ' ' << P;  // the largest u lies above what is printed
    }
}

}  // namespace fold_closed_forms_test
}  // namespace mixity
