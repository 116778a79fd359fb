#include <algorithm>
#include <cmath>
#include <limits>

#include "fitting/curve_objective.h"
#include "fitting/energy_objective.h"
#include "fitting/prepare.h"
#include "fitting/toughness_objective.h"
#include "solver/descent.h"

namespace mixity {
namespace {

/// The points' loads and areas; without standard errors those are 1, so that residuals keep their unit.
std::vector<MeasuredPoint> measured_points(const Dataset& data, const PreparedFit& prepared) {
  std::vector<MeasuredPoint> points;
  points.reserve(prepared.used.size());
  for (const std::size_t i : prepared.used) {
    const Point& p = data.points[i];
    points.push_back({p.P, data.shear_as_read(i), p.A, prepared.errors ? prepared.errors->T[i] : 1.0,
                      prepared.errors ? prepared.errors->A[i] : 1.0});
  }
  return points;
}

FreeChoice choice_of_model(const PreparedFit& prepared) {
  return FreeChoice(prepared.model, {prepared.base, prepared.constants}, prepared.held);
}

/// What may be freed beside the model's parameters, with its range: factors of a thousand, loads and shear up to ten
/// times the largest, areas up to nine tenths of the smallest.
FreeChoice free_choice(const Dataset& data, const PreparedFit& prepared) {
  FreeChoice choice = choice_of_model(prepared);
  double largest_load = 1, largest_shear = 1,
         smallest_area = prepared.used.empty() ? 1 : std::numeric_limits<double>::infinity();
  for (const std::size_t i : prepared.used) {
    largest_load = std::max(largest_load, std::abs(data.points[i].P));
    largest_shear = std::max(largest_shear, data.points[i].shear());
    smallest_area = std::min(smallest_area, data.points[i].A);
  }
  const double factor = std::log(1000.0);
  for (const auto& [constant, mean, prior] : prepared.fitted) {
    const double reach = is_factor(constant)       ? factor
                         : constant == kAreaOffset ? 0.9 * smallest_area
                                                   : 10 * (constant == kShearOffset ? largest_shear : largest_load);
    FreeParameter parameter{std::string(kConstantNames[constant]), mean - reach, mean + reach, mean};
    parameter.prior = prior;
    parameter.scale = constant_scale(data, constant);
    parameter.logarithmic = is_factor(constant);
    parameter.unit = constant_unit(data, constant);
    if (!prepared.start.empty()) parameter.start = prepared.start[choice.constants().size()];
    choice.add(constant, parameter);
  }
  return choice;
}

std::unique_ptr<ModelProblem> energy_problem(const Dataset& data, const PreparedFit& prepared) {
  const std::vector<EnergyPoint> points = energy_points(data, prepared.used);
  std::vector<FreeParameter> toughness;
  if (!prepared.fitted.empty()) toughness = series_toughness(data, points, prepared.used, prepared.fitted[0].prior);
  return std::make_unique<EnergyObjective>(points, choice_of_model(prepared), toughness);
}

}  // namespace

std::unique_ptr<ModelProblem> make_problem(const Dataset& data, const FitOptions& options, const PreparedFit& prepared,
                                           std::vector<double> weights) {
  const bool corrected = !prepared.fitted.empty() || prepared.constants != Constants{};
  const bool weighted = prepared.objective == Objective::curve || !weights.empty();
  std::unique_ptr<ModelProblem> problem;
  if (prepared.objective == Objective::curve && data.has_energies) {
    problem = energy_problem(data, prepared);
  } else if (prepared.objective == Objective::curve) {
    problem = std::make_unique<CurveObjective>(measured_points(data, prepared), free_choice(data, prepared));
  } else if (corrected && data.has_loads) {
    problem = std::make_unique<ToughnessOfLoads>(measured_points(data, prepared), free_choice(data, prepared),
                                                 std::move(weights));
  } else {
    std::vector<ToughnessPoint> points;
    points.reserve(prepared.used.size());
    for (const std::size_t i : prepared.used) points.push_back(*data.toughness(i));
    problem = std::make_unique<ToughnessObjective>(points, scale_of(options), free_choice(data, prepared),
                                                   std::move(weights));
  }
  // a file of psi and Gc can only be weighted by its sigma_Gc
  const bool energies_without = data.has_energies && data.errors.empty();
  problem->set_known_errors(weighted && !energies_without && (!prepared.errors || prepared.errors->absolute()));
  return problem;
}

std::vector<double> jkr_start(const Dataset& data, const FitOptions& options, const PreparedFit& prepared) {
  std::vector<double> start;
  for (const FittedConstant& constant : prepared.fitted) start.push_back(constant.mean);
  double largest = 0, pull = 0;
  for (const std::size_t i : prepared.used) {
    largest = std::max(largest, data.points[i].shear());
    pull = std::max(pull, -data.points[i].P);
  }
  const std::size_t free = options.free.size();
  // with a toughness at which every load keeps the contact closed, if the stated one is not: at 0.85 of pull-off
  for (std::size_t k = 0; k < free; ++k)
    if (options.free[k] == kToughness && above_pull_off(-pull) < 0) start[k] = std::log(pull / 4);
  PreparedFit unsheared = prepared;
  unsheared.objective = Objective::curve;
  std::fill(unsheared.held.begin(), unsheared.held.end(), true);
  unsheared.fitted.resize(free);
  std::erase_if(unsheared.used, [&](std::size_t i) { return data.points[i].shear() > 0.01 * largest; });
  if (free == 0 || unsheared.used.size() < free) return start;
  SolverOptions solver;
  solver.engine = Engine::kernel;
  const std::vector<double> begin(start.begin(), start.begin() + static_cast<std::ptrdiff_t>(free));
  const auto minimum = descend(*make_problem(data, options, unsheared), begin, solver);
  if (minimum && minimum->stationary) std::copy(minimum->x.begin(), minimum->x.end(), start.begin());
  return start;
}

std::vector<double> solver_values(const Problem& problem, const std::vector<FittedParameter>& fitted) {
  std::vector<double> x;
  for (const FreeParameter& parameter : problem.parameters()) {
    const auto same = std::find_if(fitted.begin(), fitted.end(),
                                   [&](const FittedParameter& other) { return other.name == parameter.name; });
    if (same != fitted.end() && same->value)
      x.push_back(std::clamp(parameter.solver_value(*same->value), parameter.lower, parameter.upper));
    else if (parameter.start)
      x.push_back(*parameter.start);
    else
      return {};
  }
  return x;
}

}  // namespace mixity
