// Points that follow another law than the model's.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "fitting/fit.h"
#include "fitting/synthetic_runs.h"
#include "mechanics/laws/known_laws.h"

namespace mixity {
namespace law_test {

const std::vector<double> kLoads = {30.4, 15, 11.5, 6.2, 3.7, 2, -0.23, -1.79};

/// Eight runs of 25 points up to 0.9 of the jump; T and A have this proportional noise.
Dataset runs_of(const std::string& model, const ParameterValues& p, double size, unsigned seed) {
  SeededNoise of_A(seed, size), of_T(seed + 1000, size);
  Dataset data = empty_runs();
  for (const double P : kLoads) {
    const double upto = 0.9 * model_named(model).first_stable_end(p, P) / shear_to_lose_area(model, p, P);
    add_run(data, model, p, P, 25, upto, std::ref(of_A));
  }
  for (Point& point : data.points) point.T *= 1 + of_T();
  return data;
}

FitResult fitted(const Dataset& data, std::string_view model, const char* sigma) {
  FitOptions options;
  options.sigma_T = options.sigma_A = *parse_quantity(sigma);
  return fit_model(data, model, options);
}

/// Without this test 27 of the 40 are believed, with predicted areas 2 % off; with it 12 are, and it finds 15.
TEST(Law, ThatBendsOtherwiseThanTheModelIsFound) {
  int believed = 0, found = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const FitResult fit = fitted(runs_of("bk", {3, 1.6}, 0.03, seed), "b", "3%");
    believed += fit.status == FitStatus::ok;
    found += fit.message.text().find("another law") != std::string::npos;
  }
  EXPECT_GE(found, 8);
  EXPECT_LE(believed, 20);
}

TEST(Law, OfTheModelIsHardlyDoubted) {
  constexpr int kExperiments = 60;
  std::vector<double> p_values;
  for (unsigned seed = 1; seed <= kExperiments; ++seed) {
    const FitResult fit = fitted(runs_of("c", {0.15}, 0.01, seed), "c", "1%");
    ASSERT_TRUE(fit.law) << seed;
    p_values.push_back(fit.law->p_value);
  }
  const auto below = std::count_if(p_values.begin(), p_values.end(), [](double p) { return p < 0.2; });
  EXPECT_GE(below, 4);  // 12 expected, with a standard deviation of 3.1
  EXPECT_LE(below, 20);
}

/// A fit of that law agrees with the score test up to what is not linear, a fifth of such falls.
TEST(Law, DepartsAsMuchAsInAFit) {
  LawError error;
  const auto law = define_law(
      {"bent_c", "exp(p*B + q*B^2)/(1 + (l - 1)*B)", {{"l", 0, 1, 0.15}, {"p", -2, 2, 0.01}, {"q", -2, 2, 0.01}}},
      error);
  ASSERT_TRUE(law) << error.message;
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const Dataset data = runs_of("c", {0.15}, 0.01, seed);
    const FitResult fit = fitted(data, "c", "1%"), bent = fitted(data, "bent_c", "1%");
    ASSERT_TRUE(fit.law && bent.has_values()) << seed << ": " << bent.message.text();
    EXPECT_NEAR(fit.law->fall, fit.sum_of_squares - bent.sum_of_squares, 0.1 + 0.2 * fit.law->fall) << seed;
  }
}

/// bk with both of its parameters free bends as the data do.
TEST(Law, OfTwoParametersIsHardlyDoubted) {
  const FitResult fit = fitted(runs_of("bk", {3, 1.6}, 0.01, 1), "bk", "1%");
  EXPECT_EQ(fit.status, FitStatus::ok) << fit.message.text();
  ASSERT_TRUE(fit.law);
  EXPECT_GT(fit.law->p_value, 1e-3);
}

}  // namespace law_test
}  // namespace mixity
