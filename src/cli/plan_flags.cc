#include "cli/plan_flags.h"

#include <algorithm>

#include "analysis/contact_shape.h"
#include "base/number_text.h"
#include "cli/contact_flags.h"
#include "cli/flags.h"

DEFINE_string(reach, "0.9", "the largest T of a run, as a fraction of the T at which the contact jumps");

namespace mixity::cli {
namespace {

StatedError error_from(const std::string& flag) {
  if (!is_set(flag)) return *parse_quantity("1%");
  return quantity_from(flag, "be \"1%\" or a quantity", [](const Quantity&) { return true; });
}

void require_affordable(const Plan& plan, const PointCost& cost) {
  const double runs = static_cast<double>(std::max<std::size_t>(plan.loads.size(), 1));
  const double all = runs * static_cast<double>(plan.points);
  if (all <= static_cast<double>(cost.most)) return;
  throw refused("points", shortest(all) + " points of all runs would take some " + rounded(1e-9 * cost.bytes * all, 2) +
                              " GB; at most " + std::to_string(cost.most));
}

}  // namespace

Plan plan_from_flags(bool needs_loads, const PointCost& cost) {
  Plan plan;
  constexpr std::string_view kOfRuns[]{"load"};  // the same as --loads
  Overrides constants = data_overrides(kOfRuns);
  plan.model = FLAGS_model;
  if (take_ellipse(constants)) plan.model += kEllipse;
  const ParameterValues p = parameters_from_flags(model_from(plan.model));
  plan.parameters.assign(p.begin(), p.end());
  plan.constants = stated_by(constants);
  if (const std::string flag = flag_of_loads(""); !flag.empty())
    for (const Quantity& load : quantities_from(flag)) {
      const bool held = plan.constants.control == NormalControl::approach;
      if (load.unit.dimension != (held ? dimension::length : dimension::force))
        throw refused(flag, held ? "a held approach needs a unit such as um" : "a load needs a unit such as mN");
      plan.loads.push_back(load.si());
      if (flag == "load" && plan.loads.size() > 1) throw not_one_number(flag);
    }
  else if (needs_loads)
    throw UsageError(plan.constants.control == NormalControl::approach
                         ? "flag '--loads' is missing: the approach held in each run, \"3,8,15 um\""
                         : "flag '--loads' is missing: the normal load of each run, \"1,2,4 mN\"");
  if (is_set("points")) plan.points = count_from("points", 3);
  require_affordable(plan, cost);
  const auto reach = parse_quantity(value_of("reach"));
  plan.reach = reach && reach->unit.dimension == dimension::none ? reach->si() : 0;
  plan.sigma_T = error_from("sigma_T");
  plan.sigma_A = error_from("sigma_A");
  Plan whole = plan;
  if (whole.loads.empty()) whole.loads = {0};  // a dummy load for the check, which needs one
  if (const std::string problem = problem_of(whole); !problem.empty()) throw UsageError(problem);
  return plan;
}

}  // namespace mixity::cli
