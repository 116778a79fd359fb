#include "fitting/comparison.h"

#include <gtest/gtest.h>

#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>

#include "fitting/synthetic.h"
#include "fitting/synthetic_runs.h"

namespace mixity {
namespace comparison_test {

FitResult finished(std::size_t n, std::size_t parameters, double sum_of_squares, bool known) {
  FitResult fit;
  fit.status = FitStatus::ok;
  fit.parameters = {{"lambda", 0.3, 0.01, 0, 1}};
  fit.used = PointIndices(n);
  fit.residuals.resize(n);
  fit.free_parameters = parameters;
  fit.sum_of_squares = sum_of_squares;
  fit.known_errors = known;
  return fit;
}

TEST(Information, FollowsTheTextbookFormulas) {
  const double n = 20;
  // Errors known: the deviance is chi^2 and K = p = 2.
  const auto known = information(finished(20, 2, 25, true));
  ASSERT_TRUE(known && known->aicc);
  EXPECT_DOUBLE_EQ(known->aic, 25 + 4);
  EXPECT_DOUBLE_EQ(*known->aicc, 25 + 4 + 12.0 / 17);
  EXPECT_DOUBLE_EQ(known->bic, 25 + 2 * std::log(n));
  // Errors unknown: n ln(S/n), and their variance is one more parameter.
  const auto unknown = information(finished(20, 2, 25, false));
  ASSERT_TRUE(unknown && unknown->aicc);
  EXPECT_DOUBLE_EQ(unknown->aic, n * std::log(25 / n) + 6);
  EXPECT_DOUBLE_EQ(*unknown->aicc, n * std::log(25 / n) + 6 + 24.0 / 16);
  EXPECT_DOUBLE_EQ(unknown->bic, n * std::log(25 / n) + 3 * std::log(n));
}

TEST(Information, NeedsMorePointsThanParameters) {
  EXPECT_TRUE(information(finished(4, 1, 1, false))->aicc);
  EXPECT_FALSE(information(finished(3, 1, 1, false))->aicc);
  EXPECT_FALSE(information(finished(3, 2, 1, true))->aicc);
  FitResult without_value = finished(10, 1, 1, false);
  without_value.parameters[0].value.reset();
  EXPECT_FALSE(information(without_value));
  EXPECT_FALSE(information(finished(10, 1, 0, false)));  // exact data: ln 0
}

TEST(Information, IsNoneOfARobustLossInUnitsOfTheScatter) {
  FitResult robust = finished(20, 1, 25, false);
  robust.loss_scale = 0.1;
  EXPECT_FALSE(information(robust));
  robust.known_errors = true;  // the loss bends at the same place in each fit
  EXPECT_TRUE(information(robust));
}

Dataset noisy(unsigned seed, const std::vector<double>& loads = {0.5, 3, 10, 30}) {
  SeededNoise noise(seed, 0.005);
  return synthetic_runs("c", {0.15}, loads, 12, 0.85, noise);
}

FitOptions curve_options() {
  return {.objective = Objective::curve, .sigma_A = *parse_quantity("0.5%"), .intervals = false};
}

TEST(Comparison, WeightsSumToOneAndFollowAicc) {
  const Dataset data = noisy(1);
  std::vector<FitResult> fits;
  for (const char* model : {"a", "b", "c"}) fits.push_back(fit_model(data, model, curve_options()));
  const auto compared = compare_models(data, fits, curve_options());
  ASSERT_EQ(compared.size(), 3u);
  double sum = 0;
  for (const ComparedModel& m : compared) sum += m.weight.value();
  EXPECT_NEAR(sum, 1, 1e-15);  // three roundings
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(*compared[i].aicc, *information(fits[i])->aicc);
    EXPECT_EQ(*compared[i].bic, information(fits[i])->bic);
    const double ratio = std::exp(0.5 * (*compared[2].aicc - *compared[i].aicc));
    EXPECT_NEAR(*compared[i].weight, *compared[2].weight * ratio, 1e-12);  // roundings of an exponent of some hundred
  }
  EXPECT_GT(*compared[2].weight, 0.99);  // the model that made the data
  for (std::size_t i = 0; i < 2; ++i) EXPECT_LT(compared[2].left_out->rmse_area, compared[i].left_out->rmse_area);
}

TEST(Comparison, LeavesOutModelsFittedToOtherPoints) {
  Dataset data = noisy(2);
  std::vector<FitResult> fits;
  for (const char* model : {"c", "b"}) fits.push_back(fit_model(data, model, curve_options()));
  fits[1].used = PointIndices(fits[1].used.size() - 1);
  const auto compared = compare_models(data, fits, curve_options());
  EXPECT_EQ(*compared[0].weight, 1);
  EXPECT_FALSE(compared[1].weight);
  EXPECT_FALSE(compared[1].aicc);
}

/// By hand: one run at a time is left out, the rest fitted, the run predicted.
TEST(LeaveOneLoadOut, IsRefittingWithoutEachRun) {
  const Dataset data = noisy(3);
  for (const Objective objective : {Objective::toughness, Objective::curve}) {
    FitOptions options = curve_options();
    options.objective = objective;
    options.fitted_errors = false;  // those of the whole fit would go with the refits
    const auto found = leave_one_load_out(data, fit_model(data, "c", options), options);
    ASSERT_TRUE(found);
    double squares = 0;
    std::size_t beyond = 0;
    for (std::size_t run = 0; run < data.curves.size(); ++run) {
      std::vector<std::size_t> others;
      for (std::size_t i = 0; i < data.points.size(); ++i)
        if (data.points[i].curve != run) others.push_back(i);
      const FitResult fit = fit_model(data, "c", options, &others);
      ASSERT_EQ(fit.status, FitStatus::ok) << fit.message.text();
      const ParameterValues lambda{*fit.parameters[0].value};
      for (const Point& p : data.points) {
        if (p.curve != run) continue;
        const Equilibria found_at = model_named("c").equilibria(lambda, data.curve_loads[run], {&p.T, 1});
        const bool exists = found_at.at[0].status == EquilibriumStatus::ok;
        beyond += !exists;
        const double y = exists ? found_at.at[0].y : found_at.last->y_bottom;
        squares += std::pow(area_from_radius(radius_from_edge_load(y, p.P)) - p.A, 2);
      }
    }
    // The refits start from the whole fit's minimum and end at the same one, to its 1e-12 or so.
    EXPECT_NEAR(found->rmse_area, std::sqrt(squares / static_cast<double>(data.points.size())),
                1e-9 * found->rmse_area);
    EXPECT_EQ(found->beyond_fold, beyond);
  }
}

/// Of toughness model bk can be fitted where the law defines no equilibrium: that predicts no area, not one of 0.
TEST(LeaveOneLoadOut, SaysNothingWhereTheLawDefinesNoArea) {
  const Dataset data = synthetic_runs("c", {0.0023}, {1, 5, 20}, 20, 0.95);
  const FitOptions options{.objective = Objective::toughness};
  const FitResult fit = fit_model(data, "bk", options);
  ASSERT_TRUE(has_all_values(fit)) << fit.message.text();
  EXPECT_EQ(fit.status, FitStatus::suspect);  // it is another model's data
  EXPECT_FALSE(fit.area->obstacle.empty());
  EXPECT_EQ(fit.area->unpredicted, data.points.size());
  EXPECT_FALSE(leave_one_load_out(data, fit, options));
}

TEST(CompareModels, GivesEachAProbabilityByItsEvidence) {
  const Dataset data = noisy(4, {0.5, 5, 20});
  FitOptions options = curve_options();
  options.intervals = true;
  std::vector<FitResult> fits;
  for (const char* model : {"a", "b", "c"}) fits.push_back(fit_model(data, model, options));
  const std::vector<ComparedModel> compared = compare_models(data, fits, curve_options());
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_TRUE(compared[i].probability) << i;
    sum += *compared[i].probability;
    const double odds = *compared[i].probability / *compared[2].probability;
    EXPECT_NEAR(std::log(odds), fits[i].evidence->evidence.log_evidence - fits[2].evidence->evidence.log_evidence,
                1e-9 * std::abs(std::log(odds)) + 1e-9);
  }
  EXPECT_NEAR(sum, 1, 1e-12);
  fits[1].evidence.reset();
  const std::vector<ComparedModel> others = compare_models(data, fits, curve_options());
  EXPECT_FALSE(others[1].probability);
  EXPECT_NEAR(*others[0].probability + *others[2].probability, 1, 1e-12);
  fits[2].evidence.reset();
  EXPECT_FALSE(compare_models(data, fits, curve_options())[0].probability);
}

TEST(Probabilities, AreNoneWhereAModelWithoutEvidenceMayBeTheBest) {
  const auto with_evidence = [](double squares, double log_evidence) {
    FitResult fit = finished(50, 1, squares, true);
    fit.evidence.emplace();
    fit.evidence->evidence.log_evidence = log_evidence;
    return fit;
  };
  const FitResult a = with_evidence(120, -60), b = with_evidence(90, -45);
  for (const auto& one : probabilities({a, b, finished(50, 1, 50, true)})) EXPECT_FALSE(one);
  const auto beside_a_worse = probabilities({a, b, finished(50, 1, 150, true)});
  EXPECT_NEAR(beside_a_worse[0].value(), 1 / (1 + std::exp(15)), 1e-12);
  EXPECT_FALSE(beside_a_worse[2]);
}

TEST(Preferences, AgreeOnlyWhereEachCriterionNamesTheSameModel) {
  ComparedModel b{"b", 10.0, {}, 0.9, LeftOut{2, 0, {}}}, c{"c", 12.0, {}, 0.1, LeftOut{3, 0, {}}};
  EXPECT_TRUE(preferences({b, c}).agree());
  b.probability = 0.2;
  c.probability = 0.8;
  EXPECT_EQ(preferences({b, c}).evidence, std::vector<std::string>{"c"});
  EXPECT_FALSE(preferences({b, c}).agree());
  c.left_out.reset();  // one alone is no comparison
  EXPECT_TRUE(preferences({b, c}).left_out.empty());
}

/// One law under two names, its numbers equal but for rounding.
TEST(Preferences, OfEqualModelsAreTies) {
  const ComparedModel a{"a", 40.0, {}, 1e-9, LeftOut{9, 0, {}}, 1e-9},
      c{"c", 10.0, {}, 0.5, LeftOut{2, 0, {}}, 0.5 + 1e-9},
      linear{"linear", 10.0, {}, 0.5 + 1e-12, LeftOut{2 + 1e-12, 0, {}}, 0.5};
  const Preferences tied = preferences({a, c, linear});
  for (const auto& models : {tied.aicc, tied.evidence, tied.left_out})
    EXPECT_EQ(models, (std::vector<std::string>{"c", "linear"}));
  EXPECT_TRUE(tied.agree());
  ComparedModel better = c;
  better.left_out->rmse_area = 1;
  EXPECT_TRUE(preferences({a, better, linear}).agree());  // c is one of those that tie elsewhere
  better.probability = 0.1;
  EXPECT_FALSE(preferences({a, better, linear}).agree());
}

TEST(LeaveOneLoadOut, NeedsTwoRunsWithLoads) {
  const Dataset one = noisy(4, {3});
  EXPECT_FALSE(leave_one_load_out(one, fit_model(one, "c", curve_options()), curve_options()));
  const Dataset angles = synthetic("c", {0.3}, angles_up_to(1.2, 10));
  EXPECT_FALSE(leave_one_load_out(angles, fit_model(angles, "c"), {}));
}

TEST(LeaveOneLoadOut, LooksAtTwoHundredRunsAtMost) {
  std::vector<double> loads(201);
  for (std::size_t i = 0; i < loads.size(); ++i) loads[i] = 1 + 0.1 * static_cast<double>(i);
  const Dataset many = noisy(6, loads);
  EXPECT_FALSE(leave_one_load_out(many, fit_model(many, "c", curve_options()), curve_options()));
  loads.pop_back();
  const Dataset as_many = noisy(6, loads);
  EXPECT_TRUE(leave_one_load_out(as_many, fit_model(as_many, "c", curve_options()), curve_options()));
}

TEST(LeaveOneLoadOut, CountsWhatLiesBeyondTheFold) {
  Dataset data = noisy(5);
  // a point 20 % beyond the fold of its run, where only the fold's area can stand for the model's
  const double T = 1.2 * shear_to_lose_area("c", {0.15}, 3);
  data.points.push_back({60, 1, 3, T, 15});
  const auto found = leave_one_load_out(data, fit_model(data, "c", curve_options()), curve_options());
  ASSERT_TRUE(found);
  EXPECT_EQ(found->beyond_fold, 1u);
}

/// Runs of two lambdas, or of one.
Dataset runs_of(double first, double second, unsigned seed) {
  SeededNoise noise(seed, 0.005);
  Dataset data = empty_runs();
  for (const double lambda : {first, second})
    for (const double P : {2.0, 15.0}) add_run(data, "c", {lambda}, P, 12, 0.8, noise);
  return data;
}

TEST(PerCurve, TellsTwoLambdasFromOne) {
  for (const bool known : {true, false}) {
    FitOptions options{.objective = Objective::curve, .intervals = false};
    if (known) options.sigma_A = *parse_quantity("0.5%");
    int rejected = 0;
    for (unsigned seed = 1; seed <= 20; ++seed) {
      const PerCurve different = fit_per_curve(runs_of(0.15, 0.2, seed), "c", options);
      ASSERT_TRUE(different.test);
      EXPECT_EQ(different.test->chi_squared, known);
      EXPECT_LT(different.test->p_value, 1e-3) << seed;  // thirty percent of lambda are ten standard errors
      EXPECT_GT(*different.test->aicc_pooled, *different.test->aicc_separate);
      rejected += fit_per_curve(runs_of(0.15, 0.15, seed), "c", options).test->p_value < 0.05;
    }
    // One in twenty by chance: more than five in twenty has a probability of 3e-4.
    EXPECT_LE(rejected, 5) << known;
  }
}

TEST(PerCurve, TestIsThatOfItsFormula) {
  const Dataset data = runs_of(0.15, 0.16, 3);
  for (const bool known : {true, false}) {
    FitOptions options{.objective = Objective::curve, .fitted_errors = false, .intervals = false};
    if (known) options.sigma_A = *parse_quantity("0.5%");
    const PerCurve found = fit_per_curve(data, "c", options);
    ASSERT_EQ(found.curves.size(), 4u);
    EXPECT_EQ(found.fitted, 4u);
    double separate = 0;
    for (std::size_t c = 0; c < 4; ++c) {
      EXPECT_EQ(found.curves[c].curve, data.curves[c]);
      EXPECT_EQ(found.curves[c].P, data.curve_loads[c]);
      EXPECT_EQ(found.curves[c].fit.used.size(), 12u);
      separate += found.curves[c].fit.sum_of_squares;
    }
    const double pooled = fit_model(data, "c", options).sum_of_squares;
    const double freedom = 3, rest = 48 - 4;
    const double statistic = known ? pooled - separate : (pooled - separate) / freedom / (separate / rest);
    ASSERT_TRUE(found.test);
    EXPECT_NEAR(found.test->statistic, statistic, 1e-9 * statistic);  // minima to 1e-12 of their cost
    EXPECT_EQ(found.test->freedom, freedom);
    EXPECT_EQ(found.test->residual_freedom, rest);
    // of three degrees of freedom: erfc(sqrt(x/2)) + sqrt(2x/pi) exp(-x/2)
    const double chi =
        std::erfc(std::sqrt(statistic / 2)) + std::sqrt(2 * statistic / pi<double>()) * std::exp(-statistic / 2);
    const double p = known ? chi : cdf(complement(boost::math::fisher_f(freedom, rest), statistic));
    EXPECT_NEAR(found.test->p_value, p, 1e-8);
  }
}

TEST(PerCurve, HasNoTestOfASingleRun) {
  const PerCurve found = fit_per_curve(noisy(6, {3}), "c", curve_options());
  ASSERT_EQ(found.curves.size(), 1u);
  EXPECT_FALSE(found.test);
  EXPECT_EQ(found.untested, "fewer than two runs have a value of their own");
}

/// Each run's loss would bend at that run's scatter: their sums are of different costs.
TEST(PerCurve, HasNoTestUnderARobustLossInUnitsOfTheScatter) {
  FitOptions options{.objective = Objective::curve, .loss = Loss::huber, .intervals = false};
  const PerCurve unknown = fit_per_curve(runs_of(0.15, 0.2, 1), "c", options);
  EXPECT_FALSE(unknown.test);
  EXPECT_EQ(unknown.untested, "a robust loss in units of the scatter is another cost for each run");
  options.sigma_A = *parse_quantity("0.5%");
  const PerCurve known = fit_per_curve(runs_of(0.15, 0.2, 1), "c", options);
  ASSERT_TRUE(known.test);
  EXPECT_LT(known.test->p_value, 1e-3);
}

/// Sum of the runs' own minima when an offset of all areas is this.
double cost_of_runs(const Dataset& data, double offset, const FitOptions& options) {
  FitOptions fixed = value_only(options);
  fixed.free.clear();
  fixed.constants = Constants{};
  (*fixed.constants)[kAreaOffset] = offset;
  double sum = 0;
  for (const auto& run : points_by_curve(data)) sum += fit_model(data, "c", fixed, &run).sum_of_squares;
  return sum;
}

/// A freed constant belongs to the experiment: one value for all runs, the best beside a lambda for each, found here by
/// a parabola through sums of the runs' own minima.
TEST(PerCurve, SharesTheConstantsThatAreFree) {
  Dataset data = runs_of(0.15, 0.15, 8);
  for (Point& p : data.points) p = {p.line, p.curve, p.P, p.T, p.A + 0.5};
  FitOptions options = curve_options();
  options.sigma_A = *parse_quantity("0.5%");
  options.free = {kAreaOffset};
  options.intervals = true;
  options.fitted_errors = false;
  const PerCurve found = fit_per_curve(data, "c", options);
  ASSERT_TRUE(found.test);
  double at = -0.5, h = 0.05;
  for (int i = 0; i < 12; ++i, h *= 0.5) {
    const double low = cost_of_runs(data, at - h, options), here = cost_of_runs(data, at, options),
                 high = cost_of_runs(data, at + h, options);
    at += std::clamp(0.5 * h * (low - high) / (low - 2 * here + high), -h, h);
  }
  const double separate = cost_of_runs(data, at, options), pooled = fit_model(data, "c", options).sum_of_squares;
  EXPECT_NEAR(found.test->statistic, pooled - separate, 1e-6);  // the parabola leaves 1e-8 of a chi^2 near 48
  EXPECT_EQ(found.test->freedom, 3);
  FitOptions fixed = curve_options();
  fixed.sigma_A = options.sigma_A;
  fixed.fitted_errors = false;
  fixed.constants = Constants{};
  (*fixed.constants)[kAreaOffset] = at;
  for (std::size_t c = 0; c < 4; ++c) {
    const auto run = points_by_curve(data)[c];
    ASSERT_EQ(found.curves[c].fit.parameters.size(), 1u);
    const FitResult own = fit_model(data, "c", fixed, &run);
    const FittedParameter& shared = found.curves[c].fit.parameters[0];
    EXPECT_NEAR(*shared.value, *own.parameters[0].value, 1e-5);     // the offset to some 1e-6
    EXPECT_GT(*shared.stderr_, 1.05 * *own.parameters[0].stderr_);  // it holds that of the offset
    ASSERT_TRUE(shared.interval && shared.interval->low);
    EXPECT_NEAR(*shared.value - *shared.interval->low, 1.96 * *shared.stderr_, 0.5 * *shared.stderr_);
  }
}

/// A load cell that is off by what is stated of it is no difference between runs; as exact it is.
TEST(PerCurve, TakesAnUncertainConstantForOneOfAllRuns) {
  int rejected = 0, rejected_exact = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Dataset data = runs_of(0.15, 0.15, seed);
    for (Point& p : data.points) p.P += 0.6;
    data.contact = Contact{0.01, 1e6, 0.03};
    FitOptions options = curve_options();
    options.sigma_A = *parse_quantity("0.5%");
    rejected_exact += fit_per_curve(data, "c", options).test->p_value < 0.05;
    data.metadata.load_offset = 0;
    data.metadata.standard_errors["load_offset"] = 0.6 * data.contact->force_unit();
    const PerCurve found = fit_per_curve(data, "c", options);
    ASSERT_TRUE(found.test);
    EXPECT_EQ(found.test->freedom, 3);
    rejected += found.test->p_value < 0.05;
  }
  EXPECT_LE(rejected, 5);  // by chance: 3e-4
  EXPECT_GE(rejected_exact, 15);
}

}  // namespace comparison_test
}  // namespace mixity
