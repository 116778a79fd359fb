// Flags that say how the errors of a fit are treated.
#pragma once

#include "fitting/fit_definition.h"

namespace mixity::cli {

/// Sets what the flags that were given say; throws UsageError.
void add_statistics_flags(FitJob& job);

}  // namespace mixity::cli
