#include "fitting/prepare.h"

#include <algorithm>
#include <cmath>

#include "base/input_error.h"
#include "base/number_text.h"

namespace mixity {
namespace {

/// The value at which to hold a parameter. Throws InputError if it is outside its range or not stated.
double held_value(const HeldParameter& held, const ParameterInfo& info, const Dataset& data) {
  std::optional<double> value = held.value;
  if (const auto& [I, II] = std::pair(data.metadata.toughness, data.metadata.toughness_II);
      !value && held.name == "r" && I && II)
    value = *II / *I;
  if (!value)
    throw InputError(data.path, "parameter '" + held.name +
                                    "' is to be held at the data set's own value, but the metadata state none" +
                                    (held.name == "r" ? " (r = toughness_II/toughness)" : ""));
  if (!(*value >= info.lower && *value <= info.upper))
    throw InputError(data.path, "parameter '" + held.name + "' is held at " + shortest(*value) +
                                    ", outside its range " + shortest(info.lower) + ".." + shortest(info.upper));
  return *value;
}

/// Throws InputError if the options require what the data set lacks.
void require_what_is_asked(const Dataset& data, const ContactModel& model, const FitOptions& options,
                           Objective objective) {
  const auto refuse = [&](const Message& message) { throw InputError(data.path, message); };
  if (model.is_elliptic() && !data.has_loads)
    refuse(
        "elliptic contacts are fitted to loads and areas or axes (columns P, T, A or a_par, a_perp); this file has " +
        std::string(data.has_energies ? "G_I and G_II" : "psi and Gc"));
  if (model.is_elliptic() && objective != Objective::curve)
    refuse("elliptic contacts have no single phase angle: fit them with " + Remedy::set("objective", "curve"));
  if (model.is_elliptic() && data.metadata.mode_III == ModeIII::averaged)
    refuse(std::string(kNoAverage) + ": fit it with " + Remedy::set("mode_III", "half"));
  if (data.holds_approach()) {
    if (model.is_elliptic()) refuse("a held approach is known for circles alone: leave out shape = ellipse");
    if (scale_of(options) == Scale::linear && objective == Objective::toughness)
      refuse("the toughness of areas under a held approach is compared in ln(Gc/GIc): leave out scale = linear");
    if (!data.loads_beside.empty() && (options.bootstrap.replicates > 0 || options.influence))
      refuse("bootstrap and influence are of points with areas alone: loads beside a held approach are not resampled");
    if (!data.loads_beside.empty() && !options.by_run.empty())
      refuse("what differs by run is fitted to areas: leave out the column P, or by_run");
    if (data.loads_beside.empty() &&
        std::find(options.free.begin(), options.free.end(), kLoadOffset) != options.free.end())
      refuse("load_offset is of readings of P, of which there are none beside delta: free approach_offset");
  } else if (std::find(options.free.begin(), options.free.end(), kApproachOffset) != options.free.end()) {
    refuse("approach_offset is of a held approach (control = \"approach\", column delta); these data hold loads");
  }
  const bool uncertain = fitted_constants(data, options).size() > options.free.size();
  const std::string columns = data.has_energies ? "G_I and G_II" : "psi and Gc";
  const bool curve = objective == Objective::curve, energies = curve && data.has_energies;
  if (!options.by_run.empty() && !(curve && data.has_loads))
    refuse("what differs by run is fitted under objective curve, to loads and areas (columns P, T, A)");
  if (curve && !data.has_loads && !energies)
    refuse("objective curve needs loads and areas (columns P, T, A), or energies (G_I, G_II); this file has " +
           columns);
  if (!data.has_loads && (options.sigma_T || options.sigma_A))
    refuse("sigma_T and sigma_A are errors of loads and areas (columns P, T, A); this file has " + columns);
  if (!data.has_loads &&
      std::any_of(options.free.begin(), options.free.end(), [](Constant c) { return c != kToughness; }))
    refuse("the toughness is the only constant that can be free without loads and areas (columns P, T, A); this file " +
           std::string("has ") + columns);
  if (data.several_spheres && std::any_of(options.free.begin(), options.free.end(),
                                          [](Constant c) { return c >= kLoadOffset && c <= kAreaOffset; }))
    refuse(kNoOffsets);
  if (model.is_elliptic() && !data.axes.empty() && !options.by_run.empty())
    refuse("what differs by run is fitted to areas: the axes of elliptic contacts have one set of parameters");
  if (model.is_elliptic() && !data.axes.empty() && (options.bootstrap.replicates > 0 || options.influence))
    refuse("bootstrap and influence are of points with areas alone: the axes of elliptic contacts are not resampled");
  if (!data.pull_off.empty() && model.is_elliptic())
    refuse("pull-off loads are those of circular contacts; fit them without " + Remedy::set("shape", "ellipse"));
  if (!data.pull_off.empty() && data.points.empty() && !curve)
    refuse("pull-off loads have no phase angle: fit them with " + Remedy::set("objective", "curve"));
  if (!data.pull_off.empty() && !options.by_run.empty())
    refuse("what differs by run is fitted to areas: pull-off loads belong to no run");
  if (!data.pull_off.empty() && curve && (options.bootstrap.replicates > 0 || options.influence))
    refuse("bootstrap and influence are of points with areas: pull-off loads are not resampled");
  if (data.has_energies && !curve && !options.free.empty())
    refuse("with energies (G_I, G_II), the toughness can be free under " + Remedy::set("objective", "curve"));
  if (!data.toughness_known && !(energies && !options.free.empty()))
    refuse("needs toughness (G_Ic)" + Remedy::state({"toughness"}, metadata_path(data.path)) + ", or fit it with " +
           Remedy{Remedy::Kind::set, {{"objective", "curve"}, {"free", "toughness"}}});
  if ((uncertain || !options.free.empty()) && !curve && scale_of(options) == Scale::linear)
    refuse(
        "with constants of the experiment fitted, free or with a standard error, objective toughness is fitted in "
        "ln(Gc/GIc)");
  if (curve && (options.weighted || options.scale))
    refuse(std::string(options.weighted ? "weighted" : "scale") + " needs the objective toughness (" +
           Remedy::set("objective", "toughness") + "): curve, the default for loads and areas, " +
           (options.weighted ? "weighs the points anyway" : "compares no toughness"));
}

/// Whether the toughness is infinite at psi = pi/2 for all parameters inside their ranges. Points there are then not
/// used.
bool is_infinite_in_mode_II(const ContactModel& model) {
  std::vector<double> typical;
  for (const ParameterInfo& info : model.parameters()) typical.push_back(info.typical);
  const Mixity<double> mode_II{0, 1};
  double value = 0;
  model.log_toughness(typical, {&mode_II, 1}, {&value, 1}, {});
  return !std::isfinite(value);
}

/// Chooses the points that the model can describe, and states why it cannot describe the others.
void choose_points(const Dataset& data, const std::vector<std::size_t>* points, PreparedFit& prepared) {
  const Scales scales(data, prepared.constants);
  std::optional<bool> infinite;
  const auto obstacle = [&](std::size_t i) -> std::string_view {
    if (prepared.objective == Objective::toughness) {
      const auto toughness = data.toughness(i, scales.of(i));
      if (!toughness) return kNoPhaseAngle;
      if (toughness->mixity.cos > 0) return {};
      if (!infinite) infinite = is_infinite_in_mode_II(prepared.model);
      if (!*infinite) return {};
      if (!prepared.excluded_reason)
        prepared.excluded_reason = std::make_shared<const std::string>(
            "model " + std::string(prepared.model.info().key) + " has an infinite toughness at this psi");
      return *prepared.excluded_reason;
    }
    if (data.has_energies) return {};
    // there may be a contact for another value of a constant
    const ConstantsScale scale = scales.of(i);
    const bool contact =
        !prepared.fitted.empty() || at_scale(prepared.model, scale).in_contact(scale.load(data.points[i].P));
    return contact ? std::string_view() : data.holds_approach() ? kBelowPullOffOfApproach : kBelowPullOff;
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
}

/// Poisson's ratio of elliptic contacts: as stated, with its error as a prior, or of an incompressible body.
void take_poisson_ratio(const Dataset& data, PreparedFit& prepared) {
  const std::size_t last = prepared.held.size() - 1;
  if (prepared.held[last]) return;
  const std::optional<double>& stated = data.metadata.poisson_ratio;
  prepared.base[last] = stated.value_or(0.5);
  prepared.poisson_error = stated ? data.metadata.standard_error(kPoissonRatio) : 0;
  prepared.held[last] = !(prepared.poisson_error > 0);
}

/// A common factor on stated errors needs stated errors.
void require_errors_for_their_factor(const Dataset& data, const FitOptions& options, Objective objective,
                                     const PreparedFit& prepared) {
  if (!options.free_sigma_factor || options.errors) return;
  const char* missing = nullptr;
  if (objective != Objective::curve)
    missing = options.weighted ? nullptr : "objective = curve, or weighted = true";
  else if (data.has_energies)
    missing = data.errors.empty() ? "a column sigma_GI or sigma_GII" : nullptr;
  else if (!StandardErrors::is_known(prepared.errors->source_T) || !StandardErrors::is_known(prepared.errors->source_A))
    missing = "standard errors of both T and A: columns sigma_T and sigma_A, or the options of these names";
  if (missing) throw InputError(data.path, std::string("sigma_factor = free needs ") + missing);
}

/// Sets held values, and typical ones for the other parameters.
void hold_parameters(const Dataset& data, const FitOptions& options, PreparedFit& prepared) {
  const std::span<const ParameterInfo> infos = prepared.model.parameters();
  prepared.held.assign(infos.size(), false);
  std::vector<double> base;
  for (const ParameterInfo& info : infos) {
    base.push_back(info.typical);
    for (const HeldParameter& held : options.hold)
      if (held.name == info.name) {
        base.back() = held_value(held, info, data);
        prepared.held[base.size() - 1] = true;
      }
  }
  prepared.base = ParameterValues(base);
  if (prepared.model.is_elliptic()) take_poisson_ratio(data, prepared);
}

}  // namespace

std::vector<FittedConstant> fitted_constants(const Dataset& data, const FitOptions& options) {
  const Constants stated = data.stated_constants();
  std::vector<FittedConstant> list;
  for (const Constant constant : options.free) list.push_back({constant, stated[constant], 0});
  if (options.constants) return list;
  for (const FittedConstant& uncertain : uncertain_constants(data))
    if (std::find(options.free.begin(), options.free.end(), uncertain.constant) == options.free.end())
      list.push_back(uncertain);
  return list;
}

StandardErrors errors_before_fit(const Dataset& data, const FitOptions& options, Objective objective) {
  StandardErrors errors =
      standard_errors(data, options.sigma_T, options.sigma_A, objective == Objective::curve, options.of_whole.get());
  errors.factor_is_free = options.free_sigma_factor;
  return errors;
}

PreparedFit prepare(const Dataset& data, const ContactModel& model, const FitOptions& options, Objective objective,
                    const std::vector<std::size_t>* points) {
  require_what_is_asked(data, model, options, objective);
  PreparedFit prepared{data.under_control(model), objective};
  prepared.constants = constants_of(data, options);
  prepared.fitted = fitted_constants(data, options);
  choose_points(data, points, prepared);
  hold_parameters(data, options, prepared);
  if (data.has_loads && (objective == Objective::curve || options.weighted))
    // A fit with given errors finds none, so that these are never changed.
    prepared.errors = options.errors && objective == Objective::curve
                          ? std::const_pointer_cast<StandardErrors>(options.errors)
                          : std::make_shared<StandardErrors>(errors_before_fit(data, options, objective));
  require_errors_for_their_factor(data, options, objective, prepared);
  return prepared;
}

}  // namespace mixity
