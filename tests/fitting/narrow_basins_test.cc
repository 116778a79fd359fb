// Basins of the cost that a coarse grid does not see: of few points, or of points beyond the fold with small errors,
// the cost changes within a hundredth of a parameter.
#include <gtest/gtest.h>

#include <cmath>

#include "base/number_text.h"
#include "fitting/fit.h"
#include "fitting/prepare.h"
#include "fitting/synthetic_runs.h"

namespace mixity {
namespace narrow_basins_test {

double bk_cost(const Dataset& data, const FitOptions& options, const ParameterValues& p) {
  const auto problem =
      make_problem(data, options, prepare(data, model_named("bk"), options, Objective::curve, nullptr));
  std::vector<double> residuals(problem->residual_count());
  return sum_of_squares(*problem, p, residuals).value();
}

/// Areas a little smaller than even an ideally brittle contact would have.
TEST(FitOfCurves, ThatWantsMoreThanLambdaOneIsAtThatBound) {
  for (const double missing : {0.003, 0.01}) {
    const Dataset data = synthetic_runs("a", {1}, {-2, 0.5, 20}, 8, 0.95, [&] { return -missing; });
    const FitResult fit = fit_model(data, "a", {.objective = Objective::curve});
    EXPECT_EQ(fit.status, FitStatus::at_bound) << fit.message.text();
    EXPECT_EQ(*fit.parameters[0].value, 1);
    EXPECT_FALSE(fit.parameters[0].stderr_);
  }
}

/// The truth's basin may be as narrow as a hundredth of a parameter; other minima, far away, fit much worse.
TEST(FitOfCurves, OfTwoParametersIsNoWorseThanTheTruth) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (unsigned round = 0; round < 20; ++round) {
    ParameterValues truth = ParameterValues::zeros(2);
    do
      for (double& value : truth) value = 0.5 * std::pow(10, uniform(random));
    while (!model_named("bk").obstacle(truth).empty());
    const double size = std::pow(10, -5 + 3.5 * uniform(random));
    SeededNoise noise(round, size);
    Dataset data = empty_runs();
    for (unsigned run = 0; run <= round % 3; ++run)
      add_run(data, "bk", truth, -4 + 34 * uniform(random), 3 + round % 5, 0.9 + 0.1 * uniform(random), noise);
    for (Point& p : data.points) p.T *= 1 + noise();
    const StatedError relative = *parse_quantity(shortest(100 * size) + "%");
    const FitOptions options{
        .objective = Objective::curve, .sigma_T = relative, .sigma_A = relative, .intervals = false};
    const FitResult fit = fit_model(data, "bk", options);
    ASSERT_TRUE(fit.has_values()) << round << ' ' << fit.message.text();
    EXPECT_LE(fit.sum_of_squares, bk_cost(data, options, truth))
        << round << ' ' << truth[0] << ' ' << truth[1] << ' ' << size;
  }
}

struct Measured {
  std::size_t run;
  double T, A, sigma_A;
};

/// `share` of the largest T is the error of each; 0: as little as the objective allows.
Dataset measured_runs(const std::vector<double>& loads, const std::vector<Measured>& points, double share = 0) {
  Dataset data = empty_runs();
  for (const double P : loads) {
    data.curves.push_back("P=" + shortest(P));
    data.curve_loads.push_back(P);
  }
  double largest = 0;
  for (const Measured& m : points) largest = std::max(largest, m.T);
  for (const Measured& m : points) {
    data.points.push_back({data.points.size() + 2, m.run, loads[m.run], m.T, m.A});
    data.errors.push_back({share * largest, m.sigma_A, 0});
  }
  data.rows = points.size();
  return data;
}

void expect_no_worse_than(const ParameterValues& truth, const Dataset& data) {
  const FitOptions options{.objective = Objective::curve};
  const FitResult fit = fit_model(data, "bk", options);
  EXPECT_TRUE(fit.has_values()) << fit.message.text();
  EXPECT_LE(fit.sum_of_squares, bk_cost(data, options, truth));
}

/// Beyond lambda = 0.009 both loads lie beyond the fold.
TEST(FitOfCurves, FindsTheBasinBesideThatBeyondTheFold) {
  const Dataset data = measured_runs({19.168}, {{0, 244.424, 25.2821, 0.09}, {0, 232.902, 27.8726, 0.09}});
  const FitResult fit = fit_model(data, "c", {.objective = Objective::curve});
  EXPECT_EQ(fit.status, FitStatus::ok) << fit.message.text();
  EXPECT_NEAR(*fit.parameters[0].value, 0.00748, 0.00001);  // the cost as seen by mixity predict
  EXPECT_LT(fit.sum_of_squares, 0.1);
}

/// The point at T = 20.16 lies beyond the fold, and all fits of toughness with it are led astray.
TEST(FitOfCurves, OfTwoParametersIsNotLedAstrayByAPointBeyondTheFold) {
  const std::vector<Measured> points{{0, 8.12, 25.56, 0.13}, {0, 20.16, 16.56, 0.13}, {0, 0.48, 26.89, 0.13},
                                     {0, 9.82, 24.85, 0.13}, {0, 14.7, 22.21, 0.13},  {0, 18.19, 17.93, 0.13},
                                     {0, 2.91, 26.57, 0.13}};
  expect_no_worse_than({1.479, 2.257}, measured_runs({8.116}, points, 0.005));
}

/// Of three points the second lies beyond the fold.
TEST(FitOfCurves, OfTwoParametersFindsTheBasinOfThreePointsOfNoScatter) {
  const std::vector<Measured> points{
      {0, 5.10903839, 8.73801163, 1.7e-4}, {0, 5.67555436, 8.03187583, 1.7e-4}, {0, 0.27142407, 11.45889011, 1.7e-4}};
  for (const double share : {1e-4, 1e-3})
    expect_no_worse_than({1.657, 1.159}, measured_runs({-3.9412461}, points, share));
}

TEST(FitOfCurves, OfTwoParametersFindsTheBasinBetweenTwoOthers) {
  std::vector<Measured> points{{0, 9.8602234, 16.813814, 0}, {0, 4.7316556, 21.849568, 0},
                               {1, 18.484521, 26.839598, 0}, {1, 13.245314, 33.596692, 0},
                               {2, 20.901013, 29.041465, 0}, {2, 14.092164, 37.632529, 0}};
  for (Measured& m : points) m.sigma_A = 0.0055 * m.A;
  expect_no_worse_than({0.6646, 0.5423}, measured_runs({4.23662169, 23.03088237, 28.92842217}, points, 0.0055));
}

/// Low shear leaves the toughness of a point open: only where each counts by its standard error do fits of toughness
/// lead to the basin.
TEST(FitOfCurves, OfTwoParametersStartsFromWeightedToughness) {
  const std::vector<Measured> measured{
      {0, 24.769849, 32.6893298, 2.152838},     {0, 7.68191994, 42.2197818, 2.51444869},
      {0, 28.5917686, 29.6939262, 1.8134143},   {0, 5.23112527, 36.0568232, 2.5291813},
      {0, 19.228312, 40.6696507, 2.34847853},   {0, 15.0006607, 41.7373282, 2.43212794},
      {1, 15.8990795, 36.8871366, 2.49817347},  {1, 19.8122656, 37.0076427, 2.42037479},
      {1, 2.13863132, 43.0570313, 2.61472291},  {1, 14.1904472, 39.7980164, 2.52405577},
      {1, 6.03855754, 40.6153076, 2.60051234},  {1, 1.16308472, 43.1915004, 2.61619372},
      {2, 1.70045995, 13.1164603, 0.838449968}, {2, 6.20059583, 9.89232354, 0.590734728},
      {2, 3.82645059, 13.0736129, 0.790930563}, {2, 6.17350964, 10.0515184, 0.601767877},
      {2, 4.29124226, 11.7013682, 0.773180473}, {2, 5.11735736, 9.80599755, 0.729841514}};
  const Dataset data = measured_runs({27.533974, 29.524425, -3.0787826}, measured);
  const FitResult fit = fit_model(data, "bk", {.objective = Objective::curve});
  EXPECT_TRUE(fit.has_values()) << fit.message.text();
  EXPECT_LT(fit.sum_of_squares, 17.61);  // two other minima, far away, have 19.97 and 20.27
}

}  // namespace narrow_basins_test
}  // namespace mixity
