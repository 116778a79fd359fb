// Compression that a file has as negative.
#pragma once

#include "dataset/dataset.h"

namespace mixity {

/// A note.
inline constexpr const char* kLoadsTurned =
    "compression is negative in the file: its loads lie far below JKR's pull-off load, and its areas are those of "
    "-P; loads are turned round (P -> -P)";

/// Of points with loads, whether it surely has: contact under loads far below that of JKR's pull-off, -3 pi/2 R G_Ic,
/// none above as much, and areas that grow as P falls or that are JKR's at -P.
bool compression_is_negative(const Dataset& data);

/// P -> -P of all points and runs, and of the offset that is to be added to P; with a note. Names of runs stay.
void turn_loads(Dataset& data);

/// Turns those of the parts of one data set whose loads are too small to tell, where others were turned; not where the
/// load is stated beside the file.
void turn_as_others(std::vector<Dataset>& parts);

}  // namespace mixity
