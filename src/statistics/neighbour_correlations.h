// How far the noise of neighbouring readings resembles itself.
#pragma once

namespace mixity {

/// Correlations of readings one place apart, 0 to below 1.
struct NeighbourCorrelations {
  double first = 0, second = 0;
  bool any() const { return first > 0 || second > 0; }
};

}  // namespace mixity
