#include "cli/contact_flags.h"

#include <algorithm>
#include <iostream>
#include <map>

#include "analysis/contact_shape.h"
#include "base/text.h"
#include "dataset/metadata.h"

DEFINE_string(approach, "",
              "approach of the sphere that is held in place of a load: a number, or a length such as \"2 um\"");
DEFINE_string(lambda, "", "mode-mixity parameter lambda");
DEFINE_string(lambda_II, "", "of an ellipse: lambda at the front and rear, where mode II acts");
DEFINE_string(lambda_III, "", "of an ellipse: lambda at the sides, where mode III acts");
DEFINE_string(parameters, "", "all parameters of the model, such as r=1.77,eta=2.28");
DEFINE_string(shear, "", "tangential loads T: \"0,5,10\", or \"0,5,10 mN\" if dimensional");
DEFINE_string(units, "mN,mm", "force and length unit of dimensional output, and of numbers without a unit");

namespace mixity::cli {

void print_numbers(std::initializer_list<double> numbers) {
  for (const double& one : numbers) std::cout << (&one == numbers.begin() ? "" : ",") << shortest(one);
}

bool is_elliptic() { return means_ellipse(value_of("shape")); }

OutputUnits output_units(bool of_ellipse) {
  if (of_ellipse && is_set("approach"))
    throw UsageError("--approach and --shape=ellipse: a held approach is known for circles alone");
  // Mode III at the edge of an ellipse depends on Poisson's ratio, whatever states the modulus.
  std::vector<std::string_view> others{"normal_stiffness"};  // may be dimensionless here
  if (of_ellipse) others = {"normal_stiffness", "shape", is_set("youngs_modulus") ? "" : "poisson_ratio"};
  Overrides overrides = metadata_overrides(others);
  if (is_set("definition")) overrides.emplace_back("definition", value_of("definition"));
  const Metadata metadata = stated_by(overrides);
  if (of_ellipse && metadata.mode_III != ModeIII::unstated)
    throw UsageError("--mode_III is about circles; the equations of an ellipse have modes II and III where they act");
  if (metadata.control == NormalControl::approach)
    throw UsageError(
        "--control=approach is about data; of a model, --approach=D of predict and instability holds the approach D");
  if (is_set("normal_stiffness") && !is_set("approach"))
    throw UsageError(
        "--normal_stiffness needs --approach, which predict and instability know, or data with control = approach");
  require_whole_modulus(metadata, {}, overrides);
  OutputUnits units;
  units.shear_weight = metadata.shear_weight();
  units.stated = metadata;
  const auto modulus = metadata.plane_strain_modulus();
  const int given = metadata.radius.has_value() + modulus.has_value() + metadata.toughness.has_value();
  if (given == 0 && is_set("units")) throw UsageError("flag '--units' needs --radius, --modulus and --toughness");
  if (given == 0) return units;
  if (given < 3) throw UsageError("a dimensional prediction needs all of --radius, --modulus and --toughness");
  const std::vector<std::string> names = list_from("units");
  const auto force = names.size() == 2 ? parse_unit(names[0]) : std::nullopt;
  const auto length = names.size() == 2 ? parse_unit(names[1]) : std::nullopt;
  if (!force || !length || force->dimension != dimension::force || length->dimension != dimension::length)
    throw must("units", "be a force and a length, such as mN,mm");
  if (!metadata.standard_errors.empty())
    warn("standard errors of constants need a fit to be carried over (DATA.csv in place of a model)");
  const Contact contact{*metadata.radius, *modulus, *metadata.toughness};
  if (!contact.usable()) throw UsageError("--radius, --modulus and --toughness together are out of range");
  const double metre = 1 / length->factor;
  return {names[0],
          names[1],
          contact.force_unit() / force->factor,
          contact.length_unit() * metre,
          contact.area_unit() * metre * metre,
          contact.displacement_unit() * metre,
          *force,
          contact,
          units.shear_weight,
          metadata};
}

std::string OutputUnits::headings(std::string_view names) const {
  std::string line;
  for (const std::string_view name : split(names)) {
    const bool is_force = name == "P" || name == "T" || name == "y" || name.starts_with("T_");
    const bool is_length = name == "a" || name == "b" || name == "u";
    const std::string unit = is_force                             ? force
                             : is_length                          ? length
                             : name == "A"                        ? area()
                             : name.starts_with("psi") && contact ? "rad"
                                                                  : "";
    line += (line.empty() ? "" : ",") + bracketed(std::string(name), unit);
  }
  return line;
}

std::vector<Load> loads_from(const std::string& flag, const OutputUnits& units) {
  const std::optional<Contact>& contact = units.contact;
  std::vector<Load> loads;
  for (Quantity quantity : quantities_from(flag)) {
    const bool bare = quantity.unit.text.empty();
    if (!contact) {
      if (!bare) throw UsageError("flag '--" + flag + "' has a unit; that needs --radius, --modulus and --toughness");
      loads.push_back({quantity.value, quantity.value});
      continue;
    }
    if (bare) quantity.unit = units.force_unit;
    if (quantity.unit.dimension != dimension::force)
      throw UsageError("flag '--" + flag + "' must be a force such as \"3 mN\"");
    const bool same = quantity.unit.factor == units.force_unit.factor;
    loads.push_back({quantity.si() / contact->force_unit(),
                     same ? quantity.value : as_decimal(quantity.si() / units.force_unit.factor)});
  }
  return loads;
}

Load load_from(const std::string& flag, const OutputUnits& units) {
  const std::vector<Load> loads = loads_from(flag, units);
  if (loads.size() != 1) throw not_one_number(flag);
  return loads[0];
}

namespace {

using Texts = std::map<std::string, std::string>;

/// Parameters that have a flag each.
constexpr const char* kOwnFlags[] = {"lambda", "lambda_II", "lambda_III"};
bool has_flag(const std::string& parameter) {
  return parameter == kPoissonRatio ||
         std::find(std::begin(kOwnFlags), std::end(kOwnFlags), parameter) != std::end(kOwnFlags);
}

/// The parameters from --parameters and the flags of one parameter, by name.
Texts parameter_texts() {
  Texts given;
  for (const std::string& item : list_from("parameters")) {
    const std::size_t equals = item.find('=');
    if (equals == std::string::npos) throw refused("parameters", "'" + item + "' is not NAME=NUMBER");
    const std::string name(trim(std::string_view(item).substr(0, equals)));
    if (!given.emplace(name, item.substr(equals + 1)).second)
      throw UsageError("flag '--parameters' names '" + name + "' twice");
  }
  for (const char* name : kOwnFlags)
    if (is_set(name) && !given.emplace(name, value_of(name)).second)
      throw UsageError("flags '--" + std::string(name) + "' and '--parameters' both give " + name);
  return given;
}

/// Takes the parameters NAME + `suffix` of the model out of `given`.
ParameterValues taken_from(Texts& given, const ContactModel& model, const std::string& suffix,
                           std::optional<std::size_t> except) {
  const std::string key(model.info().key);
  const std::span<const ParameterInfo> infos = model.parameters();
  ParameterValues p = ParameterValues::zeros(infos.size());
  for (std::size_t i = 0; i < p.size(); ++i) {
    const ParameterInfo& info = infos[i];
    const std::string name = std::string(info.name) + suffix;
    if (i == except) continue;
    const auto found = given.find(name);
    if (found == given.end())
      throw UsageError("model " + key + (suffix.empty() ? "" : " of an ellipse") + " needs " +
                       (has_flag(name) ? "--" + name : "--parameters=" + name + "=..."));
    const auto value = parse_number(found->second);
    if (!value || !(*value >= info.lower && *value <= info.upper))
      throw UsageError(name + " is '" + found->second + "'; model " + key + " needs a number from " +
                       shortest(info.lower) + " to " + shortest(info.upper));
    p[i] = *value;
    given.erase(found);
  }
  return p;
}

void require_no_other(const Texts& given, const ContactModel& model) {
  if (!given.empty())
    throw UsageError("model " + std::string(model.info().key) + " has no parameter '" + given.begin()->first + "'");
}

}  // namespace

HeldApproach held_approach_from_flags(const OutputUnits& units) {
  if (is_set("load") || is_set("loads")) throw UsageError("--approach and --load: one of them is held");
  const bool bare = !units.contact;
  const Quantity given = quantity_from(
      "approach",
      bare ? "be a number; a unit needs --radius, --modulus and --toughness" : "be a length, such as \"2 um\"",
      [&](const Quantity& one) { return bare ? one.unit.text.empty() : one.unit.dimension == dimension::length; });
  HeldApproach held{bare ? given.value : given.si() / units.contact->displacement_unit()};
  if (is_set("normal_stiffness"))
    held.compliance =
        1 / positive_quantity("normal_stiffness", "N/m",
                              units.contact ? std::optional(units.contact->stiffness_unit()) : std::nullopt);
  return held;
}

ContactModel model_from(const std::string& key) {
  require_model("model", key);
  return ContactModel::find(key).value();
}

ContactModel shaped_model_from(const std::string& key) {
  const ContactModel model = model_from(key);
  if (!is_elliptic() || model.is_elliptic()) return model;
  return ContactModel::find(key + std::string(kEllipse)).value();
}

void require_contact(const ContactModel& model, const ParameterValues& p, double P) {
  if (const auto obstacle = model.obstacle(p, P); !obstacle.empty()) throw UsageError(std::string(obstacle));
}

ParameterValues parameters_from_flags(const ContactModel& model, std::optional<std::size_t> except) {
  Texts given = parameter_texts();
  if (model.is_elliptic() && is_set(kPoissonRatio)) given.emplace(kPoissonRatio, value_of(kPoissonRatio));
  ParameterValues p = taken_from(given, model, "", except);
  if (except && given.contains(std::string(model.parameters()[*except].name)))
    throw UsageError("parameter " + std::string(model.parameters()[*except].name) +
                     " is on the axis of the map: only the others are stated");
  require_no_other(given, model);
  return p;
}

EndParameterValues end_parameters_from_flags(const ContactModel& model) {
  Texts given = parameter_texts();
  EndParameterValues p{taken_from(given, model, "_II", {}), taken_from(given, model, "_III", {})};
  require_no_other(given, model);
  return p;
}

}  // namespace mixity::cli
