// From a data set and options to the least-squares problem of one model.
#pragma once

#include <memory>

#include "dataset/input_error.h"
#include "dataset/number_text.h"
#include "fitting/experiment_objective.h"
#include "fitting/fit.h"
#include "mechanics/measurement.h"

namespace mixity {

template <class Model>
struct PreparedFit {
  std::vector<std::size_t> used;   // indices into Dataset::points
  std::vector<Excluded> excluded;  // points this model cannot describe
  Parameters<Model> base{};        // held values, and typical ones for the rest
  std::array<bool, parameter_count<Model>> held{};
  std::optional<StandardErrors> errors;  // where the objective uses them
  std::vector<double> start;             // of the freed constants, in the solver's numbers; empty: the stated values
};

/// What the metadata say of a parameter; null if nothing.
inline std::optional<double> stated_value(std::string_view parameter, const Metadata& metadata) {
  if (parameter == "r" && metadata.toughness && metadata.toughness_II)
    return *metadata.toughness_II / *metadata.toughness;
  return std::nullopt;
}

inline double held_value(const HeldParameter& held, const ParameterInfo& info, const Dataset& data) {
  const auto value = held.value ? held.value : stated_value(held.name, data.metadata);
  if (!value)
    throw InputError(data.path, "parameter '" + held.name +
                                    "' is to be held at the data set's own value, but the metadata state none" +
                                    (held.name == "r" ? " (r = toughness_II/toughness)" : ""));
  if (!(*value >= info.lower && *value <= info.upper))
    throw InputError(data.path, "parameter '" + held.name + "' is held at " + shortest(*value) +
                                    ", outside its range " + shortest(info.lower) + ".." + shortest(info.upper));
  return *value;
}

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

template <class Model>
PreparedFit<Model> prepare(const Dataset& data, const FitOptions& options, const std::vector<std::size_t>* points) {
  PreparedFit<Model> prepared;
  static const std::string kInfinite =
      "model " + std::string(Model::info.key) + " has an infinite toughness at this psi";
  const CorrectedScale scale(options.corrections);
  const auto obstacle = [&](std::size_t i) -> std::string_view {
    if (options.objective == Objective::toughness) {
      const auto toughness = data.toughness(i);
      return !toughness ? kNoPhaseAngle : describes<Model>(toughness->mixity) ? std::string_view() : kInfinite;
    }
    // a freed constant may bring it back
    const bool contact = !options.free.empty() || above_pull_off(scale.load(data.points[i].P)) >= 0;
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
  const bool needs_loads = options.objective != Objective::toughness || !options.free.empty();
  if (needs_loads && !data.has_loads)
    throw InputError(data.path, options.free.empty()
                                    ? "objective " + std::string(to_string(options.objective)) +
                                          " needs loads and areas (columns P, T, A); this file has psi and Gc"
                                    : "only a file with loads and areas (columns P, T, A) can free constants of the "
                                      "experiment");
  if (!data.has_loads && (options.sigma_T || options.sigma_A))
    throw InputError(data.path,
                     "objective toughness needs loads and areas (columns P, T, A) for sigma_T and sigma_A; "
                     "this file has psi and Gc");
  const bool corrected = !options.free.empty() || options.corrections != Corrections{};
  if (corrected && options.objective == Objective::toughness && (options.weighted || options.scale == Scale::linear))
    throw InputError(
        data.path,
        "with constants of the experiment free, objective toughness is fitted in ln(Gc/GIc) without weights; "
        "objective curve weighs the points");
  if (data.has_loads && (options.objective != Objective::toughness || options.weighted))
    prepared.errors = standard_errors(data, options.sigma_T, options.sigma_A);
  return prepared;
}

/// The points' loads and areas; without standard errors those are 1, so that residuals keep their unit.
template <class Model>
std::vector<MeasuredPoint> measured_points(const Dataset& data, const PreparedFit<Model>& prepared) {
  std::vector<MeasuredPoint> points;
  points.reserve(prepared.used.size());
  for (const std::size_t i : prepared.used) {
    const Point& p = data.points[i];
    points.push_back(
        {p.P, p.T, p.A, prepared.errors ? prepared.errors->T[i] : 1.0, prepared.errors ? prepared.errors->A[i] : 1.0});
  }
  return points;
}

/// What may be freed beside the model's parameters, with its range: factors of a thousand, loads up to ten times the
/// largest, areas up to nine tenths of the smallest.
template <class Model>
FreeChoice<Model> free_choice(const Dataset& data, const FitOptions& options, const PreparedFit<Model>& prepared) {
  FreeChoice<Model> choice({prepared.base, options.corrections}, prepared.held);
  double largest_load = 1, smallest_area = prepared.used.empty() ? 1 : std::numeric_limits<double>::infinity();
  for (const std::size_t i : prepared.used) {
    largest_load = std::max(largest_load, std::abs(data.points[i].P));
    smallest_area = std::min(smallest_area, data.points[i].A);
  }
  const double factor = std::log(1000.0);
  for (const Correction correction : options.free) {
    FreeParameter parameter{std::string(kCorrectionNames[correction]), -factor, factor, 0.0, 1.0, true};
    if (correction == kToughness && data.contact) parameter.scale = data.contact->toughness, parameter.unit = "J/m^2";
    if (correction == kModulus && data.contact) parameter.scale = data.contact->modulus, parameter.unit = "Pa";
    if (correction == kLoadOffset)
      parameter = {parameter.name, -10 * largest_load, 10 * largest_load, 0.0, data.display.force_scale,
                   false,          data.display.force};
    if (correction == kAreaOffset)
      parameter = {parameter.name, -0.9 * smallest_area, 0.9 * smallest_area, 0.0, data.display.area_scale,
                   false,          data.display.area};
    if (!prepared.start.empty()) parameter.start = prepared.start[choice.corrections().size()];
    choice.add(correction, parameter);
  }
  return choice;
}

template <class Model, template <class> class Residuals>
std::unique_ptr<ModelProblem<Model>> experiment(const std::vector<MeasuredPoint>& points, FreeChoice<Model> choice,
                                                bool toughness) {
  std::vector<double> targets, weights;
  for (const MeasuredPoint& point : points) {
    if (toughness) {
      targets.push_back(std::log(toughness_of_area(point.P, point.T, point.A)->ratio));
      weights.push_back(1);
    } else {
      targets.push_back(point.A / point.sigma_A);
      weights.push_back(1 / point.sigma_A);
    }
  }
  return std::make_unique<ExperimentObjective<Model, Residuals>>(points, std::move(targets), std::move(weights),
                                                                 std::move(choice));
}

/// `weights`: of objective toughness, 1/standard error; empty: 1.
template <class Model>
std::unique_ptr<ModelProblem<Model>> make_problem(const Dataset& data, const FitOptions& options,
                                                  const PreparedFit<Model>& prepared,
                                                  std::vector<double> weights = {}) {
  const FreeChoice<Model> choice = free_choice(data, options, prepared);
  const bool corrected = !options.free.empty() || options.corrections != Corrections{};
  const bool weighted = options.objective != Objective::toughness || !weights.empty();
  std::unique_ptr<ModelProblem<Model>> problem;
  if (options.objective == Objective::toughness && !corrected) {
    std::vector<ToughnessPoint> points;
    points.reserve(prepared.used.size());
    for (const std::size_t i : prepared.used) points.push_back(*data.toughness(i));
    problem = std::make_unique<ToughnessObjective<Model>>(std::move(points), options.scale, choice, std::move(weights));
  } else {
    const std::vector<MeasuredPoint> points = measured_points(data, prepared);
    if (options.objective == Objective::toughness)
      problem = experiment<Model, ToughnessResiduals>(points, choice, true);
    else if (options.objective == Objective::area)
      problem = experiment<Model, AreaResiduals>(points, choice, false);
    else
      problem = experiment<Model, CurveResiduals>(points, choice, false);
  }
  // a file of psi and Gc can only be weighted by its sigma_Gc
  problem->set_known_errors(weighted && (!prepared.errors || prepared.errors->absolute()));
  return problem;
}

}  // namespace mixity
