// The budget of a fit against refits: with priors moved, with constants changed, with constants free.
#include "fitting/budget.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
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
  ASSERT_EQ(fit.budget->exact.size(), kConstantNames.size() - 1);  // approach_offset is of held approaches
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

/// A linear problem of two fitted parameters and two constants, whose rows are evaluated in parts.
class RowsInParts : public Problem {
 public:
  static constexpr std::size_t kRows = 300, kColumns = 4;
  explicit RowsInParts(std::size_t parts, bool known_errors) : parts_(parts), known_errors_(known_errors) {
    SeededNoise noise(4, 1.0);
    for (double& one : jacobian_) one = noise();
    for (std::size_t i = 0; i < kRows; ++i) jacobian_[i * kColumns + 3] += 0.7 * jacobian_[i * kColumns + 2];
    for (double& one : residuals_) one = noise();
    for (const char* const name : {"lambda", "modulus", "load_offset", "force_gain"})
      parameters_.push_back({name, -10, 10, 0.0});
    parameters_[1].prior = 0.2;
  }
  std::size_t residual_count() const override { return kRows; }
  const std::vector<FreeParameter>& parameters() const override { return parameters_; }
  bool evaluate(std::span<const double>, std::span<double> r, std::span<double> J) const override {
    std::ranges::copy(residuals_, r.begin());
    if (!J.empty()) std::ranges::copy(jacobian_, J.begin());
    return true;
  }
  std::size_t parts() const override { return parts_; }
  bool evaluate_part(std::size_t part, std::span<const double>, std::vector<double>& r,
                     std::vector<double>& J) const override {
    const auto rows = [&](const auto& all, std::size_t width) {
      const std::size_t begin = part * kRows / parts_, end = (part + 1) * kRows / parts_;
      return std::vector<double>(all.begin() + static_cast<std::ptrdiff_t>(begin * width),
                                 all.begin() + static_cast<std::ptrdiff_t>(end * width));
    };
    r = rows(residuals_, 1);
    J = rows(jacobian_, kColumns);
    return true;
  }
  double data_norm() const override { return 1; }
  bool known_errors() const override { return known_errors_; }

 private:
  std::size_t parts_;
  bool known_errors_;
  std::array<double, kRows> residuals_;
  std::array<double, kRows * kColumns> jacobian_;
  std::vector<FreeParameter> parameters_;
};

TEST(Budget, OfSeveralPartsIsThatOfOne) {
  for (const bool known : {true, false}) {
    const auto budget = [&](std::size_t parts) {
      return error_budget(RowsInParts(parts, known), {0.1, 0.02, 0, 0}, 0.5, {false, false}, {{2, 0.01}, {3, 0.05}});
    };
    const auto whole = budget(1);
    ASSERT_TRUE(whole && whole->scatter && whole->exact.size() == 2);
    for (const std::size_t parts : {2u, 7u}) {
      const auto summed = budget(parts);
      ASSERT_TRUE(summed && summed->scatter);
      // sums of 300 terms in another order
      const auto same = [](double a, double b) { EXPECT_NEAR(a, b, 1e-12 * (1 + std::abs(b))); };
      same(*summed->scatter, *whole->scatter);
      same(summed->independent, whole->independent);
      ASSERT_EQ(summed->parts.size(), 1u);
      same(summed->parts[0].share, whole->parts[0].share);
      for (std::size_t k = 0; k < 2; ++k) {
        ASSERT_TRUE(summed->exact[k].score && whole->exact[k].score);
        const auto &a = *summed->exact[k].score, &b = *whole->exact[k].score;
        same(*summed->exact[k].effect, *whole->exact[k].effect);
        same(a.fall, b.fall);
        same(a.value, b.value);
        same(a.p_value, b.p_value);
        same(a.change, b.change);
        same(a.widening, b.widening);
      }
    }
  }
}

}  // namespace budget_test
}  // namespace mixity
