// A fit that says ok has the best lambda, whatever unit the areas are given in: absolute tolerances would call small
// numbers converged at once.
#include <gtest/gtest.h>

#include "fitting/fit.h"
#include "fitting/unit_cases.h"

namespace mixity {
namespace {

class FalseConvergence : public ::testing::TestWithParam<std::size_t> {};

template <class Model>
void expect_right_or_not_ok(const UnitCase& at) {
  const BestValue best = best_value<Model>(at.in({"m^2", 1}), 1200);
  for (const AreaUnit& unit : kAreaUnits) {
    const FitOptions options{.objective = Objective::area, .sigma_A = parse_quantity(at.sigma_in(unit))};
    const Dataset data = at.in(unit);
    // without an interval, whose search finds lower costs on its way, the minimum has nobody to revoke it
    for (const FitOptions& chosen : {options, value_only(options)}) {
      const FitResult fit = fit_model(data, at.model, chosen);
      const double value = fit.has_values() ? fit.parameters[0].value.value_or(std::nan("")) : std::nan("");
      const std::string where = at.name + " in " + unit.name + ": " + std::string(to_string(fit.status)) + ", lambda " +
                                std::to_string(value) + ", best " + std::to_string(best.x) + " +/- " +
                                std::to_string(best.standard_error) + ". " + fit.message;
      if (fit.status == FitStatus::ok) {
        EXPECT_TRUE(is_right(value, best)) << where;
      }
    }
  }
}

TEST_P(FalseConvergence, NeverWhateverTheUnitOfTheAreas) {
  const UnitCase at = unit_cases(MIXITY_ROOT "/data/mergel2018.csv")[GetParam()];
  with_model(at.model, [&](auto model) {
    if constexpr (parameter_count<decltype(model)> == 1) expect_right_or_not_ok<decltype(model)>(at);
  });
}

INSTANTIATE_TEST_SUITE_P(Cases, FalseConvergence, ::testing::Range(std::size_t{0}, std::size_t{6}));

}  // namespace
}  // namespace mixity
