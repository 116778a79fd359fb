#include "cli/fit_flags.h"

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "analysis/fit_definition.h"
#include "analysis/job_options.h"
#include "base/output_file.h"
#include "base/printable.h"
#include "cli/flags.h"
#include "cli/law_flags.h"
#include "cli/usage_error.h"

namespace mixity::cli {
namespace {

/// One of modulus and youngs_modulus replaces the other.
void replace(Overrides& constants, const Overrides& with) {
  for (const auto& [name, text] : with) {
    const bool both = name == "modulus";  // instead of the two that it follows from
    const std::string_view other = both ? "youngs_modulus" : name == "youngs_modulus" ? "modulus" : "";
    std::erase_if(constants, [&](const auto& one) {
      return one.first == name || one.first == other || (both && one.first == "poisson_ratio");
    });
    constants.emplace_back(name, text);
  }
}

}  // namespace

FitJob job_for(const std::string& path) {
  FitJob job;
  if (path.ends_with(".toml"))
    job = read_fit_definition(path);
  else
    job.data_path = path;
  for (const std::string& note : job.law_notes) std::cerr << "mixity: " << note << '\n';
  const auto refuse = [](const std::string& option, const std::string& problem) {
    throw UsageError("flag '--" + option + "' " + problem);
  };
  for (const std::string_view option : kJobOptions) {
    if (!is_set(option)) continue;
    if (const std::string problem = set_option(job, option, value_of(option)); !problem.empty())
      refuse(std::string(option), problem);
  }
  if (!job.stated.contains("models"))
    job.models.insert(job.models.end(), laws_of_flags().begin(), laws_of_flags().end());
  if (const auto wrong = contradiction(job)) refuse(wrong->option, wrong->problem);
  replace(job.constants, data_overrides());
  return job;
}

std::vector<RunFile> pooled_files(const std::vector<std::string>& arguments) {
  std::vector<RunFile> files;
  for (const std::string& path : arguments) {
    if (path.ends_with(".toml"))
      throw UsageError("flag '--pool' takes data files; a definition lists its own: data = [...]");
    for (std::string& file : files_of(path)) files.push_back({std::move(file)});
  }
  return files;
}

std::vector<FitJob> jobs_for(const std::vector<std::string>& arguments) {
  std::vector<FitJob> jobs;
  if (FLAGS_pool) {
    jobs.push_back(job_for(arguments.front()));
    jobs.back().runs = pooled_files(arguments);
    jobs.back().data_path = jobs.back().runs.front().path;
    return jobs;
  }
  for (const std::string& path : arguments) jobs.push_back(job_for(path));
  return jobs;
}

std::vector<std::string_view> with_fit_flags(std::vector<std::string_view> flags) {
  flags.insert(flags.end(), kJobOptions.begin(), kJobOptions.end());
  flags.push_back("pool");
  return with_metadata_flags(with_law_flags(std::move(flags)));
}

void tell_names_apart(std::vector<JobResult>& results) {
  const auto place = [](const Dataset& data) { return std::filesystem::absolute(data.path).lexically_normal(); };
  std::vector<std::string> names;
  for (const JobResult& result : results) {
    const bool shared = std::any_of(results.begin(), results.end(), [&](const JobResult& other) {
      return other.data.name == result.data.name && place(other.data) != place(result.data);
    });
    const std::string folder = printable(place(result.data).parent_path().filename().string(), std::string::npos);
    names.push_back((shared ? folder + '/' : "") + result.data.name);
  }
  for (std::size_t i = 0; i < results.size(); ++i) results[i].data.name = names[i];
}

std::string file_stem(const JobResult& result, std::set<std::string>& taken) {
  const std::string name = plain_file_name(result.data.name);
  std::string stem = name;
  for (int i = 2; !taken.insert(stem).second; ++i) stem = name + "-" + std::to_string(i);
  return stem;
}

}  // namespace mixity::cli
