// Readings that are off by what the metadata state give the numbers of right readings.
#include <gtest/gtest.h>

#include "dataset/check.h"
#include "fitting/fit.h"
#include "fitting/misread_data.h"
#include "fitting/sahli.h"

namespace mixity {
namespace corrected_readings_test {

/// Corrections round a few times; of numbers of order one.
constexpr double kRounding = 1e-11;

TEST(CorrectedReadings, HaveThePhaseAnglesAndToughnessesOfRightOnes) {
  const Dataset right = mergel();
  for (const auto& [constant, data] : misread_mergel())
    for (std::size_t i = 0; i < right.points.size(); ++i) {
      const auto one = right.toughness(i), other = data.toughness(i);
      ASSERT_EQ(one.has_value(), other.has_value()) << constant << ' ' << i;
      if (!one) continue;
      EXPECT_NEAR(other->psi(), one->psi(), kRounding) << constant << ' ' << i;
      EXPECT_NEAR(other->ratio / one->ratio, 1, 1e3 * kRounding)
          << constant << ' ' << i;  // f ~ 1/y^2, y is a difference
    }
}

TEST(CorrectedReadings, AreFittedAsRightOnes) {
  const Dataset right = mergel();
  for (const Objective objective : {Objective::toughness, Objective::curve})
    for (const std::optional<Scale> scale : {std::optional<Scale>{}, std::optional(Scale::linear)}) {
      if (objective == Objective::curve && scale) continue;
      FitOptions options;
      options.objective = objective;
      options.scale = scale;
      if (objective == Objective::curve) {  // errors that do not follow the readings
        options.sigma_T = StatedError{0.05, *parse_unit("mN")};
        options.sigma_A = StatedError{0.5, *parse_unit("%")};
      }
      const FitResult one = fit_model(right, "c", options);
      for (const auto& [constant, data] : misread_mergel()) {
        if (constant == "area_offset" && objective == Objective::curve) continue;  // its errors follow the readings
        const FitResult other = fit_model(data, "c", options);
        EXPECT_EQ(other.used, one.used) << constant;
        EXPECT_NEAR(*other.parameters[0].value / *one.parameters[0].value, 1, 1e-7) << constant;  // of a minimum
        EXPECT_NEAR(*other.r2, *one.r2, objective == Objective::curve ? 1e-3 : 1e-9) << constant;
        EXPECT_EQ(other.status, one.status) << constant;
      }
    }
}

TEST(CorrectedReadings, AreWeighedAsRightOnes) {
  const Dataset right = mergel();
  FitOptions options;
  options.objective = Objective::toughness;
  options.weighted = true;
  options.sigma_T = StatedError{0.05, *parse_unit("mN")};
  options.sigma_A = StatedError{0.5, *parse_unit("%")};
  const FitResult one = fit_model(right, "c", options);
  for (const auto& [constant, data] : misread_mergel()) {
    if (constant == "area_offset") continue;
    const FitResult other = fit_model(data, "c", options);
    EXPECT_NEAR(*other.parameters[0].value / *one.parameters[0].value, 1, 1e-7) << constant;
    EXPECT_NEAR(*other.r2, *one.r2, 1e-9) << constant;
  }
}

TEST(CorrectedReadings, RaiseTheQuestionsOfRightOnes) {
  const auto right = find_oddities(mergel());
  for (auto& [constant, data] : misread_mergel()) {
    data.notes.clear();  // of the file as it was read
    EXPECT_EQ(find_oddities(data), right) << constant;
  }
}

TEST(CorrectedReadings, HaveTheParabolasOfRightOnes) {
  const SahliResult right = fit_sahli(mergel(), 0.5, "c", {0.0023});
  for (const auto& [constant, data] : misread_mergel()) {
    const SahliResult other = fit_sahli(data, 0.5, "c", {0.0023});
    ASSERT_EQ(other.runs.size(), right.runs.size()) << constant;
    for (std::size_t i = 0; i < right.runs.size(); ++i) {
      EXPECT_NEAR(other.runs[i].alpha / right.runs[i].alpha, 1, 1e-7) << constant;
      EXPECT_NEAR(*other.runs[i].alpha_predicted / *right.runs[i].alpha_predicted, 1, 1e-9) << constant;
    }
  }
}

}  // namespace corrected_readings_test
}  // namespace mixity
