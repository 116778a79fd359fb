// The expected improvement is that of the fit with the cause; causes that fall short are not fitted.
#include "fitting/expected_fall.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "fitting/causes.h"
#include "fitting/fit.h"
#include "fitting/measured_runs.h"

namespace mixity {
namespace expected_fall_test {

/// The data as read by somebody who states another toughness.
Dataset with_wrong_toughness(double factor) {
  Dataset data = measured_runs(5);
  Contact stated = *data.contact;
  stated.toughness *= factor;
  const double force = data.contact->force_unit() / stated.force_unit(),
               area = data.contact->area_unit() / stated.area_unit();
  for (Point& point : data.points) point.P *= force, point.T *= force, point.A *= area;
  for (double& load : data.curve_loads) load *= force;
  data.contact = stated;
  data.metadata.toughness = stated.toughness;
  return data;
}

/// Each run has a toughness of its own.
Dataset with_toughness_by_run(double spread) {
  Dataset data = measured_runs(5, {}, 40);
  SeededNoise of_run(9, spread);
  std::vector<double> factors;
  for (std::size_t run = 0; run < data.curves.size(); ++run) factors.push_back(std::exp(of_run()));
  const Contact contact = *data.contact;
  for (Point& point : data.points) {
    Contact own = contact;
    own.toughness *= factors[point.curve];
    // a run of a tougher contact at the same load, in the units of the others: areas grow, near P = 0 by the 2/3 power
    point.A *= own.area_unit() / contact.area_unit();
    point.T *= own.force_unit() / contact.force_unit();
  }
  return data;
}

FitOptions known(bool known) { return known ? stated_errors() : FitOptions{.intervals = false}; }

TEST(ExpectedFall, OfAConstantIsThatOfTheFitWithItFree) {
  for (const bool errors : {true, false})
    for (const double factor : {0.97, 1.03, 1.2}) {
      const Dataset data = with_wrong_toughness(factor);
      const FitResult fit = fit_and_test(data, "c", known(errors));
      FitOptions with = known(errors);
      with.free = {kToughness};
      const double fall = misfit(fit) - misfit(fit_and_test(data, "c", with));
      const ExpectedFall expected = expected_fall(fit, kToughness, fit.used.size());
      ASSERT_GT(fall, 6) << factor;
      // linearised, with the errors of the wrong fit: those of unknown size are estimated anew
      EXPECT_NEAR(expected.misfit, fall, 0.05 * fall + (errors ? 1 : 4)) << errors << " " << factor;
    }
}

TEST(ExpectedFall, OfAQuantityByRunIsThatOfTheRandomEffect) {
  const Dataset data = with_toughness_by_run(0.05);
  const FitResult fit = fit_and_test(data, "c", known(true));
  FitOptions with = known(true);
  with.by_run = {"toughness"};
  const double fall = misfit(fit) - misfit(fit_and_test(data, "c", with));
  ASSERT_GT(fall, 50);
  const auto test = std::find_if(fit.run_tests.begin(), fit.run_tests.end(),
                                 [](const RunTest& one) { return one.quantity == "toughness"; });
  ASSERT_NE(test, fit.run_tests.end());
  // runs determine it unequally well, which the formula neglects
  EXPECT_NEAR(expected_fall(fit, *test, fit.used.size()).misfit, fall, 0.15 * fall);
}

TEST(ExpectedFall, OfHalfOfThePointsIsHalf) {
  const FitResult fit = fit_and_test(with_wrong_toughness(1.1), "c", known(true));
  const ExpectedFall all = expected_fall(fit, kToughness, fit.used.size()),
                     half = expected_fall(fit, kToughness, fit.used.size() / 2);
  EXPECT_NEAR(half.misfit, all.misfit / 2, 1e-12 * all.misfit);
  EXPECT_NEAR(half.chi2, all.chi2 / 2, 1e-12 * all.chi2);
}

TEST(ExpectedFall, IsNotKnownOfAConstantThatIsNotTested) {
  FitOptions options = known(true);
  options.free = {kToughness};
  const FitResult fit = fit_and_test(measured_runs(5), "c", options);
  EXPECT_TRUE(std::isinf(expected_fall(fit, kToughness, fit.used.size()).misfit));
}

TEST(ExpectedFall, TellsWhichConstantLeavesTooMuch) {
  const FitResult fit = fit_and_test(with_wrong_toughness(1.2), "c", known(true));
  const auto left = [&](Constant one) {
    return stays_too_large(fit, expected_fall(fit, one, fit.used.size()), fit.used.size());
  };
  EXPECT_FALSE(left(kToughness));
  EXPECT_TRUE(left(kShearOffset));
  FitOptions unknown;
  const FitResult scattered = fit_and_test(with_wrong_toughness(1.2), "c", unknown);
  EXPECT_FALSE(stays_too_large(scattered, {0, 0}, scattered.used.size()));
}

/// All causes are found that trying each of them finds, though most are not tried.
TEST(ExpectedFall, LeavesOutNoCauseThatDoesAsWell) {
  const Dataset data = with_wrong_toughness(1.1);
  const FitOptions options = known(true);
  const FitResult fit = fit_and_test(data, "c", options);
  std::set<std::string> tried;
  const Refit refit = [&](const Dataset& of, const FitOptions& with, const std::vector<std::size_t>& points,
                          const std::vector<FittedParameter>*) {
    for (const Constant one : with.free) tried.emplace(kConstantNames[one]);
    tried.insert(with.by_run.begin(), with.by_run.end());
    return fit_and_test(of, "c", with, &points);
  };
  constexpr double kRange = 6;
  std::set<std::string> named;
  for (const Cause& one : causes({data, fit, options, refit}, fit.used.list(), misfit(fit), kRange))
    named.insert(one.name);
  EXPECT_TRUE(named.count("toughness"));
  EXPECT_LT(tried.size(), 4U);
  const auto with_free = [&](Constant constant) {
    FitOptions with = options;
    with.free = {constant};
    return fit_and_test(data, "c", with);
  };
  const double most = misfit(with_free(kToughness)) + kRange;
  for (const ExactConstant& one : fit.budget->exact) {
    const FitResult other = with_free(constant_named(one.constant).value());
    const bool as_well = is_found(other) && explains(data, other) && misfit(other) < std::min(misfit(fit), most);
    EXPECT_EQ(named.count(one.constant) > 0, as_well) << one.constant;
  }
}

}  // namespace expected_fall_test
}  // namespace mixity
