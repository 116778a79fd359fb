// The predicted peak force, the tangential load at the fold over the Hertz area (the paper's Fig. 11), compared with
// measured peaks.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/result.h"
#include "dataset/peak_forces.h"

namespace mixity {

struct PredictedPeak {
  double P, stress, low, high;  // in the units of the peaks; low and high: at the ends of lambda's interval
};

struct PredictedPeaks {
  std::string model;
  std::vector<PredictedPeak> loads;  // at the loads of measured peaks with a jump
  /// Mean of measured over predicted peaks (first cycles), and its standard error; null with fewer than two.
  std::optional<double> ratio{}, ratio_error{};
};

/// The first row with this value at each load, by load: the first cycle of a stick-slip test.
std::vector<const PeakForce*> first_of_loads(const PeakForces& peaks, std::optional<double> PeakForce::*value);

/// One entry per fit with values. Empty if only one of peaks and data has units.
std::vector<PredictedPeaks> predict_peaks(const Analysis& result, const PeakForces& peaks);

}  // namespace mixity
