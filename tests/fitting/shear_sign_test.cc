// Equilibrium depends on T^2: whatever is fitted or estimated knows nothing of the sign of a point's shear.
#include <gtest/gtest.h>

#include "fitting/fit.h"
#include "fitting/predicted_area.h"
#include "fitting/sahli.h"
#include "fitting/synthetic_runs.h"

namespace mixity {
namespace shear_sign_test {

Dataset runs() {
  SeededNoise noise(7, 0.005);
  return synthetic_runs("c", {0.3}, {1.0, 4.0}, 15, 0.9, [&] { return noise(); });
}

/// The same with the sign of every third shear changed.
Dataset with_signs(Dataset data) {
  for (std::size_t i = 0; i < data.points.size(); i += 3) data.points[i].T *= -1;
  return data;
}

void expect_same(const FitResult& one, const FitResult& other) {
  ASSERT_TRUE(one.parameters[0].value && other.parameters[0].value) << one.message.text() << other.message.text();
  EXPECT_EQ(one.status, other.status);
  for (std::size_t k = 0; k < one.parameters.size(); ++k) {
    EXPECT_EQ(*one.parameters[k].value, *other.parameters[k].value);
    EXPECT_EQ(one.parameters[k].stderr_, other.parameters[k].stderr_);
  }
  EXPECT_EQ(one.residuals, other.residuals);
  ASSERT_TRUE(one.area && other.area);
  EXPECT_EQ(one.area->rmse, other.area->rmse);
  ASSERT_EQ(one.area->areas.size(), other.area->areas.size());
  for (std::size_t i = 0; i < one.area->areas.size(); ++i) {
    ASSERT_EQ(one.area->predicts(i), other.area->predicts(i)) << i;
    EXPECT_TRUE(!one.area->predicts(i) || one.area->areas[i] == other.area->areas[i]) << i;
  }
}

TEST(ShearSign, DoesNotChangeAFit) {
  const Dataset data = runs(), other = with_signs(data);
  for (const char* model : {"a", "c"})
    for (const Objective objective : {Objective::toughness, Objective::curve}) {
      FitOptions options;
      options.objective = objective;
      expect_same(fit_model(data, model, options), fit_model(other, model, options));
      options.free = {kToughness};
      expect_same(fit_model(data, model, options), fit_model(other, model, options));
    }
}

TEST(ShearSign, DoesNotChangeAWeightedFit) {
  const Dataset data = runs(), other = with_signs(data);
  for (const Scale scale : {Scale::log, Scale::linear}) {
    FitOptions options;
    options.objective = Objective::toughness;
    options.scale = scale;
    options.weighted = true;
    options.sigma_T = *parse_quantity("2%");
    options.sigma_A = *parse_quantity("1%");
    expect_same(fit_model(data, "c", options), fit_model(other, "c", options));
  }
}

TEST(ShearSign, DoesNotChangeStandardErrorsAndParabolas) {
  const Dataset data = runs(), other = with_signs(data);
  const StandardErrors errors = standard_errors(data, {}, {}), of_other = standard_errors(other, {}, {});
  EXPECT_EQ(errors.T, of_other.T);
  EXPECT_EQ(errors.A, of_other.A);
  EXPECT_EQ(errors.scatter, of_other.scatter);
  const SahliResult parabolas = fit_sahli(data, 0.5, "", {}), of_others = fit_sahli(other, 0.5, "", {});
  ASSERT_EQ(parabolas.runs.size(), 2);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(parabolas.runs[i].points, of_others.runs[i].points);
    EXPECT_EQ(parabolas.runs[i].alpha, of_others.runs[i].alpha);
    EXPECT_EQ(parabolas.runs[i].A0, of_others.runs[i].A0);
  }
}

TEST(ShearSign, PointsThatDifferInItAloneAreOne) {
  Dataset data = runs();
  data.points.resize(1);
  data.points[0].T = 3;
  data.points.push_back(data.points[0]);
  data.points[1].T = -3;
  EXPECT_EQ(fit_model(data, "c").status, FitStatus::not_identifiable);
}

TEST(Fit, OfToughnessListsPointsWithoutAPhaseAngle) {
  Dataset data = runs();
  data.points[4].A = area_from_radius(hertz_radius(data.points[4].P));
  for (const Objective objective : {Objective::toughness, Objective::curve}) {
    FitOptions options;
    options.objective = objective;
    const FitResult fit = fit_model(data, "c", options);
    const std::size_t left_out = objective == Objective::toughness ? 1 : 0;
    EXPECT_EQ(fit.used.size(), data.points.size() - left_out);
    ASSERT_EQ(fit.excluded.size(), left_out);
    if (left_out == 0) continue;
    EXPECT_EQ(fit.excluded[0].line, data.points[4].line);
    EXPECT_EQ(fit.excluded[0].reason, kNoPhaseAngle);
  }
}

}  // namespace shear_sign_test
}  // namespace mixity
