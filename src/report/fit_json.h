// Fits as JSON; the schema stands in README.md beside this file.
#pragma once

#include <string>
#include <vector>

#include "jobs/job.h"

namespace mixity {

/// {schema, version, datasets: [...]}, indented, with a final newline.
std::string to_json(const std::vector<JobResult>& results);

}  // namespace mixity
