#include "cli/fit_flags.h"

#include <algorithm>
#include <filesystem>

#include "cli/flags.h"
#include "cli/statistics_flags.h"
#include "cli/usage_error.h"
#include "dataset/printable.h"
#include "jobs/fit_definition.h"
#include "report/output_file.h"

namespace mixity::cli {
namespace {

std::vector<std::string> models_from_flag() {
  std::vector<std::string> models = split_list("models", FLAGS_models);
  for (auto model = models.begin(); model != models.end(); ++model) {
    require_model("models", *model);
    if (std::find(models.begin(), model, *model) != model)
      throw UsageError("flag '--models' names '" + *model + "' twice");
  }
  return models;
}

Scale scale_from_flag() {
  for (const Scale scale : {Scale::log, Scale::linear})
    if (FLAGS_scale == to_string(scale)) return scale;
  throw UsageError("flag '--scale' is '" + FLAGS_scale + "'; it must be log or linear");
}

std::vector<HeldParameter> hold_from_flag() {
  std::vector<HeldParameter> hold;
  for (const std::string& item : split_list("hold", FLAGS_hold)) {
    const auto held = parse_held(item);
    if (!held) throw UsageError("flag '--hold': '" + item + "' is neither a parameter nor PARAMETER=NUMBER");
    hold.push_back(*held);
  }
  return hold;
}

Objective objective_from_flag() {
  if (FLAGS_objective == "area") throw UsageError("flag '--objective': " + std::string(kNoAreaObjective));
  const auto objective = parse_objective(FLAGS_objective);
  if (!objective) throw UsageError("flag '--objective' is '" + FLAGS_objective + "'; it must be toughness or curve");
  return *objective;
}

}  // namespace

FitJob job_for(const std::string& path) {
  FitJob job;
  const bool is_definition = path.ends_with(".toml");
  if (is_definition)
    job = read_fit_definition(path);
  else
    job.data_path = path;
  if (!is_definition || is_set("models")) job.models = models_from_flag();
  if (is_set("objective")) job.options.objective = objective_from_flag();
  if (is_set("scale")) job.options.scale = scale_from_flag();
  if (is_set("scale") && job.options.objective == Objective::curve)
    throw UsageError("flag '--scale' needs --objective=toughness");
  if (!is_definition || is_set("hold")) job.options.hold = hold_from_flag();
  add_statistics_flags(job);
  if (is_set("compare")) job.compare = FLAGS_compare;
  if (!FLAGS_per.empty() && FLAGS_per != "curve")
    throw UsageError("flag '--per' is '" + FLAGS_per + "'; it must be curve");
  job.per_curve |= FLAGS_per == "curve";
  for (const HeldParameter& held : job.options.hold) {
    if (!has_parameter(job.models, held.name))
      throw UsageError((is_set("hold") || !is_definition ? "flag '--hold': " : "flag '--models': ") +
                       ("no fitted model has a parameter '" + held.name + "'"));
    const auto same = [&](const HeldParameter& other) { return other.name == held.name; };
    if (std::count_if(job.options.hold.begin(), job.options.hold.end(), same) > 1)
      throw UsageError("flag '--hold' names '" + held.name + "' twice");
  }
  return job;
}

std::vector<std::string_view> with_fit_flags(std::vector<std::string_view> flags) {
  flags.insert(flags.end(),
               {"models",     "objective", "scale",   "weighted",  "sigma_T",    "sigma_A",      "loss",
                "loss_scale", "hold",      "free",    "interval",  "confidence", "lambda_prior", "bootstrap",
                "resample",   "seed",      "threads", "influence", "compare",    "per"});
  return with_metadata_flags(std::move(flags));
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
