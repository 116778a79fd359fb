// The least-squares problem of one model, and where its constants start.
#pragma once

#include <memory>
#include <vector>

#include "fitting/model_problem.h"
#include "fitting/prepare.h"

namespace mixity {

/// `weights`: of objective toughness, 1/standard error; empty: 1.
std::unique_ptr<ModelProblem> make_problem(const Dataset& data, const FitOptions& options, const PreparedFit& prepared,
                                           std::vector<double> weights = {});

/// Where the constants start: at the JKR curve through the points without shear (T up to 1 % of the largest).
std::vector<double> jkr_start(const Dataset& data, const FitOptions& options, const PreparedFit& prepared);

/// A fit's values as the solver counts, for a problem of the same parameters or fewer of them: constants of the
/// experiment that it does not have start where the problem says. Empty where a value is missing.
std::vector<double> solver_values(const Problem& problem, const std::vector<FittedParameter>& fitted);

}  // namespace mixity
