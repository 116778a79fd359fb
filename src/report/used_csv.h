// The points of a data set as a file of its own, which reads as they do.
#pragma once

#include <string>

#include "dataset/dataset.h"

namespace mixity {

/// In the units of the file or files that were read: curve, P, T, A and the standard errors that were stated; psi and
/// Gc_over_GIc without loads.
std::string used_csv(const Dataset& data);

}  // namespace mixity
