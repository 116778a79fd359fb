// Each objective on noise-free runs: what went in comes out, with constants of the experiment free, too.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "base/input_error.h"
#include "dataset/load_text.h"
#include "fitting/fit.h"
#include "fitting/prepare.h"
#include "fitting/synthetic_runs.h"

namespace mixity {
namespace fit_objectives_test {

const std::vector<Objective> kObjectives{Objective::toughness, Objective::curve};

FitOptions with(Objective objective, std::vector<Constant> free = {}) {
  return {.objective = objective,
          .free = std::move(free),
          .sigma_T = *parse_quantity("1%"),
          .sigma_A = *parse_quantity("1%"),
          .intervals = false};
}

class ExactRuns : public OfModel {};
INSTANTIATE_TEST_SUITE_P(OfLambda, ExactRuns, ::testing::Values("a", "b", "c"));

/// Areas are exact to 4e-15 and toughness to a few of that. What they leave of lambda is that over
/// dlnA/dlnlambda, which is of order one where the runs reach their fold, and 1e-2 where model a or b has none.
TEST_P(ExactRuns, GiveLambdaBackUnderEveryObjective) {
  for (const double lambda : {1e-4, 0.0023, 0.15, 0.5, 0.9})
    for (const Objective objective : kObjectives) {
      const FitResult fit = fit_model(synthetic_runs(key(), {lambda}, {-1, 0.5, 5, 30}, 8), key(), with(objective));
      EXPECT_EQ(fit.status, FitStatus::ok) << to_string(objective) << lambda << fit.message.text();
      ASSERT_TRUE(fit.parameters[0].value);
      // Model a at 1e-4 loses 1e-4 of its area, along an asymptote where the curve's T is known to 1e-8 only.
      const bool sliver = key() == "a" && lambda == 1e-4 && objective == Objective::curve;
      EXPECT_NEAR(*fit.parameters[0].value / lambda, 1, sliver ? 1e-4 : 1e-10) << to_string(objective) << lambda;
      EXPECT_EQ(fit.area->unpredicted, 0u);
    }
}

TEST(ExactRunsOfModel, GiveBothParametersOfTheTwoParameterLawBack) {
  const ParameterValues p{1.774, 2.284};
  for (const Objective objective : kObjectives) {
    const FitResult fit = fit_model(synthetic_runs("bk", p, {5}, 8, 0.95), "bk", with(objective));
    EXPECT_EQ(fit.status, FitStatus::ok) << to_string(objective) << fit.message.text();
    // 4e-15 times the condition of two correlated parameters, some 1e3
    EXPECT_NEAR(*fit.parameters[0].value, p[0], 1e-10) << to_string(objective);
    EXPECT_NEAR(*fit.parameters[1].value, p[1], 1e-10) << to_string(objective);
  }
}

/// The same contact, described with a toughness and a modulus that are wrong by these factors.
Dataset misdescribed(const Dataset& right, double toughness, double modulus) {
  Dataset data = right;
  for (Point& p : data.points)
    p = {p.line, p.curve, p.P / toughness, p.T / toughness, p.A * std::pow(modulus / toughness, 2.0 / 3)};
  for (double& P : data.curve_loads) P /= toughness;
  return data;
}

TEST_P(ExactRuns, GiveToughnessAndModulusBackWhenTheyAreFree) {
  for (const double lambda : {0.0023, 0.15, 0.9}) {
    // constants stated 10 % too large and 20 % too small
    const Dataset data = misdescribed(synthetic_runs(key(), {lambda}, {-1, 0.5, 30}, 6), 1.1, 0.8);
    const FitResult fit = fit_model(data, key(), with(Objective::curve, {kToughness, kModulus}));
    EXPECT_EQ(fit.status, FitStatus::ok) << lambda << fit.message.text();
    ASSERT_EQ(fit.parameters.size(), 3u);
    ASSERT_TRUE(fit.parameters[0].value) << lambda;
    // as above, times the condition of three correlated parameters
    EXPECT_NEAR(*fit.parameters[0].value / lambda, 1, 1e-9) << lambda;
    EXPECT_NEAR(*fit.parameters[1].value * 1.1, 1, 1e-9) << lambda;
    EXPECT_NEAR(*fit.parameters[2].value * 0.8, 1, 1e-9) << lambda;
    ASSERT_EQ(fit.correlations.size(), 9u);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(fit.correlations[4 * k], 1, 1e-14);
  }
}

/// A rate-dependent adhesive sticks at tensions that its stated toughness would not bear: half of it, here.
TEST_P(ExactRuns, GiveToughnessBackWhereTheStatedOneWouldHavePulledOff) {
  const Dataset data = misdescribed(synthetic_runs(key(), {0.15}, {-3.5, -1, 0.5, 2.5}, 6), 0.5, 1);
  ASSERT_LT(above_pull_off(data.points[0].P), 0);
  const FitResult fit = fit_model(data, key(), with(Objective::curve, {kToughness}));
  EXPECT_EQ(fit.status, FitStatus::ok) << fit.message.text();
  ASSERT_TRUE(fit.parameters[0].value);
  EXPECT_NEAR(*fit.parameters[0].value / 0.15, 1, 1e-9);  // as above
  EXPECT_NEAR(*fit.parameters[1].value * 0.5, 1, 1e-9);
}

/// Held at a toughness that is too small, the model predicts nothing for these points: they are named, the rest fitted.
TEST(PointsBelowPullOff, AreLeftOutOfAFitOfCurves) {
  Dataset data = synthetic_runs("c", {0.15}, {1, 5}, 6);
  const FitResult without = fit_model(data, "c", with(Objective::curve));
  data.points.push_back({14, 0, -5, 0.1, 3});
  const FitResult fit = fit_model(data, "c", with(Objective::curve));
  EXPECT_EQ(fit.status, FitStatus::ok) << fit.message.text();
  EXPECT_NEAR(*fit.parameters[0].value, *without.parameters[0].value, 1e-10);  // as above
  ASSERT_EQ(fit.excluded.size(), 1u);
  EXPECT_EQ(fit.excluded[0].line, 14u);
  EXPECT_EQ(fit.excluded[0].reason, kBelowPullOff);
}

/// Offsets, too: loads read 0.3 too small and areas 0.4 too large.
TEST_P(ExactRuns, GiveOffsetsBackWhenTheyAreFree) {
  Dataset data = synthetic_runs(key(), {0.15}, {1, 5, 30}, 8);
  for (Point& p : data.points) p = {p.line, p.curve, p.P - 0.3, p.T, p.A + 0.4};
  const FitResult fit = fit_model(data, key(), with(Objective::curve, {kLoadOffset, kAreaOffset}));
  EXPECT_EQ(fit.status, FitStatus::ok) << fit.message.text();
  EXPECT_NEAR(*fit.parameters[0].value, 0.15, 1e-10);  // as above
  EXPECT_NEAR(*fit.parameters[1].value, 0.3, 1e-9);
  EXPECT_NEAR(*fit.parameters[2].value, -0.4, 1e-9);
}

/// Under one load without adhesion-free points every constant scales A(T) alike: freeing all of them at once leaves a
/// direction that no area feels.
TEST(ExactRunsOfModel, OfOneLoadDoNotIdentifyEveryConstantAtOnce) {
  SeededNoise noise(3, 0.003);
  const Dataset data = synthetic_runs("c", {0.15}, {0.0}, 20, 0.8, noise);
  // P = 0, model c: A(T) = A0 g(lambda (T/G)^2), A0 ~ (G/E)^(2/3), so that lambda and toughness act as one with E free
  const FitResult fit = fit_model(data, "c", with(Objective::curve, {kToughness, kModulus}));
  EXPECT_EQ(fit.status, FitStatus::not_identifiable);
  EXPECT_NE(fit.message.text().find("lambda and toughness and modulus independently"), std::string::npos)
      << fit.message.text();
  for (const FittedParameter& parameter : fit.parameters) EXPECT_FALSE(parameter.value);
}

/// The same file in other units and the same numbers in SI: every result agrees.
TEST(ExactRunsOfModel, UnitsDoNotMatter) {
  std::string milli = "P [mN],T [mN],A [mm^2]\n", micro = "P [µN],T [µN],A [µm^2]\n";
  const Contact contact{0.01, 2e6, 0.03};
  SeededNoise noise(4, 0.01);
  for (const Point& p : synthetic_runs("c", {0.15}, {0.5, 5}, 12, 0.85, noise).points) {
    const double force = contact.force_unit() * 1e3, area = contact.area_unit() * 1e6;
    const auto line = [&](double scale, double square) {
      char text[200];
      std::snprintf(text, sizeof text, "%.17g,%.17g,%.17g\n", p.P * force * scale, p.T * force * scale,
                    p.A * area * square);
      return std::string(text);
    };
    milli += line(1, 1);
    micro += line(1e3, 1e6);
  }
  const char* metadata =
      "radius = \"10 mm\"\nmodulus = \"2 MPa\"\ntoughness = \"30 mJ/m^2\"\nprovenance = \"measured\"\n";
  const Dataset one = load_text(milli, metadata), other = load_text(micro, metadata);
  for (const Objective objective : kObjectives) {
    FitOptions options = with(objective, {kToughness});
    options.intervals = true;
    options.sigma_A = *parse_quantity("0.003 mm^2");
    const FitResult a = fit_model(one, "c", options), b = fit_model(other, "c", options);
    ASSERT_EQ(a.status, FitStatus::ok) << a.message.text();
    ASSERT_EQ(b.status, FitStatus::ok) << b.message.text();
    for (std::size_t k = 0; k < 2; ++k) {
      // Data differ by roundings; the ends of intervals are found to 1e-10 of their distance.
      EXPECT_NEAR(*a.parameters[k].value / *b.parameters[k].value, 1, 1e-11) << to_string(objective);
      EXPECT_NEAR(*a.parameters[k].stderr_ / *b.parameters[k].stderr_, 1, 1e-9) << to_string(objective);
      EXPECT_NEAR(*a.parameters[k].interval->low / *b.parameters[k].interval->low, 1, 1e-9);
      EXPECT_NEAR(*a.parameters[k].interval->high / *b.parameters[k].interval->high, 1, 1e-9);
    }
    EXPECT_NEAR(a.area->rmse * 1e6, b.area->rmse, 1e-9 * b.area->rmse);
  }
}

/// Objective toughness, weighted: noise that grows with psi counts less, and equal errors count alike.
TEST(ExactRunsOfModel, WeightsOfEqualSizeChangeNothing) {
  Dataset data =
      load_text("psi [deg],Gc_over_GIc,sigma_Gc\n0,1,0.1\n20,1.11,0.111\n40,1.4,0.14\n60,2.3,0.23\n75,3.3,0.33\n");
  const FitResult plain = fit_model(data, "c", {.intervals = false});
  const FitResult weighted = fit_model(data, "c", {.weighted = true, .intervals = false});
  ASSERT_EQ(weighted.status, FitStatus::ok) << weighted.message.text();
  // every ln f has the error 0.1; the sigma column's roundings
  EXPECT_NEAR(*plain.parameters[0].value, *weighted.parameters[0].value, 1e-12);
  EXPECT_NEAR(*plain.r2, *weighted.r2, 1e-12);
  EXPECT_NEAR(*plain.rmse * 10, *weighted.rmse, 1e-12);
}

/// A fit of a constant alone, with the model held, is a fit like any other.
TEST(Freed, AConstantIsFoundWithTheModelHeld) {
  const Dataset data = misdescribed(synthetic_runs("c", {0.15}, {0.5, 5, 20}), 1.1, 1);
  for (const Objective objective : kObjectives) {
    FitOptions options = with(objective, {kToughness});
    options.hold = {{"lambda", 0.15}};
    const FitResult fit = fit_model(data, "c", options);
    EXPECT_EQ(fit.status, FitStatus::ok) << to_string(objective) << fit.message.text();
    ASSERT_TRUE(fit.parameters[1].value) << to_string(objective);
    EXPECT_NEAR(*fit.parameters[1].value * 1.1, 1, 1e-10);  // as above
  }
}

/// With a constant free, toughness is fitted in ln f, with weights or without; Gc/GIc is refused, not silently dropped.
TEST(Freed, AConstantRefusesAnotherScaleOfToughness) {
  const Dataset data = synthetic_runs("c", {0.15}, {0.5, 5, 20});
  FitOptions options = with(Objective::toughness, {kToughness});
  EXPECT_EQ(fit_model(data, "c", options).status, FitStatus::ok);
  options.scale = Scale::linear;
  EXPECT_THROW(fit_model(data, "c", options), InputError);
  options.scale = Scale::log;
  options.weighted = true;
  EXPECT_EQ(fit_model(data, "c", options).status, FitStatus::ok);
}

/// What is of the other objective is refused under curve, also where that is so by default.
TEST(Curve, RefusesTheScaleAndTheWeightsOfToughness) {
  const Dataset data = synthetic_runs("c", {0.15}, {0.5, 5, 20});
  EXPECT_EQ(fit_model(data, "c").objective, Objective::curve);
  EXPECT_THROW(fit_model(data, "c", {.scale = Scale::linear}), InputError);
  EXPECT_THROW(fit_model(data, "c", {.weighted = true}), InputError);
  const Dataset angles = load_text("psi [deg],Gc_over_GIc\n0,1\n20,1.11\n40,1.4\n60,2.3\n");
  EXPECT_EQ(fit_model(angles, "c").objective, Objective::toughness);
  EXPECT_THROW(fit_model(angles, "c", {.objective = Objective::curve}), InputError);
}

/// The paper's fit of the same points stands beside every fit of curves, whatever is free in that.
TEST(Curve, HasThePapersFitBesideIt) {
  SeededNoise noise(6, 0.01);
  const Dataset data = synthetic_runs("c", {0.15}, {0.5, 5, 20}, 20, 0.9, noise);
  const FitResult paper = fit_model(data, "c", {.objective = Objective::toughness});
  EXPECT_FALSE(paper.paper);
  for (const std::vector<Constant>& free : {std::vector<Constant>{}, std::vector<Constant>{kToughness}}) {
    const FitResult fit = fit_model(data, "c", with(Objective::curve, free));
    ASSERT_TRUE(fit.paper);
    EXPECT_EQ(fit.paper->status, FitStatus::ok);
    ASSERT_EQ(fit.paper->parameters.size(), 1u);
    // the kernel's minimum and Ceres', both to roundings of the gradient
    EXPECT_NEAR(*fit.paper->parameters[0].value, *paper.parameters[0].value, 1e-12);
    EXPECT_NEAR(*fit.paper->r2, *paper.r2, 1e-12);
    EXPECT_EQ(fit.paper->points, data.points.size());
  }
}

TEST(Fit, OfAnUnknownModelIsAnError) {
  EXPECT_THROW(fit_model(synthetic_runs("c", {0.15}, {5}), "d"), std::invalid_argument);
}

/// The last loads are those of the folds, to the last digit, where A at given T has a slope without bound.
TEST(ExactRunsOfModel, ThatEndAtTheFoldAreExactUnderCurve) {
  for (const double lambda : {0.2673491, 0.0695609, 0.9920213, 1.885382e-4}) {
    const Dataset data = synthetic_runs("c", {lambda}, {-2, 3.8811}, 3, 1.0);
    const FitResult fit = fit_model(data, "c", with(Objective::curve));
    EXPECT_EQ(fit.status, FitStatus::ok) << lambda << ": " << fit.message.text();
    ASSERT_TRUE(fit.parameters[0].value);
    EXPECT_NEAR(*fit.parameters[0].value / lambda, 1, 1e-10);  // as above: the fold's T is exact to some eps
  }
}

}  // namespace fit_objectives_test
}  // namespace mixity
