// Fits of data whose approach is held. The readings of the first tests come from the equations in SI units on a dense
// grid of radii, which shares no code with the program: P = (2 E a Delta - 2/3 E a^3/R)/(1 + 2 E a/k), y = 4/3 E a^3/R
// - P, lambda T^2 = 8 pi E G a^3 - y^2 for model c.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "base/input_error.h"
#include "dataset/arrays.h"
#include "fitting/curve_objective.h"
#include "fitting/fit.h"
#include "fitting/prediction.h"
#include "fitting/problem_checks.h"
#include "fitting/toughness_objective.h"

namespace mixity {
namespace held_approach_fit_test {

constexpr double kR = 9.42e-3, kE = 2.133e6, kG = 27e-3, kLambda = 0.05;

struct Reading {
  double T, A, P;
};

/// States along the stable branch, at equal steps of T up to `reach` of its end.
std::vector<Reading> brute_force(double approach, double stiffness, std::size_t n, double reach) {
  std::vector<double> T, a, P;
  for (int i = 400000; i > 0; --i) {
    const double one = 6e-4 * i / 400000,
                 load = (2 * kE * one * approach - 2.0 / 3 * kE * one * one * one / kR) /
                        (1 + (stiffness > 0 ? 2 * kE * one / stiffness : 0)),
                 y = 4.0 / 3 * kE * one * one * one / kR - load,
                 square = 8 * std::numbers::pi * kE * kG * one * one * one - y * y;
    if (!(square > 0)) continue;
    const double shear = std::sqrt(square / kLambda);
    if (!T.empty() && shear < T.back()) break;
    T.push_back(shear);
    a.push_back(one);
    P.push_back(load);
  }
  std::vector<Reading> list;
  std::size_t k = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double shear = reach * T.back() * static_cast<double>(i) / static_cast<double>(n - 1);
    while (k + 2 < T.size() && T[k + 1] < shear) ++k;
    const double share = std::clamp((shear - T[k]) / (T[k + 1] - T[k]), 0.0, 1.0),
                 one = a[k] + share * (a[k + 1] - a[k]);
    list.push_back({shear, std::numbers::pi * one * one, P[k] + share * (P[k + 1] - P[k])});
  }
  return list;
}

struct Experiment {
  double stiffness = 0;  // N/m; 0: rigid
  double zero = 0;       // m, added to the readings of delta
  double of_P = 0;       // N, noise of readings of P; 0: none are read
  double noise = 0.004;  // of T, as a share of the largest, and of A
  unsigned seed = 1;
  Overrides more{};
};

Dataset data_of(const Experiment& by) {
  std::mt19937 random(by.seed);
  std::normal_distribution<double> normal;
  std::vector<double> delta, T, A, P;
  for (const double approach : {3e-6, 8e-6, 15e-6}) {
    const auto readings = brute_force(approach, by.stiffness, 30, 0.9);
    for (const Reading& one : readings) {
      delta.push_back((approach + by.zero) * 1e6);
      T.push_back((one.T + by.noise * readings.back().T * normal(random)) * 1e3);
      A.push_back(one.A * (1 + by.noise * normal(random)) * 1e6);
      P.push_back((one.P + by.of_P * normal(random)) * 1e3);
    }
  }
  std::vector<ArrayColumn> columns{{"delta [um]", delta}, {"T [mN]", T}, {"A [mm^2]", A}};
  if (by.of_P > 0) columns.push_back({"P [mN]", P});
  Overrides constants{
      {"radius", "9.42 mm"}, {"modulus", "2.133 MPa"}, {"toughness", "27 mJ/m^2"}, {"control", "approach"}};
  if (by.stiffness > 0) constants.emplace_back("normal_stiffness", "1.2 kN/m");
  constants.insert(constants.end(), by.more.begin(), by.more.end());
  return make_dataset("held", columns, constants);
}

double value_of(const FitResult& fit, std::string_view name) { return *find_parameter(fit.parameters, name)->value; }

/// Of 400,000 radii: lambda is found to the error of their interpolation.
TEST(FitOfHeldApproach, FindsTheTruthOfReadingsWithoutNoise) {
  for (const double stiffness : {0.0, 1200.0}) {
    const FitResult fit = fit_model(data_of({.stiffness = stiffness, .noise = 0}), "c", {});
    ASSERT_TRUE(fit.has_values()) << fit.message.text();
    EXPECT_NEAR(value_of(fit, "lambda") / kLambda, 1, 1e-5) << stiffness;
  }
}

TEST(FitOfHeldApproach, FindsTheTruthOfNoisyReadingsWithinItsInterval) {
  std::size_t inside = 0, all = 0;
  for (const double stiffness : {0.0, 1200.0})
    for (const double of_P : {0.0, 5e-5})
      for (unsigned seed = 1; seed <= 5; ++seed) {
        const FitResult fit = fit_model(data_of({.stiffness = stiffness, .of_P = of_P, .seed = seed}), "c", {});
        ASSERT_TRUE(fit.has_values());
        const auto& interval = *fit.parameters[0].interval;
        inside += *interval.low <= kLambda && kLambda <= *interval.high;
        ++all;
        EXPECT_NEAR(value_of(fit, "lambda") / kLambda, 1, 0.02);
        if (of_P > 0) {
          EXPECT_EQ(fit.axes, fit.used.size());  // a residual of P for each point
        }
      }
  EXPECT_GE(inside, all - 4);  // of 20 intervals of 95 %, more than 4 miss once in 400
}

TEST(FitOfHeldApproach, FindsTheZeroOfTheApproachAsAConstantWithAPrior) {
  const Dataset data = data_of({.zero = -0.4e-6, .more = {{"approach_offset", "0 +/- 0.3 um"}}});
  const FitResult fit = fit_model(data, "c", {});
  ASSERT_TRUE(fit.has_values());
  EXPECT_NEAR(value_of(fit, "approach_offset"), 0.4, 0.02);  // um
  EXPECT_NEAR(value_of(fit, "lambda") / kLambda, 1, 0.02);
  ASSERT_TRUE(fit.budget);
  EXPECT_EQ(fit.budget->parts.front().constant, "approach_offset");
}

/// Without the prior, the score test names the offset.
TEST(FitOfHeldApproach, NamesAWrongZero) {
  const FitResult fit = fit_model(data_of({.zero = -1.5e-6}), "c", {});
  EXPECT_NE(fit.status, FitStatus::ok);
  EXPECT_NE(fit.message.text().find("approach_offset looks wrong"), std::string::npos) << fit.message.text();
  FitOptions free;
  free.free = {kApproachOffset};
  EXPECT_NEAR(value_of(fit_model(data_of({.zero = -1.5e-6}), "c", free), "approach_offset"), 1.5, 0.03);
}

/// All parameters and constants, of distances in T, A and P, and of the toughness.
/// Readings without P allow another modulus, too; those of P tell that it is the stiffness.
TEST(FitOfHeldApproach, NamesAWrongStiffness) {
  for (const double stiffness : {800.0, 1800.0})  // 1200 N/m is stated
    for (const double of_P : {0.0, 5e-5}) {
      const FitResult fit = fit_model(data_of({.stiffness = stiffness, .of_P = of_P}), "c", {});
      EXPECT_EQ(fit.status, FitStatus::suspect) << stiffness;
      const auto named = std::find_if(fit.explanations.begin(), fit.explanations.end(),
                                      [](const Explanation& one) { return one.cause == "normal_stiffness"; });
      ASSERT_NE(named, fit.explanations.end()) << fit.message.text();
      EXPECT_NEAR(*named->first.value / kLambda, 1, 0.05) << fit.message.text();
      EXPECT_NE(fit.message.text().find("normal_stiffness looks wrong: at "), std::string::npos);
    }
  EXPECT_EQ(fit_model(data_of({.stiffness = 1200}), "c", {}).status, FitStatus::ok);
}

TEST(FitOfHeldApproach, HasTheJacobianOfItsDifferences) {
  for (const char* key : {"a", "b", "c"})
    for (const double compliance : {0.0, 0.2})
      for (const bool loads : {false, true}) {
        const ContactModel model = ContactModel::find(key)->at_held_approach(compliance);
        const ParameterValues p{0.15};
        std::vector<MeasuredPoint> points;
        std::vector<MeasuredAxes> read;
        SeededNoise noise(3, 0.02);
        for (const double approach : {-0.3, 2.0, 9.0})
          for (const double T : {0.0, 2.0, 5.0, 8.0}) {
            double A = 0;
            EquilibriumStatus status{};
            model.areas_at(p, approach, {&T, 1}, {&A, 1}, {&status, 1});
            if (status != EquilibriumStatus::ok) continue;
            PointPlace place;
            place.order = approach / 20;
            place.stretch = T / 10;
            place.unsheared = T == 0;
            points.push_back({approach, T + 0.1 + noise(), A * (1.02 + noise()), 0.2, 0.02 * A, place});
            read.push_back({model.load(approach, radius_from_area(A)) + 0.1 + noise(), 0.15, 0});
          }
        ASSERT_GT(points.size(), 6u);
        MeasuredPoints measured(points);
        if (loads) measured.axes = std::make_shared<const std::vector<MeasuredAxes>>(read);
        const FreeChoice choice = everything_free(model);
        const std::string where = std::string(key) + (compliance > 0 ? " soft" : " rigid") + (loads ? " with P" : "");
        for (const Constants& c : kSomeConstants) {
          std::vector<double> x = solver_point(p, c, true);
          const CurveObjective curve(measured, choice);
          // the offset of P acts on its residuals alone
          if (loads) expect_jacobian(curve, x, 1e-6, where);
          if (loads) continue;
          FreeChoice without(model,
                             {p,
                              [] {
                                Constants held{};
                                held.approach_held = true;
                                return held;
                              }()},
                             {});
          x.assign(p.begin(), p.end());
          for (const Constant one : kAllConstants)
            if (one != kLoadOffset) {
              without.add(one, {std::string(kConstantNames[one]), -1, 1, 0.0});
              x.push_back(c[one]);
            }
          expect_jacobian(CurveObjective(points, without), x, 1e-7, where);
          expect_jacobian(ToughnessOfLoads(points, without), x, 1e-7, where);
        }
      }
}

TEST(FitOfHeldApproach, PredictsItsFoldsWithErrors) {
  const Dataset data = data_of({});
  const FitResult fit = fit_model(data, "c", {});
  const FoldsPrediction folds =
      predict_folds_of(data, fit, {}, data.curve_loads[1], {{Control::Kind::load}, {Control::Kind::displacement}});
  ASSERT_TRUE(folds.problem.empty()) << folds.problem;
  ASSERT_GE(folds.folds.size(), 2u);
  const double end = brute_force(8e-6, 0, 3, 1).back().T / data.contact->force_unit();
  EXPECT_NEAR(*folds.folds[0].T.value / end, 1, 0.01);
  EXPECT_GT(*folds.folds[0].T.standard_error, 0);
}

TEST(FitOfHeldApproach, RefusesWhatDoesNotApply) {
  const Dataset data = data_of({});
  FitOptions options;
  options.free = {kLoadOffset};
  EXPECT_THROW(fit_model(data, "c", options), InputError);
  EXPECT_THROW(fit_model(data, "c-ellipse", {}), InputError);
  options.free = {};
  options.bootstrap.replicates = 20;
  EXPECT_THROW(fit_model(data_of({.of_P = 1e-4}), "c", options), InputError);
}

}  // namespace held_approach_fit_test
}  // namespace mixity
