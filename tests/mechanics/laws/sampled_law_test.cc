// A law that is a function, sampled: where it is a published one it gives its areas, and what is lost is told.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "mechanics/contact_model.h"
#include "mechanics/laws/area_of.h"
#include "mechanics/laws/known_laws.h"
#include "mechanics/laws/law_check.h"
#include "mechanics/laws/sampled_toughness.h"
#include "mechanics/registry.h"

namespace mixity {
namespace sampled_law_test {

using Parameter = std::span<const double>;
using Law = double (*)(double psi, Parameter p);

std::shared_ptr<const LawSampler> sampler_of(Law law) {
  return std::make_shared<const LawSampler>([law](std::span<const double> psi, Parameter p, std::span<double> f) {
    for (std::size_t i = 0; i < psi.size(); ++i) f[i] = law(psi[i], p);
  });
}

double square(double x) { return x * x; }
const Law kJohnson = [](double psi, Parameter p) { return 1 + (1 - p[0]) * square(std::tan(psi)); };
const Law kWatersGuduru = [](double psi, Parameter p) { return 1 + square(std::tan((1 - p[0] / 2) * psi)); };
const Law kPapangeloCiavarella = [](double psi, Parameter p) { return 1 / (1 + (p[0] - 1) * square(std::sin(psi))); };
const Law kBenzeggaghKenane = [](double psi, Parameter p) {
  return 1 + (p[0] - 1) * std::pow(square(std::sin(psi)), p[1]);
};

const Law kTurning = [](double psi, Parameter p) { return 1 + p[0] * std::pow(std::tan(psi), p[1]); };

void define_published() {
  const auto define = [](const char* key, Law law, std::vector<LawParameter> parameters) {
    if (find_law(key)) return;
    LawError error;
    ASSERT_TRUE(define_law({key, "law(psi)", std::move(parameters), "", false, sampler_of(law)}, error))
        << error.message;
  };
  define("sampled_a", kJohnson, {{"l", 0, 1, 0.15}});
  define("sampled_b", kWatersGuduru, {{"l", 0, 2, 0.15}});
  define("sampled_c", kPapangeloCiavarella, {{"l", 0, 1, 0.15}});
  define("sampled_bk", kBenzeggaghKenane, {{"r", 1e-3, 1e3, 2}, {"n", 1e-2, 1e2, 2}});
  define("sampled_turning", kTurning, {{"p", 0, 1, 0.5}, {"n", 0.5, 4, 2}});
  LawError error;
  ASSERT_TRUE(define_law({"turning", "1 + p*t^n", {{"p", 0, 1, 0.5}, {"n", 0.5, 4, 2}}}, error)) << error.message;
}

struct Pair {
  const char *published, *sampled;
  std::vector<std::vector<double>> parameters;
};
const std::vector<Pair> kPairs{
    {"a", "sampled_a", {{0.0023}, {0.15}, {0.7}, {0.95}, {1}}},
    {"b", "sampled_b", {{0.01}, {0.15}, {0.3}, {1}, {1.9}, {2}}},
    {"c", "sampled_c", {{0.0023}, {0.15}, {0.7}, {0.95}, {1}}},
    {"bk", "sampled_bk", {{2, 2}, {1.5, 1.7}, {0.5, 2}, {3, 5}, {0.5, 0.7}}},
    {"turning",
     "sampled_turning",
     {{0.5, 1.5}, {1, 1.857}, {0.3, 3}, {0.7, 2.1}, {0.7, 2.3}, {0.7, 2.5}, {0.5, 1.98}}},  // one area stands for
                                                                                            // several T
};

// As of typed laws: the function's own rounding near 90 degrees is magnified as theirs.
TEST(SampledLaws, HaveTheAreasOfThePublishedOnes) {
  define_published();
  for (const Pair& pair : kPairs)
    for (const std::vector<double>& p : pair.parameters)
      for (const double P : {-4.5, -1.79, 0.0, 2.0, 30.4, 1000.0}) {
        const std::vector<Fold> folds = model_of(pair.published).folds(p, P, {Control::Kind::load});
        const double most = folds.empty() ? 300 : std::min(folds[0].T, 1e4);  // no contact is sheared so
        for (int i = 0; i <= 30; ++i) {
          const double T = i == 1 ? 9e-4 : i == 2 ? 1e-5 : most * 0.0332 * i;  // to 0.4 % from the fold
          expect_same_area(pair.published, pair.sampled, p, P, T);
        }
      }
}

// Differences of a step of 1e-3, a quartic through five, leave 1e-12 of it, and rounding 1e-15/1e-3.
TEST(SampledLaws, HaveTheDerivativesOfThePublishedOnes) {
  define_published();
  for (const Pair& pair : kPairs)
    for (const std::vector<double>& p : pair.parameters)
      for (const double psi : {0.01, 0.3, 0.8, 1.2, 1.5}) {
        const Mixity<double> at = mixity_from_angle(psi);
        double value = 0;
        std::vector<double> published(p.size()), gradient(p.size());
        model_of(pair.published).log_toughness(p, {&at, 1}, {&value, 1}, published);
        model_of(pair.sampled).log_toughness(p, {&at, 1}, {&value, 1}, gradient);
        for (std::size_t k = 0; k < p.size(); ++k)
          EXPECT_NEAR(gradient[k], published[k], 2e-9 * (1 + std::abs(published[k])))
              << pair.sampled << ' ' << p[0] << ' ' << psi << ' ' << k;
      }
}

/// Largest error of ln f, to a millionth of a degree from both ends, and what is told of it.
struct Error {
  double found, told, at;
};
Error error_of(Law law) {
  const double none = 0;
  const SampledToughness sampled(*sampler_of(law), {&none, 1});
  Error error{0, sampled.error(), sampled.error_at()};
  const auto look = [&](double psi) {
    const double lacks = sampled.log_toughness(psi, std::cos(psi)) - std::log(law(psi, {}));
    error.found = std::max(error.found, std::abs(lacks));
  };
  for (int i = 1; i < 3000; ++i) look(0.5 * pi<double>() * i / 3000);
  for (int i = 0; i <= 160; ++i) {
    look(std::pow(10, -8 + 0.05 * i));
    look(0.5 * pi<double>() - std::pow(10, -8 + 0.05 * i));
  }
  return error;
}

TEST(SampledLaws, MayHaveAnyPowerAtTheEnds) {
  for (const Law law :
       std::initializer_list<Law>{[](double psi, Parameter) { return 1 + 0.4 * std::pow(std::tan(psi), 1.3); },
                                  [](double psi, Parameter) { return 1 + 0.4 * std::pow(std::tan(psi), 2.5); },
                                  [](double psi, Parameter) { return 1 - 0.4 * std::pow(std::sin(psi), 1.4); },
                                  [](double psi, Parameter) { return 2 - std::pow(std::cos(psi), 0.6); },
                                  [](double psi, Parameter) { return 1 + std::pow(std::tan(psi), 4); }}) {
    const Error error = error_of(law);
    EXPECT_LT(error.found, 1e-13);
    EXPECT_LT(error.told, 1e-11);
  }
}

TEST(SampledLaws, TellWhatSamplesDoNot) {
  const Error kink = error_of([](double psi, Parameter) { return std::max(1.0, 1 + psi - 0.7); });
  EXPECT_LT(kink.found, 1e-9);
  EXPECT_NEAR(kink.at, 0.7, 1e-6);
  const Error noise = error_of([](double psi, Parameter) { return 1 + 0.1 * psi * psi + 1e-9 * std::sin(1e9 * psi); });
  EXPECT_GT(noise.told, 1e-10);
  EXPECT_LT(noise.told, 1e-8);
  const Error jump = error_of([](double psi, Parameter) { return psi > 0.7 ? 1.1 : 1.0; });
  EXPECT_GT(jump.told, 1e-3);
  EXPECT_NEAR(jump.at, 0.7, 1e-6);
}

LawCheck checked(Law law, bool normalised = false) {
  LawError error;
  const auto made = UserLaw::make({"key", "law(psi, p)", {{"p", 0, 1, 0.5}}, "", normalised, sampler_of(law)}, error);
  EXPECT_TRUE(made) << error.message;
  return check_law(*made);
}

TEST(SampledLaws, AreCheckedAsTypedOnesAre) {
  const Law twice = [](double psi, Parameter p) { return 2 + p[0] * square(std::tan(psi)); };
  EXPECT_EQ(checked(twice).error, "f at psi = 0 is 2 with p = 0, not 1; normalised = true divides f by it");
  EXPECT_FALSE(checked(twice, true).error);
  const std::optional<std::string> below =
      checked([](double psi, Parameter p) { return 1 - 2 * p[0] * square(std::sin(psi)); }).error;
  ASSERT_TRUE(below);  // at a sample behind 70.5 degrees
  EXPECT_TRUE(below->starts_with("f is not a positive number at psi = 7")) << *below;
  EXPECT_TRUE(below->ends_with("deg with p = 0.562: narrow the ranges of the parameters, or correct the expression"))
      << *below;
  const LawCheck turns = checked([](double psi, Parameter p) { return 1 + (3 + p[0]) * square(std::tan(psi)); });
  ASSERT_EQ(turns.warnings.size(), 1u);
  EXPECT_TRUE(turns.warnings[0].starts_with("several T have the same area in 18 of 18 parts")) << turns.warnings[0];
  EXPECT_TRUE(checked([](double psi, Parameter p) { return 1 + p[0] * square(std::tan(psi)); }).warnings.empty());
  const LawCheck jump = checked([](double psi, Parameter p) { return psi > 0.7 ? 1 + 0.1 * p[0] : 1.0; });
  ASSERT_TRUE(jump.error);
  EXPECT_TRUE(jump.error->starts_with("f cannot be sampled near psi = 40.11 deg with p = ")) << *jump.error;
  const LawCheck kink = checked([](double psi, Parameter p) { return 1 - 0.1 * p[0] * std::max(0.0, psi - 0.7); });
  EXPECT_FALSE(kink.error);
  ASSERT_EQ(kink.warnings.size(), 1u);
  EXPECT_TRUE(kink.warnings[0].starts_with("near psi = 40.11 deg with p = ")) << kink.warnings[0];
}

TEST(SampledLaws, AreOneWhereTheirFunctionIsOne) {
  const auto sampler = sampler_of(kJohnson);
  LawError error;
  const auto one = define_law({"function", "f(psi)", {{"l", 0, 1, 0.5}}, "", false, sampler}, error);
  ASSERT_TRUE(one);
  EXPECT_EQ(define_law({"function", "f(psi)", {{"l", 0, 1, 0.5}}, "", false, sampler}, error), one);
  EXPECT_FALSE(define_law({"function", "f(psi)", {{"l", 0, 1, 0.5}}, "", false, sampler_of(kJohnson)}, error));
  EXPECT_EQ(error.message,
            "there is another law 'function': f = f(psi), another function; choose another key for this one");
}

TEST(SampledLaws, LetOutWhatTheirFunctionThrows) {
  const Law throws = [](double, Parameter p) -> double {
    if (p[0] > 0.5) throw std::domain_error("too large");
    return 1;
  };
  LawError error;
  ASSERT_TRUE(define_law({"throws", "f(psi, l)", {{"l", 0, 1, 0.4}}, "", false, sampler_of(throws)}, error));
  const auto f_at = [](double l) {
    const double psi = 0.3;
    double f = 0;
    const Values parameter{&l, 0};
    model_of("throws").toughness_ratios({&parameter, 1}, {&psi, 0}, {&f, 1});
    return f;
  };
  EXPECT_EQ(f_at(0.4), 1);
  EXPECT_THROW(f_at(0.6), std::domain_error);
  EXPECT_EQ(f_at(0.4), 1);
}

}  // namespace sampled_law_test
}  // namespace mixity
