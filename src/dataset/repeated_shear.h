// Runs at one load that follow each other in a file without names of runs.
#pragma once

#include "dataset/dataset.h"

namespace mixity {

/// Splits a run where T goes back, from one point to the next, from more than half of its largest value to near its
/// start, and then rises again. A run in which T falls and stays low, or that is not ordered by T, remains one. Adds a
/// note.
void split_repeated_shear(Dataset& data);

}  // namespace mixity
