// Each model against its law as printed, in 50 digits, to the ends of its range.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mechanics/printed_equation.h"
#include "mechanics/registry.h"

namespace mixity {
namespace printed_laws_test {

using truth::Digits50;

/// ln f against the printed law at loads (y, T). Relative error of ln f.
template <class Model>
double worst_error(const std::vector<Parameters<Model>>& list) {
  double worst = 0;
  for (const auto& p : list)
    for (const double T : {1e-9, 1e-4, 0.1, 0.7, 1.0, 1.4, 8.0, 1e4, 1e9}) {
      const Digits50 f = truth::printed_toughness<Digits50>(Model::info.key, p[0], p.size() > 1 ? p[1] : 0.0, 1, T);
      const Digits50 expected = log(f);
      const double found = Model::log_toughness(p, mixity_from_loads(1.0, T)).value;
      if (abs(expected) < 1e-30) {  // f = 1 + ... leaves 50 digits too few to judge the rest by
        EXPECT_LT(std::abs(found), 1e-30);
        continue;
      }
      worst = std::max(worst, std::abs(static_cast<double>((found - expected) / expected)));
    }
  return worst;
}

// A few roundings (eps = 2.2e-16) of tan, its square and the logarithm.
constexpr double kFewRoundings = 3e-15;

TEST(Johnson, MatchesThePrintedLawToTheLastDigits) {
  EXPECT_LT(worst_error<Johnson>({{0.0}, {1e-12}, {0.0023}, {0.5}, {8.0 / 9}, {1 - 1e-12}, {1.0}}), kFewRoundings);
}

TEST(WatersGuduru, MatchesThePrintedLawToTheLastDigits) {
  EXPECT_LT(worst_error<WatersGuduru>({{0.0}, {1e-12}, {0.0023}, {0.3}, {1.0}, {1.7}, {2.0}}), kFewRoundings);
}

TEST(PapangeloCiavarella, MatchesThePrintedLawToTheLastDigits) {
  EXPECT_LT(worst_error<PapangeloCiavarella>({{0.0}, {1e-12}, {0.0023}, {0.2331}, {0.9}, {1 - 1e-12}, {1.0}}),
            kFewRoundings);
}

TEST(BenzeggaghKenane, MatchesThePrintedLawToTheLastDigits) {
  EXPECT_LT(worst_error<BenzeggaghKenane>({{1.774, 2.284}, {0.5, 0.3}, {3, 1}, {100, 8}, {1, 2}}), kFewRoundings);
}

TEST(BenzeggaghKenane, ReachesItsTwoEndsExactly) {
  const Parameters<BenzeggaghKenane> p{1.774, 2.284};
  EXPECT_EQ(std::exp(BenzeggaghKenane::log_toughness(p, mixity_from_mode_ratio(0)).value), 1);
  EXPECT_NEAR(std::exp(BenzeggaghKenane::log_toughness(p, mixity_from_mode_ratio(1)).value), 1.774, 1e-15);
}

/// At r = 2, eta = 1 all of T^2 but its part B cancels in tau^2.
TEST(BenzeggaghKenane, ShearTermKeepsItsDigitsAtTheEdgeOfTheDomain) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 5000; ++i) {
    const double eta = i % 5 ? 1 + std::pow(10, -15 + 13 * uniform(random)) : 1;
    const double r = 2 - (i % 3 ? std::pow(10, -15 + 13 * uniform(random)) : 0);
    const double y = 0.5 + 9 * uniform(random), T = y * std::pow(10, -7 + 5 * uniform(random));
    const std::array<Digits50, 2> exact{r, eta};
    const auto wanted = BenzeggaghKenane::shear_term(exact, Digits50(y), Digits50(T));
    const auto got = BenzeggaghKenane::shear_term(std::array{r, eta}, y, T);
    // roundings of B, ln B, f and a dozen operations
    EXPECT_NEAR(got.value, static_cast<double>(wanted.value), 3e-15 * static_cast<double>(wanted.value))
        << r << ' ' << eta << ' ' << y << ' ' << T;
  }
}

TEST(BenzeggaghKenane, NamesItsDomainOfEquilibrium) {
  EXPECT_TRUE(BenzeggaghKenane::equilibrium_domain({0.5, 0.3}).empty());
  EXPECT_TRUE(BenzeggaghKenane::equilibrium_domain({2, 1}).empty());
  EXPECT_FALSE(BenzeggaghKenane::equilibrium_domain({2.1, 1}).empty());
  EXPECT_FALSE(BenzeggaghKenane::equilibrium_domain({1.5, 0.9}).empty());
  // eta = 2: (r - 1)/3 <= 1
  EXPECT_TRUE(BenzeggaghKenane::equilibrium_domain({4, 2}).empty());
  EXPECT_FALSE(BenzeggaghKenane::equilibrium_domain({4.01, 2}).empty());
}

TEST(Models, AgreeInTheSavkoorBriggsLimit) {
  for (const double T : {0.1, 1.0, 7.0, 1e3}) {
    const auto mixity = mixity_from_loads(1.0, T);
    EXPECT_EQ(Johnson::log_toughness({1.0}, mixity).value, 0);
    EXPECT_EQ(WatersGuduru::log_toughness({2.0}, mixity).value, 0);
    EXPECT_EQ(PapangeloCiavarella::log_toughness({1.0}, mixity).value, 0);
  }
}

}  // namespace printed_laws_test
}  // namespace mixity
