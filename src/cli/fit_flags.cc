#include "cli/fit_flags.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "analysis/contact_shape.h"
#include "analysis/fit_definition.h"
#include "analysis/result.h"
#include "analysis/settings.h"
#include "base/files.h"
#include "base/text.h"
#include "cli/flag_words.h"
#include "cli/flags.h"

DEFINE_bool(pool, false, "treat the files as the runs of one data set");

namespace mixity::cli {
namespace {

/// Overrides constants. modulus and youngs_modulus replace each other; modulus also replaces poisson_ratio, unless mode
/// III is averaged, which needs it.
void replace(Overrides& constants, const Overrides& with) {
  const auto averages = [](const auto& one) { return one.first == "mode_III" && one.second == "averaged"; };
  const bool averaged =
      std::any_of(constants.begin(), constants.end(), averages) || std::any_of(with.begin(), with.end(), averages);
  for (const auto& one_of_them : with) {
    const std::string& name = one_of_them.first;  // clang 14 captures no structured binding
    const bool both = name == "modulus";
    const std::string_view other = both ? "youngs_modulus" : name == "youngs_modulus" ? "modulus" : "";
    std::erase_if(constants, [&](const auto& one) {
      return one.first == name || one.first == other || (both && !averaged && one.first == "poisson_ratio");
    });
    constants.push_back(one_of_them);
  }
}

}  // namespace

FitRequest request_for(const std::string& path, const std::optional<std::string>& model) {
  FitRequest request;
  if (path.ends_with(".toml"))
    request = read_fit_definition(path);
  else
    request.data_path = path;
  request.words = in_flags;
  for (const std::string& note : request.law_notes) warn(note);
  const auto refuse = [](const std::string& option, const std::string& problem) {
    throw UsageError("flag '--" + option + "' " + problem);
  };
  for (const Setting& option : settings()) {
    if (!is_set(option.name)) continue;
    if (const std::string problem = set_option(request, option.name, value_of(option.name)); !problem.empty())
      refuse(option.name, problem);
  }
  if (!request.stated.contains("models"))
    request.models.insert(request.models.end(), laws_of_flags().begin(), laws_of_flags().end());
  if (model) request.models = {*model};
  replace(request.constants, data_overrides());
  take_shape(request);
  if (const auto wrong = contradiction(request)) refuse(wrong->option, wrong->problem);
  const std::vector<InputFile>& laws = inputs_of_laws().files();
  request.inputs.insert(request.inputs.end(), laws.begin(), laws.end());
  return request;
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

std::vector<FitRequest> requests_for(const std::vector<std::string>& arguments) {
  std::vector<FitRequest> requests;
  if (FLAGS_pool) {
    requests.push_back(request_for(arguments.front()));
    requests.back().runs = pooled_files(arguments);
    requests.back().data_path = requests.back().runs.front().path;
    return requests;
  }
  for (const std::string& path : arguments) requests.push_back(request_for(path));
  return requests;
}

}  // namespace mixity::cli
