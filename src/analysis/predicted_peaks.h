// What a fitted model predicts of the peak force: the tangential load of its fold over the area of Hertz (the paper's
// Fig. 11), and how the peaks that were measured compare.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/result.h"
#include "dataset/peak_forces.h"

namespace mixity {

struct PredictedPeak {
  double P, stress, low, high;  // in the units of the peak forces; low and high at the ends of lambda's interval
};

struct PredictedPeaks {
  std::string model;
  std::vector<PredictedPeak> loads;  // those of the peaks that were measured, without loads at which nothing jumps
  /// First measured peaks over predicted ones, and the standard error of that mean; null with fewer than two.
  std::optional<double> ratio{}, ratio_error{};
};

/// The first row of each load that has such a value, by load: of a test that slips again and again, the first cycle.
std::vector<const PeakForce*> first_of_loads(const PeakForces& peaks, std::optional<double> PeakForce::*value);

/// Of each fit that has values. Empty if the peaks have units and the data have none, or the other way round.
std::vector<PredictedPeaks> predict_peaks(const Analysis& result, const PeakForces& peaks);

}  // namespace mixity
