// Sums of two autoregressive processes, and their likelihood at many correlations at once.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "statistics/neighbour_correlations.h"

namespace mixity {

/// Deviations d = first u + second v of two processes u and v with variance 1.
struct TwoProcesses {
  std::vector<std::vector<std::size_t>> runs;  // indices of the deviations of each run, in their order
  std::vector<double> places;                  // per deviation: its position along the run, ascending
  std::vector<double> first, second;           // weights; not both 0
  /// At most kMostOwn columns with one number per deviation. Each run has its own multiple of each column, which is not
  /// noise: likelihoods are restricted to the remainder.
  std::vector<std::vector<double>> own{};
};

inline constexpr std::size_t kMostOwn = 2;

/// Correlations, and factors on the weights.
struct ScaledCorrelations {
  NeighbourCorrelations correlations;
  double first = 1, second = 1;
};

/// As many as are computed in the time of one.
inline constexpr std::size_t kTrials = 8;
using Trials = std::array<double, kTrials>;

/// The decorrelated deviations at each of several correlations: the sum of their squares, less what the columns of each
/// run explain; their number, less that of these columns; and ln of the determinant.
struct Independent {
  Trials squares, n, log_determinant;
};
Independent independent(const TwoProcesses& processes, std::span<const double> deviations,
                        const std::array<ScaledCorrelations, kTrials>& trials);

}  // namespace mixity
