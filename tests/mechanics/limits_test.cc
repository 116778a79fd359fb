// Small shear, large area and Savkoor & Briggs, against the printed equation in 50 digits.
#include "mechanics/limits.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mechanics/contact_model.h"
#include "mechanics/equilibrium.h"
#include "mechanics/printed_equation.h"
#include "mechanics/states.h"

namespace mixity {
namespace limits_test {

using truth::Digits50;

const double kLoads[] = {-4.7, -4.0, -1.0, -1e-6, 0, 1e-6, 1, 30.4, 1e4, 1e8};

/// Area on the upper branch of the printed equation at a small T: Newton in 50 digits from JKR, slope by differences.
template <class Model>
Digits50 printed_area_near_jkr(const Parameters<Model>& p, double P, const Digits50& T) {
  const auto F = [&](const Digits50& y) { return truth::residual_of<Model>(p, P, y, T); };
  Digits50 y = truth::jkr_edge_load(P);
  for (int i = 0; i < 12; ++i) {
    const Digits50 h = y * Digits50(1e-20);
    y -= F(y) * 2 * h / (F(y + h) - F(y - h));
  }
  const Digits50 a = cbrt(Digits50(Digits50(3) / 4 * (y + P)));
  return truth::kPi * a * a;
}

/// (A0 - A)/T^2 at T and T/2, Richardson's way: the terms in T^2 that remain of O(T^4) drop out.
template <class Model>
double printed_alpha(const Parameters<Model>& p, double P) {
  const Digits50 T = Digits50(1e-6) * sqrt(Digits50(9 * truth::kPi * truth::kPi + 6 * truth::kPi * Digits50(P)));
  const Digits50 A0 = printed_area_near_jkr<Model>(p, P, 0);
  const Digits50 coarse = (A0 - printed_area_near_jkr<Model>(p, P, T)) / (T * T);
  const Digits50 fine = (A0 - printed_area_near_jkr<Model>(p, P, T / 2)) / (T * T / 4);
  return static_cast<double>(Digits50((4 * fine - coarse) / 3));
}

/// What is left after Richardson is T^4 = 1e-24 of the whole, times (S0/y)^4 lambda^-1 at most; the 3 pi + P + S0 of
/// the library is exact to a few roundings.
template <class Model>
void expect_alpha(const Parameters<Model>& p) {
  for (const double P : kLoads) {
    const double alpha = printed_alpha<Model>(p, P);
    const auto found = shear_sensitivity(Model{}, p, P);
    ASSERT_TRUE(found) << Model::info.key << ' ' << p[0] << ' ' << P;
    EXPECT_NEAR(*found, alpha, 4e-15 * std::abs(alpha)) << Model::info.key << ' ' << p[0] << ' ' << P;
    const double A0 = area_from_radius(jkr_radius(P));
    const auto at_area = ContactModel::find(Model::info.key)->shear_sensitivity(p, A0);
    ASSERT_TRUE(at_area) << P;
    // S0 = h - 3 pi - P from A0: near pull-off a rounding of A0 is magnified by 1/S0^2, at large P by the cancelling P
    const double S0 = circle_radius(P);
    EXPECT_NEAR(*at_area, alpha, 1e-15 * (50 + 1e3 / (S0 * S0) + std::sqrt(std::abs(P))) * alpha) << P;
  }
}

TEST(SmallShear, SensitivityIsThatOfThePrintedEquation) {
  for (const double lambda : {1e-6, 0.0023, 0.15, 0.5, 0.95, 1.0}) {
    expect_alpha<PapangeloCiavarella>({lambda});
    expect_alpha<Johnson>({lambda});
    expect_alpha<WatersGuduru>({lambda});
    expect_alpha<WatersGuduru>({2 * lambda});
  }
  for (const auto& p : {std::array{1.5, 1.0}, {0.5, 1.0}, {1.0, 1.0}, {1.774, 2.284}, {0.7, 3.0}})
    expect_alpha<BenzeggaghKenane>(p);
}

TEST(SmallShear, SensitivityIsZeroWithoutCouplingAndAtTheEdgeOfBk) {
  EXPECT_EQ(shear_sensitivity(PapangeloCiavarella{}, {0.0}, 1), 0);
  EXPECT_EQ(shear_sensitivity(Johnson{}, {0.0}, 1), 0);
  EXPECT_EQ(shear_sensitivity(WatersGuduru{}, {0.0}, 1), 0);
  EXPECT_EQ((shear_sensitivity(BenzeggaghKenane{}, {2, 1}, 1)), 0);
}

/// B^eta with eta < 1 dominates T^2: (A0 - A)/T^2 grows as T falls, so there is no alpha.
TEST(SmallShear, BkBelowEtaOneHasNoSensitivity) {
  for (const double eta : {0.5, 0.9}) {
    const auto loss = [&](double T) {
      const Digits50 A0 = printed_area_near_jkr<BenzeggaghKenane>({0.5, eta}, 1, 0);
      return (A0 - printed_area_near_jkr<BenzeggaghKenane>({0.5, eta}, 1, T)) / (Digits50(T) * T);
    };
    EXPECT_GT(loss(1e-8), 2 * loss(1e-4)) << eta;
    for (const double P : kLoads) EXPECT_FALSE((shear_sensitivity(BenzeggaghKenane{}, {0.5, eta}, P))) << eta;
  }
}

TEST(SmallShear, NoSensitivityExistsAtOrBelowPullOff) {
  for (const double P : {-4.7124, -5.0, -1e8}) EXPECT_FALSE(shear_sensitivity(PapangeloCiavarella{}, {0.5}, P)) << P;
  EXPECT_TRUE(shear_sensitivity(PapangeloCiavarella{}, {0.5}, -4.71238898038469));  // 1.8e-16 above -3 pi/2
  EXPECT_FALSE(ContactModel::find("c")->shear_sensitivity(std::array{0.5}, 7.28));  // pull-off area is 7.2893
}

TEST(LargeArea, SensitivityFollowsThePowerMinusFiveQuarters) {
  // pi^(7/4) lambda/(8 sqrt 2) A0^(-5/4), the constant from 50 digits
  const double constant = static_cast<double>(Digits50(pow(truth::kPi, Digits50(7) / 4) / (8 * sqrt(Digits50(2)))));
  double last_A0 = 0, last_alpha = 0;
  for (const double P : {1e4, 1e8, 1e12, 1e16, 1e100}) {
    const double A0 = area_from_radius(jkr_radius(P));
    const double exact = *shear_sensitivity(PapangeloCiavarella{}, {0.15}, P);
    const double limit = constant * 0.15 * std::pow(A0, -1.25);
    EXPECT_NEAR(limit / exact, 1, 2.5 / std::sqrt(P) + 1e-14) << P;          // the next term, as the header says
    EXPECT_GT(std::abs(limit / exact - 1), 1.5 / std::sqrt(P) - 1e-8) << P;  // and no better than that
    if (last_A0 > 0) {
      const double power = std::log(exact / last_alpha) / std::log(A0 / last_A0);
      EXPECT_NEAR(power, -1.25, 0.01) << P;
    }
    last_A0 = A0;
    last_alpha = exact;
  }
}

TEST(Jkr, LoadInvertsTheRadius) {
  for (const double P : {-4.712, -4.7, -4.0, -1.0, 0.0, 1e-6, 1.0, 30.4, 1e4, 1e8}) {
    const auto found = jkr_load(area_from_radius(jkr_radius(P)));
    ASSERT_TRUE(found) << P;
    // P is the difference of h = 4/3 a^3 and sqrt(6 pi h), h carries a few roundings
    const double h = P + 3 * pi<double>() + circle_radius(P);
    EXPECT_NEAR(*found, P, 2e-15 * h) << P;
  }
  EXPECT_FALSE(jkr_load(7.289));  // pi (9 pi/8)^(2/3) = 7.28928 at pull-off
  EXPECT_TRUE(jkr_load(7.2893));
  for (const double A0 : {0.0, 1e-300, -1.0, std::nan("")}) EXPECT_FALSE(jkr_load(A0)) << A0;
}

TEST(SavkoorBriggs, IsTheBrittleLimitOfEveryModel) {
  for (const double P : {-4.71, -4.7, -1.0, 0.0, 1.0, 30.4, 1e4, 1e8})
    for (const double part : {0.0, 1e-8, 0.1, 0.5, 0.9, 0.99}) {
      const double T = part * circle_radius(P);
      // the printed equation with f = 1: y^2 + T^2 = 6 pi (y + P), upper root, in 50 digits
      const Digits50 q = truth::kPi, y = 3 * q + sqrt(Digits50(9 * q * q + 6 * q * P - Digits50(T) * T));
      const double truth = static_cast<double>(Digits50(cbrt(Digits50(Digits50(3) / 4 * (y + P)))));
      // one rounding of S0 - T is worth 1/sqrt(1 - part) more in y
      const double tolerance = 2e-15 / std::sqrt(1 - part);
      const auto expect = [&](const auto& contact) {
        EXPECT_NEAR(contact_state(P, T, contact.at(T).y).a, truth, tolerance * truth) << P << ' ' << part;
      };
      expect(LoadedContact(Johnson{}, {1.0}, P));
      expect(LoadedContact(PapangeloCiavarella{}, {1.0}, P));
      expect(LoadedContact(WatersGuduru{}, {2.0}, P));
    }
}

EquilibriumStatus brittle(double P, double T) { return LoadedContact(PapangeloCiavarella{}, {1.0}, P).at(T).status; }

TEST(SavkoorBriggs, DoesNotExistBeyondTheCircle) {
  EXPECT_EQ(brittle(-4.72, 0), EquilibriumStatus::no_equilibrium);
  for (const double P : {-4.0, 0.0, 30.4}) {
    const double S0 = circle_radius(P);
    EXPECT_EQ(brittle(P, S0), EquilibriumStatus::ok) << P;
    EXPECT_EQ(brittle(P, S0 * (1 + 1e-15)), EquilibriumStatus::no_equilibrium) << P;
  }
}

TEST(SavkoorBriggs, RefusesWhatIsNoLoad) {
  const double nan = std::nan("");
  EXPECT_EQ(brittle(nan, 0), EquilibriumStatus::invalid);
  EXPECT_EQ(brittle(0, nan), EquilibriumStatus::invalid);
  EXPECT_EQ(brittle(0, -1e10), EquilibriumStatus::invalid);
}

}  // namespace limits_test
}  // namespace mixity
