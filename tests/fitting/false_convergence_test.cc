// A fit that says ok has the best lambda, whatever unit the areas and their errors are given in: absolute tolerances
// would call small numbers converged at once.
#include <gtest/gtest.h>

#include <cmath>

#include "fitting/fit.h"
#include "fitting/unit_cases.h"

namespace mixity {
namespace false_convergence_test {

constexpr int kScanned = 1200;

/// What each objective should find, from the data in SI units.
BestValue truth_of(const UnitCase& at, const FitOptions& options) {
  const ContactModel model = model_named(at.model);
  const Dataset data = at.in({"m^2", 1});
  const double sigma_T = at.sigma_T / data.contact->force_unit(), sigma_A = at.sigma_A / data.contact->area_unit();
  const ParameterInfo& lambda = model.parameters()[0];
  const auto best = [&](const Residuals& residuals, bool known) {
    return best_value(residuals, lambda.lower, lambda.upper, kScanned, known);
  };
  if (options.objective == Objective::curve) return best(curve_residuals(model, data, sigma_T, sigma_A), true);
  const std::vector<double> ones(data.points.size(), 1.0);
  BestValue found = best(toughness_residuals(model, data, ones), false);
  // the weights follow from lambda, and lambda from the weights
  for (int i = 0; options.weighted && i < 20; ++i)
    found = best(toughness_residuals(model, data, toughness_weights(model, data, sigma_T, sigma_A, found.x)), true);
  return found;
}

struct Tally {
  int ok = 0, cases = 0;
};

void expect_right_or_not_ok(const UnitCase& at, FitOptions options, const std::vector<AreaUnit>& units, Tally& tally) {
  const BestValue best = truth_of(at, options);
  for (const AreaUnit& unit : units) {
    const Dataset data = at.in(unit);
    options.fitted_errors = false;
    if (options.objective == Objective::curve || options.weighted) {
      options.sigma_T = parse_quantity(at.sigma_T_text());
      options.sigma_A = parse_quantity(at.sigma_A_in(unit));
    }
    // without an interval, whose search finds lower costs on its way, the minimum has nobody to revoke it
    for (const FitOptions& chosen : {options, value_only(options)}) {
      const FitResult fit = fit_model(data, at.model, chosen);
      ++tally.cases;
      // what makes a fit suspect is not where its minimum lies
      if (fit.status != FitStatus::ok && fit.status != FitStatus::suspect) continue;
      ++tally.ok;
      const double value = fit.parameters[0].value.value_or(std::nan(""));
      EXPECT_TRUE(is_right(value, best)) << at.name << " in " << unit.name << ", " << to_string(fit.objective)
                                         << (options.weighted ? ", weighted" : "") << ": lambda " << value << ", best "
                                         << best.x << " +/- " << best.standard_error;
    }
  }
}

class FalseConvergence : public ::testing::TestWithParam<std::size_t> {};

TEST_P(FalseConvergence, NeverWhateverTheUnitOfTheAreas) {
  const UnitCase at = unit_cases(MIXITY_ROOT "/data/mergel2018.csv")[GetParam()];
  const std::vector<AreaUnit> units(kAreaUnits.begin(), kAreaUnits.end());
  Tally tally;
  expect_right_or_not_ok(at, {.objective = Objective::curve}, units, tally);
  expect_right_or_not_ok(at, {.objective = Objective::toughness}, units, tally);
  expect_right_or_not_ok(at, {.objective = Objective::toughness, .weighted = true}, units, tally);
  EXPECT_EQ(tally.cases, 42);
  // the area that grows has its least squares at the bound
  EXPECT_EQ(tally.ok, at.name == "c, growing area" ? 0 : 42) << at.name;
}

INSTANTIATE_TEST_SUITE_P(Cases, FalseConvergence, ::testing::Range(std::size_t{0}, std::size_t{6}));

/// Runs up to the fold with errors in T, where A at given T has a slope without bound.
TEST(RunsUpToTheFold, AreOkAtTheLowestCost) {
  Tally tally;
  for (unsigned seed = 1; seed <= 8; ++seed) {
    SeededNoise of_A(seed, 0.003), of_T(seed + 1000, 0.02);
    Dataset data = synthetic_runs("c", {0.15}, {0.5, 2, 5, 10, 20, 40}, 25, 0.999, of_A);
    for (Point& p : data.points) p = {p.line, p.curve, p.P, p.T * (1 + of_T()), p.A};
    const UnitCase at("seed " + std::to_string(seed), "c", data);
    expect_right_or_not_ok(at, {.objective = Objective::curve}, {{"m^2", 1}}, tally);
  }
  EXPECT_EQ(tally.ok, 16);
}

}  // namespace false_convergence_test
}  // namespace mixity
