// Fit definitions, fits/NAME.toml: data, models, options, and published numbers to compare with. Keys are the options
// of settings.h, data, runs, peaks, log_figures, source, and the tables columns, constants, laws and published.
#pragma once

#include <string>

#include "analysis/request.h"

namespace mixity {

/// Throws InputError with file, line and column.
FitRequest read_fit_definition(const std::string& path);

/// A definition that repeats this analysis, for the file `path`: file names are relative to its folder. It gives the
/// same numbers as long as the data and the constants beside them do not change.
std::string fit_definition_text(const FitRequest& request, const Dataset& data, const std::string& path);

}  // namespace mixity
