// Runs at one load that follow each other in a file which does not name them.
#pragma once

#include "dataset/dataset.h"

namespace mixity {

/// Parts a run where T goes back, from one point to the next in the file, from half of its largest to near where it
/// began, and then rises anew; what falls and stays, or comes in no order of T, remains one run. Adds a note. False if
/// there is no such run.
bool part_where_shear_begins_anew(Dataset& data);

}  // namespace mixity
