// Drift of the zero of T and noise of the apparatus, which are common to all loading runs of a log.
#pragma once

#include <optional>

#include "dataset/logs/loading_runs.h"

namespace mixity {

/// Fits a line to the baselines of the runs over time. Subtracts it from T within the runs if `stated` is true, or if
/// it is null and the slope is significant.
void remove_drift(std::optional<bool> stated, LoadingRuns& found);

/// Once the baselines are known, sets T, the smooth P and the standard errors of the kept frames, and the error of the
/// zero of T. `noise_A`: of the whole log, used if the runs are too short.
void estimate_errors(double noise_A, LoadingRuns& found);

}  // namespace mixity
