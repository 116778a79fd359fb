// The error budget of a fitted parameter: the sources of its variance, the effect of each constant of the experiment on
// it, and score tests of constants that were not fitted. All come from the Jacobian at the minimum, without a refit.
#pragma once

#include <optional>
#include <vector>

#include "fitting/result.h"
#include "solver/problem.h"

namespace mixity {

/// A step of a constant that was not fitted.
struct ConstantStep {
  std::size_t parameter;  // index among the parameters of the problem
  double step;            // in the solver's numbers
};

/// `problem`: the data alone, with the parameters of the fit followed by the constants that were not fitted; `x`: their
/// values. `unit`: the standard error of a residual. `held`: parameters held by a bound. Null if the Jacobian is not
/// finite or the fit does not determine its first parameter.
std::optional<Budget> error_budget(const Problem& problem, const std::vector<double>& x, double unit,
                                   const std::vector<bool>& held, const std::vector<ConstantStep>& exact);

}  // namespace mixity
