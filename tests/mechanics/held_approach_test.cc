// Contacts whose approach is held. Reference values: the printed equations in 45 digits (mpmath), in forty steps from T
// = 0.
#include "mechanics/held_approach.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "mechanics/contact.h"

namespace mixity {
namespace held_approach_test {

constexpr double kRadius = 1e-12;  // relative, away from folds

ApproachStates states(const char* key, double lambda, double approach, double compliance,
                      const std::vector<double>& T) {
  return under_held_approach(ContactModel::find(key).value(), {&lambda, 1}, {approach, compliance}, T);
}

TEST(HeldApproach, HasTheStatesOfAReferenceSolution) {
  struct Case {
    const char* model;
    double lambda, approach, compliance, T, a, P;
  };
  const std::vector<Case> cases{{"c", 0.15, 5, 0, 20, 3.02824894168804244, 11.7692054217687455},
                                {"c", 0.15, -0.5, 0, 4, 1.63353230532526015, -4.53950764102120535},
                                {"c", 0.02, 5, 0.3, 40, 2.72863214889385536, 5.21103068171383098},
                                {"a", 0.5, 3, 0.1, 12, 2.52756124865358761, 2.92284114480433978},
                                {"b", 0.3, 10, 0, 40, 3.76640038251551967, 39.7084766571263866}};
  for (const Case& one : cases) {
    const ApproachStates found = states(one.model, one.lambda, one.approach, one.compliance, {one.T});
    ASSERT_EQ(found.at[0].status, EquilibriumStatus::ok) << one.model << one.approach;
    EXPECT_NEAR(found.at[0].a / one.a, 1, kRadius) << one.model << one.approach;
    EXPECT_NEAR(found.at[0].P / one.P, 1, 10 * kRadius) << one.model << one.approach;
  }
}

TEST(HeldApproach, ThroughASoftMachineIsAHeldLoad) {
  const double lambda = 0.15, compliance = 1e15;
  for (const double P : {-3.0, 0.5, 20.0}) {
    const std::vector<double> T{0, 3, 8};
    std::vector<double> A(T.size());
    std::vector<EquilibriumStatus> status(T.size());
    ContactModel::find("c")->areas_at({&lambda, 1}, P, T, A, status);
    const ApproachStates found = states("c", lambda, P * compliance, compliance, T);
    for (std::size_t i = 0; i < T.size(); ++i)
      EXPECT_NEAR(found.at[i].a / radius_from_area(A[i]), 1, kRadius) << P << ' ' << T[i];
  }
}

TEST(HeldApproach, IsJkrWithoutShear) {
  for (const double P : {-2.0, 0.0, 10.0}) {
    const double a = jkr_radius(P), approach = a * a - edge_load(a, P) / (2 * a);
    for (const double T : {0.0, 1e-9}) {
      const ApproachState state = states("c", 0.15, approach, 0, {T}).at[0];
      EXPECT_NEAR(state.a / a, 1, 1e-14);
      EXPECT_NEAR(state.P, P, 1e-12);
    }
  }
}

/// JKR holds down to an approach below that of the pull-off load: 2 a = sqrt(pi/(2 a)) there.
TEST(HeldApproach, EndsAtThePullOffOfAHeldApproach) {
  const double a = std::cbrt(pi<double>() / 8), least = a * a - std::sqrt(2 * pi<double>() * a);
  EXPECT_EQ(states("c", 0.15, least * (1 - 1e-9), 0, {0}).at[0].status, EquilibriumStatus::ok);
  EXPECT_EQ(states("c", 0.15, least * (1 + 1e-9), 0, {0}).at[0].status, EquilibriumStatus::no_equilibrium);
}

/// At the fold T(a) is stationary: tau^2 = 8 pi a^3 - y^2 for model c.
TEST(HeldApproach, HasTheFoldOfModelC) {
  const double lambda = 0.15, approach = 5;
  const ApproachStates found = states("c", lambda, approach, 0, {1, 1e3});
  ASSERT_TRUE(found.end);
  EXPECT_TRUE(found.end->fold);
  EXPECT_EQ(found.at[1].status, EquilibriumStatus::no_equilibrium);
  const double a = found.end->a, y = 2 * a * (a * a - approach);
  const double slope = 24 * pi<double>() * a * a - 2 * y * (6 * a * a - 2 * approach);
  EXPECT_NEAR(slope / (24 * pi<double>() * a * a), 0, 1e-6);  // the place of a maximum, to the root of its rounding
  EXPECT_NEAR(lambda * found.end->T * found.end->T / (8 * pi<double>() * a * a * a - y * y), 1, 1e-12);
  EXPECT_NEAR(found.end->P, 2 * a * approach - 2.0 / 3 * a * a * a, 1e-12);
}

TEST(HeldApproach, IsNeverNaNWithoutAStatus) {
  const std::vector<double> T{0, 1, -1, std::nan(""), 1e200, 1e3};
  for (const char* key : {"a", "b", "c"})
    for (const double lambda : {0.0, 0.3, 1.0, -1.0})
      for (const double approach : {-1e3, -0.5, 0.0, 7.0, 1e6, std::nan("")})
        for (const double compliance : {0.0, 0.1, 1e10, -1.0})
          for (const ApproachState& one : states(key, lambda, approach, compliance, T).at)
            EXPECT_EQ(one.status == EquilibriumStatus::ok, std::isfinite(one.a) && std::isfinite(one.P));
}

}  // namespace held_approach_test
}  // namespace mixity
