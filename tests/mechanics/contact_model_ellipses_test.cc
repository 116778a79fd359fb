// Semi-axes of elliptic contacts. The reference values come from the same equations in 45 digits (mpmath: Carlson's
// integrals, Newton's method from T = 0 in twelve steps); the pressure was compared with the quadrature of its
// potential.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "mechanics/contact.h"
#include "mechanics/contact_model.h"
#include "mechanics/ellipse_pressure.h"

namespace mixity {
namespace contact_model_ellipses_test {

constexpr double kAxes = 1e-12;  // relative, away from folds

ContactModel model(const char* key) { return ContactModel::find(key).value(); }

Ellipses ellipses(const char* key, double mode_II, double mode_III, double nu, double P, const std::vector<double>& T) {
  return model(key).ellipses({{&mode_II, 1}, {&mode_III, 1}, nu}, P, T);
}

constexpr Control kLoad{Control::Kind::load}, kDisplacement{Control::Kind::displacement};
Control spring(double k) { return {Control::Kind::stiffness, k}; }

std::optional<EllipseBranchEnd> end_of(const char* key, double mode_II, double mode_III, double nu, double P,
                                       Control control = kLoad) {
  return model(key).ellipse_end({{&mode_II, 1}, {&mode_III, 1}, nu}, P, control);
}

TEST(Ellipses, HaveTheAxesOfAReferenceSolution) {
  struct Case {
    const char* model;
    double P, mode_II, mode_III, nu, T, a, b;
  };
  const std::vector<Case> cases{{"c", 3, 0.008, 0, 0, 95.3202193183654, 2.5479939831433404134, 2.6075078768764035399},
                                {"c", 3, 0.3, 0.1, 0, 16.1763776314092, 2.5251740032204218702, 2.5705824268718069618},
                                {"c", -2, 0.2, 0.05, 0, 10.1121044067718, 2.1585812691941576352, 2.1803018884386622295},
                                {"c", 3, 0.3, 0.1, 0.5, 16, 2.5124351550041199468, 2.5357083673031736812},
                                {"c", 30, 0.1, 0.3, 0.25, 20, 3.630253394261424035, 3.5984419217261182524},
                                {"c", -4, 0.5, 0.9, 0, 3, 1.8286470880185659913, 1.8197713036717792039},
                                {"c", 0, 0.02, 0.15, 0.5, 1, 2.4177609388942251072, 2.4174885370139945836},
                                {"a", 3, 0.3, 0.1, 0, 16, 2.5675256263234810158, 2.5966435698416821434},
                                {"a", 10, 0.9, 0.5, 0.5, 20, 2.6218627538262779601, 2.7393181506399702536},
                                {"b", 3, 0.3, 0.1, 0, 20, 2.503378994464522507, 2.5569318327488301278},
                                {"b", -1, 1.2, 0.4, 0.5, 6, 2.2350119610423520054, 2.2421327003186556451},
                                {"b", 20, 0.15, 0.15, 0.3, 60, 3.1774684049220222473, 3.1450892896545005926}};
  for (const Case& one : cases) {
    const Ellipses found = ellipses(one.model, one.mode_II, one.mode_III, one.nu, one.P, {one.T});
    ASSERT_EQ(found.at[0].status, EquilibriumStatus::ok) << one.model << one.P;
    EXPECT_NEAR(found.at[0].a / one.a, 1, kAxes) << one.model << ' ' << one.P;
    EXPECT_NEAR(found.at[0].b / one.b, 1, kAxes) << one.model << ' ' << one.P;
  }
}

/// Against central differences of the reference solution, with a step of 1e-15 in 60 digits.
TEST(Ellipses, HaveTheDerivativesOfAReferenceSolution) {
  struct Case {
    const char* model;
    double P, mode_II, mode_III, nu, T;
    std::array<double, 5> a, b;
  };
  const std::vector<Case> cases{
      {"c",
       3,
       0.3,
       0.1,
       0.5,
       16,
       {-0.01931834937732933, 0.08158234609501568, -0.4051822055708065, -0.3299213334739272, -0.06598426669478544},
       {-0.01560707427343874, 0.07897405098049469, -0.1594714187923805, -0.7701516854979572, -0.1540303370995914}},
      {"b",
       -1,
       1.2,
       0.4,
       0.5,
       6,
       {-0.03535319633868817, 0.1221655213407265, -0.03819031382522265, -0.07040662701143593, -0.05856315568110021},
       {-0.03198954609239776, 0.1206332203664255, -0.01837881747107274, -0.141911157479455, -0.1180395306681083}},
      {"a",
       10,
       0.9,
       0.5,
       0.25,
       20,
       {-0.03961842278882756, 0.07166373385490453, -1.155479625609032, -0.2125621992520452, -0.05476135099761155},
       {-0.01878982449540816, 0.05949445438562565, -0.3342944235930711, -0.4407419845305056, -0.1135461836544142}}};
  for (const Case& one : cases) {
    const EndParameters p{{&one.mode_II, 1}, {&one.mode_III, 1}, one.nu};
    const std::vector<double> T{one.T};
    const ContactModel used = model(one.model);
    const EllipseSlopes slopes = used.ellipse_slopes(p, one.P, T, used.ellipses(p, one.P, T).at);
    ASSERT_EQ(slopes.a.size(), 5u);
    for (std::size_t k = 0; k < 5; ++k) {
      EXPECT_NEAR(slopes.a[k] / one.a[k], 1, 1e-11) << one.model << k;
      EXPECT_NEAR(slopes.b[k] / one.b[k], 1, 1e-11) << one.model << k;
    }
  }
}

TEST(Ellipses, OfEqualCouplingsAreCircles) {
  for (const char* key : {"a", "b", "c"})
    for (const double P : {-3.0, 0.0, 5.0, 200.0}) {
      const double lambda = 0.2, end = model(key).first_stable_end({&lambda, 1}, P);
      std::vector<double> T;
      for (double share = 0; share < 0.995; share += 0.05) T.push_back(share * std::min(end, 50.0));
      std::vector<double> A(T.size());
      std::vector<EquilibriumStatus> status(T.size());
      model(key).areas_at({&lambda, 1}, P, T, A, status);
      const Ellipses found = ellipses(key, lambda, lambda, 0, P, T);
      for (std::size_t i = 0; i < T.size(); ++i) {
        ASSERT_EQ(found.at[i].status, status[i]) << key << P << ' ' << T[i];
        EXPECT_NEAR(found.at[i].a / radius_from_area(A[i]), 1, kAxes) << key << P << ' ' << T[i];
        EXPECT_NEAR(found.at[i].b / found.at[i].a, 1, kAxes);
      }
    }
}

/// The coupling of mode III enters model c as lambda/(1 - nu).
TEST(Ellipses, OfModelCAreCirclesAlsoWherePoissonsRatioMakesTheCouplingsEqual) {
  const Ellipses found = ellipses("c", 0.2, 0.1, 0.5, 3, {0, 5, 10, 18});
  for (const EllipseState& one : found.at) EXPECT_NEAR(one.a / one.b, 1, kAxes);
}

TEST(Ellipses, ExchangeTheirAxesWithTheCouplings) {
  for (const char* key : {"a", "b", "c"}) {
    const Ellipses one = ellipses(key, 0.3, 0.1, 0, 3, {4, 12}), other = ellipses(key, 0.1, 0.3, 0, 3, {4, 12});
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_NEAR(one.at[i].a / other.at[i].b, 1, kAxes);
      EXPECT_NEAR(one.at[i].b / other.at[i].a, 1, kAxes);
    }
  }
}

TEST(Ellipses, AreJkrsCircleWithoutShear) {
  for (const double T : {0.0, 1e-150, 1e-9}) {
    const Ellipses found = ellipses("c", 0.3, 0.1, 0.5, 3, {T});
    EXPECT_NEAR(found.at[0].a / jkr_radius(3.0), 1, 1e-15) << T;
    EXPECT_NEAR(found.at[0].b / jkr_radius(3.0), 1, 1e-15) << T;
  }
}

/// ln(a/b) = -(lambda_II - lambda_III) T^2/(8 a^3 (y + pi)) to first order, from the criterion linearised at the circle
/// of the mean coupling.
TEST(Ellipses, OfNearlyEqualCouplingsFollowTheFirstOrder) {
  const double lambda = 0.2, T = 16, P = 3;
  std::vector<double> A(1);
  std::vector<EquilibriumStatus> status(1);
  model("c").areas_at({&lambda, 1}, P, std::vector{T}, A, status);
  const double a = radius_from_area(A[0]), y = edge_load(a, P);
  std::vector<double> off;
  for (const double apart : {1e-2, 1e-3}) {
    const Ellipses found = ellipses("c", lambda + apart / 2, lambda - apart / 2, 0, P, {T});
    const double first = -apart * T * T / (8 * a * a * a * (y + pi<double>()));
    off.push_back(std::abs(std::log(found.at[0].a / found.at[0].b) / first - 1));
  }
  EXPECT_LT(off[0], 1e-3);
  EXPECT_NEAR(off[1] / off[0], 0.01, 0.002);  // q is odd in the difference: what is left falls with its square
}

TEST(Ellipses, EndAtAFoldBeforeTheCircleOfTheMeanCoupling) {
  const double mean = 0.004, circle = model("c").first_stable_end({&mean, 1}, 3);
  const auto found = end_of("c", 0.008, 0, 0, 3);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, EllipseEnd::fold);
  EXPECT_LT(found->T, 0.9999 * circle);
  const double T = found->T;
  const Ellipses around = ellipses("c", 0.008, 0, 0, 3, {T * (1 - 1e-9), T * (1 + 1e-9)});
  EXPECT_EQ(around.at[0].status, EquilibriumStatus::ok);
  EXPECT_EQ(around.at[1].status, EquilibriumStatus::no_equilibrium);
  EXPECT_TRUE(std::isnan(around.at[1].a));
}

void is_fold(const EllipseBranchEnd& found, const Fold& fold) {
  EXPECT_NEAR(found.T / fold.T, 1, kAxes);
  EXPECT_NEAR(found.u / fold.u, 1, kAxes);
  EXPECT_NEAR(pi<double>() * found.a * found.b / fold.A, 1, kAxes);
}

/// Circles, whose folds are known in closed form; the displacement of a circle is 3/4 T/a at nu = 1/2.
TEST(Ellipses, OfEqualCouplingsHaveTheFoldsOfCircles) {
  const double lambda = 0.2;
  for (const double P : {-3.0, 0.0, 5.0, 40.0}) {
    for (const Control control : {kLoad, kDisplacement, spring(1e-3), spring(0.5), spring(20)}) {
      const auto found = end_of("c", lambda, lambda * 0.5, 0.5, P, control);
      ASSERT_TRUE(found) << P;
      EXPECT_EQ(found->kind, EllipseEnd::fold);
      is_fold(*found, model("c").folds({&lambda, 1}, P, control)[0]);
    }
  }
}

/// u of a circle is T/(2 a) at nu = 0, two thirds of that of the models of circles: so is the stiffness of the spring.
TEST(Ellipses, OfEqualCouplingsWithoutPoissonsRatioHaveTheFoldsOfCirclesThroughASpring) {
  for (const char* key : {"a", "b", "c"})
    for (const double P : {-3.0, 0.0, 5.0})
      for (const double k : {0.01, 1.0, 50.0}) {
        const double lambda = 0.6;
        const auto found = end_of(key, lambda, lambda, 0, P, spring(1.5 * k));
        const auto folds = model(key).folds({&lambda, 1}, P, spring(k));
        ASSERT_EQ(found.has_value() && found->kind == EllipseEnd::fold, !folds.empty()) << key << P << ' ' << k;
        if (folds.empty()) continue;
        Fold fold = folds[0];
        fold.u *= 2.0 / 3;
        is_fold(*found, fold);
      }
}

/// Maxima of u + T/k along the curve of states, found in 40 digits Carlson's integrals checked by quadrature.
TEST(Ellipses, HaveTheFoldsThroughASpringOfAReferenceSolution) {
  struct Case {
    const char* model;
    double P, mode_II, mode_III, nu, k, T, u, A;
  };
  const std::vector<Case> cases{
      {"c", 3, 0.3, 0.1, 0.5, 1, 23.9062611977273543, 8.69857996077526116, 13.1803796500825769},
      {"b", -1, 1.2, 0.4, 0.5, 0.5, 10.1167352346578827, 4.28552477599328858, 9.75925396688134716},
      {"c", 30, 0.1, 0.3, 0.25, 3, 46.5062292584078352, 8.54857151139689403, 31.8904733741197537},
      {"a", -1, 0.9, 0.8, 0.3, 0.3, 9.13432215077355568, 3.34027771846207961, 8.66056653715756159}};
  for (const Case& one : cases) {
    const auto found = end_of(one.model, one.mode_II, one.mode_III, one.nu, one.P, spring(one.k));
    ASSERT_TRUE(found) << one.model;
    EXPECT_EQ(found->kind, EllipseEnd::fold);
    EXPECT_NEAR(found->T / one.T, 1, kAxes) << one.model << ' ' << one.P;
    EXPECT_NEAR(found->u / one.u, 1, kAxes) << one.model << ' ' << one.P;
    EXPECT_NEAR(pi<double>() * found->a * found->b / one.A, 1, kAxes) << one.model << ' ' << one.P;
  }
}

/// The fold moves in proportion to k, and to 1/k.
TEST(Ellipses, HaveTheFoldsOfHeldLoadsAndDisplacementsAtTheEndsOfTheStiffness) {
  const auto of = [](Control control) { return *end_of("c", 0.3, 0.1, 0.5, 3, control); };
  for (const auto& [limit, stiff] : {std::pair{kLoad, 1e-14}, std::pair{kDisplacement, 1e14}}) {
    const EllipseBranchEnd at = of(limit), through = of(spring(stiff));
    EXPECT_NEAR(through.T / at.T, 1, kAxes);
    EXPECT_NEAR(through.u / at.u, 1, kAxes);
    EXPECT_NEAR(through.a / at.a, 1, kAxes);
    EXPECT_NEAR(through.b / at.b, 1, kAxes);
  }
}

/// Against the integral of the edge's distance over the angle, by the trapezoidal rule, which converges geometrically.
TEST(Ellipses, HaveTheComplianceOfTheirOutline) {
  for (const double q : {-1.0, -0.1, 0.0, 1e-6, 0.1, 1.0})
    for (const double nu : {0.0, 0.3, 0.5}) {
      const double a = std::exp(0.5 * q), b = std::exp(-0.5 * q);
      constexpr int kPoints = 400;
      double sum = 0;
      for (int i = 0; i < kPoints; ++i) {
        const double c = std::cos(2 * pi<double>() * i / kPoints), square = c * c;
        sum += (1 - nu + nu * square) / std::sqrt(square / (a * a) + (1 - square) / (b * b));
      }
      const double expected = sum / kPoints * 2 * pi<double>() / (4 * pi<double>() * (1 - nu));
      EXPECT_NEAR(ellipse_compliance(q, nu).value / expected, 1, 1e-13) << q << ' ' << nu;
      constexpr double kStep = 1e-4;  // a difference of the fourth order: 1e-12 of rounding
      const auto pair = [&](double step) {
        return (ellipse_compliance(q + step, nu).value - ellipse_compliance(q - step, nu).value) / (2 * step);
      };
      EXPECT_NEAR(ellipse_compliance(q, nu).slope, (4 * pair(kStep) - pair(2 * kStep)) / 3, 1e-11) << q << ' ' << nu;
    }
}

/// Under model b large loads reach Hertz smoothly; a circle does at sqrt(6 pi P)/sin(pi lambda/4).
TEST(Ellipses, EndWhereTheEdgeCloses) {
  const double P = 30;
  const auto circle = end_of("b", 0.15, 0.15, 0, P), found = end_of("b", 0.2, 0.1, 0, P);
  ASSERT_TRUE(circle && found);
  EXPECT_NEAR(circle->T * std::sin(pi<double>() * 0.15 / 4) / std::sqrt(6 * pi<double>() * P), 1, 1e-10);
  EXPECT_EQ(found->kind, EllipseEnd::closes_along);
  const auto [kind, T, u, a, b] = *found;
  EXPECT_GT(u, 0);
  // K_I = 0 at (a, 0), to the square root of the rounding of w
  EXPECT_NEAR(4.0 / 3 * std::pow(a * b, 1.5) * ellipse_pressure(std::log(a / b)).along / P, 1, 1e-9);
  EXPECT_EQ(ellipses("b", 0.2, 0.1, 0, P, {T * 1.001}).at[0].status, EquilibriumStatus::no_equilibrium);
  EXPECT_EQ(end_of("b", 0.1, 0.2, 0, P)->kind, EllipseEnd::closes_across);
}

/// With lambda_III = 0 K_I at (a, 0) falls with the load at the end, but the fold comes first.
TEST(Ellipses, OfModelCHaveAFoldBeforeTheEdgeCloses) {
  for (const double P : {3.0, 100.0, 1e4, 1e6}) {
    const auto found = end_of("c", 0.008, 0, 0, P);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->kind, EllipseEnd::fold) << P;
    const double w = 4.0 / 3 * std::pow(found->a * found->b, 1.5);
    EXPECT_GT(w * ellipse_pressure(std::log(found->a / found->b)).along, P) << P;
  }
}

TEST(Ellipses, OfUncoupledModesStayJkrsCircle) {
  const Ellipses found = ellipses("c", 0, 0, 0.5, 3, {0, 1e3, 1e150});
  EXPECT_FALSE(found.end);
  EXPECT_FALSE(end_of("c", 0, 0, 0.5, 3));
  for (const EllipseState& one : found.at) EXPECT_EQ(one.a, one.b);
}

TEST(Ellipses, OfModelAReachAnAsymptote) {
  const Ellipses found = ellipses("a", 0.3, 0.1, 0, 3, {1e2, 1e4, 1e6, 1e8});
  for (const EllipseState& one : found.at) EXPECT_EQ(one.status, EquilibriumStatus::ok);
  EXPECT_NEAR(found.at[3].a / found.at[2].a, 1, 1e-5);
}

TEST(Ellipses, AreNeverNaNWithoutAStatus) {
  const std::vector<double> T{0, 1, -1, std::nan(""), 1e200, 30};
  for (const double nu : {0.5, -0.1, 0.6})
    for (const double P : {3.0, -10.0, std::nan("")})
      for (const double lambda : {0.3, -1.0, 2.0})
        for (const EllipseState& one : ellipses("c", lambda, 0.1, nu, P, T).at)
          EXPECT_EQ(one.status == EquilibriumStatus::ok, std::isfinite(one.a) && std::isfinite(one.b));
}

}  // namespace contact_model_ellipses_test
}  // namespace mixity
