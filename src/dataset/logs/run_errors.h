// The drift of the zero of T and the noise of the apparatus, which all loading runs of a log share.
#pragma once

#include <optional>

#include "dataset/logs/loading_runs.h"

namespace mixity {

/// Fits a line to the baselines of the runs over time. Subtracts it from T within the runs if this is stated, or if
/// nothing is stated and its slope is significant.
void remove_drift(std::optional<bool> stated, LoadingRuns& found);

/// After the baselines are known: sets T, the smooth P and the standard errors of the frames that the runs keep, and
/// the error of the zero of T. `noise_A`: of the whole log, used if the runs are too short.
void estimate_errors(double noise_A, LoadingRuns& found);

}  // namespace mixity
