// A criterion is solved in few evaluations, to the same bits whatever was asked before, and where it is of no usual
// form.
#include "mechanics/laws/criterion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <thread>

#include "mechanics/laws/known_laws.h"
#include "mechanics/laws/law_workspace.h"
#include "mechanics/registry.h"

namespace mixity {
namespace criterion_test {

TEST(Criteria, InPowersTakeThreeEvaluations) {
  int asked = 0, roots = 0;
  double worst = 0;
  for (const double r : {0.2, 1.0, 3.0, 30.0})
    for (const double m : {0.5, 0.8, 1.0, 1.5, 3.0})
      for (const double n : {0.5, 0.8, 1.0, 1.5, 3.0})
        for (int k = 0; k <= 20; ++k) {
          const double B = k / 20.0;
          const auto rest = [&](const Taylor& q) {
            return log(pow(exp(q) * Taylor(1 - B), Taylor(m)) + pow(exp(q) * Taylor(B / r), Taylor(n)));
          };
          const auto root = contracted_root(
              [&](double q) {
                ++asked;
                return rest({q, 1, 0});
              },
              0);
          ASSERT_TRUE(root) << r << ' ' << m << ' ' << n << ' ' << B;
          ++roots;
          const Taylor there = rest({root->q, 1, 0});
          worst = std::max(worst, std::abs(there.value / there.first));
          EXPECT_NEAR(root->slope / there.first, 1, 1e-10) << r << ' ' << m << ' ' << n << ' ' << B;
        }
  EXPECT_LT(asked, 2.8 * roots);
  EXPECT_LT(worst, 4e-15);  // roundings of ln f up to 3.4
}

TEST(Criteria, OfSeveralRootsHaveTheNearest) {
  const auto cubic = [](double q) {  // roots -0.1, 0.3, 0.7
    const Taylor x{q, 1, 0};
    return (x + Taylor(0.1)) * (x - Taylor(0.3)) * (x - Taylor(0.7));
  };
  ASSERT_TRUE(enclosed_root(cubic));
  EXPECT_NEAR(enclosed_root(cubic)->q, -0.1, 1e-15);
  const auto near = contracted_root(cubic, 0);
  EXPECT_TRUE(!near || std::abs(near->q + 0.1) < 1e-15) << near->q;
  // the tangent at 0.53 leads far beyond 0.7
  const auto far = contracted_root(cubic, 0.53);
  EXPECT_TRUE(!far || (far->q > 0.2 && far->q < 0.8)) << far->q;
  EXPECT_FALSE(enclosed_root([](double q) { return Taylor(1 + q * q, 2 * q, 2); }));
  EXPECT_FALSE(contracted_root([](double q) { return Taylor(1 + q * q, 2 * q, 2); }, 0));
}

std::shared_ptr<const UserLaw> made(const std::string& text) {
  LawError error;
  const auto law = UserLaw::make({"key", text, {{"l", 0, 1, 0.5}}}, error);
  EXPECT_TRUE(law) << error.message;
  return law;
}

// Model c in forms of which the logarithm is no number, whose sides are of either sign, or that are not smooth. The
// last loses 430 eps by its difference.
TEST(Criteria, MayBeWrittenInAnyForm) {
  for (const char* text :
       {"K_I^2 + l*K_II^2 = 1", "K_I^2 + l*K_II^2 - 1 = 0", "1 = K_I^2 + l*K_II^2", "-l*K_II^2 = K_I^2 - 1",
        "sqrt(K_I^2 + l*K_II^2) = 1", "0 = 1 - K_I^2 - l*K_II^2", "1 + (1-l)*K_II^2"}) {
    const auto law = made(text);
    if (!law) continue;
    for (const double l : {0.0023, 0.15, 1.0})
      for (const double psi : {0.0, 1e-6, 0.4, 1.1, 1.5707}) {
        const double f = law->toughness(psi, std::vector{l});
        EXPECT_NEAR(f * (std::pow(std::cos(psi), 2) + l * std::pow(std::sin(psi), 2)), 1, 1e-13)
            << text << ' ' << l << ' ' << psi;
      }
  }
  const auto corner = made("max(K_I^2, l*K_II^2) = 1");
  EXPECT_NEAR(corner->toughness(0.3, std::vector{0.2}), 1 / std::pow(std::cos(0.3), 2), 1e-14);
  EXPECT_NEAR(corner->toughness(1.4, std::vector{0.2}), 1 / (0.2 * std::pow(std::sin(1.4), 2)), 1e-14);
  EXPECT_TRUE(std::isnan(made("l*K_I^2 + K_II^2 = -1")->toughness(0.3, std::vector{0.2})));
}

// Derivatives are those of differences, with a start that is known and without.
TEST(Criteria, HaveTheirDerivativesFromAnyStart) {
  LawError error;
  const auto law = UserLaw::make(
      {"key", "(K_I^2)^m + (K_II^2/r)^n = 1", {{"r", 0.1, 10, 2}, {"m", 0.5, 3, 1}, {"n", 0.5, 3, 1}}}, error);
  ASSERT_TRUE(law);
  const std::vector<double> p{2, 1.3, 0.8};
  const auto at = [&](double psi, std::optional<Taylor> about) {
    LawState state = along_angle(std::sin(psi), std::cos(psi));
    state.about = about;
    return LawLease(*law).workspace().toughness(state, p);
  };
  for (const double psi : {0.2, 0.7, 1.3}) {
    const Taylor alone = at(psi, {});
    const double h = 1e-4;
    EXPECT_NEAR(alone.first, (at(psi + h, {}).value - at(psi - h, {}).value) / (2 * h), 1e-7);
    EXPECT_NEAR(alone.second, (at(psi + h, {}).first - at(psi - h, {}).first) / (2 * h), 1e-6);
    const Taylor near = log(alone);
    for (const double off : {0.0, 1e-9, 1e-4, 0.3, 30.0}) {
      const Taylor started = at(psi, Taylor{near.value + off, near.first - off, near.second + off});
      EXPECT_NEAR(started.value / alone.value, 1, 4e-15) << psi << ' ' << off;
      EXPECT_NEAR(started.first, alone.first, 1e-12) << psi << ' ' << off;
      EXPECT_NEAR(started.second, alone.second, 1e-8) << psi << ' ' << off;
    }
  }
}

// Bits of a result are those of the same question on another thread, where nothing was asked before.
TEST(Criteria, DoNotRememberWhatWasAsked) {
  LawError error;
  ASSERT_TRUE(define_law(
      {"no_memory", "(K_I^2)^m + (K_II^2/r)^n = 1", {{"r", 0.1, 10, 2}, {"m", 0.5, 3, 1}, {"n", 0.5, 3, 1}}}, error));
  const auto ask = [](double r, double psi, bool shear) {
    const LawLease lease(*find_law("no_memory"));
    const UserLawView law(lease);
    const ParameterValues p{r, 1.4, 0.8};
    return shear ? law.shear_term(p, std::cos(psi), std::sin(psi)).value
                 : law.log_toughness(p, mixity_from_angle(psi)).value;
  };
  for (const bool shear : {false, true})
    for (const double psi : {0.1, 0.6, 1.2}) {
      for (const double r : {0.3, 2.0, 5.0}) ask(r, psi + 0.01 * r, !shear);
      const double here = ask(2.2, psi, shear);
      double fresh = 0;
      std::thread([&] { fresh = ask(2.2, psi, shear); }).join();
      EXPECT_EQ(here, fresh) << psi;
      EXPECT_EQ(ask(2.2, psi, shear), fresh) << psi;
    }
}

}  // namespace criterion_test
}  // namespace mixity
