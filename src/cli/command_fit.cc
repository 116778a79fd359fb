// mixity fit: fits definitions and data sets.
#include <filesystem>
#include <iostream>
#include <set>
#include <utility>

#include "analysis/fit_definition.h"
#include "analysis/judgement.h"
#include "analysis/result_names.h"
#include "analysis/run.h"
#include "analysis/run_all.h"
#include "base/files.h"
#include "base/inputs.h"
#include "base/units.h"
#include "cli/commands.h"
#include "cli/fit_flags.h"
#include "cli/flags.h"
#include "cli/memory.h"
#include "cli/progress.h"
#include "report/fit_csv.h"
#include "report/fit_json.h"
#include "report/fit_text.h"

DEFINE_string(shard, "",
              "fit only a part of the files, i/n: every n-th from the i-th on (mixity merge merges the parts)");

namespace mixity::cli {
namespace {

/// With --shard=i/n every n-th argument, starting with the i-th; `mixity merge` restores the order. Throws UsageError.
Arguments shard_of(const Arguments& arguments) {
  if (FLAGS_shard.empty()) return arguments;
  const auto shard = shard_number(FLAGS_shard);
  if (!shard) throw must("shard", "be i/n, such as 2/10");
  Arguments mine;
  for (std::size_t i = shard->part - 1; i < arguments.size(); i += shard->of) mine.push_back(arguments[i]);
  return mine;
}

std::vector<OutputFile> result_files(const std::string& folder, const std::vector<Analysis>& results,
                                     const std::string& text, const Shard& shard) {
  std::set<std::string> taken;
  std::vector<OutputFile> files;
  const auto add = [&](const std::string& name, std::string content) {
    files.push_back({folder + "/" + name, std::move(content)});
  };
  for (const Analysis& result : results) {
    const std::string stem = file_stem(result, taken);
    add(stem + "_residuals.csv", residuals_csv(result));
    if (!result.data.pull_off.empty()) add(stem + "_pull_off.csv", pull_off_csv(result));
    add(stem + "_curves.csv", curves_csv(result));
  }
  add("fits.csv", fits_csv(results));
  add("fits.json", to_json(results, shard));
  add("fits.txt", text);
  return files;
}

/// What the parts of a list must share to be merged: everything that affects results.
Shard campaign_of(const Arguments& arguments) {
  Shard shard{FLAGS_shard, arguments};
  for (const std::string_view flag : with_fit_flags({}))
    if (flag != "threads" && is_set(flag)) shard.flags.emplace(flag, value_of(flag));
  return shard;
}

/// Refuses a path that has the constants of a data file.
void require_definition_path(const std::string& path) {
  for (const char* ending : {".csv", ".CSV", ".txt", ".dat"}) {
    const std::string data = path.substr(0, path.size() - 5) + ending;
    if (std::filesystem::exists(data))
      throw refused("save", path + " is where the constants of " + data + " stand; take another name");
  }
}

}  // namespace

int run_fit(const Arguments& arguments) {
  if (arguments.empty()) throw UsageError("fit needs a data CSV or a fit definition (see mixity help fit)");
  if (!FLAGS_shard.empty() && FLAGS_pool)
    throw UsageError("flag '--shard' divides data sets, but with --pool there is only one");
  const std::vector<FitRequest> requests = requests_for(shard_of(arguments));
  const Shard shard = campaign_of(arguments);
  if (!FLAGS_save.empty() && requests.size() > 1) throw UsageError("flag '--save' needs exactly one data set");
  if (!FLAGS_save.empty()) require_definition_path(path_to_save());
  bool all_ok = true;
  const Progress progress = progress_line("fit");
  keep_freed_memory(requests);
  std::vector<Analysis> results = run_all(
      requests,
      [](const FitRequest& one, const Progress& part) {
        Dataset data =
            one.runs.empty() ? load_dataset(one.data_path, one.constants) : load_pooled(one.runs, one.constants);
        forget_large_contents(data.inputs);  // which would stay in memory beside the points
        return run(one, std::move(data), part);
      },
      progress);
  for (const Analysis& one : results) all_ok &= can_be_believed(one);
  if (progress) progress(1);
  make_names_unique(results);
  std::string text;
  for (const Analysis& result : results)
    if (FLAGS_format == "text" || !FLAGS_out.empty()) text += (text.empty() ? "" : "\n") + to_text(result);
  std::vector<OutputFile> files;
  std::vector<std::string> inputs;
  for (const Analysis& result : results)
    for (std::string& input : files_read(result)) inputs.push_back(std::move(input));
  if (!FLAGS_out.empty()) files = result_files(FLAGS_out, results, text, shard);
  if (!FLAGS_save.empty())
    files.push_back({FLAGS_save, fit_definition_text(results[0].request, results[0].data, FLAGS_save)});
  write_outputs(files, {inputs});
  std::cout << (FLAGS_format == "json" ? to_json(results, shard) : FLAGS_format == "csv" ? fits_csv(results) : text);
  return all_ok ? kFine : kFitNotOk;
}

}  // namespace mixity::cli
