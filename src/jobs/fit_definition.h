// fits/NAME.toml: which data, which models, how, and what was published about them.
#pragma once

#include <string>

#include "jobs/job.h"

namespace mixity {

/// Throws InputError with file, line and column for anything not understood.
FitJob read_fit_definition(const std::string& path);

}  // namespace mixity
