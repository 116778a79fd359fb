// From a data set and options to the least-squares problem of one model, and where its constants start.
#pragma once

#include <memory>

#include "base/input_error.h"
#include "fitting/curve.h"
#include "fitting/energies.h"
#include "fitting/result.h"
#include "fitting/stated_constants.h"
#include "fitting/toughness.h"
#include "solver/descent.h"

namespace mixity {

template <class Model>
struct PreparedFit {
  Objective objective;
  std::vector<std::size_t> used;   // indices into Dataset::points
  std::vector<Excluded> excluded;  // points this model cannot describe
  Parameters<Model> base{};        // held values, and typical ones for the rest
  std::array<bool, parameter_count<Model>> held{};
  std::optional<StandardErrors> errors;  // where the objective uses them
  Constants constants{};                 // of those that are not fitted
  std::vector<FittedConstant> fitted;    // the free ones first
  std::vector<double> start;             // of these, in the solver's numbers; empty: their means
};

/// The constants that a fit with these options fits: those that are free, then those that are uncertain.
std::vector<FittedConstant> fitted_constants(const Dataset& data, const FitOptions& options);

/// The value at which a parameter is to be held. Throws InputError if that is outside its range, or none is stated.
double held_value(const HeldParameter& held, const ParameterInfo& info, const Dataset& data);

/// A model whose toughness is infinite at psi = pi/2 for every parameter in the interior of its range says nothing
/// about points there.
template <class Model>
bool describes(const Mixity<double>& mixity) {
  if (mixity.cos > 0) return true;
  Parameters<Model> p;
  for (std::size_t i = 0; i < p.size(); ++i) p[i] = Model::parameters[i].typical;
  return std::isfinite(Model::log_toughness(p, mixity).value);
}

/// Why a point with loads has no predicted area.
inline constexpr std::string_view kBelowPullOff =
    "the load lies below the JKR pull-off load -3/2 pi R G_Ic, at which no model predicts an area";

/// Throws InputError where the options ask for what the data set does not have.
void require_what_is_asked(const Dataset& data, const FitOptions& options, Objective objective);

/// `points`: indices of those to fit; null: all.
template <class Model>
PreparedFit<Model> prepare(const Dataset& data, const FitOptions& options, Objective objective,
                           const std::vector<std::size_t>* points) {
  require_what_is_asked(data, options, objective);
  PreparedFit<Model> prepared;
  prepared.objective = objective;
  static const std::string kInfinite =
      "model " + std::string(Model::info.key) + " has an infinite toughness at this psi";
  prepared.constants = options.constants.value_or(stated_constants(data));
  prepared.fitted = fitted_constants(data, options);
  const ConstantsScale scale(prepared.constants);
  const auto obstacle = [&](std::size_t i) -> std::string_view {
    if (objective == Objective::toughness) {
      const auto toughness = data.toughness(i);
      return !toughness ? kNoPhaseAngle : describes<Model>(toughness->mixity) ? std::string_view() : kInfinite;
    }
    if (data.has_energies) return {};
    // a freed constant may bring it back
    const bool contact = !prepared.fitted.empty() || above_pull_off(scale.load(data.points[i].P)) >= 0;
    return contact ? std::string_view() : kBelowPullOff;
  };
  const auto consider = [&](std::size_t i) {
    if (const std::string_view reason = obstacle(i); reason.empty())
      prepared.used.push_back(i);
    else
      prepared.excluded.push_back({data.points[i].line, reason});
  };
  if (points)
    for (const std::size_t i : *points) consider(i);
  else
    for (std::size_t i = 0; i < data.points.size(); ++i) consider(i);
  for (std::size_t k = 0; k < prepared.base.size(); ++k) {
    const ParameterInfo& info = Model::parameters[k];
    prepared.base[k] = info.typical;
    for (const HeldParameter& held : options.hold)
      if (held.name == info.name) {
        prepared.base[k] = held_value(held, info, data);
        prepared.held[k] = true;
      }
  }
  if (data.has_loads && (objective == Objective::curve || options.weighted))
    prepared.errors = standard_errors(data, options.sigma_T, options.sigma_A, objective == Objective::curve);
  return prepared;
}

/// The points' loads and areas; without standard errors those are 1, so that residuals keep their unit.
template <class Model>
std::vector<MeasuredPoint> measured_points(const Dataset& data, const PreparedFit<Model>& prepared) {
  std::vector<MeasuredPoint> points;
  points.reserve(prepared.used.size());
  for (const std::size_t i : prepared.used) {
    const Point& p = data.points[i];
    points.push_back({p.P, data.shear_as_read(i), p.A, prepared.errors ? prepared.errors->T[i] : 1.0,
                      prepared.errors ? prepared.errors->A[i] : 1.0});
  }
  return points;
}

/// What may be freed beside the model's parameters, with its range: factors of a thousand, loads and shear up to ten
/// times the largest, areas up to nine tenths of the smallest.
template <class Model>
FreeChoice<Model> free_choice(const Dataset& data, const PreparedFit<Model>& prepared) {
  FreeChoice<Model> choice({prepared.base, prepared.constants}, prepared.held);
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

/// `weights`: of objective toughness, 1/standard error; empty: 1.
template <class Model>
std::unique_ptr<ModelProblem<Model>> make_problem(const Dataset& data, const FitOptions& options,
                                                  const PreparedFit<Model>& prepared,
                                                  std::vector<double> weights = {}) {
  const FreeChoice<Model> choice = free_choice(data, prepared);
  const bool corrected = !prepared.fitted.empty() || prepared.constants != Constants{};
  const bool weighted = prepared.objective == Objective::curve || !weights.empty();
  std::unique_ptr<ModelProblem<Model>> problem;
  if (prepared.objective == Objective::curve && data.has_energies) {
    const std::vector<EnergyPoint> points = energy_points(data, prepared.used);
    const FreeChoice<Model> of_model({prepared.base, prepared.constants}, prepared.held);
    std::vector<FreeParameter> toughness;
    if (!prepared.fitted.empty()) toughness = series_toughness(data, points, prepared.used, prepared.fitted[0].prior);
    problem = std::make_unique<EnergyObjective<Model>>(points, of_model, toughness);
  } else if (prepared.objective == Objective::curve) {
    problem = std::make_unique<CurveObjective<Model>>(measured_points(data, prepared), choice);
  } else if (corrected && data.has_loads) {
    problem = std::make_unique<ToughnessOfLoads<Model>>(measured_points(data, prepared), choice, std::move(weights));
  } else {
    std::vector<ToughnessPoint> points;
    points.reserve(prepared.used.size());
    for (const std::size_t i : prepared.used) points.push_back(*data.toughness(i));
    problem =
        std::make_unique<ToughnessObjective<Model>>(std::move(points), scale_of(options), choice, std::move(weights));
  }
  // a file of psi and Gc can only be weighted by its sigma_Gc
  const bool energies_without = data.has_energies && data.errors.empty();
  problem->set_known_errors(weighted && !energies_without && (!prepared.errors || prepared.errors->absolute()));
  return problem;
}

/// Where the constants start: at the JKR curve through the points without shear (T up to 1 % of the largest).
template <class Model>
std::vector<double> jkr_start(const Dataset& data, const FitOptions& options, const PreparedFit<Model>& prepared) {
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
  PreparedFit<Model> unsheared = prepared;
  unsheared.objective = Objective::curve;
  unsheared.held.fill(true);
  unsheared.fitted.resize(free);
  std::erase_if(unsheared.used, [&](std::size_t i) { return data.points[i].shear() > 0.01 * largest; });
  if (free == 0 || unsheared.used.size() < free) return start;
  SolverOptions solver;
  solver.engine = Engine::kernel;
  const std::vector<double> begin(start.begin(), start.begin() + static_cast<std::ptrdiff_t>(free));
  const auto minimum = descend(*make_problem<Model>(data, options, unsheared), begin, solver);
  if (minimum && minimum->stationary) std::copy(minimum->x.begin(), minimum->x.end(), start.begin());
  return start;
}

/// A fit's values as the solver counts, for a problem of the same parameters or fewer of them: constants of the
/// experiment that it does not have start where the problem says. Empty where a value is missing.
std::vector<double> solver_values(const Problem& problem, const std::vector<FittedParameter>& fitted);

}  // namespace mixity
