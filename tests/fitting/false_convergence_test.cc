// A fit that says ok has the best lambda, whatever unit the areas are given in: absolute tolerances would call small
// numbers converged at once.
#include <gtest/gtest.h>

#include <cmath>

#include "fitting/fit.h"
#include "fitting/unit_cases.h"

namespace mixity {
namespace {

template <class Model>
void expect_right_or_not_ok(const UnitCase& at, const AreaUnit& unit, const BestValue& best) {
  const FitOptions options{.objective = Objective::area, .sigma_A = parse_quantity(at.sigma_in(unit))};
  const Dataset data = at.in(unit);
  // without an interval, whose search finds lower costs on its way, the minimum has nobody to revoke it
  for (const FitOptions& chosen : {options, value_only(options)}) {
    const FitResult fit = fit_model(data, at.model, chosen);
    const double value = fit.has_values() ? fit.parameters[0].value.value_or(std::nan("")) : std::nan("");
    if (fit.status == FitStatus::ok) {
      EXPECT_TRUE(is_right(value, best)) << at.name << " in " << unit.name << ": lambda " << value << ", best "
                                         << best.x << " +/- " << best.standard_error;
    }
  }
}

class FalseConvergence : public ::testing::TestWithParam<std::size_t> {};

TEST_P(FalseConvergence, NeverWhateverTheUnitOfTheAreas) {
  const UnitCase at = unit_cases(MIXITY_ROOT "/data/mergel2018.csv")[GetParam()];
  with_model(at.model, [&](auto model) {
    using Model = decltype(model);
    if constexpr (parameter_count<Model> == 1) {
      const BestValue best = best_value<Model>(at.in({"m^2", 1}), 1200);
      for (const AreaUnit& unit : kAreaUnits) expect_right_or_not_ok<Model>(at, unit, best);
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Cases, FalseConvergence, ::testing::Range(std::size_t{0}, std::size_t{6}));

/// Runs up to the fold with errors in T: many points pass it on the way of lambda, each of which bends the cost.
TEST(ManyBasins, OkIsTheLowest) {
  const AreaUnit unit{"m^2", 1};
  for (unsigned seed = 1; seed <= 8; ++seed) {
    SeededNoise of_A(seed, 0.003), of_T(seed + 1000, 0.02);
    Dataset data = synthetic_runs<PapangeloCiavarella>({0.15}, {0.5, 2, 5, 10, 20, 40}, 25, 0.999, of_A);
    for (Point& p : data.points) p = {p.line, p.curve, p.P, p.T * (1 + of_T()), p.A};
    const UnitCase at("seed " + std::to_string(seed), "c", data);
    const BestValue best = best_value<PapangeloCiavarella>(at.in(unit), 1200);
    EXPECT_GT(best.minima, 1);
    expect_right_or_not_ok<PapangeloCiavarella>(at, unit, best);
  }
}

}  // namespace
}  // namespace mixity
