// Flags of a single contact: model, constants, loads.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/number_text.h"
#include "base/units.h"
#include "cli/flags.h"
#include "dataset/metadata.h"
#include "mechanics/contact.h"
#include "mechanics/contact_model.h"
#include "mechanics/held_approach.h"

namespace mixity::cli {

/// Units of the output: factors on dimensionless numbers, and names. Dimensionless output has factors 1 and no names.
struct OutputUnits {
  std::string force, length;
  double force_scale = 1, length_scale = 1, area_scale = 1, displacement_scale = 1;
  Unit force_unit{};               // for numbers given without a unit
  std::optional<Contact> contact;  // null if dimensionless
  double shear_weight = 1;         // the models' T over that of the experiment (Metadata::shear_weight)
  Metadata stated{};

  double shear_scale() const { return force_scale / shear_weight; }        // of the models' T
  double slip_scale() const { return displacement_scale / shear_weight; }  // of the u that they give for it

  std::string area() const { return length.empty() ? "" : length + "^2"; }
  /// "P [mN],A [mm^2],stable" for "P,A,stable": adds units to P, T, T_*, y, a, u, A and psi.
  std::string headings(std::string_view names) const;
};

/// Prints numbers in full precision, separated by commas.
void print_numbers(std::initializer_list<double> numbers);

/// Whether --shape=ellipse is given; as a number --shape is a constant of the data.
bool is_elliptic();

/// Made from --radius, --modulus (or --youngs_modulus and --poisson_ratio), --toughness, --units and --mode_III. Throws
/// UsageError if only some of the first are given. `of_ellipse`: --shape=ellipse and --poisson_ratio alone are
/// accepted.
OutputUnits output_units(bool of_ellipse = false);

struct Load {
  double dimensionless, shown;  // shown: in the output's unit
};

/// A list of loads. Throws UsageError for a wrong or missing unit.
std::vector<Load> loads_from(const std::string& flag, const OutputUnits& units);

/// The same for a flag with exactly one load.
Load load_from(const std::string& flag, const OutputUnits& units);

/// --approach and --normal_stiffness, dimensionless; throws UsageError if a load is given, too.
HeldApproach held_approach_from_flags(const OutputUnits& units);

/// The model with this key; throws UsageError if there is none.
ContactModel model_from(const std::string& key);

/// The same, of elliptic contacts with --shape=ellipse.
ContactModel shaped_model_from(const std::string& key);

/// Throws UsageError if these parameters define no contact under the load P (ContactModel::obstacle).
void require_contact(const ContactModel& model, const ParameterValues& p, double P = 0);

/// The parameters of a model. Throws UsageError if one is missing or out of range. The parameter with the index
/// `except` must not be given and stays 0.
ParameterValues parameters_from_flags(const ContactModel& model, std::optional<std::size_t> except = {});

/// The same for the two modes at the edge of an ellipse: NAME_II and NAME_III for each parameter of the model.
struct EndParameterValues {
  ParameterValues mode_II, mode_III;
};
EndParameterValues end_parameters_from_flags(const ContactModel& model);

}  // namespace mixity::cli
