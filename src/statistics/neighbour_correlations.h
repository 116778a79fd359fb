// Correlation of the noise of neighbouring readings.
#pragma once

namespace mixity {

/// Correlations of readings one position apart, from 0 to below 1.
struct NeighbourCorrelations {
  double first = 0, second = 0;
  bool any() const { return first > 0 || second > 0; }
};

}  // namespace mixity
