// fits/NAME.toml: which data, which models, how, and what was published about them. Its keys are the flags of
// `mixity fit` (job_options.h), data, peaks, source and tables of constants and of published numbers.
#pragma once

#include <string>

#include "analysis/request.h"

namespace mixity {

/// Throws InputError with file, line and column for anything not understood.
FitRequest read_fit_definition(const std::string& path);

/// The definition of a request that was run with these data, to be written to `path`: files are named as seen from
/// there. Running it gives the same numbers, as long as the data and the constants beside them stay as they are.
std::string fit_definition_text(const FitRequest& request, const Dataset& data, const std::string& path);

}  // namespace mixity
