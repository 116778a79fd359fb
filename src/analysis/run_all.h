// Runs several requests on all processors.
#pragma once

#include <functional>
#include <vector>

#include "analysis/result.h"

namespace mixity {

/// Whether the request's files are so small that several fits at once need little memory.
bool has_small_files(const FitRequest& request);

/// Calls run_one for each request, several at once where their files are small, and returns the results in order. Each
/// is what it is alone. Throws what the first request that fails throws.
std::vector<Analysis> run_all(const std::vector<FitRequest>& requests,
                              const std::function<Analysis(const FitRequest&, const Progress&)>& run_one,
                              const Progress& progress = {});

}  // namespace mixity
