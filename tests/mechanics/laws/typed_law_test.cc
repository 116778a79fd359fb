// A law that is typed is a model like the published ones: where it is one of them, it gives their areas, folds and
// jumps.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <thread>

#include "many_digits.h"
#include "mechanics/contact_model.h"
#include "mechanics/laws/area_of.h"
#include "mechanics/laws/known_laws.h"
#include "mechanics/laws/law_check.h"
#include "mechanics/non_monotone_curve.h"
#include "mechanics/registry.h"

namespace mixity {
namespace typed_law_test {

std::shared_ptr<const UserLaw> defined(const LawDefinition& definition) {
  LawError error;
  const auto law = define_law(definition, error);
  EXPECT_TRUE(law) << error.message;
  return law;
}

/// The published laws as they are printed, and c as a criterion.
void define_published() {
  defined({"typed_a", "1 + (1-l)*tan(psi)^2", {{"l", 0, 1, 0.15}}});
  defined({"typed_b", "1 + tan((1-l/2)*psi)^2", {{"l", 0, 2, 0.15}}});
  defined({"typed_c", "1/(1 + (l-1)*sin(psi)^2)", {{"l", 0, 1, 0.15}}});
  defined({"criterion_c", "K_I^2 + l*K_II^2 = 1", {{"l", 0, 1, 0.15}}});
  defined({"typed_bk", "1 + (r-1)*B^n", {{"r", 1e-3, 1e3, 2}, {"n", 1e-2, 1e2, 2}}});
}

struct Pair {
  const char *published, *typed;
  std::vector<std::vector<double>> parameters;
};
const std::vector<Pair> kPairs{
    {"a", "typed_a", {{0.0023}, {0.15}, {0.7}, {0.95}, {1}}},
    {"b", "typed_b", {{0.01}, {0.15}, {0.3}, {1}, {1.9}, {2}}},
    {"c", "typed_c", {{0.0023}, {0.15}, {0.7}, {0.95}, {1}}},
    {"c", "criterion_c", {{0.0023}, {0.15}, {0.7}, {0.95}, {1}}},
    {"bk", "typed_bk", {{2, 2}, {1.5, 1.7}, {0.5, 2}, {3, 5}, {0.5, 0.7}}},
};
constexpr double kLoads[] = {-4.5, -1.79, -0.23, 0, 2, 30.4, 1000};

TEST(TypedLaws, HaveTheAreasOfThePublishedOnes) {
  define_published();
  for (const Pair& pair : kPairs)
    for (const std::vector<double>& p : pair.parameters)
      for (const double P : kLoads) {
        const std::vector<Fold> folds = model_of(pair.published).folds(p, P, {Control::Kind::load});
        const double most = folds.empty() ? 300 : folds[0].T;
        for (int i = 0; i <= 60; ++i) {
          const double T = most * 0.0166 * i;  // to 0.4 % from the fold, and then from beyond what jumps leave
          expect_same_area(pair.published, pair.typed, p, P, T);
        }
      }
}

TEST(TypedLaws, FoldAndJumpWhereThePublishedOnesDo) {
  define_published();
  for (const Pair& pair : kPairs)
    for (const std::vector<double>& p : pair.parameters)
      for (const double P : kLoads)
        for (const Control control : {Control{Control::Kind::load}, Control{Control::Kind::displacement}}) {
          const std::vector<Fold> published = model_of(pair.published).folds(p, P, control),
                                  typed = model_of(pair.typed).folds(p, P, control);
          ASSERT_EQ(model_of(pair.typed).problem(p, P), model_of(pair.published).problem(p, P)) << pair.typed;
          ASSERT_EQ(typed.size(), published.size()) << pair.typed << ' ' << p[0] << " P " << P;
          for (std::size_t i = 0; i < typed.size(); ++i) {
            const Fold &one = published[i], &other = typed[i];
            // 1e-10: u and A at a fold are known to the root of the rounding of T, 1e-7, where no slope tells them
            EXPECT_NEAR(other.T, one.T, 1e-10 * one.T) << pair.typed << ' ' << p[0] << " P " << P;
            EXPECT_NEAR(other.A, one.A, 1e-6 * one.A) << pair.typed << ' ' << p[0] << " P " << P;
            EXPECT_EQ(other.jumps_to, one.jumps_to) << pair.typed << ' ' << p[0] << " P " << P;
          }
        }
}

// The printed equation y^2 + T^2 = 8 pi a^3 f, in 50 digits, of laws that nobody published.
TEST(TypedLaws, SolveTheirPrintedEquation) {
  using Many = truth::Digits50;
  defined({"own_power", "1 + p*t^2/(1 + q*B^1.5)", {{"p", 0, 1, 0.5}, {"q", 0, 1, 0.5}}});
  defined({"own_mixed", "(1 + q*B)/(1 - s*B^2)", {{"q", 0, 1, 0.3}, {"s", 0, 0.9, 0.3}}});
  defined({"own_angle", "exp(q*psi^2)", {{"q", 0, 0.5, 0.3}}});
  const auto solve = [](const auto& f, double P, double T) {
    // from the JKR radius down to the first root: where the sign of y^2 + T^2 - 8 pi a^3 f changes
    const Many three_pi = 3 * pi<Many>(), y0 = three_pi + sqrt(three_pi * three_pi + 6 * pi<Many>() * P);
    const auto rest = [&](const Many& y) {
      return Many(y * y + T * T - 6 * pi<Many>() * (y + P) * f(Many(atan2(Many(T), y))));
    };
    Many high = y0, low = y0;
    for (int i = 1; i < 4000 && rest(low) > 0; ++i) {
      high = low;
      low = y0 * (1 - Many(i) / 4000);
    }
    for (int i = 0; i < 160; ++i) {
      const Many middle = (low + high) / 2;
      (rest(middle) > 0 ? high : low) = middle;
    }
    const Many a = cbrt(Many(0.75) * (low + P));
    return static_cast<double>(pi<Many>() * a * a);
  };
  for (const double P : {-2.0, 0.5, 20.0})
    for (const double share : {0.05, 0.3, 0.6, 0.9}) {
      const auto check = [&](const std::string& key, const std::vector<double>& p, const auto& f) {
        const std::vector<Fold> folds = model_of(key).folds(p, P, {Control::Kind::load});
        const double T = share * (folds.empty() ? 40 : folds[0].T);
        EquilibriumStatus status{};
        const double A = area_of(key, p, P, T, status);
        ASSERT_EQ(status, EquilibriumStatus::ok) << key;
        EXPECT_NEAR(A / solve(f, P, T), 1, 1e-13) << key << " P " << P << " T " << T;
      };
      check("own_power", {0.4, 0.7}, [](const Many& psi) {
        const Many B = sin(psi) * sin(psi);
        return Many(1 + Many(0.4) * pow(tan(psi), 2) / (1 + Many(0.7) * pow(B, Many(1.5))));
      });
      check("own_mixed", {0.7, 0.4}, [](const Many& psi) {
        const Many B = sin(psi) * sin(psi);
        return Many((1 + Many(0.7) * B) / (1 - Many(0.4) * B * B));
      });
      check("own_angle", {0.4}, [](const Many& psi) { return Many(exp(Many(0.4) * psi * psi)); });
    }
}

TEST(TypedLaws, AreSolvedForTheirToughnessWhereTheyAreCriteria) {
  const auto law =
      defined({"power_law", "(K_I^2)^m + (K_II^2/r)^n = 1", {{"r", 0.1, 10, 2}, {"m", 0.5, 3, 1}, {"n", 0.5, 3, 1}}});
  for (const double r : {0.5, 2.0, 8.0})
    for (const double m : {0.7, 1.0, 2.3})
      for (const double n : {0.6, 1.0, 2.0})
        for (const double psi : {0.0, 1e-4, 0.3, 0.8, 1.3, 1.57}) {
          const double f = law->toughness(psi, std::vector{r, m, n}), C = std::cos(psi) * std::cos(psi),
                       B = std::sin(psi) * std::sin(psi);
          EXPECT_NEAR(std::pow(f * C, m) + std::pow(f * B / r, n), 1, 1e-14) << r << ' ' << m << ' ' << n << ' ' << psi;
          // m = n in closed form
          const double even = law->toughness(psi, std::vector{r, m, m});
          EXPECT_NEAR(even, std::pow(std::pow(C, m) + std::pow(B / r, m), -1 / m), 1e-14 * even);
        }
}

// Their derivatives are those of differences.
TEST(TypedLaws, HaveExactDerivatives) {
  define_published();
  defined({"power_2", "(K_I^2)^m + (K_II^2/r)^n = 1", {{"r", 0.1, 10, 2}, {"m", 0.5, 3, 1}, {"n", 0.5, 3, 1}}});
  const auto check = [](const std::string& key, const ParameterValues& p) {
    const LawLease lease(*find_law(key));
    const UserLawView law(lease);
    for (const double psi : {0.1, 0.5, 1.0, 1.4}) {
      const double h = 1e-5, y = 3 * std::cos(psi), T = 3 * std::sin(psi);
      const auto at = [&](double y_at) { return law.shear_term(p, y_at, T); };
      const auto term = at(y);
      EXPECT_NEAR(term.d1, (at(y + h).value - at(y - h).value) / (2 * h), 1e-8) << key << ' ' << psi;
      EXPECT_NEAR(term.d2, (at(y + h).d1 - at(y - h).d1) / (2 * h), 1e-8) << key << ' ' << psi;
      const auto f = law.log_toughness(p, mixity_from_angle(psi));
      for (std::size_t k = 0; k < p.size(); ++k) {
        auto above = p, below = p;
        above[k] += h;
        below[k] -= h;
        EXPECT_NEAR(f.gradient[k],
                    (law.log_toughness(above, mixity_from_angle(psi)).value -
                     law.log_toughness(below, mixity_from_angle(psi)).value) /
                        (2 * h),
                    1e-8)
            << key << ' ' << psi;
      }
    }
  };
  check("typed_a", {0.3});
  check("typed_b", {0.3});
  check("typed_bk", {1.7, 2.2});
  check("power_2", {2.0, 1.3, 0.8});
}

TEST(TypedLaws, OfTheSameNumberOfParametersAreNotTakenForOneAnother) {
  define_published();
  const double c = std::exp(0.0), psi = 1;
  double inner = 0, outer = 0;
  const LawLease lease_of_a(*find_law("typed_a"));
  const UserLawView a(lease_of_a);
  {
    const LawLease lease_of_c(*find_law("typed_c"));
    inner = UserLawView(lease_of_c).log_toughness({0.3}, mixity_from_angle(psi)).value;
  }
  outer = a.log_toughness({0.3}, mixity_from_angle(psi)).value;
  EXPECT_EQ(a.info.key, "typed_a");
  EXPECT_NEAR(std::exp(outer), c + 0.7 * std::tan(psi) * std::tan(psi), 1e-14);
  EXPECT_NEAR(std::exp(inner), 1 / (1 - 0.7 * std::sin(psi) * std::sin(psi)), 1e-14);
}

TEST(TypedLaws, OfOneKeyAreOne) {
  const auto law = defined({"one", "1 + p*t^2", {{"p", 0, 1, 0.5}}});
  EXPECT_EQ(defined({"one", "1 + p*t^2", {{"p", 0, 1, 0.5}}}), law);
  LawError error;
  EXPECT_FALSE(define_law({"one", "1 + p*t^3", {{"p", 0, 1, 0.5}}}, error));
  EXPECT_EQ(error.message, "there is another law 'one': f = 1 + p*t^2; choose another key for this one");
}

std::string error_of(const std::string& text, std::vector<LawParameter> parameters = {{"p", 0, 1, 0.5}}) {
  LawError error;
  if (UserLaw::make({"key", text, std::move(parameters)}, error)) return {};
  return (error.at ? std::to_string(*error.at) + ": " : "") + error.message;
}

TEST(TypedLaws, ThatCannotBeReadSayWhere) {
  const auto no_name = [](const std::string& name) {
    return "'" + name +
           "' cannot be the name of a parameter: that is a letter, then letters, digits and _, and no function or word "
           "of expressions";
  };
  EXPECT_EQ(error_of("1 + p*t^2"), "");
  EXPECT_EQ(error_of("1 + (p*t^2"), "4: this bracket is not closed");
  EXPECT_EQ(error_of("1 + p*t^2)"), "9: this bracket closes none");
  EXPECT_EQ(error_of("1 + 2p*t^2"), "5: a * is missing before this");
  EXPECT_EQ(error_of("1 + p*t^"), "8: something is missing at the end");
  EXPECT_EQ(error_of("1 + p**t"), "5: cannot be read from here on");
  EXPECT_EQ(error_of(""), "0: the expression is empty");
  EXPECT_EQ(error_of("(1 + p*B)exp(p*B)"), "9: a * is missing before this");
  EXPECT_EQ(error_of("(p)1 + p*B"), "3: a * is missing before this");
  EXPECT_EQ(error_of("p 1 + p*B"), "2: a * is missing before this");
  EXPECT_EQ(error_of("K_I^2 + (1 - p)K_II^2 = 1"), "15: a * is missing before this");
  EXPECT_EQ(error_of("p := 3"), "2: ':' has no place in an expression");
  EXPECT_EQ(error_of("1 + sin p"), "4: function 'sin' needs its argument in brackets");
  EXPECT_TRUE(error_of("1 + q*t").starts_with("4: 'q' is not known; there are psi, B, t, K_I, K_II, p, pi and sin, "));
  EXPECT_EQ(error_of("K_I^2 + K_II = 1 + )"), "19: this bracket closes none");
  EXPECT_EQ(error_of("1 = p"), "2: an equation is solved for K_I and K_II, and these are not in it");
  EXPECT_EQ(error_of(std::string(100, '(')), "60: brackets stand in one another 60 times at most");
  EXPECT_EQ(error_of(std::string(1200, '1')), "1000: an expression has 1000 characters at most, this one 1200");
  EXPECT_EQ(error_of("1", {}), "a law has 1 to 3 parameters, each stated with its range; this one has 0");
  EXPECT_EQ(error_of("1", {{"t", 0, 1, 0}}), "'t' is a variable or stands twice: it cannot be the name of a parameter");
  EXPECT_EQ(error_of("1", {{"if", 0, 1, 0}}), no_name("if"));
  EXPECT_EQ(error_of("1", {{"sin_psi", 0, 1, 0}}), no_name("sin_psi"));
  EXPECT_EQ(error_of("1 + p*B", {{"p", 0, 1, 0.5}, {"q", 0, 1, 0.5}}), "parameter 'q' is not in the expression");
  EXPECT_EQ(error_of("p", {{"p", 1, 0, 0}}), "the range of p must be two numbers within 1e100, the smaller first");
}

LawCheck checked(const std::string& text, std::vector<LawParameter> parameters, bool normalised = false) {
  LawError error;
  const auto law = UserLaw::make({"key", text, std::move(parameters), "", normalised}, error);
  EXPECT_TRUE(law) << error.message;
  return check_law(*law);
}

TEST(TypedLaws, AreCheckedBeforeTheyAreUsed) {
  EXPECT_EQ(checked("2 + p*t^2", {{"p", 0, 1, 0.5}}).error,
            "f at psi = 0 is 2 with p = 0, not 1; normalised = true divides f by it");
  EXPECT_FALSE(checked("2 + p*t^2", {{"p", 0, 1, 0.5}}, true).error);
  EXPECT_EQ(
      checked("1 - 2*p*B", {{"p", 0, 1, 0.2}}).error,
      "f is not a positive number at psi = 72.39 deg with p = 0.562: narrow the ranges of the parameters, or correct "
      "the expression");
  const LawCheck partly = checked("1 + (r-1)*B^n", {{"r", 1, 20, 2}, {"n", 1, 4, 2}});
  EXPECT_FALSE(partly.error);
  ASSERT_EQ(partly.warnings.size(), 1u);
  EXPECT_TRUE(partly.warnings[0].starts_with("several T have the same area in ")) << partly.warnings[0];
  EXPECT_TRUE(checked("1 + p*t^2", {{"p", 0, 1, 0.5}}).warnings.empty());
  const LawCheck rounded = checked("1 + tan((1-p/2)*psi)^2", {{"p", 0, 2, 0.5}});
  ASSERT_EQ(rounded.warnings.size(), 1u);
  EXPECT_TRUE(rounded.warnings[0].starts_with("near psi = 89.")) << rounded.warnings[0];
}

// What happens between the 48 angles that a law is looked at by is refused: its areas and folds would be wrong.
TEST(TypedLaws, WithFeaturesTooNarrowToBeFollowedAreRefused) {
  const auto near = [](const LawCheck& check) {
    constexpr std::string_view begin =
        "f has a feature narrower than 3 deg, or is not positive and finite, near psi = ";
    return check.error && check.error->starts_with(begin) ? std::stod(check.error->substr(begin.size())) : -1;
  };
  const std::vector<LawParameter> p{{"p", 0.05, 0.6, 0.3}};
  EXPECT_NEAR(near(checked("1 + p*(tanh((psi-1.0133)/0.01)+1)/2", p, true)), 58, 3);
  EXPECT_NEAR(near(checked("1 + p*(tanh((psi-0.8111)/0.01)+1)/2", p, true)), 46.5, 3);
  EXPECT_NEAR(near(checked("1 + p*exp(-((psi-0.6071)/0.006)^2)*B", p)), 34.8, 3);
  EXPECT_NEAR(near(checked("1 + p*t^2/(1-t/2)^2", p)), 63.435, 0.01);  // a pole
  EXPECT_NEAR(near(checked("(1 + p*t)^2/(1-t)^2", p)), 45, 0.01);
  EXPECT_FALSE(checked("1 + p*min(t, 1)^2", p).error);  // a kink is none
  EXPECT_FALSE(checked("1 + p*exp(-((psi-0.7)/0.2)^2)*B", p).error);
  EXPECT_FALSE(checked("1 + p*exp(-((psi-0.7)/w)^2)*B", {{"p", 0.1, 2, 0.5}, {"w", 0.08, 0.3, 0.1}}).error);
  EXPECT_FALSE(checked("1 + p*t^8", p).error);
}

// T tends to a constant: what folds there is rounding.
TEST(TypedLaws, HaveNoPairsOfFoldsOfOneLoad) {
  defined({"constant", "(1 + p*t^2)^n/(1 + q*B)", {{"p", 0, 1, 0.5}, {"n", 0.3, 1.2, 1}, {"q", 0, 2, 0.5}}});
  EXPECT_LE(model_of("constant").folds(std::vector{0.8, 0.5, 0.4}, 0, {Control::Kind::load}).size(), 1u);
}

// (1 + tan^2 psi)/f of bk grows exactly where its closed condition says so (models/benzeggagh_kenane.h).
TEST(TypedLaws, AreNonMonotoneWhereThePublishedOneIsNotUnique) {
  define_published();
  int agree = 0, all = 0;
  for (double r = 0.3; r < 12; r += 0.4)
    for (double n = 0.3; n < 6; n += 0.3) {
      const LawLease lease(*find_law("typed_bk"));
      const bool non_monotone = UserLawView(lease).non_monotone({r, n});
      ++all;
      agree += model_of("bk").problem(std::vector{r, n}).empty() != non_monotone;
    }
  EXPECT_GE(agree, all - 2);  // next to the border 48 angles may miss the one where it is lost
}

// Written in t, f loses the digits of its slope towards 90 degrees; what is the same law in B shows it.
TEST(TypedLaws, HaveNoFoldsOfRounding) {
  defined({"in_t", "1 + p*t^2/(1 + q*t^2)", {{"p", 0.01, 5, 0.5}, {"q", 0.01, 5, 0.5}}});
  defined({"in_B", "1 + p*B/(1 - B + q*B)", {{"p", 0.01, 5, 0.5}, {"q", 0.01, 5, 0.5}}});
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform;
  std::vector<std::array<double, 3>> cases{{0.2, 0.74, 36},
                                           {0.2132221084228233, 0.7436339603912742, 36.10017430431416}};
  for (int i = 0; i < 200; ++i) cases.push_back({0.05 + uniform(random), 0.02 + uniform(random), 40 * uniform(random)});
  for (const auto& [p, q, P] : cases)
    for (const Control control : {Control{Control::Kind::load}, Control{Control::Kind::displacement}}) {
      const auto one = model_of("in_t").folds(std::vector{p, q}, P, control),
                 other = model_of("in_B").folds(std::vector{p, q}, P, control);
      ASSERT_EQ(one.size(), other.size()) << p << ' ' << q << ' ' << P;
      for (std::size_t i = 0; i < one.size(); ++i)
        EXPECT_NEAR(one[i].T, other[i].T, 1e-10 * other[i].T) << p << ' ' << q << ' ' << P;
    }
}

// Laws that leave psi = 0 with a slope or a root, against the printed equation in 50 digits.
TEST(TypedLaws, KeepTheirDigitsAtSmallShear) {
  using Many = truth::Digits50;
  defined({"rooted", "1 - p*B^n", {{"p", 0, 0.9, 0.3}, {"n", 0.05, 2, 0.25}}});
  defined({"straight", "K_I + K_II/r = 1", {{"r", 0.1, 10, 2}}});
  const auto check = [](const std::string& key, const std::vector<double>& p, const auto& f) {
    for (const double T : {1e-12, 1e-8, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2}) {
      EquilibriumStatus status{};
      const double A = area_of(key, p, 2, T, status);
      const Many three_pi = 3 * pi<Many>(), y0 = three_pi + sqrt(three_pi * three_pi + 12 * pi<Many>());
      Many low = y0 / 2, high = y0;
      for (int i = 0; i < 160; ++i) {
        const Many y = (low + high) / 2;
        (y * y + Many(T) * T > 6 * pi<Many>() * (y + 2) * f(Many(Many(T) / y)) ? high : low) = y;
      }
      const Many a = cbrt(Many(Many(3) / 4 * (low + 2)));
      EXPECT_NEAR(A / static_cast<double>(Many(pi<Many>() * a * a)), 1, 1e-13) << key << " T " << T;
    }
  };
  for (const double n : {0.1, 0.25, 0.5, 0.8})
    check("rooted", {0.3, n},
          [&](const Many& t) { return Many(1 - Many(0.3) * pow(Many(t * t / (1 + t * t)), Many(n))); });
  check("straight", {2}, [](const Many& t) { return Many((1 + t * t) / pow(Many(1 + t / 2), 2)); });
}

TEST(TypedLaws, AreTheSameOnEveryThread) {
  define_published();
  double here = 0, there = 0;
  EquilibriumStatus status{};
  here = area_of("typed_b", {0.3}, 2, 10, status);
  std::thread([&] {
    EquilibriumStatus other{};
    there = area_of("typed_b", {0.3}, 2, 10, other);
  }).join();
  EXPECT_EQ(here, there);
}

}  // namespace typed_law_test
}  // namespace mixity
