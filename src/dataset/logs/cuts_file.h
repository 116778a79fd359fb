// Times, stated by the user, at which the runs of a log are cut.
#pragma once

#include <map>
#include <string>

#include "dataset/logs/loading_runs.h"

namespace mixity {

/// Reads [[cuts]] with run, and shear = "2.1 s", onset = "4.31 s" or leave_out = true. Throws InputError, with line and
/// column, for anything else.
std::map<std::string, StatedCut> read_cuts(const std::string& path);

}  // namespace mixity
