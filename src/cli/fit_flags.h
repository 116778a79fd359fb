// Flags that describe fits, and the requests they make of definitions and data sets.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/result.h"

namespace mixity::cli {

/// A definition as it stands, or the default request for a CSV; flags that were given win over both. Throws UsageError.
FitRequest request_for(const std::string& path);

/// One request for each argument, or with --pool one for all. Throws UsageError.
std::vector<FitRequest> requests_for(const std::vector<std::string>& arguments);
/// The files of --pool. Throws UsageError for a definition among them.
std::vector<RunFile> pooled_files(const std::vector<std::string>& arguments);

/// These flags and those that request_for reads, metadata included.
std::vector<std::string_view> with_fit_flags(std::vector<std::string_view> flags);

/// Gives data sets of one name that are different files the names of their folders, too: "a/run", "b/run".
void tell_names_apart(std::vector<Analysis>& results);

/// File names from data set names, made distinct where two data sets share one.
std::string file_stem(const Analysis& result, std::set<std::string>& taken);

}  // namespace mixity::cli
