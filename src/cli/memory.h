// How a run with large files uses its memory.
#pragma once

#include <vector>

#include "analysis/request.h"

namespace mixity::cli {

/// Where a file is large, lets lists of millions of points be made of memory that earlier ones have left: the C library
/// returns each to the system, which clears its pages anew for the next. Ten million points are fitted in a tenth less
/// time. Call it before threads start.
void keep_freed_memory(const std::vector<FitRequest>& requests);

}  // namespace mixity::cli
