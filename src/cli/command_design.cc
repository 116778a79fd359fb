// mixity design: what a planned experiment will tell, and which loads to measure next.
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>

#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/flags.h"
#include "cli/plan_flags.h"
#include "cli/progress.h"
#include "cli/quantity_list.h"
#include "cli/usage_error.h"
#include "dataset/number_text.h"
#include "mechanics/any_model.h"
#include "studies/design.h"

namespace mixity::cli {
namespace {

constexpr double kMilli = 1e-3;
constexpr std::size_t kCandidates = 21, kMostRuns = 30;
constexpr double kSureOdds = 19;  // 95 %

std::string error_text(const Plan& plan, const std::optional<double>& error) {
  if (!error) return "not determined";
  return rounded(*error, 3) + " (" + rounded(100 * *error / plan.parameters[0], 3) + "%)";
}

std::string loads_text(const std::vector<double>& loads, std::size_t from = 0) {
  std::string text;
  for (std::size_t k = from; k < loads.size(); ++k) text += (text.empty() ? "" : ", ") + rounded(loads[k] / kMilli, 4);
  return text + " mN";
}

std::string odds_text(double chi2) {
  const double odds = std::exp(0.5 * chi2);
  return std::isinf(odds) || odds > 1e6 ? "more than 10^6" : rounded(odds, 2);
}

void print_expectation(const Plan& plan, const Expectation& expected) {
  std::cout << "    expected standard error of " << parameter_names(plan.model)[0] << ": "
            << error_text(plan, expected.standard_error) << '\n';
  for (const Expectation::Rival& rival : expected.rivals)
    std::cout << "    against model " << rival.model << ": chi^2 " << rounded(rival.chi2, 3) << ", odds "
              << odds_text(rival.chi2) << '\n';
}

struct Range {
  double least, most;
};
Range range_of_loads() {
  const auto ends = quantity_list("load_range", FLAGS_load_range);
  if (ends.size() != 2 || ends[0].unit.dimension != dimension::force || !(ends[0].si() < ends[1].si()))
    throw UsageError("flag '--load_range' is '" + FLAGS_load_range + "'; it must be two loads, \"0.5,10 mN\"");
  return {ends[0].si(), ends[1].si()};
}

}  // namespace

int run_design(const Arguments& arguments) {
  require_flags_only("design", arguments);
  const bool searches = is_set("load_range");
  const Plan plan = plan_from_flags(!searches);
  const std::vector<std::string> rivals = split_list("models", FLAGS_models);
  for (const std::string& model : rivals) require_model("models", model);
  if (FLAGS_goal != "error" && FLAGS_goal != "model")
    throw UsageError("flag '--goal' is '" + FLAGS_goal + "'; it must be error or model");
  const Goal goal = FLAGS_goal == "error" ? Goal::error : Goal::model;
  if ((is_set("runs") || is_set("wanted")) && !searches)
    throw UsageError("flag '--load_range' is missing: between which loads runs may be, \"0.5,10 mN\"");
  const Range range = searches ? range_of_loads() : Range{0, 0};
  const auto candidates =
      searches ? next_loads(plan, range.least, range.most, kCandidates, rivals) : std::vector<LoadCandidate>{};
  if (FLAGS_format == "csv") {
    std::cout << "load [mN],standard_error";
    for (const auto& rival : candidates.empty() ? std::vector<Expectation::Rival>{} : candidates[0].expected.rivals)
      std::cout << ",chi2_" << rival.model;
    std::cout << '\n';
    for (const LoadCandidate& one : candidates) {
      std::cout << shortest(one.load / kMilli) << ','
                << (one.expected.standard_error ? shortest(*one.expected.standard_error) : "");
      for (const auto& rival : one.expected.rivals) std::cout << ',' << shortest(rival.chi2);
      std::cout << '\n';
    }
    return kFine;
  }
  const std::string name = parameter_names(plan.model)[0];
  std::cout << "[[Plan]]\n    model " << plan.model << ", " << name << " = " << shortest(plan.parameters[0])
            << "; runs of " << plan.points << " points up to " << rounded(100 * plan.reach, 3) << "% of the jump\n";
  if (!plan.loads.empty()) {
    std::cout << "    loads " << loads_text(plan.loads) << '\n';
    print_expectation(plan, expect(plan, rivals));
  }
  if (searches) {
    std::cout << "[[Next load]]\n    load [mN]   error of " << name << "            least chi^2 of other models\n";
    for (const LoadCandidate& one : candidates)
      std::cout << "    " << std::left << std::setw(12) << rounded(one.load / kMilli, 4)
                << std::setw(10 + 12 + static_cast<int>(name.size())) << error_text(plan, one.expected.standard_error)
                << rounded(one.expected.least_chi2(), 3) << '\n';
    const auto by_error = std::min_element(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
      return a.expected.standard_error.value_or(1e300) < b.expected.standard_error.value_or(1e300);
    });
    const auto by_model = std::max_element(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
      return a.expected.least_chi2() < b.expected.least_chi2();
    });
    std::cout << "    best for " << name << ": " << loads_text({by_error->load})
              << "; best to tell models apart: " << loads_text({by_model->load}) << '\n';
  }
  Plan chosen = plan;
  if (is_set("runs")) {
    chosen = best_plan(plan, range.least, range.most, count_from("runs", 1), goal, rivals);
    std::cout << "[[Best " << FLAGS_runs << " loads for " << (goal == Goal::error ? name : "telling models apart")
              << "]]\n    " << loads_text(chosen.loads, plan.loads.size()) << '\n';
    print_expectation(chosen, expect(chosen, rivals));
    Plan even = plan;
    const std::size_t n = count_from("runs", 1);
    for (std::size_t k = 0; k < n; ++k)
      even.loads.push_back(n == 1 ? 0.5 * (range.least + range.most)
                                  : range.least + (range.most - range.least) * static_cast<double>(k) /
                                                      static_cast<double>(n - 1));
    std::cout << "    evenly spaced loads: " << error_text(plan, expect(even, {}).standard_error) << '\n';
  }
  if (is_set("wanted")) {
    const auto wanted = parse_quantity(FLAGS_wanted);
    if (!wanted || wanted->unit.dimension != dimension::none || !(wanted->value > 0))
      throw UsageError("flag '--wanted' is '" + FLAGS_wanted + "'; it must be an error such as 2% or 0.0001");
    const double error = wanted->unit.text == "%" ? wanted->si() * plan.parameters[0] : wanted->si();
    std::optional<std::size_t> for_error, for_odds;
    for (std::size_t runs = 1; runs <= kMostRuns && !(for_error && for_odds); ++runs) {
      if (!for_error) {
        const auto found = expect(best_plan(plan, range.least, range.most, runs, Goal::error, {}), {}).standard_error;
        if (found && *found <= error) for_error = runs;
      }
      if (!for_odds) {
        const double chi2 =
            expect(best_plan(plan, range.least, range.most, runs, Goal::model, rivals), rivals).least_chi2();
        if (0.5 * chi2 >= std::log(kSureOdds)) for_odds = runs;
      }
    }
    const auto runs_text = [](const std::optional<std::size_t>& runs) {
      return runs ? std::to_string(*runs) : "more than " + std::to_string(kMostRuns);
    };
    std::cout << "[[Runs needed]]\n    for an error of " << rounded(error, 3) << ": " << runs_text(for_error)
              << "; for 95% odds against every other model: " << runs_text(for_odds) << '\n';
  }
  if (is_set("experiments")) {
    if (chosen.loads.empty()) throw UsageError("flag '--experiments' needs loads: --loads, or --runs to find some");
    const Outcome outcome =
        try_plan(chosen, count_from("seed", 0), count_from("experiments", 2), rivals, progress_line("experiments"));
    std::cout << "[[" << outcome.experiments << " simulated experiments at " << loads_text(chosen.loads) << "]]\n    "
              << name << " scatters by " << rounded(outcome.spread, 3) << ", stated "
              << rounded(outcome.mean_standard_error, 3) << "; 95% intervals hold the truth in "
              << rounded(100 * outcome.covered, 3) << "%\n";
    if (outcome.decided)
      std::cout << "    the right model has a probability above 95% in " << rounded(100 * *outcome.decided, 3) << "%\n";
  }
  return kFine;
}

}  // namespace mixity::cli
