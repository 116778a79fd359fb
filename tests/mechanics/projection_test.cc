// The nearest point of the curve against brute force: dense sampling, and golden section about the best sample.
#include "mechanics/projection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "mechanics/equilibrium.h"
#include "mechanics/model_types.h"
#include "mechanics/printed_equation.h"

namespace mixity {
namespace {

template <class Model>
std::vector<Parameters<Model>> cases() {
  if constexpr (parameter_count<Model> == 2)
    return {{1.774, 2.284}, {0.7, 1.5}};
  else
    return {{0.0023}, {0.15}, {0.9}};
}

struct Measured {
  double T, A, sigma_T, sigma_A;

  double distance(const CurvePoint& q) const { return std::hypot((q.T - T) / sigma_T, (q.A - A) / sigma_A); }
  /// Cosine of the angle between the way to q and the curve there.
  double slope(const CurvePoint& q) const {
    const double x = (q.T - T) / sigma_T, y = (q.A - A) / sigma_A, dx = q.dT / sigma_T, dy = q.dA / sigma_A;
    return (x * dx + y * dy) / (std::hypot(x, y) * std::hypot(dx, dy));
  }
};

/// One curve, its natural scales, and points about it.
template <class Model>
struct Scene {
  EquilibriumCurve<Model> curve;
  double T_scale, A_scale, T_most;
  PhiRange range;
  std::vector<CurvePoint> samples;  // up to T_most

  Scene(const Parameters<Model>& p, double P) : curve(p, P) {
    const double fold = LoadedContact<Model>(p, P).branches().front().T_bottom;
    T_scale = std::min(fold, shear_scale(curve));
    T_most = 2.5 * T_scale;
    range = drawable_ranges(curve, T_most).front();
    constexpr int kSamples = 3000;
    for (int i = 0; i <= kSamples; ++i) {
      samples.push_back(curve.point(i == kSamples ? range.to : range.from + (range.to - range.from) * i / kSamples));
      if (samples.back().T <= T_most) continue;
      samples.pop_back();
      break;
    }
    A_scale = samples.front().A;
  }

  double brute_force(const Measured& m) const {
    std::size_t best = 0;
    for (std::size_t i = 0; i < samples.size(); ++i)
      if (m.distance(samples[i]) < m.distance(samples[best])) best = i;
    double low = samples[best > 0 ? best - 1 : 0].phi, high = samples[std::min(best + 1, samples.size() - 1)].phi;
    const double golden = 0.5 * (std::sqrt(5.0) - 1);
    for (int i = 0; i < 60; ++i) {
      const double one = high - golden * (high - low), other = low + golden * (high - low);
      if (m.distance(curve.point(one)) < m.distance(curve.point(other)))
        high = other;
      else
        low = one;
    }
    return std::min(m.distance(samples[best]), m.distance(curve.point(0.5 * (low + high))));
  }

  /// T from none to beyond the fold, areas from a fifth of JKR's to beyond JKR; errors of 0.5 to 3 percent.
  std::vector<Measured> points() const {
    std::vector<Measured> list;
    for (const double T : {0.0, 0.01, 0.3, 0.7, 0.95, 1.0, 1.02, 1.3})
      for (const double A : {0.2, 0.5, 0.8, 0.97, 1.0, 1.1})
        for (const double error : {0.005, 0.03})
          list.push_back({T * T_scale, A * A_scale, error * T_scale, 0.6 * error * A_scale});
    return list;
  }
};

template <class Model>
class NearestPoint : public ::testing::Test {};
TYPED_TEST_SUITE(NearestPoint, ModelTypes);

TYPED_TEST(NearestPoint, IsAsNearAsBruteForceFindsIt) {
  for (const Parameters<TypeParam>& p : cases<TypeParam>())
    for (const double P : {-2.0, 0.5, 30.0}) {
      const Scene<TypeParam> scene(p, P);
      const Projection<TypeParam> projection(scene.curve, scene.T_most);
      for (const Measured& m : scene.points()) {
        const CurvePoint q = projection.nearest(m.T, m.A, m.sigma_T, m.sigma_A);
        // Golden section stops where the squared distance no longer changes, sqrt(eps) from the best phi.
        EXPECT_LE(m.distance(q), scene.brute_force(m) * (1 + 1e-12) + 1e-7)
            << TypeParam::info.key << p[0] << " P=" << P << " T=" << m.T << " A=" << m.A << " " << m.sigma_T;
      }
    }
}

TYPED_TEST(NearestPoint, LiesOnThePrintedCurve) {
  for (const Parameters<TypeParam>& p : cases<TypeParam>()) {
    const Scene<TypeParam> scene(p, 0.5);
    const Projection<TypeParam> projection(scene.curve, scene.T_most);
    for (const Measured& m : scene.points()) {
      const CurvePoint q = projection.nearest(m.T, m.A, m.sigma_T, m.sigma_A);
      const auto residual = truth::residual_of<TypeParam>(p, 0.5, q.y, q.T);
      // A few roundings of y and T in the terms of the equation, the largest of which are y^2 and 6 pi y.
      EXPECT_LT(std::abs(static_cast<double>(residual)),
                64 * truth::kEps * (q.y * q.y + 6 * pi<double>() * (q.y + 0.5)));
      EXPECT_LE(q.T, scene.T_most * (1 + 1e-9));  // T_most is met by bisection of phi to 2^-40 of a step
    }
  }
}

/// The way to the nearest point is at right angles to the curve, except at an end of it.
TYPED_TEST(NearestPoint, IsStationary) {
  std::size_t inside = 0;
  for (const Parameters<TypeParam>& p : cases<TypeParam>())
    for (const double P : {-2.0, 0.5, 30.0}) {
      const Scene<TypeParam> scene(p, P);
      const Projection<TypeParam> projection(scene.curve, scene.T_most);
      for (const Measured& m : scene.points()) {
        const CurvePoint q = projection.nearest(m.T, m.A, m.sigma_T, m.sigma_A);
        // On the curve itself the direction is rounding; ends need not be stationary.
        const bool end = q.phi <= scene.range.from || q.phi >= 0.999 * scene.samples.back().phi;
        if (end || m.distance(q) < 1e-4) continue;
        ++inside;
        // nearest() stops at 1e-11; phi's rounding, seen through its sensitivity to T, adds eps T/(sigma distance).
        EXPECT_LT(std::abs(m.slope(q)), 1e-10 + 1e-12 / m.distance(q))
            << TypeParam::info.key << p[0] << " P=" << P << " T=" << m.T << " A=" << m.A;
      }
    }
  EXPECT_GT(inside, 200u);
}

/// A point of the curve is its own nearest, before, at and beyond the fold.
TYPED_TEST(NearestPoint, OfAPointOnTheCurveIsThatPoint) {
  for (const Parameters<TypeParam>& p : cases<TypeParam>())
    for (const double P : {-2.0, 0.5, 30.0}) {
      const Scene<TypeParam> scene(p, P);
      const Projection<TypeParam> projection(scene.curve, scene.T_most);
      for (std::size_t i = 0; i < scene.samples.size(); i += 97) {
        const CurvePoint& on = scene.samples[i];
        const CurvePoint q = projection.nearest(on.T, on.A, 0.01 * scene.T_scale, 0.01 * scene.A_scale);
        // Rounding of T and A, in units of 1 % of the scales.
        EXPECT_NEAR(q.T, on.T, 1e-10 * scene.T_scale) << on.phi;
        EXPECT_NEAR(q.A, on.A, 1e-10 * scene.A_scale) << on.phi;
      }
    }
}

/// Errors of T far below the distances between the nodes that the search starts from, as of a force that is read to
/// 0.1 % beside an area that is read to 5 %: still the nearest branch.
TYPED_TEST(NearestPoint, IsFoundWhereTIsMuchBetterKnownThanA) {
  for (const Parameters<TypeParam>& p : cases<TypeParam>())
    for (const double P : {-2.0, 0.5, 30.0}) {
      const Scene<TypeParam> scene(p, P);
      const Projection<TypeParam> projection(scene.curve, scene.T_most);
      for (std::size_t i = 0; i < scene.samples.size() && scene.samples[i].dT > 0; i += 29)
        for (const double sigma_T : {1e-3, 1e-4, 1e-6}) {
          const CurvePoint& on = scene.samples[i];
          const Measured m{on.T, 1.03 * on.A, sigma_T * scene.T_scale, 0.05 * scene.A_scale};
          const CurvePoint q = projection.nearest(m.T, m.A, m.sigma_T, m.sigma_A);
          // the point of the same T is one candidate
          EXPECT_LE(m.distance(q), 0.03 * on.A / m.sigma_A * (1 + 1e-12) + 1e-7)
              << TypeParam::info.key << p[0] << " P=" << P << " T=" << m.T << " A=" << m.A << " " << sigma_T;
        }
    }
}

/// Far from the curve, where more than one of its points is nearest among its neighbours, with or without a fold
/// between them.
TYPED_TEST(NearestPoint, IsTheNearestOfSeveralFarFromTheCurve) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform;
  for (const Parameters<TypeParam>& p : cases<TypeParam>())
    for (const double P : {-4.0, -0.5, 0.5, 30.0}) {
      const Scene<TypeParam> scene(p, P);
      const Projection<TypeParam> projection(scene.curve, scene.T_most);
      for (int i = 0; i < 100; ++i) {
        const Measured m{2 * uniform(random) * scene.T_scale, 2 * uniform(random) * scene.A_scale, scene.T_scale,
                         std::pow(10.0, 4 * uniform(random) - 2) * scene.A_scale};
        const CurvePoint q = projection.nearest(m.T, m.A, m.sigma_T, m.sigma_A);
        EXPECT_LE(m.distance(q), scene.brute_force(m) * (1 + 1e-12) + 1e-7)
            << TypeParam::info.key << p[0] << " P=" << P << " T=" << m.T << " A=" << m.A << " " << m.sigma_A;
      }
    }
}

/// Model bk with eta < 1: T grows as phi^2, so that phi = 0 is stationary for every point and the search must not stop.
TEST(NearestPoint, IsFoundWhereTIsStationaryAtTheStart) {
  const Scene<BenzeggaghKenane> scene({0.5, 0.5}, -2);
  const Projection<BenzeggaghKenane> projection(scene.curve, scene.T_most);
  for (const double T : {0.003, 0.005, 0.011}) {
    const Measured m{T * scene.T_scale, scene.A_scale, 0.003 * scene.T_scale, 0.003 * scene.A_scale};
    const CurvePoint q = projection.nearest(m.T, m.A, m.sigma_T, m.sigma_A);
    EXPECT_LE(m.distance(q), scene.brute_force(m) * (1 + 1e-12) + 1e-7) << T;
  }
}

/// Of a point far above or far out only the direction counts: the top of the curve, or the fold.
TEST(NearestPoint, OfAPointFarOffIsTheExtremeOfTheCurve) {
  const Scene<PapangeloCiavarella> scene({0.15}, 0.5);
  const Projection<PapangeloCiavarella> projection(scene.curve, scene.T_most);
  const double T_fold = std::sqrt(3 * pi<double>() * (3 * pi<double>() + 2 * 0.5) / 0.15);
  const CurvePoint top = projection.nearest(0, 1e6 * scene.A_scale, 1, 1);
  EXPECT_NEAR(top.A, scene.A_scale, 1e-12 * scene.A_scale);  // the minimum is at phi = 0 exactly, but for rounding
  const CurvePoint out = projection.nearest(1e6 * T_fold, 0.4 * scene.A_scale, 1, 1);
  // The normal turns by A/1e6 T, so that T falls short of the fold by the square of that.
  EXPECT_NEAR(out.T, T_fold, 1e-10 * T_fold);
}

/// Towards an asymptote T grows over all bounds within a few segments; the search once crept from both sides of them.
TEST(NearestPoint, IsNoFurtherThanThePointAboveOrBelow) {
  std::mt19937_64 random(2024);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 4000; ++i) {
    const double lambda = 1 - std::pow(10, -3 * uniform(random)), P = -4 + 34 * uniform(random);
    const LoadedContact<Johnson> contact({lambda}, P);
    const double scale = circle_radius(P), T_most = scale * (2 + 40 * uniform(random)),
                 T = 0.5 * T_most * uniform(random);
    const Equilibrium at = contact.at(T);
    if (at.status != EquilibriumStatus::ok) continue;
    const double A_T = area_from_radius(radius_from_edge_load(at.y, P)), A = A_T * (0.9 + 0.2 * uniform(random));
    const double sigma_T = 0.02 * scale * 20, sigma_A = 0.02 * A;
    const CurvePoint q = Projection<Johnson>({{lambda}, P}, T_most).nearest(T, A, sigma_T, sigma_A);
    const double above = std::abs(A_T - A) / sigma_A;
    EXPECT_LE(std::hypot((q.T - T) / sigma_T, (q.A - A) / sigma_A), above * (1 + 1e-9) + 1e-7)
        << lambda << " P=" << P << " T=" << T << " A=" << A << " T_most=" << T_most;
  }
}

/// lambda = 0: shear does not act, the curve is one point.
TEST(NearestPoint, OfAnUncoupledContactIsJkr) {
  const EquilibriumCurve<PapangeloCiavarella> curve({0.0}, 2.0);
  const CurvePoint q = Projection<PapangeloCiavarella>(curve, 100).nearest(30, 5, 1, 1);
  EXPECT_EQ(q.T, 0);
  EXPECT_NEAR(q.A, area_from_radius(jkr_radius(2.0)), 1e-14 * q.A);  // two ways to the same number
}

/// With eta < 1 the curve falls along A at T = 0 before it turns along T, all within one step of phi: the nearest place
/// may lie beyond the corner.
TEST(NearestPoint, IsSeenRoundACorner) {
  for (const auto& [r, eta] : {std::pair(0.98846, 0.1268), {0.98685, 0.01}, {0.5, 0.1}, {0.7, 0.5}})
    for (const double P : {-2.0, 14.0, 26.3}) {
      const Scene<BenzeggaghKenane> scene({r, eta}, P);
      const Projection<BenzeggaghKenane> projection(scene.curve, scene.T_most);
      const double top = scene.samples.front().A;
      for (const double T : {1e-3, 0.01, 0.08, 0.3, 1.0})
        for (const double share : {0.97, 0.98, 0.99, 0.995, 1.0})
          for (const double error : {2e-4, 2e-3, 0.02}) {
            const Measured m{T, share * top, error * scene.T_scale, error * top};
            const double found = m.distance(projection.nearest(m.T, m.A, m.sigma_T, m.sigma_A));
            // the curve's T is known to some 1e-12 where it is steep in phi
            EXPECT_LE(found, scene.brute_force(m) * (1 + 1e-9) + 1e-9)
                << r << ' ' << eta << ' ' << P << " T " << T << " A " << share << " error " << error;
          }
    }
}

}  // namespace
}  // namespace mixity
