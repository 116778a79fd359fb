// What all loading runs of a log have in common: the drift of the zero of T, and the noise of one apparatus.
#pragma once

#include <optional>

#include "dataset/logs/loading_runs.h"

namespace mixity {

/// Fits a line to the baselines of the runs over time, and takes it off T as a drift within the runs; if nothing is
/// stated, where its slope is sure.
void remove_drift(std::optional<bool> stated, LoadingRuns& found);

/// Once the baselines are known: fills in T, the smooth P and the standard errors of the frames that the runs keep, and
/// the error of the zero of T. `noise_A`: of the whole log, where the runs are too short.
void estimate_errors(double noise_A, LoadingRuns& found);

}  // namespace mixity
