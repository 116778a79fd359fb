// What a contact jumps to at a fold.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "mechanics/fold_checks.h"
#include "mechanics/folds.h"
#include "mechanics/printed_equation.h"
#include "mechanics/registry.h"

namespace mixity {
namespace fold_jumps_test {

using truth::Digits50;

/// Judges where a fold jumps to with the printed equation at the same T, u or u + T/k, as a function of y alone:
/// positive above the stable root. Counts what it saw.
template <class Model>
void judge_jumps(const Parameters<Model>& p, double P, const Control& control, int (&seen)[4]) {
  for (const Fold& fold : find_folds(EquilibriumCurve(Model{}, p, P), control)) {
    const std::string where = describe(Model{}, p, P, control);
    ++seen[static_cast<int>(fold.jumps_to)];
    const Digits50 T_f = fold.T, y_f = fold.place.position.y, k = control.stiffness;
    const auto a_at = [&](const Digits50& y) { return cbrt(Digits50(Digits50(3) / 4 * (y + P))); };
    const auto share = [&](const Digits50& y) {  // v/T
      if (control.kind == Control::Kind::load) return Digits50(1);
      const Digits50 u = Digits50(3) / 4 / a_at(y);
      return control.kind == Control::Kind::displacement ? u : Digits50(u + 1 / k);
    };
    const auto residual = [&](const Digits50& y) {
      const Digits50 T = T_f * share(y_f) / share(y);
      return truth::residual_of<Model>(p, P, y, T);
    };
    EXPECT_EQ(fold.area_lost, fold.A - fold.area_after) << where;
    Digits50 y_after = P < 0 ? Digits50(-P) : Digits50(0);  // off contact; Hertz
    if (fold.jumps_to == Jump::off_contact) {
      EXPECT_LE(P, 0) << where;
      EXPECT_EQ(fold.area_after, 0) << where;
    } else if (fold.jumps_to == Jump::hertz) {
      EXPECT_GT(P, 0) << where;
      const Digits50 a = a_at(0);
      expect_near(fold.area_after, truth::kPi * a * a, 1e-15, "Hertz area " + where);
    } else {
      const Digits50 a = sqrt(Digits50(Digits50(fold.area_after) / truth::kPi)), sum = Digits50(4) / 3 * a * a * a;
      y_after = sum - P;
      // the area to 1e-10: T and u of the fold are known to 1e-13, magnified where the lower branch is steep
      EXPECT_LT(residual(y_after - 1.5e-10 * sum), 0) << where;
      EXPECT_GT(residual(y_after + 1.5e-10 * sum), 0) << where;
      EXPECT_EQ(fold.jumps_to == Jump::lower_branch, fold.place.maximum) << where;
      EXPECT_EQ(fold.jumps_to == Jump::lower_branch, fold.area_lost > 0) << where;
    }
    // no state in between that would hold the contact
    for (int i = 1; i < 40; ++i) {
      const Digits50 y = y_after + (y_f - y_after) * i / 40;
      EXPECT_EQ(residual(y) > 0, fold.place.maximum) << where << " at y " << y;
    }
  }
}

TEST(Jumps, LeadToTheNextStateAtTheSameControl) {
  std::mt19937_64 random(13);
  std::uniform_real_distribution<double> uniform(0, 1);
  int seen[4] = {};
  for (int i = 0; i < 120; ++i) {
    const double P = i % 3 ? -4.7 + 24 * uniform(random) : std::pow(10, 3 * uniform(random));
    for (const Control& control : {kLoad, kDisplacement, spring(std::pow(10, -2 + 4 * uniform(random)))}) {
      judge_jumps<Johnson>({1 - 0.2 * std::pow(10, -6 * uniform(random))}, P, control, seen);
      judge_jumps<WatersGuduru>({2 * uniform(random)}, P, control, seen);
      judge_jumps<PapangeloCiavarella>({uniform(random)}, P, control, seen);
      judge_jumps<BenzeggaghKenane>({1 + uniform(random), 2 + uniform(random)}, P, control, seen);
    }
  }
  for (const Jump jump : {Jump::hertz, Jump::lower_branch, Jump::upper_branch, Jump::off_contact})
    EXPECT_GT(seen[static_cast<int>(jump)], 20) << to_string(jump);
}

}  // namespace fold_jumps_test
}  // namespace mixity
