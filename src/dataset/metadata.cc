#include "dataset/metadata.h"

#include <array>
#include <filesystem>
#include <toml++/toml.h>

#include "dataset/csv.h"
#include "dataset/input_error.h"
#include "dataset/number_text.h"
#include "mechanics/contact.h"

namespace mixity {
namespace {

struct Field {
  std::string_view name;
  std::optional<double> Metadata::*value;
  Dimension dimension;
  std::string_view example;
};

constexpr std::array kFields{
    Field{"radius", &Metadata::radius, dimension::length, "9.42 mm"},
    Field{"modulus", &Metadata::modulus, dimension::stress, "2.133 MPa"},
    Field{"youngs_modulus", &Metadata::youngs_modulus, dimension::stress, "1.6 MPa"},
    Field{"poisson_ratio", &Metadata::poisson_ratio, dimension::none, "0.5"},
    Field{"toughness", &Metadata::toughness, dimension::energy_per_area, "27 mJ/m^2"},
    Field{"toughness_II", &Metadata::toughness_II, dimension::energy_per_area, "1.7 N/mm"},
    Field{"shear_strength", &Metadata::shear_strength, dimension::stress, "0.43 MPa"},
};

constexpr std::array kProvenances{Provenance::measured, Provenance::digitised, Provenance::reconstructed};

std::string quoted(std::string_view text) { return '"' + std::string(text) + '"'; }

}  // namespace

std::string_view to_string(Provenance provenance) {
  switch (provenance) {
    case Provenance::measured: return "measured";
    case Provenance::digitised: return "digitised";
    case Provenance::reconstructed: return "reconstructed";
    case Provenance::unstated: break;
  }
  return "unstated";
}

std::optional<double> Metadata::plane_strain_modulus() const {
  if (modulus) return modulus;
  if (youngs_modulus && poisson_ratio) return mixity::plane_strain_modulus(*youngs_modulus, *poisson_ratio);
  return std::nullopt;
}

std::string set_field(Metadata& metadata, std::string_view name, std::string_view text) {
  if (name == "source") return metadata.source = text, "";
  if (name == "note") return metadata.note = text, "";
  if (name == "provenance") {
    for (const Provenance provenance : kProvenances)
      if (text == to_string(provenance)) return metadata.provenance = provenance, "";
    return "provenance is " + quoted(text) + "; it must be measured, digitised or reconstructed";
  }
  for (const Field& field : kFields) {
    if (field.name != name) continue;
    const auto quantity = parse_quantity(text);
    if (!quantity)
      return std::string(name) + " is " + quoted(text) + "; it must be a number with a unit, such as " +
             quoted(field.example);
    if (quantity->unit.dimension != field.dimension)
      return std::string(name) + " is " + quoted(text) + "; it must be " + describe(field.dimension) + ", written " +
             quoted(field.example);
    const double value = quantity->si();
    if (name == "poisson_ratio" ? !(value >= 0 && value <= 0.5) : !(value > 0))
      return std::string(name) + " is " + quoted(text) +
             (name == "poisson_ratio" ? "; it must lie between 0 and 0.5" : "; it must be positive");
    metadata.*field.value = value;
    return "";
  }
  std::string known = "provenance, source, note";
  for (const Field& field : kFields) known += ", " + std::string(field.name);
  return "unknown key " + quoted(name) + " (known: " + known + ")";
}

Metadata read_metadata(const std::string& path) {
  Metadata metadata;
  if (!std::filesystem::exists(path)) return metadata;
  toml::table table;
  try {
    table = toml::parse(read_file(path), path);
  } catch (const toml::parse_error& error) {
    throw InputError(path, error.source().begin.line, error.source().begin.column, std::string(error.description()));
  }
  for (const auto& [key, node] : table) {
    const auto fail = [&, &value = node, &name = key](const std::string& message, bool at_key = false) {
      const toml::source_position at = at_key ? name.source().begin : value.source().begin;
      throw InputError(path, at.line, at.column, message);
    };
    std::string text;
    if (node.is_string())
      text = node.as_string()->get();
    else if (key.str() == "poisson_ratio" && node.is_number())
      text = shortest(node.value<double>().value_or(-1));
    else
      fail(std::string(key.str()) + " must be a string" +
           (node.is_number() ? " with a number and a unit, such as \"9.42 mm\"" : ""));
    const std::string problem = set_field(metadata, key.str(), text);
    if (!problem.empty()) fail(problem, problem.starts_with("unknown key"));
  }
  if (metadata.modulus && metadata.youngs_modulus)
    throw InputError(path, "states both modulus and youngs_modulus; state one");
  if (metadata.youngs_modulus && !metadata.poisson_ratio)
    throw InputError(path, "states youngs_modulus without poisson_ratio");
  return metadata;
}

void apply_overrides(const Overrides& overrides, Metadata& metadata) {
  for (const auto& [name, text] : overrides) {
    if (name == "modulus") metadata.youngs_modulus.reset();
    if (name == "youngs_modulus") metadata.modulus.reset();
    const std::string problem = set_field(metadata, name, text);
    if (!problem.empty()) throw InputError("--" + name, problem);
  }
}

}  // namespace mixity
