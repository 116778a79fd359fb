// The sources of the variance of a fitted parameter, the effect of each constant of the experiment on it, and score
// tests of constants that were not fitted. All from the Jacobian at the minimum, without a refit.
#pragma once

#include <optional>
#include <vector>

#include "fitting/result.h"
#include "solver/problem.h"

namespace mixity {

/// A change of a constant that was not fitted.
struct ConstantStep {
  std::size_t parameter;  // its number among the parameters of the problem
  double step;            // in the solver's numbers
};

/// `problem`: of the data alone, with the parameters of the fit and behind them the constants that were not fitted;
/// `x`: its values at the fit. `unit`: the standard error of a residual. `held`: by a bound. Null if the Jacobian is
/// not finite or the fit does not determine its first parameter.
std::optional<Budget> error_budget(const Problem& problem, const std::vector<double>& x, double unit,
                                   const std::vector<bool>& held, const std::vector<ConstantStep>& exact);

}  // namespace mixity
