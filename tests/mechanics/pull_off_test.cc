// Pull-off loads of sheared contacts against a minimisation of the printed equation in 60 digits (mpmath: golden
// section over the edge load; at a held displacement the radius is a root of the printed equation at each phase angle).
#include "mechanics/pull_off.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "mechanics/contact_model.h"
#include "mechanics/laws/known_laws.h"

namespace mixity {
namespace pull_off_test {

constexpr double kPi = 3.14159265358979323846;
constexpr HeldShear kLoad = HeldShear::load, kDisplacement = HeldShear::displacement;

PullOff pull_off_of(std::string_view key, const std::vector<double>& p, HeldShear held, double shear) {
  PullOff at;
  ContactModel::find(key)->pull_off(p, held, {&shear, 1}, {&at, 1}, {});
  return at;
}

struct Reference {
  const char* key;
  std::vector<double> p;
  HeldShear held;
  double shear, P;
};
const std::vector<Reference> kReferences{
    {"a", {0.15}, kLoad, 0.001, -4.7123889724269427792},
    {"a", {0.15}, kLoad, 3, -4.6464540872651563377},
    {"a", {0.15}, kLoad, 40, -4.0333327553881630036},
    {"a", {0.15}, kLoad, 1000, -4.0055759960775533898},
    {"a", {0.15}, kDisplacement, 0.001, -4.7123889475598570411},
    {"a", {0.15}, kDisplacement, 2, -4.5988103640109617666},
    {"a", {0.15}, kDisplacement, 15, -4.0569729055663753516},
    {"a", {0.9}, kLoad, 3, -4.2869847930630860108},
    {"a", {0.9}, kLoad, 40, -0.47362814062247108106},
    {"a", {0.9}, kLoad, 1000, -0.47124266538809296431},
    {"a", {0.9}, kDisplacement, 2, -3.9109152162157552937},
    {"a", {0.9}, kDisplacement, 15, -0.49114789584473008111},
    {"a", {0.99}, kLoad, 40, -0.04714983239661931132},
    {"a", {0.99}, kDisplacement, 15, -0.04811502623127951366},
    {"b", {0.15}, kLoad, 0.001, -4.712388972725358246},
    {"b", {0.15}, kLoad, 3, -4.6453381800218921832},
    {"b", {0.15}, kLoad, 40, -0.45499051914128018241},
    {"b", {0.15}, kDisplacement, 2, -4.5915369137180941217},
    {"b", {0.15}, kDisplacement, 15, -1.8215432390018734918},
    {"b", {1.2}, kLoad, 3, -4.3133857171491175568},
    {"b", {1.2}, kLoad, 40, 55.274331142914032714},
    {"b", {1.2}, kDisplacement, 2, -3.9574526709078339976},
    {"c", {0.004}, kLoad, 0.001, -4.7123889801724832669},
    {"c", {0.004}, kLoad, 40, -4.3728584351219798081},
    {"c", {0.004}, kLoad, 1000, 207.49420180880909117},
    {"c", {0.004}, kDisplacement, 15, -4.5135626074968246407},
    {"c", {0.5}, kLoad, 3, -4.473656565746846854},
    {"c", {0.5}, kLoad, 1000, 26521.111459668837938},
    {"c", {0.5}, kDisplacement, 2, -4.2651412677759487411},
    {"c", {0.5}, kDisplacement, 15, 670.33494631835135572},
    {"bk", {0.5, 1.5}, kLoad, 3, -4.1617414049756209141},
    {"bk", {0.5, 1.5}, kLoad, 1000, 102197.08503473363626},
    {"bk", {0.5, 1.5}, kDisplacement, 2, -3.5689200854093942067},
    {"bk", {0.5, 1.5}, kDisplacement, 15, 38635.595041383506081},
    {"bk", {2, 2}, kLoad, 40, 37.787935284417146317},
    {"bk", {2, 2}, kDisplacement, 2, -3.9653515449344583979},
    {"bk", {2, 2}, kDisplacement, 15, 670.3350996858893391},
};

TEST(PullOff, LoadsAreThoseOfTheMinimisedPrintedEquation) {
  for (const Reference& one : kReferences) {
    const PullOff at = pull_off_of(one.key, one.p, one.held, one.shear);
    // P is a difference of terms as large as y
    EXPECT_NEAR(at.P, one.P, 4e-15 * (std::abs(one.P) + 2 * at.y)) << one.key << ' ' << one.p[0] << ' ' << one.shear;
    EXPECT_FALSE(at.smooth);
  }
}

TEST(PullOff, WithoutShearIsThatOfJkr) {
  for (const HeldShear held : {kLoad, kDisplacement})
    for (const auto& [key, p] :
         {std::pair<const char*, std::vector<double>>{"a", {0.3}}, {"b", {0.3}}, {"bk", {2, 2}}}) {
      const PullOff at = pull_off_of(key, p, held, 0);
      EXPECT_DOUBLE_EQ(at.P, -1.5 * kPi);
      EXPECT_DOUBLE_EQ(at.y, 3 * kPi);
      EXPECT_EQ(at.slope, 0);
      // tiny shears go there
      EXPECT_NEAR(pull_off_of(key, p, held, 1e-12).P, -1.5 * kPi, 1e-13);
    }
}

/// f = 1 along the whole curve without coupling: shear does not act.
TEST(PullOff, WithoutCouplingShearDoesNotAct) {
  for (const double shear : {1e-6, 1.0, 1e4}) {
    EXPECT_NEAR(pull_off_of("c", {0}, kLoad, shear).P, -1.5 * kPi, 1e-13);
    EXPECT_NEAR(pull_off_of("a", {0}, kDisplacement, shear).P, -1.5 * kPi, 1e-13);
  }
}

TEST(PullOff, OfModelCIsAParabola) {
  for (const double lambda : {1e-6, 0.003, 0.4, 1.0})
    for (const double T : {1e-3, 1.0, 77.0, 1e6}) {
      const PullOff at = pull_off_of("c", {lambda}, kLoad, T);
      EXPECT_NEAR(at.P, -1.5 * kPi + lambda * T * T / (6 * kPi), 1e-14 * (10 + lambda * T * T));
      EXPECT_NEAR(at.y, 3 * kPi, 1e-12);
      EXPECT_NEAR(at.slope, lambda * T / (3 * kPi), 1e-14 * lambda * T);
    }
}

/// As lambda T^2 = m T^2 -> infinity, y of model a goes to m (3 pi + sqrt(9 pi^2 + 6 pi P/m)), which exists from P = -3
/// pi m/2 on.
TEST(PullOff, OfModelAHasALimitAtLargeShear) {
  for (const double lambda : {0.1, 0.5, 0.95})
    EXPECT_NEAR(pull_off_of("a", {lambda}, kLoad, 1e6).P, -1.5 * kPi * (1 - lambda), 1e-9);
}

/// Model b reaches Hertz at T_H = sqrt(6 pi P)/sin(pi lambda/4), and beyond some shear does so without a jump.
TEST(PullOff, OfModelBAtLargeShearIsTheLoadOfHertz) {
  for (const double lambda : {0.15, 1.2}) {
    const double sine = std::sin(kPi * lambda / 4), T = 1000;
    const PullOff at = pull_off_of("b", {lambda}, kLoad, T);
    EXPECT_TRUE(at.smooth);
    EXPECT_NEAR(at.P, T * T * sine * sine / (6 * kPi), 1e-13 * at.P);
    EXPECT_NEAR(at.slope, 2 * at.P / T, 1e-13 * at.slope);
  }
  const PullOff at = pull_off_of("b", {1.2}, kDisplacement, 15);
  EXPECT_TRUE(at.smooth);
  EXPECT_NEAR(at.T, 4.0 / 3 * 15 * at.a, 1e-13 * at.T);
  EXPECT_NEAR(at.P, 4.0 / 3 * at.a * at.a * at.a, 1e-13 * at.P);
}

/// Closely above it there is a contact at this T, closely below there is none.
TEST(PullOff, IsTheLimitOfContact) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (const char* key : {"a", "b", "c"})
    for (int i = 0; i < 200; ++i) {
      const ContactModel model = *ContactModel::find(key);
      const std::vector<double> p{model.parameters()[0].upper * std::pow(10, -4 * uniform(random))};
      const double T = std::pow(10, -1 + 3 * uniform(random));
      const PullOff at = pull_off_of(key, p, kLoad, T);
      if (at.smooth || at.P > 0) continue;  // where Hertz remains
      const double share = 1e-6 * (1 + std::abs(at.P));
      EXPECT_EQ(model.equilibria(p, at.P - share, {&T, 1}).at[0].status, EquilibriumStatus::no_equilibrium)
          << key << ' ' << p[0] << ' ' << T << ' ' << at.P;
      const auto above = model.at_constant_shear(p, T, std::vector<double>{at.y});
      EXPECT_NEAR(above[0].P, at.P, 1e-12 * (10 + std::abs(at.P)));
      EXPECT_NEAR(above[0].dP_dy, 0, 1e-9);  // d2P/dy2 is 1/(3 pi), or more next to a cusp
    }
}

/// The state is on the load fold of the curve at its P (held T), or on that under displacement control (held u).
TEST(PullOff, IsAFoldOfTheCurveAtItsLoad) {
  for (const auto& [key, p] :
       {std::pair<const char*, std::vector<double>>{"a", {0.3}}, {"b", {0.3}}, {"c", {0.02}}, {"bk", {1.5, 2}}})
    for (const double shear : {1.0, 5.0, 11.0})
      for (const auto& [held, kind] :
           {std::pair{kLoad, Control::Kind::load}, {kDisplacement, Control::Kind::displacement}}) {
        const PullOff at = pull_off_of(key, p, held, shear);
        const auto folds = ContactModel::find(key)->folds(p, at.P, {kind});
        ASSERT_FALSE(folds.empty()) << key << ' ' << shear << ' ' << at.P;
        double nearest = 1;
        for (const Fold& fold : folds)
          nearest = std::min(nearest, std::abs((held == kLoad ? fold.T : fold.u) / shear - 1));
        EXPECT_LT(nearest, 1e-9) << key << ' ' << shear;  // of T and P near the end of the curve, of y sqrt(eps)
      }
}

TEST(PullOff, DerivativesAreThoseOfDifferences) {
  constexpr double kStep = 1e-5;
  for (const Reference& one : kReferences) {
    if (one.shear < 0.01) continue;
    const ContactModel model = *ContactModel::find(one.key);
    PullOff at;
    std::vector<double> gradient(one.p.size());
    model.pull_off(one.p, one.held, {&one.shear, 1}, {&at, 1}, gradient);
    const double size = std::abs(at.P) + at.y;
    const auto P_at = [&](std::size_t k, double factor) {
      std::vector<double> p = one.p;
      double shear = one.shear;
      (k < p.size() ? p[k] : shear) *= factor;
      return pull_off_of(one.key, p, one.held, shear).P;
    };
    for (std::size_t k = 0; k <= one.p.size(); ++k) {
      const double value = k < one.p.size() ? one.p[k] : one.shear,
                   difference = (P_at(k, 1 + kStep) - P_at(k, 1 - kStep)) / (2 * kStep * value),
                   expected = k < one.p.size() ? gradient[k] : at.slope;
      // third derivatives, up to 100 of the first as model a turns to its limit, times the step squared; rounding
      EXPECT_NEAR(expected, difference, 1e-7 * std::abs(expected) + 1e-10 * size / value)
          << one.key << one.p[0] << ' ' << k;
    }
  }
}

TEST(PullOff, IsNeverANumberWithoutAContact) {
  for (const double shear : {-1.0, 1e41, std::nan("")})
    EXPECT_TRUE(std::isnan(pull_off_of("c", {0.1}, kLoad, shear).P));
  EXPECT_TRUE(std::isnan(pull_off_of("c", {1.5}, kLoad, 1).P));
  EXPECT_TRUE(std::isnan(pull_off_of("bk", {2, 0.5}, kLoad, 1).P));
  EXPECT_TRUE(std::isnan(pull_off_of("c-ellipse", {0.1, 0.1, 0.5}, kLoad, 1).P));
  for (const char* key : {"a", "b", "c"})
    for (const HeldShear held : {kLoad, kDisplacement})
      for (double lambda : {0.0, 1e-300, 1e-9, 0.5, 1.0})
        for (double shear : {0.0, 1e-300, 1e-20, 1.0, 1e20, 1e40}) {
          const PullOff at = pull_off_of(key, {lambda}, held, shear);
          EXPECT_TRUE(std::isfinite(at.P) && std::isfinite(at.slope) && std::isfinite(at.a))
              << key << ' ' << lambda << ' ' << shear;
        }
}

/// Model c written as a law of one's own.
TEST(PullOff, OfATypedLawIsThatOfTheBuiltInOne) {
  LawError error;
  ASSERT_TRUE(define_law({"pulled_c", "1/(1 + (l-1)*B)", {{"l", 0, 1, 0.5}}}, error)) << error.message;
  for (const double shear : {0.1, 3.0, 50.0})
    for (const HeldShear held : {kLoad, kDisplacement})
      EXPECT_NEAR(pull_off_of("pulled_c", {0.2}, held, shear).P, pull_off_of("c", {0.2}, held, shear).P,
                  1e-12 * (10 + std::abs(pull_off_of("c", {0.2}, held, shear).P)));
}

/// The signed distance against one that is found by a fine search over the curve.
TEST(PullOffDistance, IsThatOfTheNearestPointOfTheCurve) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (const char* key : {"a", "b", "c"})
    for (int i = 0; i < 60; ++i) {
      const ContactModel model = *ContactModel::find(key);
      const std::vector<double> p{0.02 + 0.5 * uniform(random)};
      const HeldShear held = i % 2 == 0 ? kLoad : kDisplacement;
      const double true_shear = 12 * uniform(random), sigma_P = 0.05, sigma_shear = i % 3 == 0 ? 0 : 0.3;
      const double P = pull_off_of(key, p, held, true_shear).P + sigma_P * (4 * uniform(random) - 2),
                   shear = true_shear + sigma_shear * (4 * uniform(random) - 2);
      double r = 0, dP = 0, dshear = 0, normal = 0, slope = 0;
      const PullOffPoints points{{&P, 1}, {&shear, 1}, {&sigma_P, 1}, {&sigma_shear, 1}, {&held, 1}};
      ASSERT_TRUE(model.pull_off_distances(p, points, {{&r, 1}, {&dP, 1}, {&dshear, 1}, {&normal, 1}, {&slope, 1}}));
      const auto distance = [&](double x) {
        const double along = sigma_shear > 0 ? (x - std::abs(shear)) / sigma_shear : 0,
                     across = (pull_off_of(key, p, held, std::abs(x)).P - P) / sigma_P;
        return std::hypot(along, across);
      };
      double best = std::abs(shear), least = distance(best);
      for (int k = -400; k <= 400; ++k)
        if (const double x = std::abs(shear) + k * 1e-2 * sigma_shear; x >= 0 && distance(x) < least)
          least = distance(best = x);
      if (sigma_shear > 0)
        least =
            minimum_between(distance, std::max(best - 1e-2 * sigma_shear, 0.0), best + 1e-2 * sigma_shear, 50).value;
      // Brent's minimum is exact to the square root of eps, the distance to eps; rounding of the nearest point
      EXPECT_NEAR(std::abs(r), least, 1e-7) << key << ' ' << i << ' ' << shear;
      // derivatives in the measured values and the parameter
      const auto at = [&](double change_P, double change_shear, double change_p) {
        const double P2 = P + change_P, shear2 = shear + change_shear;
        double other = 0;
        EXPECT_TRUE(model.pull_off_distances({{p[0] + change_p}},
                                             {{&P2, 1}, {&shear2, 1}, {&sigma_P, 1}, {&sigma_shear, 1}, {&held, 1}},
                                             {{&other, 1}, {&dP, 1}, {&dshear, 1}, {&normal, 1}, {}}));
        return other;
      };
      const double of_P = dP, of_shear = dshear, h = 1e-5;
      EXPECT_NEAR(of_P, (at(h, 0, 0) - at(-h, 0, 0)) / (2 * h), 1e-5 * std::abs(of_P));
      EXPECT_NEAR(of_shear, (at(0, h, 0) - at(0, -h, 0)) / (2 * h), 1e-4 * std::abs(of_shear) + 1e-5);
      EXPECT_NEAR(slope, (at(0, 0, h) - at(0, 0, -h)) / (2 * h), 1e-5 * std::abs(slope) + 1e-4);
    }
}

}  // namespace pull_off_test
}  // namespace mixity
