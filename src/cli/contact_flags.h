// Flags that describe one contact: its model, its constants, its loads.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/number_text.h"
#include "base/units.h"
#include "cli/flags.h"
#include "cli/usage_error.h"
#include "mechanics/contact.h"
#include "mechanics/registry.h"

namespace mixity::cli {

/// How dimensionless numbers are printed: all scales one, without unit names, if dimensionless.
struct OutputUnits {
  std::string force, length;
  double force_scale = 1, length_scale = 1, area_scale = 1, displacement_scale = 1, stiffness_scale = 1;
  Unit force_unit{};               // of numbers given without one
  std::optional<Contact> contact;  // null if dimensionless

  std::string area() const { return length.empty() ? "" : length + "^2"; }
  std::string angle() const { return length.empty() ? "" : "rad"; }
  /// "T [mN]", or "T" if dimensionless.
  static std::string header(const std::string& name, const std::string& unit) {
    return unit.empty() ? name : name + " [" + unit + "]";
  }
};

/// From --radius, --modulus (or --youngs_modulus, --poisson_ratio), --toughness and --units: all or none.
OutputUnits output_units();

struct Load {
  double dimensionless, shown;  // shown: in the output's unit, as given where it was given in that
};

/// A list of loads from the text of a flag; throws UsageError if a unit is missing, wrong or out of place.
std::vector<Load> loads_from(const std::string& flag, const std::string& text, const OutputUnits& units);

/// The same for a flag that must hold exactly one load.
Load load_from(const std::string& flag, const std::string& text, const OutputUnits& units);

/// --parameters and --lambda by name.
std::map<std::string, std::string> parameter_texts();

/// The parameters of a model, all of them given and in range, except that of this number, which stays 0; throws
/// UsageError otherwise.
template <class Model>
Parameters<Model> parameters_from_flags(std::optional<std::size_t> except = {}) {
  std::map<std::string, std::string> given = parameter_texts();
  Parameters<Model> p{};
  for (std::size_t i = 0; i < p.size(); ++i) {
    const ParameterInfo& info = Model::parameters[i];
    const std::string name(info.name);
    if (i == except) continue;
    const auto found = given.find(name);
    if (found == given.end())
      throw UsageError("model " + std::string(Model::info.key) + " needs " +
                       (name == "lambda" ? "--lambda" : "--parameters=" + name + "=..."));
    const auto value = parse_number(found->second);
    if (!value || !(*value >= info.lower && *value <= info.upper))
      throw UsageError(name + " is '" + found->second + "'; model " + std::string(Model::info.key) +
                       " needs a number from " + shortest(info.lower) + " to " + shortest(info.upper));
    p[i] = *value;
    given.erase(found);
  }
  if (except && given.contains(std::string(Model::parameters[*except].name)))
    throw UsageError("parameter " + std::string(Model::parameters[*except].name) +
                     " is on the axis of the map: only the others are stated");
  if (!given.empty())
    throw UsageError("model " + std::string(Model::info.key) + " has no parameter '" + given.begin()->first + "'");
  return p;
}

}  // namespace mixity::cli
