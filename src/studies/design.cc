#include "studies/design.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <stdexcept>

#include "base/threads.h"
#include "fitting/comparison.h"
#include "fitting/fit.h"
#include "mechanics/contact_model.h"
#include "mechanics/ellipse.h"
#include "studies/simulate.h"

namespace mixity {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

std::vector<std::string> without(const std::vector<std::string>& models, const std::string& own) {
  std::vector<std::string> rivals = models;
  std::erase(rivals, own);
  if (const auto model = ContactModel::find(own); model && model->is_elliptic())
    std::erase(rivals, std::string(model->circle().info().key));
  return rivals;
}

}  // namespace

double Expectation::Rival::odds() const { return std::exp(0.5 * chi2); }

double Expectation::least_chi2() const {
  double least = kInfinite;
  for (const Rival& rival : rivals) least = std::min(least, rival.chi2);
  return least;
}

double Expectation::cost(Goal goal) const {
  return goal == Goal::error ? standard_error.value_or(kInfinite) : -least_chi2();
}

Expectation expect(const Plan& plan, const std::vector<std::string>& rivals) {
  const Dataset data = simulate(plan, 0, std::nullopt);
  FitOptions options = value_only({});
  Expectation expected;
  const FitResult own = fit_model(data, plan.model, options);
  const bool determined = own.status != FitStatus::not_identifiable;
  if (determined) expected.standard_error = own.parameters.front().stderr_;
  for (std::size_t k = 1; k < own.parameters.size(); ++k) {
    const FittedParameter& one = own.parameters[k];
    const bool drift = one.name == kConstantNames[kModulusDrift] || one.name == kConstantNames[kToughnessDrift];
    if (k < plan.parameters.size() ? !one.held : drift)
      expected.others.push_back(
          {one.name, k < plan.parameters.size() ? plan.parameters[k] : 0, determined ? one.stderr_ : std::nullopt});
  }
  // a rival's misfit is no noise whose correlation along the runs could be estimated
  options.fitted_errors = false;
  for (const std::string& model : without(rivals, plan.model)) {
    const FitResult fit = fit_model(data, model, options);
    if (has_all_values(fit)) expected.rivals.push_back({model, fit.sum_of_squares});
  }
  return expected;
}

double CouplingRuns::needed(double odds) const { return std::ceil(2 * std::log(odds) / chi2); }

std::vector<CouplingRuns> runs_for_couplings(const Plan& plan, std::span<const double> loads,
                                             std::span<const double> reaches) {
  const ContactModel circle = ContactModel::find(plan.model).value().circle();
  const std::vector<std::string> equal{std::string(circle.info().key) + std::string(kEqualEllipse)};
  std::vector<CouplingRuns> found;
  for (const double load : loads)
    for (const double reach : reaches) {
      Plan one = plan;
      one.loads = {load};
      one.reach = reach;
      found.push_back({load, reach, expect(one, equal).least_chi2()});
    }
  return found;
}

std::vector<LoadCandidate> next_loads(const Plan& plan, double least, double most, std::size_t candidates,
                                      const std::vector<std::string>& rivals, const Progress& progress) {
  std::vector<LoadCandidate> found(std::max<std::size_t>(candidates, 2));
  std::atomic<std::size_t> done = 0;
  parallel_for(found.size(), [&](std::size_t i) {
    found[i].load = least + (most - least) * static_cast<double>(i) / static_cast<double>(found.size() - 1);
    Plan with = plan;
    with.loads.push_back(found[i].load);
    found[i].expected = expect(with, rivals);
    if (progress) progress(static_cast<double>(++done) / static_cast<double>(found.size()));
  });
  return found;
}

Plan best_plan(const Plan& plan, double least, double most, std::size_t runs, Goal goal,
               const std::vector<std::string>& rivals, const Progress& progress) {
  constexpr std::size_t kCandidates = 25;
  constexpr double kHelps = 1e-3;  // relative; smaller gains from an exchange are grid noise
  const std::vector<std::string> others = goal == Goal::error ? std::vector<std::string>{} : rivals;
  Plan best = plan;
  const auto best_next = [&](const Plan& with) {
    const auto candidates = next_loads(with, least, most, kCandidates, others, progress);
    return *std::min_element(candidates.begin(), candidates.end(), [&](const auto& one, const auto& other) {
      return one.expected.cost(goal) < other.expected.cost(goal);
    });
  };
  double reached = kInfinite;
  for (std::size_t k = 0; k < runs; ++k) {
    const LoadCandidate next = best_next(best);
    best.loads.push_back(next.load);
    reached = next.expected.cost(goal);
  }
  for (bool helped = runs > 1; helped;) {
    helped = false;
    for (std::size_t k = plan.loads.size(); k < best.loads.size(); ++k) {
      Plan rest = best;
      rest.loads.erase(rest.loads.begin() + static_cast<std::ptrdiff_t>(k));
      const LoadCandidate next = best_next(rest);
      const double now = next.expected.cost(goal);
      if (!(now < reached - kHelps * std::abs(reached))) continue;
      best.loads[k] = next.load;
      reached = now;
      helped = true;
    }
  }
  std::sort(best.loads.begin() + static_cast<std::ptrdiff_t>(plan.loads.size()), best.loads.end());
  return best;
}

Outcome try_plan(const Plan& plan, std::uint64_t seed, std::size_t experiments, const std::vector<std::string>& rivals,
                 const Progress& progress) {
  if (const std::string problem = problem_of(plan); !problem.empty()) throw std::invalid_argument(problem);
  const std::vector<std::string> others = without(rivals, plan.model);
  struct One {
    std::optional<double> value, standard_error;
    bool ok = false, covered = false, decided = false;
  };
  std::vector<One> all(experiments);
  std::size_t done = 0;
  std::mutex reporting;
  parallel_for(experiments, [&](std::size_t i) {
    const Dataset data = simulate(plan, seed, i);
    FitOptions options;
    options.checks = !others.empty();
    std::vector<FitResult> fits{fit_model(data, plan.model, options)};
    const FittedParameter& parameter = fits[0].parameters.front();
    One& one = all[i];
    one.value = parameter.value;
    one.standard_error = parameter.stderr_;
    one.ok = fits[0].status == FitStatus::ok;
    if (parameter.interval) {
      const auto& [low, high] = std::pair(parameter.interval->low, parameter.interval->high);
      const double truth = plan.parameters[0];
      one.covered = (!low || *low <= truth) && (!high || truth <= *high);
    }
    if (!others.empty()) {
      for (const std::string& model : others) fits.push_back(fit_model(data, model, options));
      one.decided = probabilities(fits)[0].value_or(0) > 0.95;
    }
    if (progress) {
      const std::lock_guard lock(reporting);
      progress(static_cast<double>(++done) / static_cast<double>(experiments));
    }
  });
  Outcome outcome;
  outcome.experiments = experiments;
  double squares = 0, errors = 0, covered = 0, decided = 0;
  for (const One& one : all) {
    outcome.ok += one.ok;
    decided += one.decided;
    if (!one.value || !one.standard_error) continue;
    ++outcome.with_value;
    outcome.mean += *one.value;
    errors += *one.standard_error;
    covered += one.covered;
  }
  const double n = static_cast<double>(outcome.with_value);
  if (outcome.with_value > 0) {
    outcome.mean /= n;
    outcome.mean_standard_error = errors / n;
    outcome.covered = covered / n;
  }
  for (const One& one : all)
    if (one.value && one.standard_error) squares += std::pow(*one.value - outcome.mean, 2);
  if (outcome.with_value > 1) outcome.spread = std::sqrt(squares / (n - 1));
  if (!others.empty() && experiments > 0) outcome.decided = decided / static_cast<double>(experiments);
  return outcome;
}

}  // namespace mixity
