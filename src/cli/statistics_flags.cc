#include "cli/statistics_flags.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cli/flags.h"
#include "cli/usage_error.h"
#include "dataset/number_text.h"

namespace mixity::cli {
namespace {

std::optional<StatedError> error_from(const std::string& flag, const std::string& text) {
  if (text.empty()) return std::nullopt;
  auto quantity = parse_quantity(text);
  if (!quantity || !(quantity->value >= 0))
    throw UsageError("flag '--" + flag + "' is '" + text + "'; it must be a percentage or a quantity of 0 or more");
  return quantity;
}

double number_between(const std::string& flag, const std::string& text, double above, double below) {
  const auto value = parse_number(text);
  if (!value || !(*value > above && *value < below))
    throw UsageError("flag '--" + flag + "' is '" + text + "'; it must be a number above " + shortest(above) +
                     (std::isinf(below) ? "" : " and below " + shortest(below)));
  return *value;
}

Loss loss_from_flag() {
  for (const Loss loss : {Loss::none, Loss::huber, Loss::cauchy})
    if (FLAGS_loss == to_string(loss)) return loss;
  throw UsageError("flag '--loss' is '" + FLAGS_loss + "'; it must be none, huber or cauchy");
}

std::string known_constants() {
  std::string names;
  for (const std::string_view name : kConstantNames) names += (names.empty() ? "" : ", ") + std::string(name);
  return names;
}

/// Parameters of the fitted models may be named, too: they are free unless they are held.
std::vector<Constant> free_from_flag(const FitJob& job) {
  std::vector<Constant> constants;
  const std::vector<std::string> names = split_list("free", FLAGS_free);
  for (const std::string& name : names) {
    if (std::count(names.begin(), names.end(), name) > 1) throw UsageError("flag '--free' names '" + name + "' twice");
    const auto found = std::find(kConstantNames.begin(), kConstantNames.end(), name);
    if (found == kConstantNames.end()) {
      if (has_parameter(model_keys(), name) && !has_parameter(job.models, name))
        throw UsageError("flag '--free': no fitted model has a parameter '" + name + "'");
      for (const HeldParameter& held : job.options.hold)
        if (held.name == name) throw UsageError("parameter '" + name + "' is to be held and to be free");
      if (has_parameter(job.models, name)) continue;
      throw UsageError("flag '--free': '" + name + "' cannot be fitted (known: " + known_constants() +
                       ", model parameters)");
    }
    constants.push_back(static_cast<Constant>(found - kConstantNames.begin()));
  }
  return constants;
}

}  // namespace

void add_statistics_flags(FitJob& job) {
  FitOptions& options = job.options;
  if (is_set("weighted")) options.weighted = FLAGS_weighted;
  if (options.weighted && options.objective == Objective::curve)
    throw UsageError("flag '--weighted' needs --objective=toughness; curve weighs the points anyway");
  if (is_set("sigma_T")) options.sigma_T = error_from("sigma_T", FLAGS_sigma_T);
  if (is_set("sigma_A")) options.sigma_A = error_from("sigma_A", FLAGS_sigma_A);
  if ((options.sigma_T || options.sigma_A) && options.objective == Objective::toughness && !options.weighted)
    throw UsageError("flag '--sigma_" + std::string(options.sigma_A ? "A" : "T") +
                     "' needs --objective=curve, or --weighted");
  if (is_set("loss")) options.loss = loss_from_flag();
  if (is_set("loss_scale"))
    options.loss_scale = number_between("loss_scale", FLAGS_loss_scale, 0, std::numeric_limits<double>::infinity());
  if (options.loss_scale && options.loss == Loss::none)
    throw UsageError("flag '--loss_scale' needs --loss=huber or cauchy");
  if (is_set("free")) options.free = free_from_flag(job);
  if (is_set("interval")) {
    if (FLAGS_interval != "profile" && FLAGS_interval != "none")
      throw UsageError("flag '--interval' is '" + FLAGS_interval + "'; it must be profile or none");
    options.intervals = FLAGS_interval == "profile";
  }
  if (FLAGS_bootstrap < 0 || FLAGS_bootstrap > 10000000)
    throw UsageError("flag '--bootstrap' must be from 0 to 10000000");
  if (FLAGS_threads < 0) throw UsageError("flag '--threads' must not be negative");
  if (FLAGS_seed < 0) throw UsageError("flag '--seed' must not be negative");
  if (FLAGS_resample != "points" && FLAGS_resample != "curves")
    throw UsageError("flag '--resample' is '" + FLAGS_resample + "'; it must be points or curves");
  options.bootstrap = {static_cast<std::size_t>(FLAGS_bootstrap),
                       FLAGS_resample == "curves" ? Resample::curves : Resample::points,
                       static_cast<std::uint64_t>(FLAGS_seed), static_cast<unsigned>(FLAGS_threads)};
  for (const char* flag : {"resample", "seed"})
    if (is_set(flag) && options.bootstrap.replicates == 0)
      throw UsageError("flag '--" + std::string(flag) + "' needs --bootstrap");
  options.influence = FLAGS_influence;
  if (is_set("threads") && options.bootstrap.replicates == 0 && !options.influence)
    throw UsageError("flag '--threads' needs --bootstrap or --influence");
  if (is_set("confidence") && !options.intervals && options.bootstrap.replicates == 0)
    throw UsageError("flag '--confidence' needs --interval=profile or --bootstrap");
  if (FLAGS_lambda_prior != "uniform" && FLAGS_lambda_prior != "log_uniform")
    throw UsageError("flag '--lambda_prior' is '" + FLAGS_lambda_prior + "'; it must be uniform or log_uniform");
  if (FLAGS_lambda_prior == "log_uniform") options.lambda_prior = RangePrior::log_uniform;
  if (is_set("confidence")) options.confidence = number_between("confidence", FLAGS_confidence, 0, 1);
}

}  // namespace mixity::cli
