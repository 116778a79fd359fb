// What a minimum says of the parameters: values, standard errors, intervals, and how far they depend on the points.
#pragma once

#include <vector>

#include "fitting/result.h"
#include "solver/problem.h"

namespace mixity {

/// Fills in the parameters of `fit` that are not held, with the intervals and profiles that the options ask for. `cost`
/// is what the verdict is on. If the intervals met a lower cost, the parameters there are returned and the fit has not
/// converged; otherwise empty.
std::vector<double> add_parameters(const Problem& cost, const Verdict& verdict, const FitOptions& options,
                                   const Progress& progress, FitResult& fit);

/// Fills in bootstrap and influence, if the options ask for them, in a reader's units.
void add_resampled(const Problem& cost, const Verdict& verdict, const Dataset& data, const FitOptions& options,
                   const Progress& progress, FitResult& fit);

}  // namespace mixity
