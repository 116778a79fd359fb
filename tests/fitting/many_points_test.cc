// Fits of so many points that what would not show is left out: the answer is the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "base/threads.h"
#include "fitting/curve_objective.h"
#include "fitting/fit.h"
#include "fitting/fitted_errors.h"
#include "fitting/measured_runs.h"
#include "fitting/run_differences.h"

namespace mixity {
namespace many_points_test {

constexpr double kTruth = 0.15, kNoise = 0.01;

Dataset many_points() { return measured_runs(1, {}, kManyPoints / 6 + 100); }

FitOptions unchecked() {
  FitOptions options;
  options.checks = false;
  return options;
}

/// The rounds of fit and errors end early: one more must not move lambda by a thousandth of its error. All distances
/// that change alike move it by their size times the root of the number of points.
TEST(ManyPoints, EndWhereAnotherRoundWouldMoveTheFitByLessThanAThousandthOfItsError) {
  const Dataset data = many_points();
  const FitOptions options = unchecked();
  const FitResult fit = fit_model(data, "c", options);
  ASSERT_EQ(fit.status, FitStatus::ok) << fit.message.text();
  EXPECT_LT(std::abs(*fit.parameters[0].value - kTruth), 4 * *fit.parameters[0].stderr_);
  // a part of the noise in T is told as noise in A, and the reverse
  ASSERT_TRUE(fit.errors->model_T && fit.errors->model_A);
  EXPECT_NEAR(fit.errors->model_T->share, kNoise, 0.03 * kNoise);
  EXPECT_NEAR(fit.errors->model_A->share, kNoise, 0.03 * kNoise);

  PreparedFit prepared = prepare(data, model_named("c"), options, Objective::curve, nullptr);
  prepared.errors = std::make_shared<StandardErrors>(*fit.errors);
  const auto problem = make_problem(data, options, prepared);
  const auto& objective = static_cast<const CurveObjective&>(*problem);
  const std::vector<double> x{*fit.parameters[0].value};
  const auto nearest = objective.nearest(x);
  ASSERT_TRUE(nearest);
  const auto expected = objective.expected(x, *nearest);
  ASSERT_TRUE(expected);
  const double n = static_cast<double>(data.points.size());
  double squares = 0, largest = 0;
  for (std::size_t i = 0; i < expected->size(); ++i)
    squares += std::pow(nearest->residuals[i] - fit.errors->expected[i], 2);
  for (std::size_t i = 0; i < expected->size(); ++i)
    largest = std::max(largest, std::abs(squares / (n - 1) * (*expected)[i] - fit.errors->expected[i]));
  EXPECT_LT(largest * std::sqrt(n), 1e-3);
}

/// A nearest point is looked for from where the last fit had it. It is the same as without.
TEST(ManyPoints, HaveTheSameNearestPlacesWhereverTheSearchBegins) {
  Dataset data = many_points();
  const FitOptions options = unchecked();
  PreparedFit prepared = prepare(data, model_named("c"), options, Objective::curve, nullptr);
  const std::vector<double> x{0.16};
  const auto blind = static_cast<const CurveObjective&>(*make_problem(data, options, prepared)).nearest(x);
  ASSERT_TRUE(blind);
  for (const double off : {1.0, 0.7, 1.4}) {
    prepared.errors->place_T = blind->T;
    prepared.errors->place_A = blind->A;
    for (double& A : prepared.errors->place_A) A *= off;
    const auto seen = static_cast<const CurveObjective&>(*make_problem(data, options, prepared)).nearest(x);
    ASSERT_TRUE(seen);
    double largest = 0;
    for (std::size_t i = 0; i < data.points.size(); ++i)
      largest = std::max(largest, std::abs(seen->residuals[i] - blind->residuals[i]));
    EXPECT_LT(largest, 1e-9) << off;  // rounding of readings of some 100 errors, where Newton's method ends
    // places that are handed over serve as those in the errors do, to the last bit
    NearestPlaces from;
    from.T = std::exchange(prepared.errors->place_T, {});
    from.A = std::exchange(prepared.errors->place_A, {});
    const auto bare = make_problem(data, options, prepared);
    const auto taken = static_cast<const CurveObjective&>(*bare).nearest(x, {}, std::move(from));
    ASSERT_TRUE(taken);
    EXPECT_EQ(taken->residuals, seen->residuals);
    EXPECT_EQ(taken->T, seen->T);
    EXPECT_EQ(taken->A, seen->A);
    EXPECT_EQ(taken->load_A, seen->load_A);
  }
}

/// Points made on demand are those of a list: in blocks, where the runs are not in the order of their loads, and where
/// some points are left out.
TEST(ManyPoints, HaveTheResidualsOfFewOnesWhereverTheyStand) {
  Dataset data = many_points();
  std::reverse(data.points.begin(), data.points.end());
  const FitOptions options = unchecked();
  std::vector<std::size_t> most(data.points.size() - 5), some;
  std::iota(most.begin(), most.end(), std::size_t{5});
  const std::vector<double> x{0.16};
  const PreparedFit many = prepare(data, model_named("c"), options, Objective::curve, &most);
  std::vector<double> residuals(most.size());
  ASSERT_TRUE(make_problem(data, options, many)->evaluate(x, residuals, {}));
  for (std::size_t i = 0; i < most.size(); i += 100) some.push_back(i);
  PreparedFit few = many;
  few.used = PointIndices();
  for (const std::size_t i : some) few.used.push_back(most[i]);
  std::vector<double> same(some.size());
  ASSERT_TRUE(make_problem(data, options, few)->evaluate(x, same, {}));
  for (std::size_t k = 0; k < some.size(); ++k) EXPECT_NEAR(residuals[some[k]], same[k], 1e-9) << k;  // as above
}

/// The errors of fitted points do not depend on whether others are left out, whose errors are those at their readings.
TEST(ManyPoints, AreAllOrSomeOfTheDataSetWithTheSameErrors) {
  const Dataset data = measured_runs(3, {}, 40);
  const FitResult fit = fit_model(data, "c", unchecked());
  const std::size_t n = data.points.size();
  std::vector<std::size_t> all(n), some(n - 1);
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::iota(some.begin(), some.end(), std::size_t{0});
  const auto evaluated = [&](const std::vector<std::size_t>& used) {
    NearestPlaces nearest;
    for (const std::size_t i : used) {
      nearest.T.push_back(1.1 * data.points[i].T);
      nearest.A.push_back(0.9 * data.points[i].A);
      nearest.load_T.push_back(0.6);
      nearest.load_A.push_back(0.8);
    }
    StandardErrors errors = *fit.errors;
    errors.load_T = errors.load_A = {};
    return std::pair(evaluate_errors(data, used, std::move(nearest), errors), errors);
  };
  const auto [change, whole] = evaluated(all);
  const auto [change_of_some, part] = evaluated(some);
  EXPECT_GT(change, 0.01);
  EXPECT_NEAR(change, change_of_some, 0.2 * change);
  for (std::size_t i = 0; i < n - 1; ++i) {
    EXPECT_EQ(whole.T[i], part.T[i]) << i;
    EXPECT_EQ(whole.A[i], part.A[i]) << i;
    EXPECT_EQ(whole.place_A[i], part.place_A[i]) << i;
    EXPECT_EQ(whole.load_T[i], part.load_T[i]) << i;
  }
  EXPECT_EQ(part.load_A[n - 1], 1);
  EXPECT_LT(whole.A[n - 1], part.A[n - 1]);  // at 0.9 of the reading and at the reading
}

/// Sums of squares and products are all that tests of differences between runs use of the rows.
TEST(ManyPoints, HaveSumsOfRunsWithTheProductsOfAllRows) {
  const Dataset data = measured_runs(3, {}, 40);
  const FitOptions options = unchecked();
  const FitResult fit = fit_model(data, "c", options);
  PreparedFit prepared = prepare(data, model_named("c"), options, Objective::curve, nullptr);
  prepared.errors = std::make_shared<StandardErrors>(*fit.errors);
  prepared.errors->correlations = {};
  const std::vector<double> x{*fit.parameters[0].value};
  const std::vector<std::string> names = tested_quantities(data, prepared);
  const auto rows = run_rows(data, options, prepared, x, fit.residuals, names, 2);
  const Groups groups = used_runs(data, prepared.used).groups;
  const auto sums =
      summed_run_rows(data, options, prepared, PointsByRun(data, prepared.used), x, fit.residuals, names, 2);
  ASSERT_TRUE(rows && sums);
  const GroupedRows whole = grouped_rows(rows->J, rows->r, rows->Zw, groups),
                    few = grouped_rows(sums->rows.J, sums->rows.r, sums->rows.Zw, sums->groups);
  const auto same = [](const auto& one, const auto& other) {
    EXPECT_LT((one - other).norm(), 1e-12 * one.norm() + 1e-300);  // rounding of sums of 40 squares
  };
  same(whole.J_J, few.J_J);
  EXPECT_NEAR(whole.r_r, few.r_r, 1e-12 * whole.r_r);
  EXPECT_LT((whole.J_r - few.J_r).norm(), 1e-12 * std::sqrt(whole.J_J.norm() * whole.r_r));
  ASSERT_EQ(whole.groups.size(), few.groups.size());
  for (std::size_t g = 0; g < whole.groups.size(); ++g) {
    same(whole.groups[g].Z_Z, few.groups[g].Z_Z);
    same(whole.groups[g].J_Z, few.groups[g].J_Z);
    EXPECT_LT((whole.groups[g].Z_r - few.groups[g].Z_r).norm(),
              1e-12 * std::sqrt(whole.groups[g].Z_Z.norm() * whole.r_r));
  }
}

/// All numbers of a fit that its points decide.
std::vector<double> numbers_of(const FitResult& fit) {
  std::vector<double> list{fit.sum_of_squares, fit.log_variances, fit.r2.value_or(0), fit.standard_error};
  for (const FittedParameter& one : fit.parameters) {
    list.insert(list.end(), {one.value.value_or(0), one.stderr_.value_or(0)});
    if (one.interval) list.insert(list.end(), {one.interval->low.value_or(0), one.interval->high.value_or(0)});
  }
  if (fit.evidence) list.push_back(fit.evidence->evidence.log_evidence);
  if (fit.budget)
    for (const ExactConstant& one : fit.budget->exact)
      list.insert(list.end(),
                  {one.effect.value_or(0), one.score ? one.score->p_value : 0, one.score ? one.score->fall : 0});
  for (const RunTest& one : fit.run_tests) list.insert(list.end(), {one.all.fall, one.odd.fall, one.drift.fall});
  const StandardErrors& errors = *fit.errors;
  for (const auto* const some : {&fit.residuals, &fit.innovations, &errors.T, &errors.A, &errors.place_T,
                                 &errors.place_A, &errors.load_T, &errors.load_A, &errors.expected})
    list.insert(list.end(), some->begin(), some->end());
  return list;
}

/// Sums are of parts of the points that do not depend on the threads.
TEST(ManyPoints, HaveTheSameFitToTheLastBitOnOneThreadAndOnSeveral) {
  const Dataset data = many_points();
  ASSERT_GT(data.points.size(), kManyPoints);
  FitOptions two;
  two.free = {kToughness};
  for (const FitOptions& options : {FitOptions(), two}) {
    const auto fitted = [&](std::ptrdiff_t busy) {
      const BusyProcessors others(busy);
      return fit_and_test(data, "c", options);
    };
    const FitResult one = fitted(static_cast<std::ptrdiff_t>(processors())), three = fitted(-2);
    ASSERT_TRUE(one.budget && !one.run_tests.empty());
    EXPECT_EQ(numbers_of(one), numbers_of(three));
  }
}

/// The points of a run need no list where the runs follow one another, and have one where they alternate.
TEST(ManyPoints, AreFoundByRunInAnyOrder) {
  const Dataset data = measured_runs(3, {}, 40);
  std::vector<std::size_t> used(data.points.size());
  std::iota(used.begin(), used.end(), std::size_t{0});
  for (const std::size_t stride : {1, 7}) {
    std::vector<std::size_t> some;
    for (std::size_t k = 0; k < used.size(); ++k) some.push_back(used[k * stride % used.size()]);
    const UsedRuns lists = used_runs(data, some);
    const PointsByRun same(data, some);
    ASSERT_EQ(same.runs(), lists.groups.size());
    for (std::size_t g = 0; g < same.runs(); ++g) {
      EXPECT_EQ(same.run(g), lists.runs[g]);
      ASSERT_EQ(same.size(g), lists.groups[g].size());
      for (std::size_t k = 0; k < same.size(g); ++k) EXPECT_EQ(same.at(g, k), lists.groups[g][k]);
    }
  }
}

}  // namespace many_points_test
}  // namespace mixity
