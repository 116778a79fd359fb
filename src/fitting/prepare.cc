#include "fitting/prepare.h"

#include <algorithm>

#include "base/number_text.h"

namespace mixity {
namespace {

/// What the metadata say of a parameter; null if nothing.
std::optional<double> stated_value(std::string_view parameter, const Metadata& metadata) {
  if (parameter == "r" && metadata.toughness && metadata.toughness_II)
    return *metadata.toughness_II / *metadata.toughness;
  return std::nullopt;
}

}  // namespace

double held_value(const HeldParameter& held, const ParameterInfo& info, const Dataset& data) {
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

std::vector<FittedConstant> fitted_constants(const Dataset& data, const FitOptions& options) {
  const Constants stated = stated_constants(data);
  std::vector<FittedConstant> list;
  for (const Constant constant : options.free) list.push_back({constant, stated[constant], 0});
  if (options.constants) return list;
  for (const FittedConstant& uncertain : uncertain_constants(data))
    if (std::find(options.free.begin(), options.free.end(), uncertain.constant) == options.free.end())
      list.push_back(uncertain);
  return list;
}

void require_what_is_asked(const Dataset& data, const FitOptions& options, Objective objective) {
  const auto refuse = [&](const std::string& message) { throw InputError(data.path, message); };
  const bool uncertain = fitted_constants(data, options).size() > options.free.size();
  const std::string columns = data.has_energies ? "G_I and G_II" : "psi and Gc";
  const bool curve = objective == Objective::curve, energies = curve && data.has_energies;
  if (curve && !data.has_loads && !energies)
    refuse("objective curve needs loads and areas (columns P, T, A), or energies (G_I, G_II); this file has " +
           columns);
  if (!data.has_loads && (options.sigma_T || options.sigma_A))
    refuse("sigma_T and sigma_A are errors of loads and areas (columns P, T, A); this file has " + columns);
  if (!data.has_loads &&
      std::any_of(options.free.begin(), options.free.end(), [](Constant c) { return c != kToughness; }))
    refuse("the toughness is the only constant that can be free without loads and areas (columns P, T, A); this file " +
           std::string("has ") + columns);
  if (data.several_spheres &&
      std::any_of(options.free.begin(), options.free.end(), [](Constant c) { return c >= kLoadOffset; }))
    refuse(kNoOffsets);
  if (data.has_energies && !curve && !options.free.empty())
    refuse("with energies (G_I, G_II), the toughness can be free under --objective=curve");
  if (!data.toughness_known && !(energies && !options.free.empty()))
    refuse("needs toughness (G_Ic): state it in " + metadata_path(data.path) +
           " or by a flag (--toughness=...), or fit it with --objective=curve --free=toughness");
  if ((uncertain || !options.free.empty()) && !curve && scale_of(options) == Scale::linear)
    refuse(
        "with constants of the experiment fitted, free or with a standard error, objective toughness is fitted in "
        "ln(Gc/GIc)");
  if (curve && (options.weighted || options.scale))
    refuse(std::string(options.weighted ? "weighted" : "scale") +
           " needs the objective toughness (--objective=toughness): curve, the default for loads and areas, " +
           (options.weighted ? "weighs the points anyway" : "compares no toughness"));
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
