// Readings of the tangential load below zero: noise about zero, or a run that is sheared the other way.
#pragma once

#include "dataset/dataset.h"

namespace mixity {

/// Once all points are read: asks for the zero of T where a run rises through it from below; changes the sign of T in
/// runs that are sheared the other way, and notes which, and how many points are below zero then. A run is sheared the
/// other way if it has three points or more and its largest reading above zero is at most a tenth of its largest below.
void finish_shear(Dataset& data);

}  // namespace mixity
