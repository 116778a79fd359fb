// The load below which a contact jumps, of every law: against the closed forms of a and b, and against what becomes of
// contacts (classify), which searches their folds.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "mechanics/contact_model.h"
#include "mechanics/laws/known_laws.h"
#include "mechanics/regimes.h"

namespace mixity {
namespace critical_load_test {

constexpr double kPullOff = -4.71238898038469;

void define(const LawDefinition& definition) {
  LawError error;
  ASSERT_TRUE(define_law(definition, error)) << error.message;
}

// 1e-11: the load is a limit at 90 degrees, where a difference of two large terms is left of 1/lambda
TEST(CriticalLoad, IsTheClosedFormOfModelB) {
  for (const double lambda : {1e-6, 0.0023, 0.15, 0.3, 0.7, 1.0, 1.3, 1.7, 1.9}) {
    const double P_c = model_b_critical_load(lambda);
    EXPECT_NEAR(critical_load(WatersGuduru{}, {lambda}), P_c, 1e-11 * P_c) << lambda;
  }
}

TEST(CriticalLoad, IsTheClosedFormOfModelA) {
  for (const double P : {-4.7, -3.0, -1.79, -0.8, -0.7, -0.23, 0.1, 0.5, 1.0, 3.0, 11.5, 30.4, 1e3}) {
    const double lambda = model_a_jump_boundary(P).lambda;
    // lambda is rounded, and the load moves by dP/d lambda, at most as 1/(1 - lambda)
    EXPECT_NEAR(critical_load(Johnson{}, {lambda}), P, 1e-12 * (5 + std::abs(P)) / (1 - lambda)) << P;
  }
}

TEST(CriticalLoad, IsPullOffWithoutCouplingAndBeyondAllLoadsForModelC) {
  EXPECT_NEAR(critical_load(Johnson{}, {0}), kPullOff, 1e-12);
  EXPECT_NEAR(critical_load(PapangeloCiavarella{}, {0}), kPullOff, 1e-12);
  for (const double lambda : {1e-9, 0.0023, 0.15, 1.0}) EXPECT_GT(critical_load(PapangeloCiavarella{}, {lambda}), 1e20);
  EXPECT_GT(critical_load(Johnson{}, {1}), 1e20);
  EXPECT_GT(critical_load(WatersGuduru{}, {2}), 1e20);
  EXPECT_FALSE(ContactModel::find("a")->critical_load(std::vector{2.0}));
  EXPECT_FALSE(ContactModel::find("bk")->critical_load(std::vector{30.0, 3.0}));  // no unique equilibrium
}

/// Loads at random, and both sides of the critical one.
void agrees(const std::string& key, const std::vector<double>& p) {
  static std::mt19937 random(1);
  std::uniform_real_distribution<double> part(0, 1);
  const ContactModel model = ContactModel::find(key).value();
  const auto critical = model.critical_load(p);
  ASSERT_EQ(critical.has_value(), model.problem(p).empty());
  if (!critical) return;
  std::vector<double> loads{*critical - 1e-6 * (5 + std::abs(*critical)), *critical + 1e-6 * (5 + std::abs(*critical))};
  for (int i = 0; i < 10; ++i) loads.push_back(kPullOff * 0.999 + 30 * part(random) * part(random));
  for (const double P : loads) {
    if (!(P > kPullOff * 0.9999 && P < 1e6)) continue;
    const auto found = model.regime(p, P);
    ASSERT_TRUE(found) << model.problem(p, P);
    EXPECT_EQ(found->regime == Regime::jump, P < *critical)
        << key << ' ' << p[0] << ' ' << p.back() << " P " << P << " critical " << *critical;
  }
}

TEST(CriticalLoad, PartsTheRegimesOfEveryModel) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> part(0, 1);
  for (int i = 0; i < 200; ++i) {
    const double q = std::pow(part(random), 3);
    agrees("a", {1 - q});
    agrees("b", {2 * q});
    agrees("c", {q});
    agrees("bk", {std::exp(3 * (part(random) - 0.5)), std::exp(2.5 * (part(random) - 0.3))});
  }
}

TEST(CriticalLoad, PartsTheRegimesOfLawsThatAreTyped) {
  define({"critical_power", "1 + p*tan(psi)^n", {{"p", 0, 1, 0.3}, {"n", 0.5, 4, 1.5}}});
  define({"critical_b", "1 + tan((1-l/2)*psi)^2", {{"l", 0, 2, 0.15}}});
  define({"critical_c", "K_I^2 + l*K_II^2 = 1", {{"l", 0, 1, 0.15}}});
  define({"critical_falls", "exp(-q*B)", {{"q", 0, 5, 1}}});  // weaker in mode II
  define({"critical_angle", "1 + q*sin(psi)^4", {{"q", 0, 50, 1}}});
  std::mt19937 random(3);
  std::uniform_real_distribution<double> part(0, 1);
  for (int i = 0; i < 30; ++i) {
    // with n < 2 every P < 0 jumps in the end, at shear beyond all searches
    agrees("critical_power", {part(random), 2 + 2 * part(random)});
    agrees("critical_b", {2 * part(random)});
    agrees("critical_c", {part(random)});
    agrees("critical_falls", {5 * part(random)});
    agrees("critical_angle", {50 * part(random)});
  }
  for (const double lambda : {0.15, 0.7, 1.7})
    EXPECT_NEAR(ContactModel::find("critical_b")->critical_load(std::vector{lambda}).value(),
                model_b_critical_load(lambda), 1e-9 * model_b_critical_load(lambda));  // psi is rounded
}

}  // namespace critical_load_test
}  // namespace mixity
