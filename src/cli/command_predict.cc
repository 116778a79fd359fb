// mixity predict: one model, one normal load, areas at a list of tangential loads.
#include <cmath>
#include <iostream>
#include <map>

#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/flags.h"
#include "cli/quantity_list.h"
#include "cli/usage_error.h"
#include "dataset/number_text.h"
#include "mechanics/prediction.h"

namespace mixity::cli {
namespace {

/// What turns dimensionless numbers into the printed ones; all ones, without unit names, if dimensionless.
struct OutputUnits {
  std::string force, length;
  double force_scale = 1, length_scale = 1, area_scale = 1, displacement_scale = 1;
  Unit force_unit{};  // of numbers given without one
};

OutputUnits output_units(std::optional<Contact>& contact) {
  Metadata metadata;
  apply_overrides(metadata_overrides(), metadata);
  const auto modulus = metadata.plane_strain_modulus();
  const int given = metadata.radius.has_value() + modulus.has_value() + metadata.toughness.has_value();
  if (given == 0 && is_set("units")) throw UsageError("flag '--units' needs --radius, --modulus and --toughness");
  if (given == 0) return {};
  if (given < 3) throw UsageError("a dimensional prediction needs all of --radius, --modulus and --toughness");
  const std::vector<std::string> names = split_list(FLAGS_units);
  const auto force = names.size() == 2 ? parse_unit(names[0]) : std::nullopt;
  const auto length = names.size() == 2 ? parse_unit(names[1]) : std::nullopt;
  if (!force || !length || force->dimension != dimension::force || length->dimension != dimension::length)
    throw UsageError("flag '--units' is '" + FLAGS_units + "'; it must be a force and a length, such as mN,mm");
  contact = Contact{*metadata.radius, *modulus, *metadata.toughness};
  const double metre = 1 / length->factor;
  return {names[0],
          names[1],
          contact->force_unit() / force->factor,
          contact->length_unit() * metre,
          contact->area_unit() * metre * metre,
          contact->displacement_unit() * metre,
          *force};
}

struct Load {
  double dimensionless, shown;  // shown: in the output's unit, as given where it was given in that
};

std::vector<Load> loads_from(const std::string& flag, const std::string& text, const std::optional<Contact>& contact,
                             const OutputUnits& units) {
  std::vector<Load> loads;
  for (Quantity quantity : quantity_list(flag, text)) {
    const bool bare = quantity.unit.text.empty();
    if (!contact && !bare)
      throw UsageError("flag '--" + flag + "' has a unit; that needs --radius, --modulus and --toughness");
    if (!contact) {
      loads.push_back({quantity.value, quantity.value});
      continue;
    }
    if (bare) quantity.unit = units.force_unit;
    if (quantity.unit.dimension != dimension::force)
      throw UsageError("flag '--" + flag + "' must be a force such as \"3 mN\"");
    const bool same = quantity.unit.factor == units.force_unit.factor;
    loads.push_back(
        {quantity.si() / contact->force_unit(), same ? quantity.value : quantity.si() / units.force_unit.factor});
  }
  return loads;
}

template <class Model>
Parameters<Model> parameters_from_flags() {
  std::map<std::string, std::string> given;
  for (const std::string& item : split_list(FLAGS_parameters)) {
    const std::size_t equals = item.find('=');
    if (equals == std::string::npos) throw UsageError("flag '--parameters': '" + item + "' is not NAME=NUMBER");
    given[item.substr(0, equals)] = item.substr(equals + 1);
  }
  if (is_set("lambda")) given["lambda"] = FLAGS_lambda;
  Parameters<Model> p{};
  for (std::size_t i = 0; i < p.size(); ++i) {
    const ParameterInfo& info = Model::parameters[i];
    const std::string name(info.name);
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
  if (!given.empty())
    throw UsageError("model " + std::string(Model::info.key) + " has no parameter '" + given.begin()->first + "'");
  return p;
}

template <class Model>
void predict() {
  const Parameters<Model> p = parameters_from_flags<Model>();
  std::optional<Contact> constants;
  const OutputUnits units = output_units(constants);
  const std::vector<Load> load = loads_from("load", FLAGS_load, constants, units);
  const std::vector<Load> shears = loads_from("shear", FLAGS_shear, constants, units);
  if (load.size() != 1) throw UsageError("flag '--load' must be one number");
  for (const Load& shear : shears)
    if (!(shear.dimensionless >= 0 && shear.dimensionless <= kLargestLoad))
      throw UsageError("flag '--shear': every T must lie between 0 and 1e150");
  const LoadedContact<Model> contact(p, load[0].dimensionless);
  if (!contact.obstacle().empty()) throw UsageError(std::string(contact.obstacle()));

  const auto header = [](const std::string& name, const std::string& unit) {
    return unit.empty() ? name : name + " [" + unit + "]";
  };
  const std::string area = units.length.empty() ? "" : units.length + "^2", angle = units.length.empty() ? "" : "rad";
  std::cout << header("P", units.force) << ',' << header("T", units.force) << ',' << header("y", units.force) << ','
            << header("a", units.length) << ',' << header("A", area) << ',' << header("u", units.length) << ','
            << header("psi", angle) << ",f,status\n";
  for (const Load& shear : shears) {
    std::cout << shortest(load[0].shown) << ',' << shortest(shear.shown) << ',';
    const Equilibrium equilibrium = contact.at(shear.dimensionless);
    if (equilibrium.status == EquilibriumStatus::ok) {
      const ContactState state = contact_state(load[0].dimensionless, shear.dimensionless, equilibrium.y);
      std::cout << shortest(state.y * units.force_scale) << ',' << shortest(state.a * units.length_scale) << ','
                << shortest(state.A * units.area_scale) << ',' << shortest(state.u * units.displacement_scale) << ','
                << shortest(state.psi) << ',' << shortest(state.f) << ',';
    } else {
      std::cout << ",,,,,,";
    }
    std::cout << to_string(equilibrium.status) << '\n';
  }
}

}  // namespace

int run_predict(const Arguments& arguments) {
  if (!arguments.empty()) throw UsageError("predict takes flags only, not '" + arguments[0] + "'");
  require_model("model", FLAGS_model);
  with_model(FLAGS_model, [](auto model) { predict<decltype(model)>(); });
  return kFine;
}

}  // namespace mixity::cli
