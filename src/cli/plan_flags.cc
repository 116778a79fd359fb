#include "cli/plan_flags.h"

#include "cli/contact_flags.h"
#include "cli/flags.h"
#include "cli/law_flags.h"

DEFINE_string(reach, "0.9", "the longest T of a run, as a share of that at which the contact jumps");

namespace mixity::cli {
namespace {

StatedError error_from(const std::string& flag) {
  const std::string text = is_set(flag) ? value_of(flag) : "1%";
  const auto error = parse_quantity(text);
  if (!error) throw must(flag, "be \"1%\" or a quantity");
  return *error;
}

}  // namespace

Plan plan_from_flags(bool needs_loads) {
  Plan plan;
  const ParameterValues p = parameters_from_flags(model_from(FLAGS_model));
  plan.model = FLAGS_model;
  plan.parameters.assign(p.begin(), p.end());
  apply_overrides(data_overrides(), plan.constants);
  if (is_set("loads"))
    for (const Quantity& load : quantities_from("loads")) {
      if (load.unit.dimension != dimension::force) throw UsageError("flag '--loads': a load needs a unit such as mN");
      plan.loads.push_back(load.si());
    }
  else if (needs_loads)
    throw UsageError("flag '--loads' is missing: the normal load of each run, \"1,2,4 mN\"");
  if (is_set("points")) plan.points = count_from("points", 3);
  const auto reach = parse_quantity(value_of("reach"));
  plan.reach = reach && reach->unit.dimension == dimension::none ? reach->si() : 0;
  plan.sigma_T = error_from("sigma_T");
  plan.sigma_A = error_from("sigma_A");
  Plan whole = plan;
  if (whole.loads.empty()) whole.loads = {0};  // for the check, which needs one
  if (const std::string problem = problem_of(whole); !problem.empty()) throw UsageError(problem);
  return plan;
}

std::vector<std::string_view> with_plan_flags(std::vector<std::string_view> flags) {
  flags.insert(flags.end(),
               {"model", "lambda", "parameters", "loads", "points", "reach", "sigma_T", "sigma_A", "seed"});
  return with_metadata_flags(with_law_flags(std::move(flags)));
}

std::size_t count_from(const std::string& flag, std::size_t least) {
  const auto number = parse_number(value_of(flag));
  if (!number || !(*number >= static_cast<double>(least)) || !(*number <= 1e9) ||
      *number != static_cast<double>(static_cast<std::size_t>(*number)))
    throw must(flag, "be a whole number from " + std::to_string(least) + " on");
  return static_cast<std::size_t>(*number);
}

}  // namespace mixity::cli
