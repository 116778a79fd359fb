#include <algorithm>
#include <cctype>
#include <utility>

#include "base/input_error.h"
#include "dataset/point_reader.h"
#include "dataset/table/column_advice.h"
#include "dataset/table/number.h"
#include "mechanics/contact.h"

namespace mixity {
namespace {

/// The load in the name of the file, in SI, at {P} of the pattern "run_{P}mN". Throws InputError if the name does not
/// match.
double load_in_name(const Dataset& data) {
  const std::string& pattern = data.metadata.load_from;
  const std::string name = data.path.substr(data.path.find_last_of('/') + 1);
  const std::size_t at = pattern.find("{P}");
  const std::string before = pattern.substr(0, at), behind = pattern.substr(at + 3);
  const auto fail = [&](const std::string& message) -> double {
    throw InputError(data.path, message + " (load_from is \"" + pattern + "\")");
  };
  // the longest unit among the letters after {P}, perhaps after a blank or an underscore
  const std::size_t begin_of_unit = std::min(behind.find_first_not_of(" _"), behind.size());
  std::size_t letters = begin_of_unit;
  while (letters < behind.size() && std::isalpha(static_cast<unsigned char>(behind[letters]))) ++letters;
  std::optional<Unit> unit;
  for (std::size_t n = letters; n > begin_of_unit && !unit; --n)
    unit = parse_unit(behind.substr(begin_of_unit, n - begin_of_unit));
  if (!unit || unit->dimension != dimension::force) fail("no unit of force follows the load in the file's name");
  for (std::size_t begin = name.find(before); begin != std::string::npos; begin = name.find(before, begin + 1)) {
    const std::size_t first = begin + before.size();
    const std::size_t end = std::min(name.find_first_not_of("0123456789+-.,", first), name.size());
    double value = 0;
    NumberStyle style;
    const std::string text = name.substr(first, end - first);
    if (name.compare(end, behind.size(), behind) == 0 && end > first &&
        (parse_number(text, '.', value, &style) || parse_number(text, ',', value, &style))) {
      if (style.doubtful) fail("'" + text + "' in the file's name may be a thousand or a decimal");
      if (text[0] == '-' && first > 0 && std::isalnum(static_cast<unsigned char>(name[first - 1])))
        fail("'-' in the file's name may be a sign or a separator; if it is a separator, include it in load_from");
      return value * unit->factor;
    }
  }
  return fail("the file's name states no load");
}

/// The values of constants. Throws MissingConstants, which recommends stating all that are missing.
std::vector<double> demand(const std::vector<std::pair<std::string, std::optional<double>>>& constants,
                           const std::string& path, const std::string& metadata_path) {
  std::vector<double> values;
  std::vector<std::string> missing;
  std::string names;
  for (const auto& [name, value] : constants) {
    values.push_back(value.value_or(0));
    if (value) continue;
    names += (names.empty() ? "" : ", ") + name;
    missing.push_back(name);
  }
  if (missing.empty()) return values;
  const std::string are = missing.size() > 1 ? "s " + names + " are" : " " + names + " is";
  throw MissingConstants(path, "the constant" + are + " missing" + Remedy::state(missing, metadata_path));
}

/// The column with the unit of toughness; null if there is none.
const Column* toughness_column(const Columns& columns) {
  return columns.find(columns.holds_energies() ? ColumnId::G_I : ColumnId::Gc);
}

void add_notes(const Columns& columns, Dataset& data) {
  // poisson_ratio beside youngs_modulus has its part in the error of E*
  const std::string_view alone = data.metadata.youngs_modulus ? std::string_view() : "poisson_ratio";
  for (const std::string_view name : {std::string_view("toughness_II"), std::string_view("shear_strength"), alone})
    if (data.metadata.standard_error(name) > 0)
      data.notes.push_back("the standard error of " + std::string(name) +
                           " affects no result: its value is taken as exact");
  for (const std::string& one : columns.taken)
    if (one.starts_with("sigma_")) data.notes.push_back("standard errors: " + one);
  if (!columns.beside.empty())
    data.notes.push_back("one run is read, and the runs beside it are not: " + columns.beside +
                         " are named like its columns except for a number; put them below it, or in separate files");
  for (const auto& [name, reason] : columns.unused)
    data.notes.push_back("column '" + name + "' is not used: " + reason);
}

void set_display(const Columns& columns, Dataset& data) {
  DisplayUnits& display = data.display;
  if (const Column* length = columns.find(ColumnId::u)) {
    display.length = length->unit.text;
    display.length_scale = data.contact->displacement_unit() / length->unit.factor;
  }
  if (const Column* shear = columns.find(columns.holds_pull_off() ? ColumnId::P_c : ColumnId::T)) {
    display.force = shear->unit.text;
    display.force_scale = data.contact->force_unit() / shear->unit.factor;
  }
  if (columns.holds_pull_off()) {  // it has no areas: those of jumps are shown in this unit
    display.area = "mm^2";
    display.area_scale = data.contact->area_unit() / 1e-6;
    return;
  }
  const Column *area = columns.find(ColumnId::A), *length = area ? nullptr : columns.find(columns.lengths()->one);
  const Column& size = area ? *area : *length;
  const auto parsed = parse_unit(size.unit.text);
  if (parsed && parsed->dimension.pixel != 0) {  // shown in a unit of area
    display.area = "mm^2";
    display.area_scale = data.contact->area_unit() / 1e-6;
  } else if (area) {
    display.area = area->unit.text;
    display.area_scale = data.contact->area_unit() / area->unit.factor;
  } else {
    display.area = length->unit.text + "^2";
    display.area_scale = data.contact->area_unit() / (length->unit.factor * length->unit.factor);
  }
  if (const Column* const approach = columns.find(ColumnId::delta); approach && data.holds_approach()) {
    display.approach = approach->unit.text;
    display.approach_scale = data.contact->displacement_unit() / approach->unit.factor;
  }
  if (!in_range(display.force_scale) || !in_range(display.area_scale))
    throw InputError(data.path, "the units of its columns are out of range beside radius, modulus and toughness");
}

/// For data without loads: sets the unit of toughness.
void take_toughness_unit(const Columns& columns, const std::string& metadata_path, PointUnits& units, Dataset& data) {
  const Column* Gc = toughness_column(columns);
  if (!Gc || Gc->unit.dimension == dimension::none) return;
  const std::optional<double>& toughness = data.metadata.toughness;
  data.toughness_known = toughness || !data.has_energies;
  if (data.toughness_known) units.ratio = demand({{"toughness", toughness}}, data.path, metadata_path)[0];
  data.display.energy = Gc->unit.text;
  data.display.energy_scale = units.ratio / Gc->unit.factor;
}

/// Throws InputError if constants of a held approach are stated for other data.
void require_control(const Columns& columns, const Dataset& data) {
  const Metadata& stated = data.metadata;
  const auto refuse = [&](const std::string& message) { throw InputError(data.path, message); };
  if (stated.control == NormalControl::approach && !columns.holds_loads())
    refuse("control is about what is held while a contact is sheared (columns delta, T, A); leave it out");
  if (stated.control == NormalControl::approach && (stated.load || !stated.load_from.empty()))
    refuse(
        "a load is stated beside control = \"approach\": one of them is held; a load that was measured is a column P");
  if (stated.control == NormalControl::approach && stated.normal_stiffness &&
      columns.find(ColumnId::T)->unit.dimension == dimension::none)
    refuse("normal_stiffness has a unit, and the columns have none");
  if (stated.control == NormalControl::approach) return;
  for (const auto& [name, value] :
       {std::pair("normal_stiffness", stated.normal_stiffness), std::pair("approach_offset", stated.approach_offset)})
    if (value) refuse(std::string(name) + " is about a held approach: state control = \"approach\", or leave it out");
}

/// For data with loads: sets the contact.
void take_contact(const Columns& columns, const std::string& metadata_path, PointUnits& units, Dataset& data) {
  const Column* const kind = columns.find(columns.holds_pull_off()   ? ColumnId::P_c
                                          : columns.has(ColumnId::P) ? ColumnId::P
                                                                     : ColumnId::T);
  if (kind->unit.dimension == dimension::none) {
    return;
  }
  const Metadata& stated = data.metadata;
  const auto known =
      demand({{"radius", stated.radius}, {"modulus", stated.plane_strain_modulus()}, {"toughness", stated.toughness}},
             data.path, metadata_path);
  data.contact = Contact{known[0], known[1], known[2]};
  units.force = data.contact->force_unit();
  units.length = data.contact->length_unit();
  units.displacement = data.contact->displacement_unit();
  if (stated.normal_stiffness && data.holds_approach())
    data.compliance = data.contact->stiffness_unit() / *stated.normal_stiffness;
  if (!data.contact->usable()) throw InputError(data.path, "radius, modulus and toughness together are out of range");
}

}  // namespace

std::optional<double> stated_load(const Dataset& data) {
  return data.metadata.load_from.empty() ? data.metadata.load : std::optional(load_in_name(data));
}

void require_units(const Columns& columns, const std::vector<Heading>& headings, bool load_stated,
                   const std::string& metadata_path, const Dataset& data) {
  const Column* const kind = columns.holds_pull_off() ? columns.find(ColumnId::P_c)
                             : columns.holds_loads()  ? columns.find(ColumnId::T)
                                                      : toughness_column(columns);
  if (!kind || kind->unit.dimension != dimension::none) return;
  std::string constants;
  const auto needed = [&](std::string_view name) {
    // with toughness_II it gives lambda
    if (name == "toughness") return !data.metadata.toughness_II;
    if (name == "load" || name == "pixel") return name == "load" && load_stated;
    return columns.holds_loads() && name != "toughness_II" && name != "shear_strength";
  };
  for (const MetadataField& field : metadata_fields())
    if (field.number && field.dimension != dimension::none && data.metadata.*field.number && needed(field.name))
      constants += (constants.empty() ? "" : ", ") + std::string(field.name);
  if (constants.empty()) return;
  // for arrays, which have no file, by quantity
  const bool arrays = metadata_path.empty();
  std::string units;
  for (const std::optional<Column>& column : columns.by_id) {
    if (!column || column->unit.text == "%" || column->id == ColumnId::psi) continue;
    const std::string_view unit = example_unit(kind_of(column->id).dimension);
    if (unit.empty()) continue;
    units +=
        (units.empty() ? "" : ",") + (arrays ? std::string(to_string(column->id)) + "=" + std::string(unit)
                                             : mapping_with(std::string(unit), column->id, headings, column->index));
  }
  throw InputError(data.path, headings.at(kind->index).place,
                   std::string("the columns have no units, but the data state ") + constants +
                       "; say the units, such as " + Remedy::set(arrays ? "units" : "columns", units) +
                       ", or leave out what is stated if the columns are dimensionless");
}

void require_shear(const Columns& columns, const std::vector<Heading>& headings, const Dataset& data) {
  if (columns.holds_loads() || data.metadata.mode_III == ModeIII::unstated) return;
  const Column* const kind = toughness_column(columns);
  throw InputError(data.path, headings.at(kind ? kind->index : 0).place,
                   "mode_III is about tangential loads (columns P, T, A); a toughness or an energy of a mode holds a "
                   "convention already: leave mode_III out");
}

PointUnits take_header(const Columns& columns, const std::string& metadata_path, Dataset& data) {
  data.has_loads = columns.holds_loads();
  data.has_energies = columns.holds_energies();
  require_control(columns, data);
  data.ignored_columns = columns.ignored;
  PointUnits units;
  if (data.has_loads)
    take_contact(columns, metadata_path, units, data);
  else
    take_toughness_unit(columns, metadata_path, units, data);
  add_notes(columns, data);
  if (data.contact) set_display(columns, data);
  if (!in_range(data.display.energy_scale))
    throw InputError(data.path, "the unit of " + std::string(to_string(toughness_column(columns)->id)) +
                                    " is out of range beside the toughness");
  return units;
}

}  // namespace mixity
