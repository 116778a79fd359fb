// Negative readings: files in which compression is negative, and runs with negative shear.
#pragma once

#include <vector>

#include "dataset/dataset.h"

namespace mixity {

/// The note of reverse_loads.
inline constexpr const char* kLoadsReversed =
    "compression is negative in the file: its loads lie far below JKR's pull-off load, and its areas are those of "
    "-P; loads are turned round (P -> -P)";

/// Whether compression is certainly negative: there are contacts at loads far below the pull-off load of JKR, -3 pi/2
/// R G_Ic, none far above it, and areas grow as P falls or are those of JKR at -P.
bool compression_is_negative(const Dataset& data);

/// Reverses P of all points and runs, and the offset that is to be added to it; adds a note. Names of runs stay.
void reverse_loads(Dataset& data);

/// If P was reversed in some parts of a data set, reverses it in those whose loads are too small to decide, unless the
/// load is stated beside the file.
void reverse_loads_alike(std::vector<Dataset>& parts);

/// Once all points are read: asks about the zero of T if a run rises through zero from below. Reverses T in runs that
/// are sheared in the negative direction, and notes which, and how many points are below zero afterwards. A run is such
/// a run if it has at least three points and its largest reading above zero is at most a tenth of its largest below.
void finish_shear(Dataset& data);

}  // namespace mixity
