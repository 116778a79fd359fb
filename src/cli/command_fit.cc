// mixity fit: definitions and data sets in, fits out.
#include <iostream>
#include <set>

#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/flags.h"
#include "cli/statistics_flags.h"
#include "cli/usage_error.h"
#include "dataset/input_error.h"
#include "fitting/fit_definition.h"
#include "report/fit_csv.h"
#include "report/fit_json.h"
#include "report/fit_text.h"
#include "report/output_file.h"

namespace mixity::cli {
namespace {

std::vector<std::string> models_from_flag() {
  std::vector<std::string> models = split_list(FLAGS_models);
  if (models.empty()) throw UsageError("flag '--models' names no model");
  for (const std::string& model : models) require_model("models", model);
  return models;
}

Scale scale_from_flag() {
  for (const Scale scale : {Scale::log, Scale::linear})
    if (FLAGS_scale == to_string(scale)) return scale;
  throw UsageError("flag '--scale' is '" + FLAGS_scale + "'; it must be log or linear");
}

std::vector<HeldParameter> hold_from_flag() {
  std::vector<HeldParameter> hold;
  for (const std::string& item : split_list(FLAGS_hold)) {
    const auto held = parse_held(item);
    if (!held) throw UsageError("flag '--hold': '" + item + "' is neither a parameter nor PARAMETER=NUMBER");
    hold.push_back(*held);
  }
  return hold;
}

Objective objective_from_flag() {
  const auto objective = parse_objective(FLAGS_objective);
  if (!objective)
    throw UsageError("flag '--objective' is '" + FLAGS_objective + "'; it must be toughness, area or curve");
  return *objective;
}

/// A definition as it stands, or the default job for a CSV; flags that were given win over both.
FitJob job_for(const std::string& path) {
  FitJob job;
  const bool is_definition = path.ends_with(".toml");
  if (is_definition)
    job = read_fit_definition(path);
  else
    job.data_path = path;
  if (!is_definition || is_set("models")) job.models = models_from_flag();
  if (!is_definition || is_set("objective")) job.options.objective = objective_from_flag();
  if (!is_definition || is_set("scale")) job.options.scale = scale_from_flag();
  if (!is_definition || is_set("hold")) job.options.hold = hold_from_flag();
  add_statistics_flags(job.options);
  if (is_set("compare")) job.compare = FLAGS_compare;
  if (!FLAGS_per.empty() && FLAGS_per != "curve")
    throw UsageError("flag '--per' is '" + FLAGS_per + "'; it must be curve");
  job.per_curve |= FLAGS_per == "curve";
  for (const HeldParameter& held : job.options.hold)
    if (!has_parameter(job.models, held.name))
      throw UsageError("flag '--hold': no fitted model has a parameter '" + held.name + "'");
  return job;
}

/// File names from data set names, made distinct where two data sets share one.
std::string file_stem(const JobResult& result, std::set<std::string>& taken) {
  std::string stem = result.data.name;
  for (int i = 2; !taken.insert(stem).second; ++i) stem = result.data.name + "-" + std::to_string(i);
  return stem;
}

void write_folder(const std::string& folder, const std::vector<JobResult>& results, const std::string& text) {
  std::set<std::string> taken;
  for (const JobResult& result : results) {
    const std::string stem = folder + "/" + file_stem(result, taken);
    write_file(stem + "_residuals.csv", residuals_csv(result));
    write_file(stem + "_curves.csv", curves_csv(result));
  }
  write_file(folder + "/fits.csv", fits_csv(results));
  write_file(folder + "/fits.json", to_json(results));
  write_file(folder + "/fits.txt", text);
}

}  // namespace

int run_fit(const Arguments& arguments) {
  if (arguments.empty()) throw UsageError("fit needs a data CSV or a fit definition (see mixity help fit)");
  if (FLAGS_format != "text" && FLAGS_format != "json" && FLAGS_format != "csv")
    throw UsageError("flag '--format' is '" + FLAGS_format + "'; it must be text, json or csv");
  const Overrides overrides = metadata_overrides();

  std::vector<JobResult> results;
  bool all_ok = true;
  for (const std::string& path : arguments) {
    results.push_back(run(job_for(path), overrides));
    for (const FitResult& fit : results.back().fits) all_ok &= fit.status == FitStatus::ok;
  }
  std::string text;
  for (const JobResult& result : results) text += (text.empty() ? "" : "\n") + to_text(result);
  if (!FLAGS_out.empty()) write_folder(FLAGS_out, results, text);
  std::cout << (FLAGS_format == "json" ? to_json(results) : FLAGS_format == "csv" ? fits_csv(results) : text);
  return all_ok ? kFine : kFitNotOk;
}

}  // namespace mixity::cli
