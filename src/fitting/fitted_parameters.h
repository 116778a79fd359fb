// The parameters at a minimum: values, standard errors, intervals, and how they depend on the points.
#pragma once

#include <vector>

#include "fitting/result.h"
#include "solver/problem.h"

namespace mixity {

/// Fills in the parameters of `fit` that are not held, with the intervals and profiles that the options ask for.
/// `verdict` is on `cost`. If the search for the intervals found a lower cost, returns the parameters there, and the
/// fit has not converged; otherwise empty.
std::vector<double> add_parameters(const Problem& cost, const Verdict& verdict, const FitOptions& options,
                                   const Progress& progress, FitResult& fit);

/// Fills in bootstrap and influence, if the options ask for them, in the user's units.
void add_resampled(const Problem& cost, const Verdict& verdict, const Dataset& data, const FitOptions& options,
                   const Progress& progress, FitResult& fit);

}  // namespace mixity
