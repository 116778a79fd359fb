// A progress bar on standard error.
#pragma once

#include "solver/options.h"

namespace mixity::cli {

/// The bar appears after one second, and only on a terminal. Copies share it.
Progress progress_line(const std::string& what);

}  // namespace mixity::cli
