// The distance from the law in the plane of two measured energies, through the whole fit.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "base/input_error.h"
#include "base/number_text.h"
#include "dataset/load_text.h"
#include "fitting/comparison.h"
#include "fitting/energy_objective.h"
#include "fitting/fit.h"
#include "fitting/models.h"

namespace mixity {
namespace energies_test {

/// Pearson's (1901) data with York's (1966) weights, w = 1/sigma^2: G_I against G_II.
Dataset pearson_and_york() {
  const double x[] = {0, .9, 1.8, 2.6, 3.3, 4.4, 5.2, 6.1, 6.5, 7.4};
  const double w_x[] = {1000, 1000, 500, 800, 200, 80, 60, 20, 1.8, 1};
  const double y[] = {5.9, 5.4, 4.4, 4.6, 3.5, 3.7, 2.8, 2.8, 2.4, 1.5};
  const double w_y[] = {1, 1.8, 4, 8, 20, 20, 70, 70, 100, 500};
  std::string text = "G_I [J/m^2],G_II [J/m^2],sigma_GI [J/m^2],sigma_GII [J/m^2]\n";
  for (int i = 0; i < 10; ++i)
    text += std::to_string(y[i]) + ',' + std::to_string(x[i]) + ',' + shortest(1 / std::sqrt(w_y[i])) + ',' +
            shortest(1 / std::sqrt(w_x[i])) + '\n';
  return load_text(text);
}

/// Model c is the line G_I = G_Ic - lambda G_II. Values in 40-digit arithmetic: intercept, minus slope, chi^2, York's
/// (2004) standard errors, profiles of the slope. They are good to the 1e-9 that a file's digits and the ends allow.
TEST(Energies, OfPearsonAndYorkRunThroughTheWholeFit) {
  const Dataset data = pearson_and_york();
  const FitResult fit = fit_model(data, "c", {.free = {kToughness}});
  ASSERT_EQ(fit.status, FitStatus::ok) << fit.message.text();
  EXPECT_EQ(fit.objective, Objective::curve);
  EXPECT_TRUE(fit.known_errors);
  ASSERT_EQ(fit.parameters.size(), 2u);
  const FittedParameter &lambda = fit.parameters[0], &toughness = fit.parameters[1];
  EXPECT_NEAR(*lambda.value, 0.480533407446201987, 1e-9 * 0.48);
  EXPECT_NEAR(*toughness.value, 5.47991022403286536, 1e-9 * 5.48);
  EXPECT_EQ(toughness.unit, "J/m^2");
  EXPECT_NEAR(fit.sum_of_squares, 11.8663531940614453, 1e-9 * 11.9);
  EXPECT_NEAR(*lambda.stderr_, 0.0579850090007744364, 1e-9);
  EXPECT_NEAR(*toughness.stderr_, 0.294970735493108564, 1e-9);
  ASSERT_TRUE(lambda.interval && lambda.interval->low && lambda.interval->high);
  EXPECT_NEAR(*lambda.interval->low, 0.376302196730043, 1e-9 * 0.376);
  EXPECT_NEAR(*lambda.interval->high, 0.601441332467526, 1e-9 * 0.601);
  // chi^2 + 1
  const FitResult one = fit_model(data, "c", {.free = {kToughness}, .confidence = 0.682689492137085897});
  EXPECT_NEAR(*one.parameters[0].interval->low, 0.425165940287338, 1e-9 * 0.425);
  EXPECT_NEAR(*one.parameters[0].interval->high, 0.540235934533822, 1e-9 * 0.540);
}

/// Energies of model c, G_I = 300 - G_II/3, with errors of 6 and 23 in turn above and below the line.
Dataset uneven(int n, bool stated) {
  std::string text = stated ? "G_I,G_II,sigma_GI,sigma_GII\n" : "G_I,G_II\n";
  for (int i = 0; i < n; ++i) {
    const double x = 20 + 600.0 * i / n, sign_I = i % 2 ? 1 : -1, sign_II = i % 4 < 2 ? 1 : -1;
    text += shortest(300 - x / 3 + 6 * sign_I) + ',' + shortest(x + 23 * sign_II) + (stated ? ",6,23\n" : "\n");
  }
  return load_text(text);
}

TEST(Energies, WithoutErrorsAreSuspectOnlyWhereTheRatioOfTheErrorsMatters) {
  FitOptions options{.objective = Objective::curve, .free = {kToughness}};
  EXPECT_EQ(fit_model(uneven(20, false), "c", options).status, FitStatus::ok);
  const FitResult many = fit_model(uneven(2000, false), "c", options);
  EXPECT_EQ(many.status, FitStatus::suspect);
  EXPECT_NE(many.message.text().find("columns sigma_GI and sigma_GII"), std::string::npos) << many.message.text();
  // what it asks for mends it
  const FitResult stated = fit_model(uneven(2000, true), "c", options);
  EXPECT_EQ(stated.status, FitStatus::ok) << stated.message.text();
  EXPECT_NEAR(*stated.parameters[0].value, 1.0 / 3, 4 * *stated.parameters[0].stderr_);
}

std::string exact(const std::string& model, const ParameterValues& p, double toughness, const std::string& series) {
  std::string text;
  for (int i = 0; i < 8; ++i) {
    const Mixity<double> mixity = mixity_from_angle(0.19 * i);
    const double Gc = toughness * std::exp(log_f(model_named(model), p, mixity));
    text += shortest(Gc * mixity.cos * mixity.cos) + ',' + shortest(Gc * mixity.sin * mixity.sin) + ",1%,1%," + series;
    text += '\n';
  }
  std::size_t at;
  while ((at = text.find("1%")) != std::string::npos) text.replace(at, 2, "0.01");
  return text;
}

class EnergiesOf : public OfModel {};
INSTANTIATE_TEST_SUITE_P(EachModel, EnergiesOf, ::testing::ValuesIn(published_keys()));

/// Two interfaces of one lambda and toughnesses of their own.
TEST_P(EnergiesOf, SeveralSeriesGiveOneLawAndAToughnessOfEach) {
  const ParameterValues p = parameter_count() == 2 ? ParameterValues{1.774, 2.284} : ParameterValues{0.35};
  const Dataset data = load_text("G_I [J/m^2],G_II [J/m^2],sigma_GI [J/m^2],sigma_GII [J/m^2],curve\n" +
                                 exact(key(), p, 2, "dry") + exact(key(), p, 5, "wet"));
  const FitResult fit = fit_model(data, key(), {.free = {kToughness}});
  ASSERT_EQ(fit.status, FitStatus::ok) << fit.message.text();
  ASSERT_EQ(fit.parameters.size(), p.size() + 2);
  // data of 16 digits, times the condition of the fit
  for (std::size_t k = 0; k < p.size(); ++k) EXPECT_NEAR(*fit.parameters[k].value, p[k], 1e-9);
  EXPECT_EQ(fit.parameters[p.size()].name, "toughness(dry)");
  EXPECT_NEAR(*fit.parameters[p.size()].value, 2, 1e-9);
  EXPECT_EQ(fit.parameters[p.size() + 1].name, "toughness(wet)");
  EXPECT_NEAR(*fit.parameters[p.size() + 1].value, 5, 1e-9);
}

/// The kinds of test are no series of an interface: at one phase angle G_Ic and the law act as one factor.
TEST(Energies, OfOneAngleInASeriesGiveOneToughnessWithANote) {
  const auto rows = [](const std::vector<std::pair<std::string, std::vector<double>>>& kinds) {
    std::string text = "G_I [J/m^2],G_II [J/m^2],test\n";
    for (const auto& [kind, shares] : kinds)
      for (std::size_t i = 0; i < 2 * shares.size(); ++i) {
        const double share = shares[i % shares.size()], Gc = 2 + 3 * share * share;
        text += shortest(Gc * (1 - share)) + "," + shortest(Gc * share) + "," + kind + "\n";
      }
    return load_text(text);
  };
  // some MMB tests of several shares do not make DCB and ENF tests interfaces of their own
  for (const std::vector<double>& mixed : {std::vector<double>{0.5}, std::vector<double>{0.25, 0.5, 0.75}}) {
    const Dataset data = rows({{"DCB", {0}}, {"MMB", mixed}, {"MMB2", {0.6}}, {"ENF", {1}}});
    const FitResult fit = fit_model(data, "bk", {.objective = Objective::curve, .free = {kToughness}});
    ASSERT_EQ(fit.parameters.size(), 3u);
    EXPECT_EQ(fit.parameters[2].name, "toughness");
    EXPECT_NEAR(*fit.parameters[2].value, 2, 1e-9);  // data of 16 digits
    EXPECT_NEAR(*fit.parameters[0].value, 2.5, 1e-9);
    EXPECT_NEAR(*fit.parameters[1].value, 2, 1e-9);
    EXPECT_NE(data.notes.back().text().find("all series share one G_Ic"), std::string::npos);
  }
  const Dataset apart = rows({{"dry", {0, 0.5, 1}}, {"wet", {0.1, 0.7}}});
  EXPECT_EQ(fit_model(apart, "bk", {.objective = Objective::curve, .free = {kToughness}}).parameters.size(), 4u);
  EXPECT_EQ(apart.notes.size(), 1u);  // on the toughness that is not stated
}

TEST(Energies, WithAStatedToughnessFitLambdaAlone) {
  const std::string text =
      "G_I [J/m^2],G_II [J/m^2],sigma_GI [J/m^2],sigma_GII [J/m^2],curve\n" + exact("c", {0.35}, 2, "");
  const FitResult fit = fit_model(load_text(text, "toughness = \"2 J/m^2\""), "c");
  ASSERT_EQ(fit.status, FitStatus::ok) << fit.message.text();
  ASSERT_EQ(fit.parameters.size(), 1u);
  EXPECT_NEAR(*fit.parameters[0].value, 0.35, 1e-12);  // data of 16 digits
}

/// The pooled fit has one lambda and both toughnesses, as the fits of each series have: their chi^2 differ by lambda's.
TEST(Energies, OfEachSeriesAreTestedWithAToughnessOfTheirOwn) {
  const std::string columns = "G_I [J/m^2],G_II [J/m^2],sigma_GI [J/m^2],sigma_GII [J/m^2],curve\n";
  const auto test = [&](double lambda_of_wet) {
    const PerCurve found =
        fit_per_curve(load_text(columns + exact("c", {0.35}, 2, "dry") + exact("c", {lambda_of_wet}, 5, "wet"),
                                "toughness = \"9 J/m^2\""),
                      "c", {.free = {kToughness}});
    EXPECT_EQ(found.curves[1].fit.parameters.size(), 2u);
    EXPECT_NEAR(*found.curves[1].fit.parameters[1].value, 5, 1e-9);  // data of 16 digits
    EXPECT_TRUE(found.test) << found.untested;
    return found.test.value();
  };
  EXPECT_EQ(test(0.36).freedom, 1);
  EXPECT_LT(test(0.45).p_value, 1e-6);
}

TEST(Energies, WithAnErrorOfSomePointsOnlyAreRefused) {
  const std::string columns = "G_I [J/m^2],G_II [J/m^2],sigma_GI [J/m^2],sigma_GII [J/m^2]\n";
  const auto refusal = [&](const std::string& rows) -> std::string {
    try {
      fit_model(load_text(columns + rows), "c", {.free = {kToughness}});
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(refusal("2,1,0.1,0.1\n1.5,2,,0.1\n1,3,0.1,0.1\n").find(":3:7: this point has no standard error sigma_GI"),
            std::string::npos);
  EXPECT_EQ(refusal("2,1,0.1,0.1\n1.5,2,0,0.1\n1,3,0.1,0.1\n"), "");
}

TEST(Energies, WithoutAToughnessAskForIt) {
  const Dataset data = pearson_and_york();
  try {
    fit_model(data, "c");
    ADD_FAILURE() << "was fitted";
  } catch (const InputError& error) {
    EXPECT_NE(error.text(cli::in_flags).find("--free=toughness"), std::string::npos) << error.what();
  }
}

TEST(Energies, RefuseConstantsThatOnlyLoadsHave) {
  EXPECT_THROW(fit_model(pearson_and_york(), "c", {.free = {kToughness, kModulus}}), InputError);
}

}  // namespace energies_test
}  // namespace mixity
