// Stick-slip cycles of a sheared contact: the maxima of T and the minima that follow.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "dataset/logs/frames.h"

namespace mixity {

/// A maximum of T and the following minimum. Errors are standard errors; 0: unknown.
struct Cycle {
  double time = 0, T_peak = 0, error_peak = 0;  // s, N
  double time_min = 0;                          // s
  std::optional<double> T_min{};                // N; null: the readings end during the drop
  double error_min = 0;
};

/// T of the frames of a load step, positive in the direction of shear and zero at its start: T = direction * (T read) -
/// start. Indexed like the log; only the frames of the step are used.
struct Shear {
  const std::vector<double>& T;
  double direction, start;
  double noise;  // standard deviation of T
};

/// Cycles in frames begin..end (end excluded). The largest reading is biased: noise raises it, and averaging over a
/// frame lowers it. The maximum is therefore the end of the straight line along which T rises, and the minimum the
/// beginning of the next line (ends_of_drop). Both are found in the samples of the force if a frame has many, otherwise
/// in the frames. The final unloading, after which T stays below a tenth of its maximum, is not a cycle.
std::vector<Cycle> slip_cycles(const Frames& frames, const Shear& shear, std::size_t begin, std::size_t end);

}  // namespace mixity
