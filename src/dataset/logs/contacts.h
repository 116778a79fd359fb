// Contacts in a log, and the steps of the load in each.
#pragma once

#include <cstddef>
#include <vector>

#include "dataset/logs/frames.h"

namespace mixity {

/// Frames begin..end (end excluded).
struct FrameRange {
  std::size_t begin, end;
};

/// Where the area exceeds its noise and a twentieth of the largest. A few lost frames do not end a contact.
std::vector<FrameRange> contacts(const Frames& frames, double noise);

/// Steps of constant load in a contact, found by PELT: long enough, and without a steady rise or fall. A step that
/// differs little from the one before, as by drift or shear, is part of it. `noise`: standard deviation of P; `range`:
/// of P in the log.
std::vector<FrameRange> load_steps(const Frames& frames, FrameRange contact, double noise, double range);

/// The zero of the load, read out of contact, and its standard error; both 0 if there are too few readings.
struct LoadZero {
  double value = 0, error = 0;
};
LoadZero load_zero(const Frames& frames, const std::vector<FrameRange>& touching);

}  // namespace mixity
