// Flags that describe one contact: its model, its constants, its loads.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/number_text.h"
#include "base/units.h"
#include "cli/flags.h"
#include "cli/usage_error.h"
#include "mechanics/contact.h"
#include "mechanics/contact_model.h"

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

/// The model with this key; throws UsageError if there is none.
ContactModel model_from(const std::string& key);

/// The parameters of a model, all of them given and in range, except that of this number, which stays 0; throws
/// UsageError otherwise.
ParameterValues parameters_from_flags(const ContactModel& model, std::optional<std::size_t> except = {});

}  // namespace mixity::cli
