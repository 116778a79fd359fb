// Files in which compression is negative.
#pragma once

#include "dataset/dataset.h"

namespace mixity {

/// The note of turn_loads.
inline constexpr const char* kLoadsTurned =
    "compression is negative in the file: its loads lie far below JKR's pull-off load, and its areas are those of "
    "-P; loads are turned round (P -> -P)";

/// Whether compression is certainly negative: there are contacts at loads far below the pull-off load of JKR, -3 pi/2
/// R G_Ic, none far above it, and areas grow as P falls or are those of JKR at -P.
bool compression_is_negative(const Dataset& data);

/// Changes the sign of P of all points and runs, and of the offset that is to be added to it; adds a note. Names of
/// runs stay.
void turn_loads(Dataset& data);

/// If the sign of some parts of a data set was changed, changes it in those whose loads are too small to decide; not
/// where the load is stated beside the file.
void turn_as_others(std::vector<Dataset>& parts);

}  // namespace mixity
