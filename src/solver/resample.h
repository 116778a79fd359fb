// The dependence of fitted parameters on the choice of points: bootstrap, jackknife, influence. Values are converted by
// FreeParameter::shown. Weights remain those of the fit, even where they depend on its parameters.
#pragma once

#include <vector>

#include "solver/options.h"
#include "solver/problem.h"
#include "solver/results.h"

namespace mixity {

/// Refits of resampled points, each starting from the fit. `runs[i]` is the run of point i. Every replicate has its own
/// random stream, so that the result does not depend on the number of threads.
BootstrapResult bootstrap(const Problem& problem, const std::vector<double>& fitted,
                          const std::vector<std::size_t>& runs, const BootstrapOptions& options, double confidence,
                          const Progress& progress = {});

/// Influence of single points and runs: jackknife, leverage, Cook's distance.
Influence influence(const Problem& problem, const std::vector<double>& fitted, const std::vector<std::size_t>& runs,
                    unsigned threads, const Progress& progress = {});

}  // namespace mixity
