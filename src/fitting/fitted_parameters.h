// The parameters at a minimum: values, standard errors, intervals, and their dependence on the points.
#pragma once

#include <vector>

#include "fitting/result.h"
#include "solver/problem.h"

namespace mixity {

/// Fills in the parameters of `fit` that are not held, with the intervals and profiles that the options request.
/// `verdict` belongs to `cost`. Normally returns an empty vector. If the search for intervals found a lower cost, the
/// fit has not converged, and the parameters there are returned.
std::vector<double> add_parameters(const Problem& cost, const Verdict& verdict, const FitOptions& options,
                                   const Progress& progress, FitResult& fit);

/// Fills in bootstrap and influence in the user's units, if the options request them.
void add_resampled(const Problem& cost, const Verdict& verdict, const Dataset& data, const FitOptions& options,
                   const Progress& progress, FitResult& fit);

}  // namespace mixity
