// Where the variance of a fitted parameter comes from, what each constant of the experiment does to it, and whether the
// data ask for another value of one that was not fitted. All from the Jacobian at the minimum, without a refit.
#pragma once

#include <optional>
#include <vector>

#include "fitting/result.h"
#include "solver/problem.h"

namespace mixity {

/// A constant beside the fit: its number among the parameters of the problem, and a change of it.
struct ConstantStep {
  std::size_t parameter;
  double step;  // as the solver counts
};

/// `problem`: of the data alone, its parameters those of the fit and behind them the constants that were not fitted;
/// `x`: at the fit. `unit`: what a residual's standard error is. `held`: by a bound. Null if the Jacobian is not
/// finite or the fit does not determine its first parameter.
std::optional<Budget> error_budget(const Problem& problem, const std::vector<double>& x, double unit,
                                   const std::vector<bool>& held, const std::vector<ConstantStep>& exact);

}  // namespace mixity
