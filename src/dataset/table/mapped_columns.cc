#include "dataset/table/mapped_columns.h"

#include <cmath>

#include "base/input_error.h"
#include "base/nearest_name.h"
#include "base/text.h"
#include "dataset/table/column_advice.h"

namespace mixity {
namespace {

/// "Kanal 3 (mN)" names a heading with or without its unit, "3" the third. Null if there is none. Throws if there are
/// two.
std::optional<std::size_t> find_mapped(const std::string& path, const std::vector<Heading>& headings, ColumnId id,
                                       const std::string& wanted) {
  const Heading given = split_heading(wanted, {});
  std::optional<std::size_t> found;
  const auto find = [&](const auto& is_it) {
    for (std::size_t i = 0; i < headings.size(); ++i) {
      if (!is_it(headings[i])) continue;
      if (found)
        throw InputError(
            path, headings[i].place,
            "columns " + std::to_string(*found + 1) + " and " + std::to_string(i + 1) + " are both named '" + wanted +
                "', which is mapped to " + name_of(id) +
                "; choose one by its number: " + Remedy::set("columns", name_of(id) + "=" + std::to_string(i + 1)));
      found = i;
    }
  };
  find([&](const Heading& heading) { return trim_name(heading.text) == given.text; });
  if (const std::string name = folded(given.name); !found && !name.empty())
    find([&](const Heading& heading) { return folded(heading.name) == name; });
  const double number = parse_number(given.name).value_or(0);
  if (!found && number >= 1 && number <= static_cast<double>(headings.size()) && number == std::floor(number))
    found = static_cast<std::size_t>(number) - 1;
  return found;
}

/// The mapping without the units that the headings themselves state.
std::string without_units(const std::vector<Heading>& headings, const std::map<std::string, std::string>& mapping) {
  std::string text;
  for (const auto& [name, wanted] : mapping) {
    const auto column = find_mapped({}, headings, *column_named(name), wanted);
    const bool has_own = !column || headings[*column].unit;
    text += (text.empty() ? "" : ",") + name + "=" + (has_own ? split_heading(wanted, {}).name : wanted);
  }
  return text;
}

/// ": did you mean HEADING?" or, where the heading goes on with a quantity that is misspelt, as in "Load,Z=Shear", what
/// that is.
std::string misspelt_in(const std::string& wanted, const std::string& heading, const std::vector<std::string>& known) {
  const std::size_t comma = wanted.rfind(','), equals = wanted.rfind('=');
  if (comma == std::string::npos || equals == std::string::npos || equals < comma) return did_you_mean(heading, known);
  const std::string quantity(trim(std::string_view(wanted).substr(comma + 1, equals - comma - 1)));
  return "; '" + printable(quantity, 40) + "' is no quantity" + did_you_mean(quantity, column_names());
}

}  // namespace

NamedColumn mapped_column(const std::string& path, const std::vector<Heading>& headings, ColumnId id,
                          const std::map<std::string, std::string>& mapping) {
  const std::string& wanted = mapping.at(name_of(id));
  const Heading given = split_heading(wanted, {});
  const std::optional<std::size_t> found = find_mapped(path, headings, id, wanted);
  if (!found) {
    std::string names;
    std::vector<std::string> known;
    for (const Heading& heading : headings) {
      if (!heading.text.empty()) names += (names.empty() ? "'" : ", '") + printable(heading.text, 40) + "'";
      known.push_back(printable(heading.name, 40));
    }
    throw InputError(path, headings.empty() ? 1 : headings.front().place.line, 1,
                     "no column '" + wanted + "', which is mapped to " + name_of(id) + "; there are " +
                         (names.empty() ? "none with a name" : names) + misspelt_in(wanted, given.name, known));
  }
  NamedColumn column{id, *found, headings[*found]};
  if (given.unit) {
    const auto own = column.heading.unit ? parse_unit(*column.heading.unit) : std::nullopt,
               mapped = parse_unit(*given.unit);
    if (own && mapped && (own->factor != mapped->factor || own->dimension != mapped->dimension))
      throw InputError(
          path, column.heading.place,
          "column '" + column.heading.text + "' is in " + own->text + ", the mapping says " + mapped->text +
              "; to read it as the file says: " + Remedy::set("columns", without_units(headings, mapping)));
    column.heading.unit = given.unit;
    column.heading.closed = given.closed;
  }
  return column;
}

std::vector<ColumnId> mapped_in(const std::vector<Heading>& headings, const ColumnRules& rules) {
  std::vector<ColumnId> found;
  for (const auto& [name, heading] : rules.mapping) {
    const ColumnId id = *column_named(name);
    const auto column = find_mapped({}, headings, id, heading);
    const bool by_number = parse_number(split_heading(heading, {}).name).has_value();
    const auto given = split_heading(heading, {}).unit;
    if (column && (!by_number || (unit_fits(headings[*column].unit, id) && (headings[*column].unit || given))))
      found.push_back(id);
  }
  return found;
}

std::string mapped_as(const NamedColumn& column, const std::vector<Heading>& headings) {
  const std::string& text = headings[column.index].text;
  std::optional<std::string> unit = column.heading.unit;
  // one with brackets, such as Origin's "mm\\+(2)", is left to the file
  if (unit && unit->find_first_of("()[]") != std::string::npos) unit.reset();
  const std::string behind = unit ? " (" + *unit + ")" : "";
  const std::string by_heading = unit && split_heading(text, {}).unit == unit ? text : text + behind;
  // a comma with an equals sign behind it may begin another entry
  const bool plain = printable(text, std::string::npos) == text && text.find('=') == std::string::npos;
  std::optional<std::size_t> found;
  try {
    if (plain) found = find_mapped({}, headings, column.id, by_heading);
  } catch (const InputError&) {  // of two columns with this heading
  }
  const bool has_unit = !unit || split_heading(by_heading, {}).unit == unit;
  return found == column.index && has_unit ? by_heading : std::to_string(column.index + 1) + behind;
}

}  // namespace mixity
