#include "dataset/metadata.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/input_error.h"
#include "base/nearest_name.h"
#include "base/number_text.h"
#include "base/text.h"
#include "dataset/constants.h"
#include "dataset/table/column_names.h"
#include "mechanics/contact.h"

namespace mixity {
namespace {

constexpr std::array<std::string_view, 4> kProvenances{"unstated", "measured", "digitised", "reconstructed"};

constexpr double kIncompressible = 0.5;  // Poisson's ratio of rubber, if none is stated

std::string quoted(std::string_view text) { return '"' + std::string(text) + '"'; }

/// Line ends and tabs become blanks, other control characters '?'.
std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
  return printable(trim(text), std::string::npos);
}

/// Reads "P=Kanal 3 (mN), T=Kanal 4 (N)": a comma separates two columns if a quantity and "=" follow it. Returns what
/// is wrong, or an empty string.
std::string read_mapping(std::string_view text, std::map<std::string, std::string>& columns) {
  const auto quantity_at = [](std::string_view rest) {
    const std::size_t equals = rest.find('=');
    return equals == std::string_view::npos ? std::nullopt : column_named(trim(rest.substr(0, equals)));
  };
  columns.clear();
  while (!trim(text).empty()) {
    const auto id = quantity_at(text);
    if (!id) {
      const std::size_t equals = text.find('=');
      const std::string meant =
          equals == std::string_view::npos ? "" : did_you_mean(trim(text.substr(0, equals)), column_names());
      return "columns is " + quoted(text) + "; it must be a list such as \"P=Kanal 3 (mN),T=Kanal 4 (N)\"" + meant;
    }
    text.remove_prefix(text.find('=') + 1);
    std::size_t end = text.find(',');
    while (end != std::string_view::npos && !quantity_at(text.substr(end + 1))) end = text.find(',', end + 1);
    const std::string_view heading = trim(text.substr(0, end));
    if (heading.empty()) return "columns names no heading for " + std::string(to_string(*id));
    if (!columns.emplace(to_string(*id), heading).second)
      return "columns names " + std::string(to_string(*id)) + " twice";
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return columns.empty() ? "columns is empty" : "";
}

const MetadataField* find_field(std::string_view name) {
  for (const MetadataField& field : metadata_fields())
    if (field.name == name) return &field;
  return nullptr;
}

/// A number with its standard error, in the unit of the example if that is read back to the last bit, else in SI.
std::string number_text(const MetadataField& field, double value, double error) {
  constexpr int kDigits = 15;  // all that a double holds for certain
  const auto text_in = [&](std::string_view unit, const std::string& number, const std::string& of_error) {
    return number + (error > 0 ? " +/- " + of_error : "") + (unit.empty() ? "" : " ") + std::string(unit);
  };
  const std::string plain = text_in(si_unit(field.dimension), shortest(value), shortest(error));
  const auto example = parse_uncertain(field.example);
  if (!example || example->quantity.unit.dimension != field.dimension) return plain;
  const Unit& unit = example->quantity.unit;
  const std::string brief =
      text_in(unit.text, rounded(value / unit.factor, kDigits), rounded(error / unit.factor, kDigits));
  const auto read = parse_uncertain(brief);
  return read && read->quantity.si() == value && read->standard_error == error ? brief : plain;
}

/// All numbers, then all texts.
std::vector<std::string> known_fields() {
  std::vector<std::string> known;
  for (const bool numbers : {true, false})
    for (const MetadataField& field : metadata_fields())
      if ((field.number != nullptr) == numbers) known.emplace_back(field.name);
  return known;
}

}  // namespace

bool is_path(std::string_view field) {
  const MetadataField* const found = find_field(field);
  return found && found->is_path;
}

std::string_view si_unit(const Dimension& d) {
  return d == dimension::length            ? "m"
         : d == dimension::stress          ? "Pa"
         : d == dimension::energy_per_area ? "J/m^2"
         : d == dimension::force           ? "N"
         : d == dimension::area            ? "m^2"
         : d == dimension::angle           ? "rad"
         : d == dimension::frequency       ? "Hz"
                                           : "";
}

std::string_view to_string(Provenance provenance) {
  const auto i = static_cast<std::size_t>(provenance);
  return kProvenances[i < kProvenances.size() ? i : 0];
}

std::string_view meaning_of(Provenance provenance) {
  switch (provenance) {
    case Provenance::unstated:
      return "Nothing says where these data come from; state it in the TOML beside the file.";
    case Provenance::digitised:
      return "Points were read from a figure: reading errors are part of the scatter.";
    case Provenance::reconstructed:
      return "Generated from a model, not measured. Recovering lambda from them tests the program, not the physics.";
    case Provenance::measured:
      break;
  }
  return "";
}

std::string_view to_string(ModeIII convention) { return convention == ModeIII::averaged ? "averaged" : "half"; }

std::string mode_III_text(const Metadata& metadata) {
  std::string text(to_string(metadata.mode_III));
  if (metadata.mode_III != ModeIII::averaged) return text;
  const bool stated = metadata.poisson_ratio.has_value();
  return text + " (kappa = " + rounded(metadata.kappa(), 6) +
         " at nu = " + rounded(metadata.poisson_ratio.value_or(kIncompressible), 6) +
         (!stated                                        ? ", not stated)"
          : metadata.standard_error("poisson_ratio") > 0 ? ", taken as exact)"
                                                         : ")");
}

std::string_view to_string(NormalControl control) { return control == NormalControl::approach ? "approach" : "load"; }

double Metadata::kappa() const {
  if (mode_III != ModeIII::averaged) return 1;
  const double nu = poisson_ratio.value_or(kIncompressible);
  return (2 - nu) / (2 - 2 * nu);
}

double Metadata::shear_weight() const { return std::sqrt(kappa()); }

std::optional<double> Metadata::plane_strain_modulus() const {
  if (modulus) return modulus;
  if (youngs_modulus && poisson_ratio) return mixity::plane_strain_modulus(*youngs_modulus, *poisson_ratio);
  return std::nullopt;
}

double Metadata::standard_error(std::string_view name) const {
  const auto found = standard_errors.find(name);
  return found == standard_errors.end() ? 0 : found->second;
}

double Metadata::modulus_error() const {
  if (modulus) return standard_error("modulus") / *modulus;
  if (!youngs_modulus || !poisson_ratio) return 0;
  // E* = E/(1 - nu^2)
  const double nu = *poisson_ratio, of_nu = 2 * nu / (1 - nu * nu) * standard_error("poisson_ratio");
  return std::hypot(standard_error("youngs_modulus") / *youngs_modulus, of_nu);
}

std::string set_field(Metadata& metadata, std::string_view name, std::string_view text) {
  const std::string given = std::string(name) + " is " + quoted(text) + "; ";
  if (name == "title") return metadata.title = one_line(std::string(text)), "";
  if (name == "source") return metadata.source = one_line(std::string(text)), "";
  if (name == "note") return metadata.note = one_line(std::string(text)), "";
  if (name == "provenance") {
    for (const auto one : {Provenance::measured, Provenance::digitised, Provenance::reconstructed})
      if (text == to_string(one)) return metadata.provenance = one, "";
    return given + "it must be measured, digitised or reconstructed";
  }
  if (name == "mode_III") {
    for (const auto one : {ModeIII::half, ModeIII::averaged})
      if (text == to_string(one)) return metadata.mode_III = one, "";
    return given + "it must be half or averaged";
  }
  if (name == "control") {
    for (const auto one : {NormalControl::load, NormalControl::approach})
      if (text == to_string(one)) return metadata.control = one, "";
    return given + "it must be load or approach";
  }
  if (name == "columns") return read_mapping(text, metadata.columns);
  if (name == "sheet") return metadata.sheet = text, "";
  if (name == "headings") return metadata.headings = text, "";
  if (name == "definition") return metadata.definition = text, "";
  if (name == "load_from") {
    if (text.find("{P}") == std::string_view::npos)
      return given + "it must hold {P}, where the load stands in the file's name: \"run_{P}mN\"";
    metadata.load.reset();
    return metadata.load_from = text, "";
  }
  if (name == "decimal") {
    if (text != "," && text != ".") return given + "it must be \",\" or \".\"";
    return metadata.decimal = text[0], "";
  }
  const MetadataField* const field = find_field(name);
  if (!field) return unknown_key(name, known_fields());
  const auto uncertain = parse_uncertain(text);
  if (const std::string meant = two_readings(text); !uncertain && !meant.empty()) return given + "write " + meant;
  if (const std::string_view unit = unknown_unit(text); !uncertain && !unit.empty()) {
    const std::string meant = with_other_capitals(unit, field->dimension);
    return given + "the unit " + quoted(unit) + " is not known" +
           (meant.empty() ? "; it must be " + describe(field->dimension)
                          : "; " + quoted(std::string_view(meant)) + " is");
  }
  if (!uncertain && states_error(text) && text.find('%') != std::string_view::npos &&
      parse_number(trim(text.substr(0, text.find_first_of(" +\xC2")))).value_or(1) == 0)
    return given + "a share of 0 is no error; write the error itself, such as " + quoted(field->example);
  if (!uncertain)
    return given + "it must be a number with a unit, such as " +
           (states_error(text) ? "\"1 mm +/- 2%\" or \"1 +/- 0.02 mm\"" : quoted(field->example));
  const bool interval = name == "rate" && uncertain->quantity.unit.dimension == dimension::time;
  if (uncertain->quantity.unit.dimension != field->dimension && !interval)
    return given + "it must be " + describe(field->dimension) + ", written " + quoted(field->example);
  const double value = interval ? 1 / uncertain->quantity.si() : uncertain->quantity.si();
  if (name == "poisson_ratio") {
    if (!(value >= 0 && value <= 0.5)) return given + "it must lie between 0 and 0.5";
  } else if (name == "table") {
    if (!(value >= 1 && value <= 1e6 && value == std::floor(value)))
      return given + "it must be a whole number, such as 2";
  } else if (is_change(name)) {
    if (value != 0)
      return given + "a change is about 0: state \"0 +/- " + shortest(std::abs(value)) +
             "\", and correct readings for one that is known";
  } else if (!name.ends_with("_offset") && name != "load" && !(value > 0)) {
    return given + "it must be positive";
  }
  if (name == "normal_stiffness" && uncertain->standard_error > 0) return given + "it is taken as exact";
  if (!field->of_experiment && uncertain->standard_error > 0)
    return given + (name == "pixel" ? "its error belongs in area_scale, which has twice that of a length: area_scale = "
                                      "\"1 +/- 2%\""
                    : name == "load" ? "its error belongs in load_offset: load_offset = \"0 +/- 0.5 mN\""
                                     : "it is taken as exact");
  if (name == "load") metadata.load_from.clear();  // load and load_from replace each other
  metadata.*field->number = value;
  metadata.standard_errors.erase(std::string(name));
  if (uncertain->standard_error > 0) metadata.standard_errors.emplace(name, uncertain->standard_error);
  return "";
}

std::string kind_of_field(std::string_view name) {
  const MetadataField* const field = find_field(name);
  if (!field) return "";
  return field->number ? "a string with a number and a unit, such as " + quoted(field->example) : "a string";
}

std::string add_constants(const Metadata& more, Metadata& constants) {
  for (const MetadataField& field : metadata_fields()) {
    if (!field.number || !field.of_experiment || !(more.*field.number)) continue;
    const std::optional<double>& value = more.*field.number;
    std::optional<double>& before = constants.*field.number;
    const std::string name(field.name);
    if (before && (*before != *value || constants.standard_error(name) != more.standard_error(name)))
      return "states another " + name + " than a file before it; constants are those of the whole experiment";
    before = value;
    if (more.standard_error(name) > 0) constants.standard_errors[name] = more.standard_error(name);
  }
  if (more.mode_III != ModeIII::unstated) {
    if (constants.mode_III != ModeIII::unstated && constants.mode_III != more.mode_III)
      return "states another mode_III than a file before it; constants are those of the whole experiment";
    constants.mode_III = more.mode_III;
  }
  if (more.control != NormalControl::unstated) {
    if (constants.control != NormalControl::unstated && constants.control != more.control)
      return "states another control than a file before it; one data set has one";
    constants.control = more.control;
  }
  constants.provenance = std::max(constants.provenance, more.provenance);
  if (constants.title.empty()) constants.title = more.title;
  if (constants.source.empty()) constants.source = more.source;
  if (constants.note.empty()) constants.note = more.note;
  return "";
}

std::optional<std::string> stated_text(const Metadata& metadata, std::string_view name) {
  const MetadataField* const field = find_field(name);
  std::string text;
  if (field && field->number) {
    const std::optional<double>& value = metadata.*field->number;
    return value ? std::optional(number_text(*field, *value, metadata.standard_error(name))) : std::nullopt;
  }
  if (name == "provenance" && metadata.provenance != Provenance::unstated) text = to_string(metadata.provenance);
  if (name == "mode_III" && metadata.mode_III != ModeIII::unstated) text = to_string(metadata.mode_III);
  if (name == "control" && metadata.control != NormalControl::unstated) text = to_string(metadata.control);
  if (name == "decimal" && metadata.decimal != 0) text = metadata.decimal;
  if (name == "columns")
    for (const auto& [quantity, heading] : metadata.columns)
      text += (text.empty() ? "" : ",") + quantity + "=" + heading;
  for (const auto& [field_name, value] :
       {std::pair("title", &Metadata::title), std::pair("source", &Metadata::source),
        std::pair("note", &Metadata::note), std::pair("headings", &Metadata::headings),
        std::pair("sheet", &Metadata::sheet), std::pair("definition", &Metadata::definition),
        std::pair("load_from", &Metadata::load_from)})
    if (name == field_name) text = metadata.*value;
  return text.empty() ? std::nullopt : std::optional(text);
}

Overrides constants_as_stated(const Metadata& metadata) {
  Overrides list;
  for (const MetadataField& field : metadata_fields())
    if ((field.number && field.of_experiment) || field.name == "mode_III" || field.name == "control")
      if (const auto text = stated_text(metadata, field.name)) list.emplace_back(field.name, *text);
  return list;
}

void apply_overrides(const Overrides& overrides, Metadata& metadata) {
  bool modulus = false, youngs_modulus = false;
  for (const auto& [name, text] : overrides) {
    const std::string problem = set_field(metadata, name, text);
    if (!problem.empty()) throw InputError(Remedy::given(name), problem);
    modulus |= name == "modulus";
    youngs_modulus |= name == "youngs_modulus";
  }
  if (modulus && !youngs_modulus) metadata.youngs_modulus.reset();
  if (youngs_modulus && !modulus) metadata.modulus.reset();
}

void require_whole_modulus(const Metadata& metadata, const std::string& path, const Overrides& overrides) {
  if (metadata.modulus && metadata.youngs_modulus)
    throw InputError(path, "states both modulus and youngs_modulus; state one");
  if (metadata.youngs_modulus.has_value() == metadata.poisson_ratio.has_value()) return;
  // beside E* it is that of mode III
  if (metadata.poisson_ratio && (metadata.modulus || metadata.mode_III == ModeIII::averaged)) return;
  const std::string_view given = metadata.youngs_modulus ? "youngs_modulus" : "poisson_ratio",
                         missing = metadata.youngs_modulus ? "poisson_ratio" : "youngs_modulus";
  for (const auto& [name, text] : overrides)
    if (name == given) throw InputError(Remedy::given(name), "needs " + std::string(missing) + ", too");
  if (!metadata.modulus) throw InputError(path, "states " + std::string(given) + " without " + std::string(missing));
}

std::optional<std::size_t> number_of_table(const Metadata& metadata) {
  return metadata.table ? std::optional(static_cast<std::size_t>(*metadata.table)) : std::nullopt;
}

ColumnRules rules_of(const Metadata& metadata, Inputs& inputs) {
  ColumnRules rules{metadata.columns, nullptr, metadata.load || !metadata.load_from.empty(),
                    metadata.control == NormalControl::approach, metadata.pixel};
  if (!metadata.headings.empty())
    rules.names = std::make_shared<Vocabulary>(Vocabulary::with(metadata.headings, inputs));
  return rules;
}

}  // namespace mixity
