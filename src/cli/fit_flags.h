// Flags of fits, and the requests made from them.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "analysis/result.h"
#include "cli/flags.h"

DECLARE_bool(pool);

namespace mixity::cli {

/// The request of a definition, or the default one for a data file, with the flags applied. Throws UsageError.
FitRequest request_for(const std::string& path, const std::optional<std::string>& model = {});

/// One request per argument, or one for all with --pool. Throws UsageError.
std::vector<FitRequest> requests_for(const std::vector<std::string>& arguments);
/// The data files of --pool. Throws UsageError for a definition.
std::vector<RunFile> pooled_files(const std::vector<std::string>& arguments);

}  // namespace mixity::cli
