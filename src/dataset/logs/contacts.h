// Finds contacts in a log, and the steps of the load in each.
#pragma once

#include <cstddef>
#include <vector>

#include "dataset/logs/frames.h"

namespace mixity {

/// Frames begin..end (end excluded).
struct FrameRange {
  std::size_t begin, end;
};

/// Ranges where the area exceeds its noise and 1/20 of its largest value. A few lost frames do not end a contact.
std::vector<FrameRange> contacts(const Frames& frames, double noise);

/// Steps of constant load in a contact, found by PELT: long enough, and without a steady rise or fall. A step that
/// differs little from the last one, as by drift or shear, is merged with it. `noise`: standard deviation of P;
/// `range`: of P in the log.
std::vector<FrameRange> load_steps(const Frames& frames, FrameRange contact, double noise, double range);

/// The zero of the load, from readings out of contact, and its standard error; both 0 if there are too few readings,
/// or if the load is stated.
struct LoadZero {
  double value = 0, error = 0;
};
LoadZero load_zero(const Frames& frames, const std::vector<FrameRange>& touching);

}  // namespace mixity
