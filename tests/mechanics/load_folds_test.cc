// Folds under load control, found along the phase angle, against the search along the curve and against 50 digits.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mechanics/fold_checks.h"
#include "mechanics/fold_search.h"
#include "mechanics/registry.h"

namespace mixity {
namespace load_folds_test {

using truth::Digits50;

template <class Model>
void expect_same_by_both(const Parameters<Model>& p, double P, int& folds) {
  const EquilibriumCurve curve(Model{}, p, P);
  if (curve.uncoupled()) return;
  constexpr std::size_t kAll = 100;
  FoundFolds angle{kAll}, position{kAll};
  if (!folds_by_angle(curve, angle) || angle.places.empty()) return;  // below the resolution of doubles, or none
  folds_by_position(curve, kLoad, position);
  const std::vector<FoldPlace>&by_angle = angle.places, &by_position = position.places;
  const std::string where = describe(Model{}, p, P, kLoad);
  ASSERT_EQ(by_angle.size(), by_position.size()) << where;
  for (std::size_t i = 0; i < by_angle.size(); ++i) {
    const FoldPlace &one = by_angle[i], &other = by_position[i];
    EXPECT_EQ(one.maximum, other.maximum) << where;
    // T has a relative error below 1e-13 by folds.h; y is right to sqrt(eps) only where both are made of its square.
    EXPECT_NEAR(one.T, other.T, 1e-13 * other.T) << where;
    EXPECT_NEAR(one.position.y, other.position.y, 1e-11 * (other.position.y + std::abs(P))) << where;
    EXPECT_NEAR(one.position.cos2 + one.position.sin2, 1, 4e-15) << where;  // tau^2 and y have some roundings
    ++folds;
  }
}

TEST(LoadFolds, AreTheSameAlongTheAngleAndAlongTheCurve) {
  std::mt19937_64 random(31);
  std::uniform_real_distribution<double> uniform(0, 1);
  int folds = 0;
  for (int i = 0; i < 1500; ++i) {
    const double P = i % 3 == 0   ? -1.5 * pi<double>() * (1 - std::pow(10, -8 * uniform(random)))
                     : i % 3 == 1 ? -4.7 + 40 * uniform(random)
                                  : std::pow(10, -8 + 14 * uniform(random));
    expect_same_by_both<Johnson>({1 - 0.2 * std::pow(10, -6 * uniform(random))}, P, folds);
    expect_same_by_both<Johnson>({uniform(random)}, P, folds);
    expect_same_by_both<WatersGuduru>({2 * uniform(random)}, P, folds);
    // away from the edge of the domain, where T along the curve is not known so well
    const Parameters<BenzeggaghKenane> r_and_eta{std::pow(10, -3 * uniform(random)),
                                                 std::pow(10, -2 + 4 * uniform(random))};
    expect_same_by_both<BenzeggaghKenane>(r_and_eta, P, folds);
    expect_same_by_both<BenzeggaghKenane>({1 + 0.9 * uniform(random), 1 + 5 * uniform(random)}, P, folds);
  }
  EXPECT_GT(folds, 5000);
}

/// A maximum and a minimum of T on a stretch of 0.4 of 7 in y, which steps along the curve pass over.
TEST(LoadFolds, AClosePairIsNotPassedOver) {
  const Parameters<BenzeggaghKenane> p{1.8114483385797515, 7.707117906519362};
  constexpr double P = 1.484908531177096;
  const EquilibriumCurve curve(BenzeggaghKenane{}, p, P);
  const std::vector<FoldPlace> places = locate_folds(curve, kLoad);
  ASSERT_EQ(places.size(), 3u);
  for (const FoldPlace& place : places) {
    const double y = place.position.y, h = 1e-6 * y;
    const auto slope = [&](double at) {
      const double T = tangential_load(BenzeggaghKenane{}, p, at, std::sqrt(6 * pi<double>() * (at + P) - at * at));
      return printed_slope(BenzeggaghKenane{}, p, P, kLoad, at, T);
    };
    EXPECT_LT(slope(y + h) * slope(y - h), 0) << y;
    EXPECT_EQ(slope(y + h) < 0, place.maximum) << y;
  }
}

/// T = y tan psi of the printed law at x = ln tan psi, from g y^2 = 6 pi (y + P).
Digits50 load_at(const Parameters<BenzeggaghKenane>& p, double P, const Digits50& x) {
  const Digits50 t = exp(x), B = t * t / (1 + t * t), f = 1 + (Digits50(p[0]) - 1) * pow(B, Digits50(p[1]));
  const Digits50 g = (1 + t * t) / f, square = 9 * truth::kPi * truth::kPi + 6 * truth::kPi * Digits50(P) * g;
  return (3 * truth::kPi + sqrt(square)) / g * t;
}

/// Where (r - 1)((eta-1)/(eta+1))^(eta-1) tends to 1 psi hardly changes tau at one place of the curve: its T is hard to
/// tell from tau, not from psi.
TEST(LoadFolds, KeepTheirLoadAtTheEdgeOfTheDomainOfModelBk) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  int checked = 0;
  for (int i = 0; i < 300; ++i) {
    const double eta = 1 + std::pow(10, -6 + 8 * uniform(random)) * 0.99;
    const double r_most = std::min(1 + std::pow((eta - 1) / (eta + 1), 1 - eta), 1000.0);
    const Parameters<BenzeggaghKenane> p{1 + (r_most - 1) * (1 - std::pow(10, -8 * uniform(random))), eta};
    const double P =
        i % 3 ? -4.7 + 20 * uniform(random) : -1.5 * pi<double>() * (1 - std::pow(10, -4 * uniform(random)));
    const EquilibriumCurve curve(BenzeggaghKenane{}, p, P);
    for (const FoldPlace& place : locate_folds(curve, kLoad)) {
      Digits50 x = log(Digits50(place.T) / Digits50(place.position.y));
      for (int step = 0; step < 6; ++step) {  // Newton on dT/dx = 0
        const Digits50 h("1e-14"), low = load_at(p, P, x - h), here = load_at(p, P, x), high = load_at(p, P, x + h);
        x -= h * (high - low) / (2 * (high - 2 * here + low));
      }
      // as folds.h promises, though there a rounding of tau^2 may count 1e5 times
      const std::string where = describe(BenzeggaghKenane{}, p, P, kLoad);
      expect_near(place.T, load_at(p, P, x), 1e-13, where);
      ++checked;
    }
  }
  EXPECT_GT(checked, 250);
}

/// Newton's method from small shear ends in rounding there, not below it; its successor went in circles.
TEST(TangentialLoad, IsFoundAtTheEdgeOfTheDomainOfModelBk) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 20000; ++i) {
    const double eta = 1 + std::pow(10, -6 + 3 * uniform(random));
    const double r_most = 1 + std::pow((eta - 1) / (eta + 1), 1 - eta);
    const Parameters<BenzeggaghKenane> p{1 + (r_most - 1) * (1 - std::pow(10, -8 * uniform(random))), eta};
    const double y = 0.5 + 9 * uniform(random), T = y * std::pow(10, -3 + 5 * uniform(random));
    const ShearTerm<double> term = BenzeggaghKenane::shear_term(p, y, T);
    if (!BenzeggaghKenane::equilibrium_domain(p).empty() || !(term.value > 0)) continue;
    // tau^2 is a difference of terms of T^2 and known to some roundings of those; d ln tau/d ln T may be small, too
    const double magnified = T * T / std::min(term.value, term.value - 0.5 * y * term.d1);
    EXPECT_NEAR(tangential_load(BenzeggaghKenane{}, p, y, std::sqrt(term.value)), T, 2e-15 * magnified * T)
        << p[0] << ' ' << eta << ' ' << y;
  }
}

}  // namespace load_folds_test
}  // namespace mixity
