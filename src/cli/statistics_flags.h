// Flags that say how the errors of a fit are treated.
#pragma once

#include "jobs/job.h"

namespace mixity::cli {

/// Sets what the flags that were given say; throws UsageError.
void add_statistics_flags(FitJob& job);

}  // namespace mixity::cli
