// Runs a request.
#pragma once

#include "analysis/result.h"

namespace mixity {

/// Fits the models in parallel, on as many threads as the machine has. Calls `progress` with the fraction done, from
/// any thread. Throws what load_dataset, exclude and fit_model throw.
Analysis run(const FitRequest& request, const Progress& progress = {});

/// The same for data in memory; ignores the request's paths and constants.
Analysis run(const FitRequest& request, Dataset data, const Progress& progress = {});

/// Every file that an analysis tried to read, existing or not. Results must not overwrite them.
std::vector<std::string> files_read(const Analysis& analysis);

}  // namespace mixity
