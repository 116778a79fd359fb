#include "mechanics/contact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "mechanics/measurement.h"
#include "mechanics/printed_equation.h"

namespace mixity {
namespace contact_test {

using truth::Digits50;

TEST(Contact, DimensionlessUnitsAreThoseOfMaugis) {
  // Mergel 2018: xi = (2.133e6 * 9.42e-3/0.027)^(1/3) = 90.620..., R G_Ic = 0.25434 mN
  const Contact contact{9.42e-3, 2.133e6, 27e-3};
  EXPECT_NEAR(contact.xi(), std::pow(2.133e6 * 9.42e-3 / 0.027, 1.0 / 3), 1e-13);
  EXPECT_NEAR(contact.force_unit(), 2.5434e-4, 1e-18);
  EXPECT_NEAR(contact.area_unit(), std::pow(9.42e-3 / contact.xi(), 2), 1e-22);
  // E* a^3/R^2 [N] and G R [N] measure the same load: 4/3 a^3 is dimensionless Hertz
  const double a = 3.3 * contact.length_unit();
  EXPECT_NEAR(4.0 / 3 * contact.modulus * a * a * a / contact.radius / contact.force_unit(), 4.0 / 3 * std::pow(3.3, 3),
              1e-12);
}

TEST(Contact, PlaneStrainModulusOfARubber) { EXPECT_DOUBLE_EQ(plane_strain_modulus(1.6e6, 0.5), 1.6e6 / 0.75); }

TEST(Contact, JkrAreaIsRightDownToPullOff) {
  for (const double P : {-4.71238898038469, -4.71238898038468, -4.712388980380, -4.7, -1e-12, 0.0, 1.0, 1e8}) {
    const Digits50 y = truth::jkr_edge_load(P);
    const Digits50 a = cbrt(Digits50(Digits50(3) / 4 * (y + P)));
    // a few roundings
    EXPECT_NEAR(jkr_radius(P) / static_cast<double>(a), 1, 1e-15) << P;
  }
}

TEST(Contact, PullOffIsTheLoadAtWhichTheCircleVanishes) {
  EXPECT_GT(above_pull_off(-4.71238898038469), 0);  // this double lies 1.8e-16 above -3 pi/2
  EXPECT_LT(above_pull_off(std::nextafter(-4.71238898038469, -5)), 0);
}

TEST(Contact, HertzRadiusFollowsTheLoad) { EXPECT_DOUBLE_EQ(hertz_radius(4.0 / 3 * 8), 2); }

TEST(Measurement, InvertsAJkrPoint) {
  for (const double P : {-4.0, 0.0, 3.0, 1e3}) {
    const auto measured = toughness_of_area(P, 0.0, area_from_radius(jkr_radius(P))).value();
    EXPECT_NEAR(measured.ratio, 1, 1e-13);  // y = 4/3 a^3 - P loses a digit or two
    EXPECT_EQ(measured.mixity.sin, 0);
  }
}

TEST(Measurement, DoesNotDependOnTheSignOfTheShear) {
  std::vector<double> P, T, A;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> decades(-20, 20);
  for (int i = 0; i < 10007; ++i) {
    P.push_back((i % 3 - 1) * std::pow(10, decades(random)));
    T.push_back(i % 5 == 0 ? 0 : (i % 7 == 0 ? -1 : 1) * std::pow(10, decades(random)));
    A.push_back(std::pow(10, decades(random)));
  }
  std::size_t none = 0;
  for (std::size_t i = 0; i < P.size(); ++i) {
    const auto one = toughness_of_area(P[i], T[i], A[i]);
    none += !one;
    const auto other = toughness_of_area(P[i], -T[i], A[i]);
    ASSERT_EQ(other.has_value(), one.has_value()) << P[i] << ' ' << T[i] << ' ' << A[i];
    if (other) {
      ASSERT_EQ(other->ratio, one->ratio);
      ASSERT_EQ(other->mixity.cos, one->mixity.cos);
      ASSERT_EQ(other->mixity.sin, one->mixity.sin);
    }
  }
  EXPECT_GT(none, 1000);
}

TEST(Mixity, KeepsFullAccuracyAtBothEnds) {
  const auto nearly_open = mixity_from_loads(1.0, 1e-20), nearly_shear = mixity_from_loads(1e-20, 1.0);
  EXPECT_DOUBLE_EQ(nearly_open.sin, 1e-20);
  EXPECT_DOUBLE_EQ(nearly_shear.cos, 1e-20);
  EXPECT_EQ(mixity_from_angle(0.5 * pi<double>()).cos, 0);
  EXPECT_DOUBLE_EQ(mixity_from_mode_ratio(0.25).sin, 0.5);
  EXPECT_DOUBLE_EQ(phase_angle(mixity_from_loads(1.0, 1.0)), 0.25 * pi<double>());
  EXPECT_DOUBLE_EQ(mixity_from_energies(3, 1).sin, 0.5);
  EXPECT_DOUBLE_EQ(mixity_from_energies(1e-40, 1).cos, 1e-20);
  EXPECT_DOUBLE_EQ(mixity_from_energies(1, 1e-40).sin, 1e-20);
}

TEST(Mixity, OfAnEnergyBelowZeroIsThatOfAPureMode) {
  EXPECT_EQ(mixity_from_energies(-0.1, 0.3).cos, 0);
  EXPECT_EQ(mixity_from_energies(-0.1, 0.3).sin, 1);
  EXPECT_EQ(mixity_from_energies(0.3, -0.1).cos, 1);
  EXPECT_EQ(mixity_from_energies(0.3, -0.1).sin, 0);
}

}  // namespace contact_test
}  // namespace mixity
