// What a fit says of jumps, and how well.
#include "fitting/prediction.h"

#include <gtest/gtest.h>

#include "fitting/fit.h"
#include "fitting/synthetic_runs.h"

namespace mixity {
namespace prediction_test {

const std::vector<Control> kControls{{Control::Kind::load}, {Control::Kind::displacement}};

/// Model c jumps at T = S0/sqrt(lambda), y = 3 pi.
TEST(FoldPredictions, OfModelCHaveTheErrorOfTheirFormula) {
  SeededNoise noise(3, 0.01);
  const Dataset data = synthetic_runs("c", {0.15}, {1, 4, 9}, 12, 0.8, [&] { return noise(); });
  const FitOptions options;
  const FitResult fit = fit_model(data, "c", options);
  const FittedParameter& lambda = fit.parameters[0];
  const FoldsPrediction predicted = predict_folds_of(data, fit, options, 4, kControls);
  ASSERT_EQ(predicted.folds.size(), 2u);
  const double T = circle_radius(4.0) / std::sqrt(*lambda.value);
  EXPECT_NEAR(*predicted.folds[0].T.value, T, 1e-12 * T);
  // differences are right to the square of their step, a thousandth of an error
  EXPECT_NEAR(*predicted.folds[0].T.standard_error, T * *lambda.stderr_ / *lambda.value / 2, 1e-6 * T);
  EXPECT_NEAR(*predicted.folds[0].A.standard_error, 0, 1e-8);  // the jump starts at the same area for every lambda
  EXPECT_TRUE(predicted.folds[0].on_loading);
  EXPECT_EQ(predicted.folds[1].control.kind, Control::Kind::displacement);
  EXPECT_GT(*predicted.folds[1].u.standard_error, 0);
  EXPECT_NE(predict_folds_of(data, fit, options, -5, kControls).problem.find("pull-off"), std::string::npos);
}

/// Laboratories whose modulus is not quite what they state: T and A of the jump as they would read them.
TEST(FoldPredictions, HoldTheTruthAsOftenAsTheyClaim) {
  constexpr int kLaboratories = 200;
  const double lambda = 0.15, P = 4, sigma = 0.03;
  SeededNoise noise(11, 0.01), constants(12, sigma);
  FitOptions options;
  options.intervals = false;
  int T_held = 0, A_held = 0;
  for (int i = 0; i < kLaboratories; ++i) {
    const double larger = std::exp(-2.0 / 3 * constants());  // areas in units of the modulus as stated
    Dataset data = synthetic_runs("c", {lambda}, {1, P, 9}, 12, 0.8, [&] { return larger * (1 + noise()) - 1; });
    data.contact = Contact{1, 1, 1};
    data.metadata.radius = data.metadata.modulus = data.metadata.toughness = 1;
    data.metadata.standard_errors["modulus"] = sigma;
    const FitResult fit = fit_model(data, "c", options);
    const FoldsPrediction predicted = predict_folds_of(data, fit, options, P, {{Control::Kind::load}});
    ASSERT_EQ(predicted.folds.size(), 1u);
    const auto holds = [](const Derived& number, double truth) {
      return std::abs(*number.value - truth) < 1.96 * *number.standard_error;
    };
    T_held += holds(predicted.folds[0].T, circle_radius(P) / std::sqrt(lambda));
    A_held += holds(predicted.folds[0].A, larger * area_from_radius(radius_from_edge_load(3 * pi<double>(), P)));
  }
  // 95 % of 200, four standard deviations of a binomial about it
  EXPECT_NEAR(T_held, 190, 12);
  EXPECT_NEAR(A_held, 190, 12);
}

}  // namespace prediction_test
}  // namespace mixity
