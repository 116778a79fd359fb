// Negative readings: files where compression is negative, and runs with negative shear.
#pragma once

#include <vector>

#include "dataset/dataset.h"

namespace mixity {

/// The note that reverse_loads adds.
inline constexpr const char* kLoadsReversed =
    "compression is negative in the file: its loads lie far below JKR's pull-off load, and its areas are those of "
    "-P; loads were reversed (P -> -P)";

/// Whether compression is certainly negative: there are contacts at loads far below JKR's pull-off load -3 pi/2 R G_Ic,
/// none far above it, and areas grow as P falls or match JKR at -P.
bool compression_is_negative(const Dataset& data);

/// Reverses P of all points and runs, and the load offset; adds a note. Run names are unchanged.
void reverse_loads(Dataset& data);

/// If P was reversed in some parts of a data set, also reverses it in parts whose loads are too small to decide, unless
/// the load is stated beside the file.
void reverse_loads_alike(std::vector<Dataset>& parts);

/// To be called when all points are read. Adds a question about the zero of T if a run rises through zero from below.
/// Reverses T in runs sheared in the negative direction, and notes these and how many points are then below zero. Such
/// a run has at least three points, and its largest reading above zero is at most a tenth of its largest below.
void finish_shear(Dataset& data);

}  // namespace mixity
