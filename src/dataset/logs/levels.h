// Where a log has contact, and under which loads.
#pragma once

#include <cstddef>
#include <vector>

#include "dataset/logs/frames.h"

namespace mixity {

/// Frames from begin to before end.
struct Stretch {
  std::size_t begin, end;
};

/// Where the area is above its noise and a twentieth of the largest; a lost frame or two do not end contact.
std::vector<Stretch> contacts(const Frames& frames, double noise);

/// Stretches of one load in a contact, by PELT: those of some length in which it does not steadily rise or fall. What
/// differs little from the level before, as by drift or by the shear, belongs to it. `noise` of P; `range` of P in the
/// log.
std::vector<Stretch> load_levels(const Frames& frames, Stretch contact, double noise, double range);

/// The zero of the load, as read out of contact, and its standard error; where too little is read there, error 0.
struct LoadZero {
  double value = 0, error = 0;
};
LoadZero load_zero(const Frames& frames, const std::vector<Stretch>& touching);

}  // namespace mixity
