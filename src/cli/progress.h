// A line on standard error that says how far a long computation is.
#pragma once

#include "solver/options.h"

namespace mixity::cli {

/// Says nothing before a second has passed, and nothing at all if standard error is no terminal. Copies share the line.
Progress progress_line(const std::string& what);

}  // namespace mixity::cli
