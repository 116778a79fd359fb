// The two conventions of mode III at the edge of a circular contact.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "averaged_mode_III.h"
#include "dataset/arrays.h"
#include "dataset/temporary_folder.h"
#include "fitting/curve_objective.h"
#include "fitting/fit.h"
#include "fitting/predicted_curves.h"
#include "fitting/prediction.h"
#include "fitting/problem_checks.h"
#include "fitting/sahli.h"
#include "fitting/toughness_objective.h"

namespace mixity {
namespace mode_III_test {

const Overrides kAveraged{{"mode_III", "averaged"}}, kHalf{{"mode_III", "half"}};

/// T, and its error, times a factor.
Dataset runs(const std::string& model, double lambda, double kappa, const Overrides& constants, double factor = 1,
             double noise = 0, double shear_offset = 0) {
  std::vector<double> P, T, A, sigma_T, sigma_A;
  SeededNoise random(5, noise);
  for (const double load : {0.5, 4.0, 12.0})
    for (int i = 0; i < 12; ++i) {
      const double longest = model == "c" ? 0.9 * std::sqrt(3 * pi<double>() * (3 * pi<double>() + 2 * load) / lambda)
                                          : 4 * std::sqrt(10 + load);
      const double shear = longest / std::sqrt(kappa) * i / 11;
      P.push_back(load);
      T.push_back(factor * (shear - shear_offset + 0.1 * random()));
      A.push_back(averaged_area(model, lambda, kappa, load, shear) * (1 + 0.01 * random()));
      sigma_T.push_back(factor * 0.1);
      sigma_A.push_back(0.01 * A.back());
    }
  return make_dataset("runs", {{"P", P}, {"T", T}, {"A", A}, {"sigma_T", sigma_T}, {"sigma_A", sigma_A}}, constants);
}

FitResult fit(const Dataset& data, const std::string& model, const FitOptions& options = {}) {
  return fit_model(data, model, options);
}

double lambda_of(const FitResult& fit) { return *fit.parameters[0].value; }

/// Areas are good to 1e-15 of their size, 1e-13 of their error; lambda follows to 1e-11 of a value of order 0.1.
constexpr double kExact = 1e-10;

TEST(ModeIII, AveragedFindsTheParameterOfTheAveragedCriterion) {
  for (const auto& [model, lambda] : {std::pair("a", 0.3), std::pair("b", 0.4), std::pair("c", 0.2)})
    for (const Objective objective : {Objective::curve, Objective::toughness})
      EXPECT_NEAR(lambda_of(fit(runs(model, lambda, 1.5, kAveraged), model, {.objective = objective})), lambda, kExact)
          << model;
}

TEST(ModeIII, AveragedIsRefusedForEllipsesWhoseModesActApart) {
  const Dataset data = runs("c", 0.2, 1.5, kAveraged);
  const std::string message = input_error([&] { fit(data, "c-ellipse"); });
  EXPECT_NE(message.find("an ellipse has each where it acts: fit it with --mode_III=half"), std::string::npos)
      << message;
}

TEST(ModeIII, HalfFindsAParameterOfModelCThatIsOneAndAHalfTimesTheAveragedOne) {
  const Dataset half = runs("c", 0.2, 1.5, kHalf), averaged = runs("c", 0.2, 1.5, kAveraged);
  const FitResult one = fit(half, "c"), other = fit(averaged, "c");
  EXPECT_NEAR(lambda_of(one), 1.5 * lambda_of(other), kExact);
  EXPECT_NEAR(*one.r2, *other.r2, kExact);
  EXPECT_NEAR(*one.area->r2, *other.area->r2, kExact);
  const std::vector<double> P(9, 4.0), T{0, 1, 3, 6, 9, 12, 15, 16, 30};
  const auto areas = predict_areas_of(half, one, {}, P, T), same = predict_areas_of(averaged, other, {}, P, T);
  for (std::size_t i = 0; i < T.size(); ++i) {
    EXPECT_EQ(areas[i].status, same[i].status) << T[i];
    // dA/dlambda reaches some 300 next to the fold
    EXPECT_NEAR(areas[i].A, same[i].A, 300 * kExact) << T[i];
  }
  const std::vector<Control> controls{
      {Control::Kind::load}, {Control::Kind::displacement}, {Control::Kind::stiffness, 30}};
  const auto folds = predict_folds_of(half, one, {}, 4, controls).folds,
             same_folds = predict_folds_of(averaged, other, {}, 4, controls).folds;
  ASSERT_EQ(folds.size(), 3u);
  ASSERT_EQ(same_folds.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(*folds[i].T.value, *same_folds[i].T.value, 300 * kExact);
    EXPECT_NEAR(*folds[i].u.value, *same_folds[i].u.value, 300 * kExact);
    EXPECT_NEAR(*folds[i].A.value, *same_folds[i].A.value, 300 * kExact);
  }
  // T_T = sqrt(3 pi (3 pi + 2 P)/lambda) in the shear of the equations, which is sqrt(1.5) times the true one
  EXPECT_NEAR(*same_folds[0].T.value, std::sqrt(3 * pi<double>() * (3 * pi<double>() + 8) / (1.5 * 0.2)), 300 * kExact);
  EXPECT_LT(folds[0].psi, same_folds[0].psi);  // another phase angle, of the same state
}

/// The limits are far above kExact, to which a fit of the right convention finds lambda.
TEST(ModeIII, TheConventionsOfModelsAAndBDescribeDifferentAreas) {
  for (const auto& [model, lambda] : {std::pair("a", 0.3), std::pair("b", 0.4)}) {
    const FitResult half = fit(runs(model, lambda, 1.5, kHalf), model);
    EXPECT_GT(std::abs(lambda_of(half) - lambda), 0.1) << model;
    EXPECT_GT(std::abs(lambda_of(half) - 1.5 * lambda), 0.01) << model;
    EXPECT_GT(1 - *half.r2, 1e-7) << model;
    EXPECT_LT(1 - *fit(runs(model, lambda, 1.5, kAveraged), model).r2, 1e-20) << model;
  }
}

TEST(ModeIII, PoissonsRatioEnters) {
  for (const auto& [nu, kappa] : {std::pair("0", 1.0), std::pair("0.3", 1.7 / 1.4), std::pair("0.5", 1.5)}) {
    const Overrides stated{{"mode_III", "averaged"}, {"poisson_ratio", nu}};
    EXPECT_NEAR(lambda_of(fit(runs("c", 0.2, kappa, stated), "c")), 0.2, kExact) << nu;
    EXPECT_NEAR(lambda_of(fit(runs("c", 0.2, kappa, kAveraged), "c")), 0.2 * kappa / 1.5, kExact) << nu;
  }
}

/// Noisy data with mode III averaged are those with sqrt(1.5) times the shear and mode III by half: the same equations.
/// The fits stop where they are converged to 1e-8 of an error or better.
TEST(ModeIII, AveragedIsTheFitToLargerShears) {
  const double weight = std::sqrt(1.5);
  FitOptions options;
  options.free = {kShearOffset};
  for (const char* model : {"a", "b", "c", "bk"}) {
    const Dataset averaged = runs("b", 0.4, 1.5, kAveraged, 1, 1, 0.4),
                  larger = runs("b", 0.4, 1.5, kHalf, weight, 1, 0.4);
    const FitResult one = fit(averaged, model, options), other = fit(larger, model, options);
    const auto expect_near = [&](double value, double expected, const char* what) {
      EXPECT_NEAR(value, expected, 1e-6 * std::abs(expected) + 1e-12) << model << ' ' << what;
    };
    ASSERT_TRUE(has_all_values(one) && has_all_values(other)) << model;
    EXPECT_EQ(one.status, other.status);
    expect_near(one.sum_of_squares, other.sum_of_squares, "sum of squares");
    for (std::size_t k = 0; k < one.parameters.size(); ++k) {
      const double factor = one.parameters[k].name == "shear_offset" ? weight : 1;
      expect_near(factor * *one.parameters[k].value, *other.parameters[k].value, "value");
      if (one.parameters[k].stderr_)
        expect_near(factor * *one.parameters[k].stderr_, *other.parameters[k].stderr_, "error");
    }
    const auto jump = predict_jump_of(averaged, one, options, 4), same = predict_jump_of(larger, other, options, 4);
    ASSERT_EQ(jump.has_value(), same.has_value());
    if (jump) {
      expect_near(weight * *jump->T.value, *same->T.value, "T of the jump");
      expect_near(weight * *jump->u.value, *same->u.value, "u of the jump");
      expect_near(weight * *jump->T.standard_error, *same->T.standard_error, "error of T");
      expect_near(*jump->A.value, *same->A.value, "A of the jump");
    }
    const DrawnCurve drawn = drawn_curve(averaged, options, one, 4, 10),
                     same_drawn = drawn_curve(larger, options, other, 4, 10 * weight);
    ASSERT_EQ(drawn.points.size(), same_drawn.points.size());
    for (std::size_t i = 0; i < drawn.points.size(); ++i) {
      // 1e-5: the offset of a point near T = 0 is a difference of two numbers that are good to 1e-6
      EXPECT_NEAR(weight * drawn.points[i].T, same_drawn.points[i].T, 1e-5);
      EXPECT_NEAR(weight * drawn.points[i].u, same_drawn.points[i].u, 1e-5);
      EXPECT_NEAR(drawn.points[i].A, same_drawn.points[i].A, 1e-5);
    }
    for (std::size_t i = 0; i < averaged.points.size(); ++i)
      expect_near(averaged.toughness(i)->psi(), larger.toughness(i)->psi(), "psi");
  }
}

/// u = 3/4 T/a at every place of a drawn curve, of the true T.
TEST(ModeIII, TheDisplacementIsThatOfTheTrueShear) {
  const Dataset data = runs("c", 0.2, 1.5, kAveraged);
  for (const DrawnPoint& q : drawn_curve(data, {}, fit(data, "c"), 4, 10).points)
    EXPECT_NEAR(q.u, 0.75 * q.T / radius_from_area(q.A), 1e-12);  // a few roundings of numbers up to 10
}

/// In A = A0 - alpha T^2 the next order is a thousandth of alpha at a tenth of the largest shear.
TEST(ModeIII, TheSensitivityToShearIsThatOfTheReadings) {
  for (const SahliRun& run : fit_sahli(runs("c", 0.2, 1.5, kAveraged), 0.1, "c", {0.2}).runs)
    EXPECT_NEAR(run.alpha, *run.alpha_predicted, 5e-3 * run.alpha);
}

TEST(ModeIII, StatedOffsetsAreOfTheReadings) {
  Overrides stated = kAveraged;
  for (const auto& one : Overrides{{"radius", "9.42 mm"}, {"modulus", "2.133 MPa"}, {"toughness", "27 mJ/m^2"}})
    stated.push_back(one);
  const Contact contact{9.42e-3, 2.133e6, 27e-3};
  Dataset plain = runs("c", 0.2, 1.5, kAveraged);
  std::vector<double> P, T, A;
  for (const Point& q : plain.points) {
    P.push_back(q.P * contact.force_unit());
    T.push_back(q.T * contact.force_unit() - 2e-4);
    A.push_back(q.A * contact.area_unit());
  }
  stated.emplace_back("shear_offset", "0.2 mN");
  const Dataset data = make_dataset("offset", {{"P [N]", P}, {"T [N]", T}, {"A [m^2]", A}}, stated);
  EXPECT_NEAR(lambda_of(fit(data, "c")), 0.2, kExact);
  // the true shear, without the weight
  const Dataset right = corrected(data);
  for (std::size_t i = 0; i < plain.points.size(); ++i) EXPECT_NEAR(right.points[i].T, plain.points[i].T, 1e-12);
  EXPECT_NEAR(lambda_of(fit(right, "c")), 0.2, kExact);
}

/// As in the tests of both objectives without a weight, which justify the tolerance.
TEST(ModeIII, JacobiansMatchDifferences) {
  for (const std::string& key : published_keys()) {
    const ContactModel model = model_named(key);
    for (const ParameterValues& p : typical_cases(model))
      for (const Constants& c : kSomeConstants) {
        const FreeChoice choice = everything_free(model, std::sqrt(1.5));
        std::vector<MeasuredPoint> points = points_off(key, p, 0.02, 0.7);
        expect_jacobian(CurveObjective(points, choice), solver_point(p, c), 1e-8, key);
        expect_jacobian(ToughnessOfLoads(points, choice), solver_point(p, c), 1e-8, key);
      }
  }
}

}  // namespace mode_III_test
}  // namespace mixity
