// Stick and slip of a sheared contact: the maxima of T and the minima behind them.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "dataset/logs/frames.h"

namespace mixity {

/// A maximum of T, and the minimum that follows: one of stick and slip. Errors are standard errors; 0: not known.
struct Cycle {
  double time = 0, T_peak = 0, error_peak = 0;  // s, N
  double time_min = 0;                          // s
  std::optional<double> T_min{};                // N; null: the fall was still going on where the readings end
  double error_min = 0;
};

/// T of frames, turned so that the shear raises it: T = direction * (T read) - start.
struct TurnedShear {
  const std::vector<double>& T;
  double direction, start;
  double noise;  // standard deviation of T
};

/// Cycles in frames begin..end (end not included). A maximum is not the largest reading, which noise raises and the
/// mean over a frame lowers, but the end of the straight line that T rose along, at the time where it leaves that; the
/// minimum is the beginning of the line behind (ends_of_fall). Read from the samples of the force where a frame holds
/// many, else from the frames. Where the shear is taken back in the end is no cycle: T stays below a tenth of its
/// largest from there on.
std::vector<Cycle> slip_cycles(const Frames& frames, const TurnedShear& shear, std::size_t begin, std::size_t end);

}  // namespace mixity
