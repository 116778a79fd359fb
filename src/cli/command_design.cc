// mixity design: what a planned experiment will determine, and which loads to measure next.
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <optional>

#include "base/number_text.h"
#include "cli/commands.h"
#include "cli/contact_flags.h"
#include "cli/flags.h"
#include "cli/plan_flags.h"
#include "cli/progress.h"
#include "mechanics/contact_model.h"
#include "studies/design.h"

DEFINE_string(runs, "", "number of further runs to find the best loads for");
DEFINE_string(goal, "error", "what these runs optimise: error (of lambda) or model (odds between models)");
DEFINE_string(wanted, "",
              "an error of lambda, 2% or 0.0001: prints how many runs reach it, and how many give 95% odds between "
              "models");
DEFINE_string(experiments, "", "number of experiments to simulate and fit, as a check of the predictions");

namespace mixity::cli {
namespace {

constexpr std::size_t kCandidates = 21, kMostTried = 30;
constexpr std::size_t kMostRuns = 100;  // a minute: the time grows with the square of their number
constexpr double kSureOdds = 19;        // 95 %

/// What is held in each run of a plan: its name, in the plural, and as the column of a table; and the unit it is shown
/// in.
struct Held {
  std::string name, names, column, unit;
  double scale;
  Dimension dimension;
  std::string shown(double value) const { return rounded(value / scale, 4); }
};
Held held_in(const Plan& plan) {
  if (plan.constants.control == NormalControl::approach)
    return {"approach", "approaches", "delta", "um", 1e-6, dimension::length};
  return {"load", "loads", "load", "mN", 1e-3, dimension::force};
}

std::string error_text(const std::optional<double>& error, double value) {
  if (!error) return "not determined";
  return rounded(*error, 3) + (value == 0 ? "" : " (" + rounded(100 * *error / std::abs(value), 3) + "%)");
}
std::string error_text(const Plan& plan, const std::optional<double>& error) {
  return error_text(error, plan.parameters[0]);
}

std::string loads_text(const Held& held, const std::vector<double>& loads, std::size_t from = 0) {
  std::string text;
  for (std::size_t k = from; k < loads.size(); ++k) text += (text.empty() ? "" : ", ") + held.shown(loads[k]);
  return text + ' ' + held.unit;
}

std::string heading(const Held& held) { return held.column + " [" + held.unit + ']'; }

std::string odds_text(const Expectation::Rival& rival) {
  return rival.odds() > 1e6 ? "more than 10^6" : rounded(rival.odds(), 2);
}

std::string first_parameter(const Plan& plan) {
  return std::string(ContactModel::find(plan.model).value().parameters()[0].name);
}

void print_expectation(const Plan& plan, const Expectation& expected) {
  std::cout << "    expected standard error of " << first_parameter(plan) << ": "
            << error_text(plan, expected.standard_error) << '\n';
  for (const Expectation::Other& other : expected.others)
    std::cout << "    expected standard error of " << other.parameter << ": "
              << error_text(other.standard_error, other.value) << '\n';
  for (const Expectation::Rival& rival : expected.rivals)
    std::cout << "    against model " << rival.model << ": chi^2 " << rounded(rival.chi2, 3) << ", odds "
              << odds_text(rival) << '\n';
}

/// What the first load once more at the end would give: it separates a drift from a dependence on the load.
void print_repeat_of_first_load(const Plan& plan) {
  const Metadata& constants = plan.constants;
  const auto may = [&](Constant drift) { return constants.standard_errors.contains(kConstantNames[drift]); };
  if (plan.loads.size() < 2 || !(may(kModulusDrift) || may(kToughnessDrift))) return;
  Plan with = plan;
  with.loads.push_back(plan.loads.front());
  std::cout << "    with the first " << held_in(plan).name << " once more at the end, which separates a drift from a "
            << "dependence on the " << held_in(plan).name << ":\n";
  print_expectation(with, expect(with, {}));
}

struct LoadRange {
  double least, most;
};
LoadRange range_of_loads(const Plan& plan) {
  const Held held = held_in(plan);
  const auto ends = quantities_from("load_range");
  if (ends.size() != 2 || ends[0].unit.dimension != held.dimension || !(ends[0].si() < ends[1].si()))
    throw must("load_range", "be two rising " + held.names + ", \"0.5,10 " + held.unit + '"');
  Plan lowest = plan;
  lowest.loads = {ends[0].si()};
  if (const std::string problem = problem_of(lowest); !problem.empty()) throw refused("load_range", problem);
  return {ends[0].si(), ends[1].si()};
}

void print_as_csv(const Held& held, const std::vector<LoadCandidate>& candidates) {
  std::cout << heading(held) << ",standard_error";
  if (!candidates.empty())
    for (const Expectation::Rival& rival : candidates[0].expected.rivals) std::cout << ",chi2_" << rival.model;
  std::cout << '\n';
  for (const LoadCandidate& one : candidates) {
    std::cout << shortest(as_decimal(one.load / held.scale)) << ','
              << (one.expected.standard_error ? shortest(*one.expected.standard_error) : "");
    for (const Expectation::Rival& rival : one.expected.rivals) std::cout << ',' << shortest(rival.chi2);
    std::cout << '\n';
  }
}

void print_candidates(const Plan& plan, const std::vector<LoadCandidate>& candidates, const std::string& name) {
  const Held held = held_in(plan);
  std::cout << "[[Next " << held.name << "]]\n    " << std::left << std::setw(12) << heading(held) << "error of "
            << name << "            least chi^2 of other models\n";
  for (const LoadCandidate& one : candidates)
    std::cout << "    " << std::left << std::setw(12) << held.shown(one.load)
              << std::setw(10 + 12 + static_cast<int>(name.size())) << error_text(plan, one.expected.standard_error)
              << rounded(one.expected.least_chi2(), 3) << '\n';
  const auto best = [&](Goal goal) {
    return std::min_element(
               candidates.begin(), candidates.end(),
               [&](const auto& one, const auto& other) { return one.expected.cost(goal) < other.expected.cost(goal); })
        ->load;
  };
  std::cout << "    best for " << name << ": " << loads_text(held, {best(Goal::error)})
            << "; best to tell models apart: " << loads_text(held, {best(Goal::model)}) << '\n';
}

void print_best(const Plan& plan, const Plan& chosen, const LoadRange& range, Goal goal,
                const std::vector<std::string>& rivals, const std::string& name) {
  const std::size_t n = chosen.loads.size() - plan.loads.size();
  const Held held = held_in(plan);
  std::cout << "[[Best " << n << ' ' << held.names << " for " << (goal == Goal::error ? name : "telling models apart")
            << "]]\n    " << loads_text(held, chosen.loads, plan.loads.size()) << '\n';
  print_expectation(chosen, expect(chosen, rivals));
  Plan even = plan;
  for (std::size_t k = 0; k < n; ++k)
    even.loads.push_back(
        std::lerp(range.least, range.most, n == 1 ? 0.5 : static_cast<double>(k) / static_cast<double>(n - 1)));
  std::cout << "    evenly spaced " << held.names << ": " << error_text(plan, expect(even, {}).standard_error) << '\n';
}

void print_runs_needed(const Plan& plan, const LoadRange& range, const std::vector<std::string>& rivals) {
  const Quantity wanted = quantity_from("wanted", "be an error such as 2% or 0.0001", [](const Quantity& one) {
    return one.unit.dimension == dimension::none && one.value > 0;
  });
  const double error = wanted.unit.text == "%" ? wanted.si() * plan.parameters[0] : wanted.si();
  const auto runs_until = [&](Goal goal, double cost) {
    const std::vector<std::string> others = goal == Goal::error ? std::vector<std::string>{} : rivals;
    for (std::size_t runs = 1; runs <= kMostTried; ++runs)
      if (expect(best_plan(plan, range.least, range.most, runs, goal, others), others).cost(goal) <= cost)
        return std::to_string(runs);
    return "more than " + std::to_string(kMostTried);
  };
  std::cout << "[[Runs needed]]\n    for an error of " << rounded(error, 3) << ": " << runs_until(Goal::error, error)
            << "; for 95% odds against every other model: " << runs_until(Goal::model, -2 * std::log(kSureOdds))
            << '\n';
}

/// Of elliptic contacts: which load and which reach of the shear tell the couplings apart, and in how many runs.
void print_couplings(const Plan& plan, const std::vector<double>& loads) {
  constexpr double kReaches[]{0.5, 0.8, 0.95}, kMostNamed = 1e6;
  const ContactModel model = ContactModel::find(plan.model).value();
  const auto parameters = model.parameters();
  const std::string II(parameters[0].name), III(parameters[(parameters.size() - 1) / 2].name);
  const std::vector<CouplingRuns> found = runs_for_couplings(plan, loads, kReaches);
  const Held held = held_in(plan);
  std::cout << "[[Couplings]]  runs of " << plan.points << " points for 95% odds that " << III << " is not " << II
            << "\n    " << std::left << std::setw(12) << heading(held) << "up to 50%   80%       95% of the jump\n";
  for (const CouplingRuns& one : found) {
    const bool first = one.reach == kReaches[0];
    if (first) std::cout << "    " << std::left << std::setw(12) << held.shown(one.load);
    const double runs = one.needed(kSureOdds);
    std::cout << std::setw(first ? 12 : 10) << (runs <= kMostNamed ? rounded(runs, 7) : "-");
    if (one.reach == kReaches[2]) std::cout << '\n';
  }
  const auto best = std::max_element(found.begin(), found.end(),
                                     [](const auto& one, const auto& other) { return one.chi2 < other.chi2; });
  const double runs = best == found.end() ? HUGE_VAL : best->needed(kSureOdds);
  if (runs <= kMostNamed)
    std::cout << "    " << III << " is told from " << II << " soonest at " << loads_text(held, {best->load})
              << " up to " << rounded(100 * best->reach, 3) << "% of the jump: by "
              << (runs == 1 ? "1 run" : rounded(runs, 7) + " runs") << '\n';
  else
    std::cout << "    no number of runs tells " << III << " from " << II << ": they are equal in this plan\n";
}

void print_outcome(const Plan& plan, const std::vector<std::string>& rivals, const std::string& name) {
  if (plan.loads.empty()) throw UsageError("flag '--experiments' needs loads: --loads, or --runs to find some");
  const Outcome outcome = try_plan(plan, count_from("seed", 0), count_from("experiments", 2, 10000000), rivals,
                                   progress_line("experiments"));
  std::cout << "[[" << outcome.experiments << " simulated experiments at " << loads_text(held_in(plan), plan.loads)
            << "]]\n    " << name << " scatters by " << rounded(outcome.spread, 3) << ", stated "
            << rounded(outcome.mean_standard_error, 3) << "; 95% intervals hold the truth in "
            << rounded(100 * outcome.covered, 3) << "%\n";
  if (outcome.decided)
    std::cout << "    the right model has a probability above 95% in " << rounded(100 * *outcome.decided, 3) << "%\n";
}

}  // namespace

int run_design(const Arguments& arguments) {
  require_flags_only("design", arguments);
  const bool searches = is_set("load_range");
  const Plan plan = plan_from_flags(!searches, {.bytes = 1000, .most = 1000000});
  const Held held = held_in(plan);
  const std::vector<std::string> rivals = list_from("models");
  for (const std::string& model : rivals) require_model("models", model);
  if (FLAGS_goal != "error" && FLAGS_goal != "model") throw must("goal", "be error or model");
  const Goal goal = FLAGS_goal == "error" ? Goal::error : Goal::model;
  if ((is_set("runs") || is_set("wanted")) && !searches)
    throw UsageError("flag '--load_range' is missing: between which " + held.names + " runs may be, \"0.5,10 " +
                     held.unit + '"');
  const LoadRange range = searches ? range_of_loads(plan) : LoadRange{0, 0};
  std::vector<LoadCandidate> candidates;
  if (searches) candidates = next_loads(plan, range.least, range.most, kCandidates, rivals);
  if (FLAGS_format == "csv") return print_as_csv(held, candidates), kFine;
  const std::string name = first_parameter(plan);
  std::cout << "[[Plan]]\n    model " << plan.model << ", " << name << " = " << shortest(plan.parameters[0])
            << "; runs of " << plan.points << " points up to " << rounded(100 * plan.reach, 3)
            << "% of the jump; mode III " << mode_III_text(plan.constants) << '\n';
  if (!plan.loads.empty()) {
    std::cout << "    " << held.names << ' ' << loads_text(held, plan.loads) << '\n';
    print_expectation(plan, expect(plan, rivals));
    print_repeat_of_first_load(plan);
  }
  if (searches) print_candidates(plan, candidates, name);
  Plan chosen = plan;
  if (is_set("runs")) {
    chosen = best_plan(plan, range.least, range.most, count_from("runs", 1, kMostRuns), goal, rivals);
    print_best(plan, chosen, range, goal, rivals, name);
  }
  if (is_set("wanted")) print_runs_needed(plan, range, rivals);
  if (ContactModel::find(plan.model).value().is_elliptic()) {
    std::vector<double> loads = plan.loads;
    if (searches) loads = {range.least, std::lerp(range.least, range.most, 0.5), range.most};
    print_couplings(plan, loads);
  }
  if (is_set("experiments")) print_outcome(chosen, rivals, name);
  return kFine;
}

}  // namespace mixity::cli
