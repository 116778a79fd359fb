// Flags that describe fits, and the jobs they make of definitions and data sets.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/job.h"

namespace mixity::cli {

/// A definition as it stands, or the default job for a CSV; flags that were given win over both. Throws UsageError.
FitJob job_for(const std::string& path);

/// One job for each argument, or with --pool one for all. Throws UsageError.
std::vector<FitJob> jobs_for(const std::vector<std::string>& arguments);
/// The files of --pool. Throws UsageError for a definition among them.
std::vector<RunFile> pooled_files(const std::vector<std::string>& arguments);

/// These flags and those that job_for reads, metadata included.
std::vector<std::string_view> with_fit_flags(std::vector<std::string_view> flags);

/// Gives data sets of one name that are different files the names of their folders, too: "a/run", "b/run".
void tell_names_apart(std::vector<JobResult>& results);

/// File names from data set names, made distinct where two data sets share one.
std::string file_stem(const JobResult& result, std::set<std::string>& taken);

}  // namespace mixity::cli
