#include "fitting/common_constants.h"

#include <algorithm>

#include "fitting/fitted_parameters.h"
#include "fitting/predicted_area.h"
#include "fitting/prepare.h"
#include "fitting/toughness_weights.h"
#include "solver/joint.h"
#include "solver/prior.h"
#include "solver/robust.h"
#include "solver/solve.h"

namespace mixity {
namespace {

/// The joint problem takes time with the cube of the number of runs.
constexpr std::size_t kMostIntervals = 40;

}  // namespace

std::optional<CommonConstants> fit_common_constants(const Dataset& data, std::string_view key,
                                                    const FitOptions& options, const Constants& near,
                                                    const std::vector<std::vector<std::size_t>>& runs,
                                                    const std::vector<FitResult>& fits) {
  const auto model = ContactModel::find(key);
  if (!model) return std::nullopt;
  const Objective objective = options.objective.value_or(default_objective(data));
  const std::vector<FittedConstant> constants = fitted_constants(data, options);
  std::vector<std::unique_ptr<ModelProblem>> problems;
  std::vector<const Problem*> parts;
  std::vector<double> start;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const PreparedFit prepared = prepare(data, *model, options, objective, &runs[i]);
    std::vector<double> weights;
    if (objective == Objective::toughness && options.weighted)
      weights = toughness_weights(data, scale_of(options), prepared.used, prepared.errors, *model,
                                  fitted_candidate(data, *model, fits[i], options).parameters);
    problems.push_back(make_problem(data, options, prepared, std::move(weights)));
    parts.push_back(problems.back().get());
    for (const FittedParameter& one : fits[i].parameters)
      if (!one.held && has_parameter({fits[i].model}, one.name)) start.push_back(*one.value);
  }
  const std::size_t own = start.size() / runs.size();
  for (const FittedConstant& one : constants) start.push_back(near[one.constant]);
  const JointProblem joint(parts, own);
  std::optional<RobustProblem> robust;
  if (options.loss != Loss::none)
    robust.emplace(joint, options.loss, options.loss_scale.value_or(usual_scale(options.loss)));
  const Problem& of_data = robust ? static_cast<const Problem&>(*robust) : joint;
  const std::size_t priors = prior_count(of_data);
  const SolvedWithPriors solved =
      priors > 0 ? solve_with_priors(of_data, {start}) : SolvedWithPriors{solve(of_data, {start}), 1};
  const FitStatus status = solved.verdict.status;
  if (status == FitStatus::not_converged || status == FitStatus::not_identifiable) return std::nullopt;
  const ProblemWithPriors with_priors(of_data, solved.unit);
  const Problem& cost = priors > 0 ? static_cast<const Problem&>(with_priors) : of_data;
  FitResult found;
  for (const FreeParameter& one : cost.parameters())
    found.parameters.push_back({one.name, {}, {}, one.lower, one.upper});
  FitOptions asked = options;
  asked.intervals &= runs.size() <= kMostIntervals;
  asked.profile_points = 0;
  if (!add_parameters(cost, solved.verdict, asked, {}, found).empty()) return std::nullopt;
  CommonConstants result{options.constants.value_or(stated_constants(data)), {}, 0, 0};
  for (std::size_t k = 0; k < constants.size(); ++k)
    result.constants[constants[k].constant] = solved.verdict.best.x[runs.size() * own + k];
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto first = found.parameters.begin() + static_cast<std::ptrdiff_t>(i * own);
    result.own.emplace_back(first, first + static_cast<std::ptrdiff_t>(own));
  }
  result.sum_of_squares = solved.verdict.best.sum_of_squares * solved.unit * solved.unit;
  result.free_parameters = cost.parameters().size() - priors;
  return result;
}

}  // namespace mixity
