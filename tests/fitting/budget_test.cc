// The budget of a fit against refits: with priors moved, with constants changed, with constants free.
#include "fitting/budget.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fitting/fit.h"
#include "fitting/measured_runs.h"

namespace mixity {
namespace budget_test {

/// As measured, with these standard errors of the constants.
Dataset measured(std::map<std::string, double, std::less<>> errors = {}) { return measured_runs(3, std::move(errors)); }

double lambda_of(const FitResult& fit) { return fit.parameters[0].value.value(); }

/// Each part of the variance is what one standard error of its prior moves lambda by, squared.
TEST(Budget, PartsAreWhatAStandardErrorOfEachPriorDoes) {
  const Dataset data = measured({{"modulus", 4e4}, {"toughness", 1.5e-3}, {"load_offset", 3e-5}});
  const FitResult fit = fit_model(data, "c", stated_errors());
  ASSERT_TRUE(fit.budget && fit.budget->scatter) << fit.message.text();
  ASSERT_EQ(fit.budget->parts.size(), 3u);
  const double variance = std::pow(*fit.parameters[0].stderr_, 2);
  double sum = *fit.budget->scatter;
  for (const BudgetPart& part : fit.budget->parts) {
    const auto with_mean = [&](double errors) {
      Dataset moved = data;
      // a factor on the constant is the same as one on the unit that its prior counts from
      if (part.constant == "load_offset") {
        moved.metadata.load_offset = errors * 3e-5;
      } else {
        const double error = part.constant == "modulus" ? 0.02 : 0.05, factor = std::exp(errors * error);
        Contact contact = *data.contact;
        (part.constant == "modulus" ? contact.modulus : contact.toughness) *= factor;
        for (Point& point : moved.points) {
          point.P *= data.contact->force_unit() / contact.force_unit();
          point.T *= data.contact->force_unit() / contact.force_unit();
          point.A *= data.contact->area_unit() / contact.area_unit();
        }
        moved.contact = contact;
        moved.metadata.modulus = contact.modulus;
        moved.metadata.toughness = contact.toughness;
        moved.metadata.standard_errors["modulus"] = 0.02 * contact.modulus;
        moved.metadata.standard_errors["toughness"] = 0.05 * contact.toughness;
      }
      return lambda_of(fit_model(moved, "c", stated_errors()));
    };
    const double move = 0.5 * (with_mean(1) - with_mean(-1));
    // a step of one standard error bends by its square
    EXPECT_NEAR(part.share, move * move / variance, 0.02 * part.share + 1e-4) << part.constant;
    sum += part.share;
  }
  EXPECT_NEAR(sum, 1, 1e-9);  // rounding of a matrix with correlations of 0.99
}

TEST(Budget, EffectOfAnExactConstantIsThatOfARefit) {
  const Dataset data = measured();
  const FitResult fit = fit_model(data, "c", stated_errors());
  ASSERT_TRUE(fit.budget);
  ASSERT_EQ(fit.budget->exact.size(), kConstantNames.size());
  for (const ExactConstant& one : fit.budget->exact) {
    const auto found = std::find(kConstantNames.begin(), kConstantNames.end(), one.constant);
    const auto constant = static_cast<Constant>(found - kConstantNames.begin());
    // a hundredth of the step, so that the curve does not bend
    const auto with = [&](double share) {
      FitOptions options = stated_errors();
      options.constants.emplace();
      (*options.constants)[constant] = share * (is_factor(constant)   ? std::log(1.05)
                                                : is_change(constant) ? one.step
                                                                      : one.step / data.display.area_scale);
      if (constant == kLoadOffset || constant == kShearOffset)
        (*options.constants)[constant] = share * one.step / data.display.force_scale;
      return lambda_of(fit_model(data, "c", options));
    };
    // Gauss-Newton leaves out the curvature times the residuals, of a few percent, and of hysteresis, without shear and
    // so without lambda, all there is: less than a hundredth of a standard error
    const double tolerance =
        0.05 * std::abs(*one.effect) + (constant == kHysteresis ? 0.01 * *fit.parameters[0].stderr_ : 0);
    EXPECT_NEAR(*one.effect, 50 * (with(0.01) - with(-0.01)), tolerance) << one.constant;
  }
}

/// Close to the minimum chi^2 is a parabola: the score test says what a fit with the constant free would find.
TEST(Budget, ScoreIsWhatChiSquareFallsByIfTheConstantIsFree) {
  Dataset data = measured();
  for (Point& point : data.points) point.P += 0.05;  // the load cell reads too much
  const FitResult fit = fit_model(data, "c", stated_errors());
  for (const ExactConstant& one : fit.budget->exact) {
    ASSERT_TRUE(one.score) << one.constant;
    const auto found = std::find(kConstantNames.begin(), kConstantNames.end(), one.constant);
    FitOptions options = stated_errors();
    options.free = {static_cast<Constant>(found - kConstantNames.begin())};
    const FitResult free = fit_model(data, "c", options);
    EXPECT_NEAR(one.score->fall, fit.sum_of_squares - free.sum_of_squares, 0.15 * one.score->fall + 0.1)
        << one.constant;
    const double error = *free.parameters[1].stderr_;
    EXPECT_NEAR(one.score->value, *free.parameters[1].value, 0.5 * error) << one.constant;
  }
}

}  // namespace budget_test
}  // namespace mixity
