// Fits as JSON; the schema stands in README.md beside this file.
#pragma once

#include <string>
#include <vector>

#include "jobs/job.h"

namespace mixity {

/// {schema, version, datasets: [...]}, indented, with a final newline.
/// `shard`: "2/10", of a part of a list; empty: the whole.
std::string to_json(const std::vector<JobResult>& results, const std::string& shard = {});

}  // namespace mixity
