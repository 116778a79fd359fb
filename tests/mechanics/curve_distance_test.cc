// Distances from the equilibrium curve against brute force in 50 digits, and against themselves.
#include "mechanics/curve_distance.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "mechanics/equilibrium.h"
#include "mechanics/model_types.h"
#include "mechanics/sampling.h"
#include "mechanics/true_distance.h"

namespace mixity {
namespace curve_distance_test {

using Point = truth::Measured<double>;

/// Points and their results in the layout of curve_distances.
template <class Model>
struct Answer {
  static constexpr std::size_t kParameters = parameter_count<Model>;
  std::vector<double> P, T, A, sigma_T, sigma_A, r, dP, dT, dA, parameters;
  bool ok;

  Answer(const Parameters<Model>& p, const std::vector<Point>& points, Search search = Search::global,
         bool derivatives = true)
      : r(points.size()) {
    for (const Point& m : points) {
      P.push_back(m.P);
      T.push_back(m.T);
      A.push_back(m.A);
      sigma_T.push_back(m.sigma_T);
      sigma_A.push_back(m.sigma_A);
    }
    if (derivatives) {
      for (std::vector<double>* out : {&dP, &dT, &dA}) out->resize(points.size());
      parameters.resize(points.size() * kParameters);
    }
    CurveDistances out{r, dP, dT, dA, parameters};
    ok = curve_distances(Model{}, p, {P, T, A, sigma_T, sigma_A}, search, derivatives, out);
  }
};

template <class Model>
std::vector<Parameters<Model>> cases() {
  if constexpr (parameter_count<Model> == 2) {
    return {{1.774, 2.284}, {0.7, 1.5}, {0.2, 3}, {0.5, 0.5}, {1, 2}};
  } else {
    const double most = Model::parameters[0].upper;
    return {{1e-9 * most}, {0.0023 * most}, {0.15 * most}, {0.6 * most}, {0.95 * most}, {(1 - 1e-9) * most}, {most}};
  }
}

/// Pull-off is at -4.71.
constexpr double kLoads[] = {-4.71, -4.0, -1.0, -0.01, 1e-6, 0.5, 7.0, 30.0, 1e4};

/// Points on, near and far from the curve of one load, before and beyond its fold, with equal and unequal errors.
template <class Model>
std::vector<Point> points_about(const Parameters<Model>& p, double P, std::mt19937_64& random, int n) {
  std::uniform_real_distribution<double> uniform;
  std::normal_distribution<double> normal;
  const EquilibriumCurve curve(Model{}, p, P);
  const double T_scale = std::min(shear_scale(curve), 1e7 * circle_radius(P)),
               A_scale = area_from_radius(jkr_radius(P));
  const std::vector<PhiRange> ranges = drawable_ranges(curve, 3 * T_scale);
  const std::vector<CurvePoint> places = sample_uniform(curve, {ranges.front()}, 200);
  std::vector<Point> points;
  for (int i = 0; i < n; ++i) {
    const CurvePoint& on = places[static_cast<std::size_t>(200 * uniform(random))];
    const bool usual = i % 2 == 0;
    const auto error = [&] { return usual ? 0.003 + 0.02 * uniform(random) : std::pow(10, -4 * uniform(random)); };
    Point m{P, on.T, on.A, error() * T_scale, error() * A_scale};
    constexpr double kOff[] = {0, 1e-6, 1e-2, 1, 2, 5, 50};
    const double off = kOff[i % 7];
    m.T = i % 11 == 0 ? 0 : std::abs(m.T + off * m.sigma_T * normal(random));
    m.A += off * m.sigma_A * normal(random);
    if (i % 5 == 4) {
      m.T = 2 * uniform(random) * T_scale;
      m.A = 1.5 * uniform(random) * A_scale;
    }
    if (m.A > 0.01 * A_scale) points.push_back(m);
  }
  return points;
}

/// The curve that starts from JKR is all of it, unless T runs to infinity at a load below 0.
template <class Model>
bool one_piece(const Parameters<Model>& p, double P) {
  return EquilibriumCurve(Model{}, p, P).pieces().front().end != CurveEnd::asymptote;
}

template <class Model>
class CurveDistance : public ::testing::Test {};
TYPED_TEST_SUITE(CurveDistance, ModelTypes);

TYPED_TEST(CurveDistance, IsTheLeastInFiftyDigits) {
  std::mt19937_64 random(11);
  for (const Parameters<TypeParam>& p : cases<TypeParam>())
    for (const double P : kLoads) {
      const truth::Curve<parameter_count<TypeParam>> curve(TypeParam::info.key, p, P, !one_piece<TypeParam>(p, P));
      const std::vector<Point> points = points_about<TypeParam>(p, P, random, 6);
      const Answer<TypeParam> run(p, points, Search::global, false);
      ASSERT_TRUE(run.ok) << TypeParam::info.key << ' ' << p[0] << ' ' << P;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const Point& m = points[i];
        const double d = static_cast<double>(curve.distance(m));
        // Some roundings of what was measured, in standard errors; those of a place reach r through its square.
        EXPECT_NEAR(std::abs(run.r[i]), d, 1e-12 * d + 1e-13 * (m.T / m.sigma_T + m.A / m.sigma_A))
            << TypeParam::info.key << ' ' << p[0] << ' ' << p.back() << " P=" << P << " T=" << m.T << " A=" << m.A
            << " errors " << m.sigma_T << ' ' << m.sigma_A;
      }
    }
}

TYPED_TEST(CurveDistance, HasTheDerivativesOfDifferencesInFiftyDigits) {
  using truth::Digits50;
  std::mt19937_64 random(12);
  std::size_t compared = 0;
  for (const Parameters<TypeParam>& p : cases<TypeParam>()) {
    if (p[0] == TypeParam::parameters[0].upper) continue;  // differences would leave the range
    for (const double P : {-3.0, 0.5, 30.0}) {
      const truth::Curve<parameter_count<TypeParam>> curve(TypeParam::info.key, p, P, !one_piece<TypeParam>(p, P));
      const std::vector<Point> points = points_about<TypeParam>(p, P, random, 6);
      const Answer<TypeParam> run(p, points);
      ASSERT_TRUE(run.ok);
      for (std::size_t i = 0; i < points.size(); ++i) {
        const Point& m = points[i];
        const double d = std::abs(run.r[i]), sign = run.r[i] < 0 ? -1 : 1;
        if (!(d > 1e-3 && d < 20)) continue;  // |r| has a corner at 0
        const auto stretch = curve.nearest(m);
        const auto expect = [&](double found, auto change, double scale, const char* name) {
          const Digits50 h = Digits50(scale) * 1e-9 / std::max(1.0, std::abs(found * scale));
          auto low = curve.exact(m), high = low;
          Digits50 p_low[2] = {p[0], p.back()}, p_high[2] = {p[0], p.back()};
          change(low, p_low, Digits50(-h));
          change(high, p_high, h);
          const double truth =
              sign * static_cast<double>(Digits50((curve.distance(stretch, high, p_high[0], p_high[1], 20) -
                                                   curve.distance(stretch, low, p_low[0], p_low[1], 20)) /
                                                  (2 * h)));
          // A rounding of T or A moves the place, and turns the normal by as much or less. The place is settled when a
          // step is below 1e-8 of it; what that leaves, its square, is seen in standard errors.
          const double fine = m.T / m.sigma_T + m.A / m.sigma_A;
          EXPECT_NEAR(found * scale, truth * scale,
                      (1e-9 + 1e-15 * fine) * std::abs(truth * scale) + 1e-9 + 1e-13 * fine)
              << TypeParam::info.key << ' ' << p[0] << ' ' << p.back() << " P=" << P << " T=" << m.T << " A=" << m.A
              << " errors " << m.sigma_T << ' ' << m.sigma_A << " r " << run.r[i] << " in " << name;
          ++compared;
        };
        expect(
            run.dP[i], [](auto& x, Digits50*, const Digits50& h) { x.P += h; }, m.sigma_A / m.A, "P");
        if (m.T > 0)
          expect(
              run.dT[i], [](auto& x, Digits50*, const Digits50& h) { x.T += h; }, m.sigma_T, "T");
        expect(
            run.dA[i], [](auto& x, Digits50*, const Digits50& h) { x.A += h; }, m.sigma_A, "A");
        for (std::size_t k = 0; k < p.size(); ++k)
          expect(
              run.parameters[i * p.size() + k], [k](auto&, Digits50* q, const Digits50& h) { q[k] += h; },
              std::min(p[k], TypeParam::parameters[k].upper - p[k]) * 1e-2, "a parameter");
      }
    }
  }
  EXPECT_GT(compared, 100u);
}

TYPED_TEST(CurveDistance, DoesNotDependOnTheOtherPoints) {
  std::mt19937_64 random(13);
  for (const Parameters<TypeParam>& p : cases<TypeParam>()) {
    std::vector<Point> points;
    for (const double P : {-3.0, 0.5, 0.5, 30.0})
      for (const Point& m : points_about<TypeParam>(p, P, random, 11)) points.push_back(m);
    for (const Search search : {Search::local, Search::global}) {
      const Answer<TypeParam> together(p, points, search);
      for (std::size_t i = 0; i < points.size(); ++i) {
        const Answer<TypeParam> alone(p, {points[i]}, search), value(p, {points[i]}, search, false);
        EXPECT_EQ(alone.r[0], together.r[i]);
        EXPECT_EQ(value.r[0], together.r[i]);
        EXPECT_EQ(alone.dP[0], together.dP[i]);
        EXPECT_EQ(alone.dT[0], together.dT[i]);
        EXPECT_EQ(alone.dA[0], together.dA[i]);
        EXPECT_EQ(alone.parameters[0], together.parameters[i * p.size()]);
      }
    }
  }
}

TYPED_TEST(CurveDistance, IsNeverLessWhereOnlyOnePlaceIsSought) {
  std::mt19937_64 random(14);
  for (const Parameters<TypeParam>& p : cases<TypeParam>())
    for (const double P : kLoads) {
      const std::vector<Point> points = points_about<TypeParam>(p, P, random, 50);
      const Answer<TypeParam> local(p, points, Search::local), global(p, points);
      ASSERT_TRUE(local.ok && global.ok);
      for (std::size_t i = 0; i < points.size(); ++i)
        // The same place may be reached from either side.
        EXPECT_GE(std::abs(local.r[i]),
                  std::abs(global.r[i]) * (1 - 1e-12) -
                      1e-13 * (points[i].T / points[i].sigma_T + points[i].A / points[i].sigma_A));
    }
}

TYPED_TEST(CurveDistance, IsEvenInT) {
  std::mt19937_64 random(15);
  for (const Parameters<TypeParam>& p : cases<TypeParam>()) {
    std::vector<Point> points = points_about<TypeParam>(p, 2, random, 20);
    const Answer<TypeParam> run(p, points);
    for (Point& m : points) m.T = -m.T;
    const Answer<TypeParam> mirrored(p, points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_EQ(mirrored.r[i], run.r[i]);
      EXPECT_EQ(mirrored.dT[i], -run.dT[i]);
      EXPECT_EQ(mirrored.dA[i], run.dA[i]);
    }
  }
}

TEST(CurveDistanceWhereShearDoesNotAct, IsThatFromJkr) {
  const double jkr = area_from_radius(jkr_radius(2.0));
  const auto expect = [&](auto model) {
    const Answer<decltype(model)> run({0.0}, {{2, 300, jkr + 3, 0.1, 1.5}, {2, 4, 0.1 * jkr, 0.1, 1.5}});
    ASSERT_TRUE(run.ok);
    EXPECT_NEAR(run.r[0], -2, 1e-14);
    EXPECT_NEAR(run.r[1], 0.6 * jkr, 1e-14 * jkr);
    EXPECT_NEAR(run.dA[0], -1 / 1.5, 1e-15);
    EXPECT_EQ(run.dT[0], 0);
    EXPECT_LT(run.parameters[0], 0);  // it would take from the area
  };
  expect(Johnson{});
  expect(WatersGuduru{});
  expect(PapangeloCiavarella{});
}

TEST(CurveDistanceSign, IsThatOfTheAreaOfTheModelLessTheMeasured) {
  const LoadedContact contact(WatersGuduru{}, {0.3}, 2);
  const double T = 10, A = area_from_radius(radius_from_edge_load(contact.at(T).y, 2.0));
  const Answer<WatersGuduru> run({0.3}, {{2, T, 0.99 * A, 0.1, 0.1}, {2, T, 1.01 * A, 0.1, 0.1}});
  ASSERT_TRUE(run.ok);
  EXPECT_GT(run.r[0], 0);
  EXPECT_LT(run.r[1], 0);
}

TEST(CurveDistanceWithoutACurve, IsRefused) {
  const auto ok = [](const Parameters<PapangeloCiavarella>& p, const Point& m) {
    return Answer<PapangeloCiavarella>(p, {{1, 2, 3, 1, 1}, m}).ok;
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(ok({0.2}, {1, 2, 3, 1, 1}));
  EXPECT_FALSE(ok({0.2}, {-4.8, 2, 3, 1, 1}));  // below pull-off
  EXPECT_FALSE(ok({1.1}, {1, 2, 3, 1, 1}));
  EXPECT_FALSE(ok({nan}, {1, 2, 3, 1, 1}));
  for (const double bad : {nan, infinity, -infinity}) {
    EXPECT_FALSE(ok({0.2}, {bad, 2, 3, 1, 1}));
    EXPECT_FALSE(ok({0.2}, {1, bad, 3, 1, 1}));
    EXPECT_FALSE(ok({0.2}, {1, 2, bad, 1, 1}));
    EXPECT_FALSE(ok({0.2}, {1, 2, 3, bad, 1}));
    EXPECT_FALSE(ok({0.2}, {1, 2, 3, 1, bad}));
  }
  EXPECT_FALSE(ok({0.2}, {1, 2, 0, 1, 1}));
  EXPECT_FALSE(ok({0.2}, {1, 2, 3, 0, 1}));
  EXPECT_FALSE(ok({0.2}, {0, 0, 1e-3, 1e-30, 1}));  // the contact that vanishes
  // Model a's curve ends at an asymptote instead.
  EXPECT_TRUE(Answer<Johnson>({0.5}, {{0, 0, 1e-3, 1e-30, 1}}).ok);
  EXPECT_FALSE(Answer<BenzeggaghKenane>({5, 0.5}, {{1, 2, 3, 1, 1}}).ok);  // no unique equilibrium
}

/// Above the corner that bk has at T = 0 with a small eta, F is so steep in T that F/|grad F| is next to nothing off
/// the curve; the nearest place of a point there is the corner.
TEST(CurveDistanceAtACorner, APointAboveTheCornerOfASmallExponentIsAsFarAsTheCorner) {
  const double P = 14.5, sigma_T = 0.4, sigma_A = 0.9, corner = area_from_radius(jkr_radius(P));
  for (const double T : {-0.02, 0.0, 1e-3, 0.05}) {
    const double A = corner + 1.3 * sigma_A;
    std::array<double, 1> r{}, dP{}, dT{}, dA{};
    std::array<double, 2> parameters{};
    CurveDistances out{r, dP, dT, dA, parameters};
    ASSERT_TRUE(curve_distances(BenzeggaghKenane{}, {0.968, 0.01},
                                {{&P, 1}, {&T, 1}, {&A, 1}, {&sigma_T, 1}, {&sigma_A, 1}}, Search::global, true, out));
    EXPECT_NEAR(r[0], -std::hypot(T / sigma_T, 1.3), 1e-12) << T;  // roundings of the corner's area over its error
  }
}

}  // namespace curve_distance_test
}  // namespace mixity
