// The parabola of Sahli et al. (2018), A = A0 - alpha T^2, fitted to each loading run; the power law of alpha against
// A0 over the runs; and both as a mode-mixity model predicts them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dataset/dataset.h"

namespace mixity {

/// One run, dimensionless. Standard errors are from the scatter about the parabola; null with fewer than three points.
struct SahliRun {
  std::string curve;
  double P;
  std::size_t points;
  double A0, alpha;
  std::optional<double> A0_stderr, alpha_stderr;
  std::optional<double> alpha_predicted;  // by the model at this A0; null without a model or below pull-off
};

/// ln alpha = ln factor + exponent ln A0 over the runs with alpha > 0; null with fewer than two distinct A0.
struct PowerLaw {
  double factor, exponent;
  std::optional<double> exponent_stderr;  // null with two runs
};

struct SahliResult {
  std::vector<SahliRun> runs;
  std::vector<std::string> skipped;  // runs without two different T, by name
  std::optional<PowerLaw> power_law, predicted_power_law;
};

/// Unweighted least squares in T^2 over the points of each run up to `upto` (0..1] of its largest T, with readings
/// corrected by the stated constants. alpha is predicted by `model` with these parameter values in order; empty: not
/// predicted. The data set must have loads.
SahliResult fit_sahli(const Dataset& data, double upto, std::string_view model = {},
                      const std::vector<double>& parameters = {});

}  // namespace mixity
