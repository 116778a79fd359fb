// The law in the plane of the two energies: nearest points against a dense walk along it, derivatives against
// differences.
#include "mechanics/energy_plane.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mechanics/contact_model.h"
#include "mechanics/laws/known_laws.h"
#include "mechanics/model_types.h"

namespace mixity {
namespace energy_plane_test {

template <class Model>
std::vector<Parameters<Model>> cases() {
  if constexpr (parameter_count<Model> == 2)
    return {{1.774, 2.284}, {0.7, 1.5}, {1.9, 1.2}, {3, 0.6}};
  else
    return {{0.0023}, {0.15}, {0.8}};
}

struct Point {
  double G_I, G_II;
};

/// Of the printed law: G_c = f(psi), G_I = G_c cos^2 psi.
template <class Model>
Point on_law(const Parameters<Model>& p, double psi) {
  const Mixity<double> mixity = mixity_from_angle(psi);
  const double Gc = std::exp(Model::log_toughness(p, mixity).value);
  return {Gc * mixity.cos * mixity.cos, Gc * mixity.sin * mixity.sin};
}

template <class Model>
class EnergyPlane : public ::testing::Test {};
TYPED_TEST_SUITE(EnergyPlane, ModelTypes);

/// bk with r > 1 and eta < 1 leaves the axis of mode I upwards, with an infinite slope: a point of mode I that reads a
/// little more than G_Ic lies beside that stretch.
TEST(EnergyPlaneOfBk, PointsAboveGIcAreNearTheStretchThatRisesFromIt) {
  const Parameters<BenzeggaghKenane> p{3, 0.6};
  const EnergyCurve law(BenzeggaghKenane{}, p);
  for (const Point& measured : {Point{1.002, 0.001}, Point{1.02, 0}, Point{1.00552, 0.002205}}) {
    double least = 1e300;
    for (int i = 0; i <= 400000; ++i) {
      const double B = std::pow(10.0, -10 + 9.0 * i / 400000), f = 1 + 2 * std::pow(B, 0.6);
      least = std::min(least, std::hypot(f * (1 - B) - measured.G_I, f * B - measured.G_II) / 0.01);
    }
    // the walk's steps of 5e-5 of B leave their square over the distance
    EXPECT_NEAR(std::abs(law.distance(measured.G_I, measured.G_II, 0.01, 0.01, 1).value), least, 1e-5);
  }
}

/// A law that leaves the axis of mode I with an infinite slope may be far from it at a mode ratio of 1e-12 already: the
/// points beyond such a corner are nearest to the corner itself, (1, 0), which no parameter of the law moves.
TEST(EnergyPlaneOfBk, PointsBeyondACornerAreNearestToItsTip) {
  for (const Parameters<BenzeggaghKenane>& p : {Parameters<BenzeggaghKenane>{0.5, 0.1}, {0.7, 0.02}}) {
    const EnergyCurve law(BenzeggaghKenane{}, p);
    for (const Point& measured : {Point{1.1, 0.0005}, Point{1.02, 1e-5}, Point{1.3, 0}}) {
      const auto r = law.distance(measured.G_I, measured.G_II, 0.02, 0.001, 1);
      const double off_I = (measured.G_I - 1) / 0.02, off_II = measured.G_II / 0.001;
      EXPECT_DOUBLE_EQ(r.value, -std::hypot(off_I, off_II)) << p[1] << ' ' << measured.G_I;
      EXPECT_EQ(r.parameters[0], 0);
      EXPECT_EQ(r.parameters[1], 0);
      EXPECT_NEAR(r.log_toughness, off_I / -r.value / 0.02, 1e-12 * r.log_toughness);  // the corner moves with G_Ic
    }
  }
}

/// The power law with exponents below 1 touches both axes along them: (G_I/G_Ic)^m + (G_II/(r G_Ic))^n = 1.
TEST(EnergyPlaneOfPowers, PointsBeyondEitherEndAreNearestToIt) {
  LawError error;
  ASSERT_TRUE(define_law(
      {"hollow", "K_I^(2*m) + (K_II^2/r)^n = 1", {{"r", 0.05, 1000, 2}, {"m", 0.2, 5, 1}, {"n", 0.2, 5, 1}}}, error))
      << error.message;
  const ContactModel model = *ContactModel::find("hollow");
  const auto distance = [&](const std::vector<double>& p, const Point& measured) {
    const std::vector<double> G_I{measured.G_I}, G_II{measured.G_II}, sigma_I{0.02}, sigma_II{0.02}, G_Ic{1};
    std::vector<double> value(1), log_toughness(1);
    model.energy_distances(p, {G_I, G_II, sigma_I, sigma_II, G_Ic}, {value, log_toughness, {}});
    return value[0];
  };
  for (const double r : {1.5, 1000.0})
    for (const double m : {0.2, 0.26, 0.9}) {
      const double away = -std::hypot(0.1, 0.0005) / 0.02;
      EXPECT_NEAR(distance({r, m, 0.2}, {1.1, 0.0005}), away, 1e-13) << r << ' ' << m;  // roundings of 1.1 over 0.02
      // cosines below 1e-20 are that: where m is 0.2, G_II at the end is 3e-7 below r
      EXPECT_NEAR(distance({r, 0.2, m}, {0.0005, r + 0.1}), away, 3e-7 * r / 0.02) << r << ' ' << m;
    }
}

TYPED_TEST(EnergyPlane, NearestPointIsThatOfADenseWalkAlongTheLaw) {
  const double sigma_I = 0.03, sigma_II = 0.05;
  for (const Parameters<TypeParam>& p : cases<TypeParam>()) {
    const EnergyCurve law(TypeParam{}, p);
    for (const double psi : {0.4, 0.6, 0.9, 1.2})
      for (const double off : {-0.08, 0.0, 0.05}) {
        const Point q = on_law<TypeParam>(p, psi);
        const Point measured{q.G_I + off, q.G_II + 0.7 * off};
        double least = 1e300;
        for (int i = 0; i <= 200000; ++i) {
          const Point at = on_law<TypeParam>(p, 1.4 * i / 200000);
          least = std::min(least, std::hypot((at.G_I - measured.G_I) / sigma_I, (at.G_II - measured.G_II) / sigma_II));
        }
        const double found = law.distance(measured.G_I, measured.G_II, sigma_I, sigma_II, 1).value;
        // the walk's steps, of up to 1e-4 in energies of 10, leave their square over the distance in standard errors,
        // or themselves where that is 0
        EXPECT_NEAR(std::abs(found), least, off == 0 ? 4e-3 : 1e-5) << p[0] << ' ' << psi << ' ' << off;
        // positive where the law's energies are the larger
        if (off != 0) {
          EXPECT_EQ(found > 0, off < 0) << p[0] << ' ' << psi;
        }
      }
  }
}

TYPED_TEST(EnergyPlane, DerivativesMatchDifferences) {
  for (const Parameters<TypeParam>& p : cases<TypeParam>())
    for (const double psi : {0.3, 0.8, 1.2}) {
      const Point q = on_law<TypeParam>(p, psi);
      const auto r = [&](const Parameters<TypeParam>& at, double log_toughness) {
        return EnergyCurve(TypeParam{}, at)
            .distance(q.G_I + 0.02, q.G_II - 0.03, 0.03, 0.05, 1.3 * std::exp(log_toughness));
      };
      const auto here = r(p, 0);
      const double h = 1e-5;  // errors h^2 and eps/h of values up to some tens
      EXPECT_NEAR(here.log_toughness, (r(p, h).value - r(p, -h).value) / (2 * h), 1e-7 * std::abs(here.log_toughness));
      for (std::size_t k = 0; k < p.size(); ++k) {
        Parameters<TypeParam> low = p, high = p;
        low[k] -= h * p[k];
        high[k] += h * p[k];
        const double slope = (r(high, 0).value - r(low, 0).value) / (2 * h * p[k]);
        EXPECT_NEAR(here.parameters[k], slope, 1e-7 * std::abs(slope) + 1e-8) << p[0] << ' ' << psi << ' ' << k;
      }
    }
}

/// Model c is the line G_I = 1 - lambda G_II, also where noise puts G_II below zero.
TEST(EnergyPlane, OfModelCIsAStraightLineOnBothSidesOfModeI) {
  const double lambda = 0.4, sigma_I = 0.1, sigma_II = 0.3;
  const EnergyCurve law(PapangeloCiavarella{}, {lambda});
  const double size = std::hypot(sigma_I, lambda * sigma_II);
  for (const double G_II : {-0.05, 0.0, 0.02, 0.5, 1.5}) {
    const double G_I = 0.9;
    const auto r = law.distance(G_I, G_II, sigma_I, sigma_II, 1);
    const double excess = 1 - lambda * G_II - G_I;
    EXPECT_NEAR(r.value, excess / size, 1e-13) << G_II;  // roundings of numbers near 1 over an error of 0.1
    // of excess/size: -G_II/size - excess lambda sigma_II^2/size^3
    const double slope = -G_II / size - excess * lambda * sigma_II * sigma_II / (size * size * size);
    EXPECT_NEAR(r.parameters[0], slope, 1e-11) << G_II;
    EXPECT_NEAR(r.log_toughness, 1 / size, 1e-11) << G_II;
  }
}

}  // namespace energy_plane_test
}  // namespace mixity
