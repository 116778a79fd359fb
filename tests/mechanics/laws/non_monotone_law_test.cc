// Laws whose (1 + tan^2 psi)/f does not grow with psi throughout: 1 + p tan^n psi with n other than 2 enlarges the
// contact at small shear (n < 2) or at large (n > 2). Against the printed equation in 50 digits, which is followed from
// T = 0 in small steps.
#include <gtest/gtest.h>

#include <cmath>

#include "mechanics/contact_model.h"
#include "mechanics/curve_distance.h"
#include "mechanics/equilibrium.h"
#include "mechanics/fold_checks.h"
#include "mechanics/laws/area_of.h"
#include "mechanics/laws/known_laws.h"
#include "mechanics/sampling.h"
#include "mechanics/true_distance.h"

namespace mixity {
namespace non_monotone_law_test {

using truth::Digits50;
using Pair = ParameterValues;

const std::vector<Pair> kCases{{0.5, 1.5}, {1, 1.857}, {0.3, 3}, {0.1, 4}, {0.2, 2.5}, {0.8, 0.7}, {1.3, 2}, {1e-3, 4}};
constexpr double kLoads[] = {-4.5, -2, -0.23, 0, 0.5, 20, 1000};

/// Beyond, psi lies so near to 90 degrees that T/y has lost digits to its rounding; no contact is sheared so.
constexpr double kMostShear = 1e4;

template <class Visit>
void with_tan_power(const Visit& visit) {
  LawError error;
  const auto tan_power = define_law({"tan_power", "1 + p*tan(psi)^n", {{"p", 0, 2, 0.5}, {"n", 0.5, 4, 2}}}, error);
  ASSERT_TRUE(tan_power) << error.message;
  const LawLease lease(*tan_power);
  visit(UserLawView(lease));
}

template <class Number>
Number residual(const Pair& p, double P, const Number& y, const Number& T) {
  return truth::printed_residual<Number>("tan_power", p[0], p[1], P, y, T);
}

/// The stable edge load at T, from JKR on, in steps that move it by less than a tenth; null where it is lost.
std::optional<Digits50> followed(const Pair& p, double P, double T, int steps = 4000) {
  double y = static_cast<double>(truth::jkr_edge_load(P));
  for (int i = 1; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps, shear = T * share * share * share;
    double low = y, high = y;
    for (int k = 0; k < 400 && residual(p, P, low, shear) > 0; ++k) low *= 1 - 1.0 / 4000;
    for (int k = 0; k < 400 && residual(p, P, high, shear) <= 0; ++k) high *= 1 + 1.0 / 4000;
    if (residual(p, P, low, shear) > 0 || residual(p, P, high, shear) <= 0) return std::nullopt;
    for (int k = 0; k < 60; ++k) {
      const double middle = 0.5 * (low + high);
      (residual(p, P, middle, shear) > 0 ? high : low) = middle;
    }
    y = 0.5 * (low + high);
  }
  Digits50 low = y * (1 - 1e-6), high = y * (1 + 1e-6);
  for (int k = 0; k < 100; ++k) {
    const Digits50 middle = (low + high) / 2;
    (residual<Digits50>(p, P, middle, T) > 0 ? high : low) = middle;
  }
  return Digits50((low + high) / 2);
}

double first_fold(const UserLawView& law, const Pair& p, double P) {
  const auto folds = find_folds(EquilibriumCurve(law, p, P), kLoad);
  return folds.empty() ? 40 : folds[0].T;
}

// A bump 10 degrees wide makes a fold and another that leads back to a stable branch, which folds again.
TEST(NonMonotoneLaws, FoldAsOftenAsTheirCurve) {
  LawError error;
  ASSERT_TRUE(define_law({"bump", "1 + p*exp(-((psi-0.7)/0.08)^2)*B", {{"p", 0, 1, 0.2}}}, error)) << error.message;
  const double p = 0.19743589743589746, P = -3;
  const std::vector<Fold> folds = model_of("bump").folds(std::vector{p}, P, {Control::Kind::load});
  ASSERT_EQ(folds.size(), 3u);
  // by psi the curve is explicit: the extrema of T in 30 digits
  EXPECT_NEAR(folds[0].T, 5.6977046995313678, 1e-12);
  EXPECT_NEAR(folds[1].T, 5.6893228577882, 1e-12);
  EXPECT_NEAR(folds[2].T, 5.7442093625486, 1e-12);
  EXPECT_EQ(folds[0].jumps_to, Jump::lower_branch);
  EXPECT_FALSE(folds[1].place.maximum);
}

// The area of a load leads back to it, or to a smaller one at which the contact had that area before.
TEST(NonMonotoneLaws, GiveTheFirstLoadThatHasAnArea) {
  with_tan_power([](const UserLawView& law) {
    std::size_t back = 0, all = 0;
    for (const Pair& p : kCases)
      for (const double P : kLoads)
        for (const double share : {1e-3, 0.02, 0.3, 0.7, 0.95}) {
          const double T = share * first_fold(law, p, P);
          if (T > kMostShear) continue;
          EquilibriumStatus status{};
          const double A = area_of("tan_power", {p[0], p[1]}, P, T, status);
          if (status != EquilibriumStatus::ok) continue;
          double found = 0;
          const std::vector<Values> parameters{{p.begin(), 0}, {p.begin() + 1, 0}};
          model_of("tan_power").tangential_loads(parameters, {&P, 0}, {&A, 0}, {&found, 1});
          ASSERT_TRUE(found <= T * (1 + 1e-3)) << p[0] << ' ' << p[1] << " P " << P << " T " << T << " found " << found;
          EXPECT_NEAR(area_of("tan_power", {p[0], p[1]}, P, found, status), A, 1e-13 * A)
              << p[0] << ' ' << p[1] << " P " << P << " T " << T;
          ++all;
          back += std::abs(found - T) <= 1e-3 * T;  // the area has lost digits of a small shear
        }
    EXPECT_GT(2 * back, all);
  });
}

TEST(NonMonotoneLaws, HaveTheAreasOfTheirPrintedEquation) {
  with_tan_power([](const UserLawView& law) {
    for (const Pair& p : kCases)
      for (const double P : kLoads) {
        const LoadedContact contact(law, p, P);
        ASSERT_EQ(contact.obstacle(), "");
        EXPECT_EQ(contact.at(0).y, contact.jkr_edge_load());
        const double T_fold = first_fold(law, p, P);
        for (const double share : {1e-9, 1e-4, 0.02, 0.3, 0.7, 0.95}) {
          const double T = share * T_fold;
          if (T > kMostShear) continue;
          const Equilibrium found = contact.at(T);
          ASSERT_EQ(found.status, EquilibriumStatus::ok) << p[0] << ' ' << p[1] << " P " << P << " T " << T;
          const auto y = followed(p, P, T);
          ASSERT_TRUE(y) << p[0] << ' ' << p[1] << " P " << P << " T " << T;
          EXPECT_NEAR(static_cast<double>(Digits50((found.y + P) / (*y + P))), 1, 1e-13)
              << p[0] << ' ' << p[1] << " P " << P << " T " << T;
        }
      }
  });
}

TEST(NonMonotoneLaws, FoldWhereTheirPrintedEquationDoes) {
  int seen = 0;
  with_tan_power([&](const UserLawView& law) {
    for (const Pair& p : kCases)
      for (const double P : kLoads)
        for (const Control& control : {kLoad, kDisplacement, spring(0.5)})
          for (const Fold& fold : find_folds(EquilibriumCurve(law, p, P), control)) {
            if (fold.T > kMostShear) continue;
            // the place lies on the printed curve, and what drives the contact has no slope there
            const Digits50 y = fold.place.position.y, T = fold.T;
            const std::string what = describe(law, p, P, control) + " T=" + std::to_string(fold.T);
            EXPECT_LE(abs(residual<Digits50>(p, P, y, T)), 1e-12 * (y * y + T * T + 6 * truth::kPi * (y + std::abs(P))))
                << what;
            EXPECT_LE(abs(printed_slope(law, p, P, control, y, T)), 1e-6) << what;
            ++seen;
          }
    // what lies beyond is another state
    const LoadedContact contact(law, {0.5, 1.5}, 0.5);
    const auto folds = find_folds(EquilibriumCurve(law, {0.5, 1.5}, 0.5), kLoad);
    if (!folds.empty()) {
      EXPECT_TRUE(followed({0.5, 1.5}, 0.5, folds[0].T * 0.9999));
      EXPECT_FALSE(followed({0.5, 1.5}, 0.5, folds[0].T * 1.01));
    }
  });
  EXPECT_GT(seen, 50);
}

TEST(NonMonotoneLaws, HaveCurvesThatSatisfyTheirPrintedEquationWithTheirDerivatives) {
  with_tan_power([](const UserLawView& law) {
    for (const Pair& p : kCases)
      for (const double P : kLoads) {
        const EquilibriumCurve curve(law, p, P);
        const double end = curve.phi_end(curve.pieces().front());
        for (int i = 1; i < 40; ++i) {
          const double s = end * i / 40, h = 1e-6;
          const CurvePoint q = curve.point(s), before = curve.point(s - h), after = curve.point(s + h);
          if (!(q.T < 1e6)) continue;
          const Digits50 scale = Digits50(q.y) * q.y + q.T * q.T + 60 * (q.y + std::abs(P));
          EXPECT_LE(abs(residual<Digits50>(p, P, q.y, q.T)), 1e-13 * scale / std::min(q.f, 1.0))
              << p[0] << ' ' << p[1] << ' ' << P;
          for (const auto& [slope, low, high, size] : {std::array{q.dT, before.T, after.T, q.T},
                                                       {q.dA, before.A, after.A, q.A},
                                                       {q.du, before.u, after.u, q.u},
                                                       {q.df, before.f, after.f, q.f},
                                                       {q.dpsi, before.psi, after.psi, q.psi},
                                                       {q.dy, before.y, after.y, q.y}})
            EXPECT_NEAR(slope, (high - low) / (2 * h), 1e-5 * (std::abs(slope) + size))
                << p[0] << ' ' << p[1] << " P " << P << " s " << s;
        }
      }
  });
}

TEST(NonMonotoneLaws, HaveTheDistancesOfTheirPrintedCurve) {
  int compared = 0;
  with_tan_power([&](const UserLawView& law) {
    for (const Pair& p : kCases)
      for (const double P : kLoads) {
        const EquilibriumCurve whole(law, p, P);
        const truth::Curve<2> curve("tan_power", {p[0], p[1]}, P,
                                    P >= 0 || whole.pieces().front().end == CurveEnd::asymptote);
        const double A0 = area_from_radius(jkr_radius(P)), T0 = first_fold(law, p, P);
        std::vector<double> loads, T, A, sigma_T, sigma_A;
        for (const double x : {0.0, 0.05, 0.4, 0.8, 0.95})
          for (const double off : {-3.0, 0.0, 1.0}) {
            const double shear = x * T0, y = LoadedContact(law, p, P).at(shear).y;
            loads.push_back(P);
            T.push_back(shear);
            sigma_T.push_back(0.01 * T0);
            sigma_A.push_back(0.005 * A0);
            A.push_back(area_from_radius(radius_from_edge_load(y, P)) + off * sigma_A.back());
          }
        std::vector<double> r(T.size()), dP(T.size()), dT(T.size()), dA(T.size()), slopes(2 * T.size());
        CurveDistances out{r, dP, dT, dA, slopes};
        ASSERT_TRUE(curve_distances(law, p, {loads, T, A, sigma_T, sigma_A}, Search::global, true, out))
            << p[0] << ' ' << p[1] << " P " << P;
        for (std::size_t i = 0; i < T.size(); ++i) {
          const double d = static_cast<double>(curve.distance({P, T[i], A[i], sigma_T[i], sigma_A[i]}));
          EXPECT_NEAR(std::abs(r[i]), d, 1e-9 * d + 1e-10) << p[0] << ' ' << p[1] << " P " << P << " T " << T[i];
          ++compared;
        }
      }
  });
  EXPECT_GT(compared, 500);
}

}  // namespace non_monotone_law_test
}  // namespace mixity
