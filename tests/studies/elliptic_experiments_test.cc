// Fits of elliptic contacts to simulated experiments.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "dataset/arrays.h"
#include "fitting/consistency.h"
#include "fitting/fit.h"
#include "fitting/prediction.h"
#include "mechanics/contact_model.h"
#include "studies/simulate.h"

namespace mixity {
namespace elliptic_experiments_test {

Plan plan_of(const std::string& model, std::vector<double> parameters) {
  Plan plan;
  plan.model = model;
  plan.parameters = std::move(parameters);
  plan.constants.radius = 9.42e-3;
  plan.constants.modulus = 2.133e6;
  plan.constants.toughness = 0.027;
  plan.constants.poisson_ratio = 0.5;
  plan.loads = {0.5e-3, 1.5e-3, 4e-3};
  plan.points = 25;
  plan.reach = 0.95;
  plan.sigma_T = *parse_quantity("0.5%");
  plan.sigma_A = *parse_quantity("0.4%");
  return plan;
}

/// The axes at a load that was not measured, with errors that the deviations of other experiments have.
TEST(EllipticExperiments, PredictAxesWithTheirErrors) {
  const Plan plan = plan_of("c-ellipse", {0.02, 0.005, 0.5});
  const Dataset data = simulate(plan, 1, std::nullopt);
  const double unit = data.contact->force_unit(), P = 2e-3 / unit, T = 30e-3 / unit;
  const std::vector<double> p{0.02, 0.005, 0.5};
  const ContactModel model = *ContactModel::find("c-ellipse");
  const EllipseState truth = model.ellipses(*model.ends_of(p), P, {&T, 1}).at[0];
  ASSERT_EQ(truth.status, EquilibriumStatus::ok);
  double squares = 0;
  constexpr int kExperiments = 20;
  for (int k = 0; k < kExperiments; ++k) {
    const Dataset noisy = simulate(plan, 10 + static_cast<std::uint64_t>(k), 0);
    const auto found = predict_areas_of(noisy, fit_model(noisy, "c-ellipse"), {}, {&P, 1}, {&T, 1});
    ASSERT_TRUE(found[0].a.value && found[0].a.standard_error && found[0].b.standard_error);
    squares += std::pow((*found[0].a.value - truth.a) / *found[0].a.standard_error, 2) +
               std::pow((*found[0].b.value - truth.b) / *found[0].b.standard_error, 2);
  }
  // the mean of 40 squares, in pairs that correlate, scatters by less than 0.35 about 1
  EXPECT_NEAR(squares / (2 * kExperiments), 1, 0.9);
  const auto of_circle = predict_areas_of(data, fit_model(data, "c"), {}, {&P, 1}, {&T, 1});
  EXPECT_FALSE(of_circle[0].a.value);
}

/// The standard errors are those of the file: without noise the fit must find the truth.
TEST(EllipticExperiments, FindsBothCouplingsFromAxesWithoutNoise) {
  for (const auto& [model, p] : std::vector<std::pair<std::string, std::vector<double>>>{
           {"c-ellipse", {0.02, 0.005, 0.5}}, {"b-ellipse", {0.3, 0.1, 0.5}}, {"c-ellipse-equal", {0.02, 0.5}}}) {
    const FitResult fit = fit_model(simulate(plan_of(model, p), 1, std::nullopt), model);
    for (std::size_t k = 0; k + 1 < p.size(); ++k) {
      ASSERT_TRUE(fit.parameters[k].value) << model << fit.message.text();
      EXPECT_NEAR(*fit.parameters[k].value / p[k], 1, 1e-6) << model << k;
    }
    EXPECT_TRUE(fit.parameters.back().held);
    EXPECT_EQ(fit.axes, fit.used.size());
    EXPECT_EQ(fit.freedom(), 2 * fit.used.size() - p.size() + 1);
  }
}

/// A tie that the axes contradict is named, not the errors or a constant.
TEST(EllipticExperiments, NameBothCouplingsWhereTheTieIsWrong) {
  const Dataset data = simulate(plan_of("c-ellipse", {0.02, 0.005, 0.5}), 3, 0);
  FitOptions held;
  held.hold = {{"lambda_III", 0.0}};
  for (const FitResult& fit : {fit_model(data, "c-ellipse-equal"), fit_model(data, "c-ellipse", held)}) {
    EXPECT_EQ(fit.status, FitStatus::suspect);
    EXPECT_TRUE(fit.message.text().starts_with("the couplings differ: without the tie lambda_II = 0.0"))
        << fit.message.text();
  }
  held.hold = {{"lambda_III", 0.005}};
  EXPECT_EQ(fit_model(data, "c-ellipse", held).status, FitStatus::ok);
}

/// Where no errors are stated, those of the axes come from residuals that a wrong tie makes large.
TEST(EllipticExperiments, NameBothCouplingsWhereTheTieIsWrongAndNoErrorIsStated) {
  FitOptions held;
  held.hold = {{"lambda_III", 0.0}};
  for (const std::uint64_t i : {0, 1, 2}) {
    Dataset data = simulate(plan_of("c-ellipse", {0.02, 0.005, 0.5}), 3, i);
    data.errors.clear();
    for (PointAxes& axes : data.axes) axes = {axes.q, std::numeric_limits<double>::quiet_NaN(), 0};
    for (const FitResult& fit : {fit_model(data, "c-ellipse-equal"), fit_model(data, "c-ellipse", held)}) {
      EXPECT_EQ(fit.status, FitStatus::suspect);
      EXPECT_TRUE(fit.message.text().starts_with("the couplings differ: without the tie lambda_II = 0.0"))
          << fit.message.text();
    }
    EXPECT_EQ(fit_model(data, "c-ellipse").status, FitStatus::ok);
  }
}

/// The axes tell lambda_III/(1 - nu): with nu held at another value than the data's, another lambda_III is named.
TEST(EllipticExperiments, KeepOtherHeldValuesWhereTheTieIsWrong) {
  const Dataset data = simulate(plan_of("c-ellipse", {0.02, 0.005, 0.5}), 3, std::nullopt);
  FitOptions held;
  held.hold = {{"lambda_III", 0.0}, {"poisson_ratio", 0.25}};
  const FitResult fit = fit_model(data, "c-ellipse", held);
  EXPECT_EQ(fit.status, FitStatus::suspect);
  EXPECT_NE(fit.message.text().find("lambda_II = 0.02 and lambda_III = 0.0075 describe"), std::string::npos)
      << fit.message.text();
}

/// Without stated errors, those of the axes come from their scatter, which is 0 here.
TEST(EllipticExperiments, OfAxesThatAreAllEqualFindACircle) {
  Dataset data = simulate(plan_of("c-ellipse", {0.02, 0.01, 0.5}), 3, 0);
  data.errors.clear();
  for (PointAxes& axes : data.axes) axes = {0, std::numeric_limits<double>::quiet_NaN(), 0};
  const FitResult fit = fit_model(data, "c-ellipse");
  EXPECT_EQ(fit.status, FitStatus::ok) << fit.message.text();
  EXPECT_NEAR(fit.errors->axes_factor / kLeastError, 1, 0.01);
  EXPECT_NEAR(*fit.parameters[1].value / *fit.parameters[0].value, 0.5, 1e-4);
  EXPECT_NEAR(*fit.parameters[0].value, 0.02, 4 * *fit.parameters[0].stderr_);
}

/// chi^2 of 2 x 12 deviations from the truth in standard errors: beyond 60 by chance in 1 of 15,000.
TEST(EllipticExperiments, HasErrorsAsLargeAsTheDeviations) {
  const std::vector<double> p{0.02, 0.005, 0.5};
  double squares = 0;
  int covered = 0;
  for (std::uint64_t i = 0; i < 12; ++i) {
    const FitResult fit = fit_model(simulate(plan_of("c-ellipse", p), 11, i), "c-ellipse");
    ASSERT_EQ(fit.status, FitStatus::ok) << fit.message.text();
    for (std::size_t k = 0; k < 2; ++k) {
      const FittedParameter& one = fit.parameters[k];
      squares += std::pow((*one.value - p[k]) / *one.stderr_, 2);
      covered += *one.interval->low <= p[k] && p[k] <= *one.interval->high;
    }
  }
  EXPECT_LT(squares, 60);
  EXPECT_GE(covered, 19);  // of 24 intervals of 95 %; fewer by chance in 1 of 1,000
}

/// White noise of five runs: the runs do not differ, neighbours do not correlate, and what five runs scatter by chance
/// does not widen an interval (by more than half in a third of such experiments, where it may).
TEST(EllipticExperiments, OfFiveRunsAreThoseOfWhiteNoise) {
  Plan plan = plan_of("c-ellipse", {0.13, 0.066, 0.5});
  plan.loads = {0.5e-3, 1e-3, 1.5e-3, 2.5e-3, 4e-3};
  plan.points = 20;
  plan.sigma_A = *parse_quantity("0.5%");
  int widened = 0;
  for (const std::uint64_t i : {0, 1, 2, 3, 4, 5, 6, 7, 11, 15}) {
    const FitResult fit = fit_and_test(simulate(plan, 1, i), "c-ellipse", {});
    EXPECT_EQ(fit.status, FitStatus::ok) << i << fit.message.text();
    EXPECT_FALSE(fit.errors->correlations.any()) << i;
    widened += fit.parameters[0].interval->method == "jackknife";
  }
  EXPECT_LE(widened, 1);
}

TEST(EllipticExperiments, OfAreasAloneIsOfTheSameCurve) {
  Dataset data = simulate(plan_of("c-ellipse", {0.02, 0.005, 0.5}), 1, std::nullopt);
  data.axes.clear();
  FitOptions options;
  options.hold = {*parse_held("lambda_III=0.005")};
  const FitResult fit = fit_model(data, "c-ellipse", options);
  EXPECT_EQ(fit.axes, 0u);
  EXPECT_NEAR(*fit.parameters[0].value / 0.02, 1, 1e-6) << fit.message.text();
}

TEST(EllipticExperiments, TakesPoissonsRatioWithItsError) {
  Plan plan = plan_of("c-ellipse", {0.02, 0.005, 0.45});
  plan.constants.poisson_ratio = 0.45;
  Dataset data = simulate(plan, 1, std::nullopt);
  const FitResult exact = fit_model(data, "c-ellipse");
  data.metadata.standard_errors["poisson_ratio"] = 0.02;
  const FitResult uncertain = fit_model(data, "c-ellipse");
  const FittedParameter &one = exact.parameters[1], &other = uncertain.parameters[1];
  EXPECT_NEAR(*one.value, *other.value, 1e-6);
  // lambda_III/(1 - nu) is what the axes tell: 0.02/0.55 of it are added in quadrature
  EXPECT_NEAR(*other.stderr_, std::hypot(*one.stderr_, 0.005 * 0.02 / 0.55), 1e-2 * *other.stderr_);
  EXPECT_TRUE(uncertain.parameters.back().prior);
}

TEST(EllipticExperiments, IsTheRemedyWhereACircleIsFittedToAnEllipse) {
  const Dataset data = simulate(plan_of("c-ellipse", {0.02, 0.002, 0.5}), 3, 0);
  FitResult circle = fit_model(data, "c");
  EXPECT_EQ(circle.status, FitStatus::suspect);
  ASSERT_TRUE(circle.consistency && circle.consistency->circle);
  EXPECT_LT(circle.consistency->circle->ratio, 0.99);
  EXPECT_NE(circle.message.text().find("the contact is no circle"), std::string::npos) << circle.message.text();
  EXPECT_EQ(fit_model(data, "c-ellipse").status, FitStatus::ok);

  const Dataset round = simulate(plan_of("c-ellipse", {0.02, 0.01, 0.5}), 3, 0);  // a circle: 0.01/(1 - 0.5)
  const FitResult fit = fit_model(round, "c");
  EXPECT_EQ(fit.status, FitStatus::ok) << fit.message.text();
  EXPECT_GT(fit.consistency->circle->p_value, 1e-3);
}

/// One run has another toughness: the search for the cause tries nothing that axes do not know.
TEST(EllipticExperiments, WithARunThatDiffersAreSuspect) {
  Dataset data = simulate(plan_of("c-ellipse", {0.02, 0.005, 0.5}), 5, 0);
  for (Point& point : data.points)
    if (point.curve == 1) point.A *= 1.03;
  FitOptions options;
  FitResult fit = fit_and_test(data, "c-ellipse", options);
  EXPECT_EQ(fit.status, FitStatus::suspect);
  find_cause(data, fit, options);
  EXPECT_EQ(fit.message.text().find("by_run"), std::string::npos) << fit.message.text();
}

}  // namespace elliptic_experiments_test
}  // namespace mixity
