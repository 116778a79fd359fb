#include "dataset/table/column_names.h"

#include <algorithm>

#include "base/input_error.h"
#include "base/printable.h"
#include "dataset/table/vocabulary.h"

namespace mixity {
namespace {

/// Whether a heading may have this unit as that quantity; none is fine.
bool fits(const std::optional<std::string>& unit, ColumnId id) {
  if (!unit) return true;
  const ColumnKind& kind = kind_of(id);
  const auto parsed = parse_unit(*unit);
  if (!parsed) return false;
  if (parsed->text == "%") return kind.name.starts_with("sigma_");
  if (kind.always_a_number) return parsed->dimension == dimension::none;
  return parsed->dimension == kind.dimension || is_pixels(parsed->dimension, kind.dimension);
}

/// A name by the program's own or the vocabulary.
std::optional<ColumnId> meaning(std::string_view name, const Vocabulary& vocabulary) {
  if (const auto own = column_named(name)) return own;
  if (const auto found = vocabulary.find(name)) return found;
  // "Normal force F_N", "friction force, T": a name and the symbol of the same
  const std::size_t behind = name.find_last_of(" ,");
  if (behind == std::string_view::npos) return std::nullopt;
  const auto first = vocabulary.find(trim_name(name.substr(0, name.find_last_not_of(" ,", behind) + 1)));
  const std::string_view symbol = name.substr(behind + 1);
  const auto second = column_named(symbol) ? column_named(symbol) : vocabulary.find(symbol);
  return first && first == second ? first : std::nullopt;
}

/// A heading by the vocabulary, with its unit found; null if it says nothing that is known.
std::optional<NamedColumn> read_heading(const Heading& heading, std::size_t index, const Vocabulary& vocabulary,
                                        bool with_unit = false) {
  const auto named = [&](std::string_view name, const std::optional<std::string>& unit) -> std::optional<NamedColumn> {
    const auto id = meaning(trim_name(name), vocabulary);
    if (!id || !fits(unit, *id)) return std::nullopt;
    NamedColumn column{*id, index, heading};
    column.heading.unit = unit;
    return column;
  };
  if (!with_unit)
    if (auto found = named(heading.name, heading.unit)) return found;
  if (heading.unit && heading.closed) {
    // "Normal force (F_N)": what stands in the brackets is a symbol
    if (!parse_unit(*heading.unit)) return named(heading.name + " " + *heading.unit, std::nullopt);
    // "F_N (cell 2) [mN]", with a name that is none before the first bracket
    return named(without_brackets(heading.text), heading.unit);
  }
  std::string_view text = heading.text;
  while (text.ends_with('_')) text.remove_suffix(1);  // what MATLAB makes of a closing bracket
  for (const std::string_view sign : {"/", " in ", " en ", ",", "_", " "}) {
    const std::size_t at = text.rfind(sign);
    if (at == std::string_view::npos || at == 0) continue;
    const std::string unit(without_brackets(text.substr(at + sign.size())));
    if (!parse_unit(unit) || parse_unit(unit)->text == "1") continue;
    if (auto found = named(text.substr(0, at), unit)) return found;
  }
  return std::nullopt;
}

/// "Kanal 3 (mN)" names a heading with or without its unit, "3" the third.
NamedColumn mapped_column(const std::string& path, const std::vector<Heading>& headings, ColumnId id,
                          const std::string& wanted) {
  const Heading said = split_heading(wanted, {});
  std::optional<std::size_t> found;
  const auto find = [&](const auto& is_it) {
    for (std::size_t i = 0; i < headings.size(); ++i) {
      if (!is_it(headings[i])) continue;
      if (found)
        throw InputError(path, headings[i].place,
                         "columns " + std::to_string(*found + 1) + " and " + std::to_string(i + 1) + " are both '" +
                             wanted + "', which is to be " + std::string(to_string(id)) +
                             "; say which by its number: --columns=\"" + std::string(to_string(id)) + "=" +
                             std::to_string(i + 1) + "\"");
      found = i;
    }
  };
  find([&](const Heading& heading) { return trim_name(heading.text) == said.text; });
  if (const std::string name = folded(said.name); !found && !name.empty())
    find([&](const Heading& heading) { return folded(heading.name) == name; });
  const auto number = parse_number(said.name);
  if (!found && number && *number >= 1 && *number <= static_cast<double>(headings.size()) &&
      *number == static_cast<double>(static_cast<std::size_t>(*number)))
    found = static_cast<std::size_t>(*number) - 1;
  const FilePlace line{headings.empty() ? 1 : headings.front().place.line, 1};
  if (!found) {
    std::string names;
    for (const Heading& heading : headings)
      if (!heading.text.empty()) names += (names.empty() ? "'" : ", '") + printable(heading.text, 40) + "'";
    throw InputError(path, line,
                     "no column '" + wanted + "', which is to be " + std::string(to_string(id)) + "; there are " +
                         (names.empty() ? "none with a name" : names));
  }
  NamedColumn column{id, *found, headings[*found]};
  if (said.unit) {
    const auto stated = column.heading.unit ? parse_unit(*column.heading.unit) : std::nullopt,
               meant = parse_unit(*said.unit);
    if (stated && meant && (stated->factor != meant->factor || stated->dimension != meant->dimension))
      throw InputError(
          path, column.heading.place,
          "column '" + column.heading.text + "' is in " + stated->text + ", the mapping says " + meant->text);
    column.heading.unit = said.unit;
    column.heading.closed = said.closed;
  }
  return column;
}

bool holds(const std::vector<NamedColumn>& columns, ColumnId id) {
  return std::any_of(columns.begin(), columns.end(), [&](const NamedColumn& column) { return column.id == id; });
}

/// Whether they say how large the contact is.
bool is_sized(const std::vector<NamedColumn>& columns) {
  const auto has = [&](ColumnId id) { return holds(columns, id); };
  using enum ColumnId;
  return has(A) || has(ColumnId::a) || (has(a_par) && has(a_perp)) || (has(major) && has(minor));
}

/// Whether points can be made of these.
bool is_complete(const std::vector<NamedColumn>& columns, const ColumnRules& rules) {
  const auto has = [&](ColumnId id) { return holds(columns, id); };
  using enum ColumnId;
  const bool loads = has(T) && (has(P) || rules.load_stated) && is_sized(columns);
  if (rules.log) return loads && has(ColumnId::time);  // a log of forces or of areas alone never is
  return loads || ((has(psi) || has(mode_ratio)) && (has(Gc) || has(Gc_over_GIc))) || (has(G_I) && has(G_II));
}

/// Throws for a heading that has the name of a quantity that is wanted still, and a unit that is not known or does not
/// fit.
void refuse_unit(const std::string& path, const std::vector<Heading>& headings, const std::vector<NamedColumn>& columns,
                 const Vocabulary& vocabulary, const ColumnRules& rules) {
  for (std::size_t i = 0; i < headings.size(); ++i) {
    const Heading& heading = headings[i];
    const auto id = vocabulary.find(heading.name);
    if (!id || !heading.unit || fits(heading.unit, *id) || holds(columns, *id)) continue;
    if (*id == ColumnId::T || (*id == ColumnId::P && !rules.load_stated) || (*id == ColumnId::A && !is_sized(columns)))
      throw InputError(path, heading.place,
                       "'" + printable(heading.text, 60) + "' may be " + std::string(to_string(*id)) + ", but '" +
                           *heading.unit + "' is not " + describe(kind_of(*id).dimension) +
                           "; if it is another way to write one: " + mapping_flag(*id, headings, i));
  }
}

}  // namespace

std::string mapping_flag(ColumnId id, const std::vector<Heading>& headings, std::size_t index) {
  constexpr std::size_t kLong = 40;
  const Heading& heading = headings[index];
  const bool alone = std::count_if(headings.begin(), headings.end(), [&](const Heading& other) {
                       return other.text == heading.text || folded(other.name) == folded(heading.name);
                     }) == 1;
  const bool plain = alone && heading.closed && !heading.name.empty() && heading.text.size() <= kLong &&
                     heading.text.find_first_of("\",=") == std::string::npos && printable(heading.text) == heading.text;
  const bool known = !heading.unit || fits(heading.unit, id);
  std::string said = plain && known ? heading.text : plain ? heading.name : std::to_string(index + 1);
  if (!known) said += " (UNIT)";
  return "--columns=\"" + std::string(to_string(id)) + "=" + said + "\"";
}

bool has_unit_of(const Heading& heading, ColumnId id) { return heading.unit && fits(heading.unit, id); }

bool is_pixels(const Dimension& found, const Dimension& wanted) {
  // a number of pixels is an area, and so are square pixels
  const bool area = wanted == dimension::area;
  return found == Dimension{0, 0, 0, 0, 1} ? area || wanted == dimension::length
                                           : area && found == Dimension{0, 0, 0, 0, 2};
}

std::vector<NamedColumn> name_columns(const std::string& path, const std::vector<Heading>& headings,
                                      const ColumnRules& rules) {
  std::vector<NamedColumn> columns;
  const auto holder = [&](const auto& wanted) { return std::find_if(columns.begin(), columns.end(), wanted); };
  const auto has = [&](ColumnId id) {
    return holder([&](const NamedColumn& column) { return column.id == id; }) != columns.end();
  };
  const auto taken = [&](std::size_t index) {
    return holder([&](const NamedColumn& column) { return column.index == index; }) != columns.end();
  };
  for (const auto& [name, heading] : rules.mapping) {
    NamedColumn column = mapped_column(path, headings, *column_named(name), heading);
    if (taken(column.index))
      throw InputError(path, column.heading.place,
                       "column " + std::to_string(column.index + 1) + " is mapped to " + name + " and to " +
                           std::string(to_string(
                               holder([&](const NamedColumn& other) { return other.index == column.index; })->id)));
    columns.push_back(std::move(column));
  }
  const std::size_t mapped = columns.size();
  const auto is_read = [&](ColumnId id) { return rules.log || id != ColumnId::time; };
  for (std::size_t i = 0; i < headings.size(); ++i) {
    const auto id = column_named(headings[i].name);
    if (!id || taken(i) || !is_read(*id) || (rules.vocabulary && !fits(headings[i].unit, *id))) continue;
    const auto before = holder([&](const NamedColumn& column) { return column.id == *id; });
    if (before != columns.end() && before < columns.begin() + static_cast<std::ptrdiff_t>(mapped)) continue;
    if (before != columns.end())
      throw InputError(path, headings[i].place,
                       "column '" + headings[i].name + "' stands twice" +
                           (rules.vocabulary ? ", in columns " + std::to_string(before->index + 1) + " and " +
                                                   std::to_string(i + 1) + "; --columns=\"" + headings[i].name + "=" +
                                                   std::to_string(i + 1) +
                                                   "\" says which; runs beside each other are to stand below each other"
                                             : ""));
    columns.push_back({*id, i, headings[i]});
  }
  if (rules.vocabulary && !is_complete(columns, rules)) {
    const std::size_t own = columns.size();
    const Vocabulary more = rules.headings.empty() ? Vocabulary{} : Vocabulary::with(rules.headings);
    const Vocabulary& vocabulary = rules.headings.empty() ? Vocabulary::shipped() : more;
    for (std::size_t i = 0; i < headings.size(); ++i) {
      if (taken(i) || column_named(headings[i].name)) continue;  // of the latter the unit does not fit
      auto column = read_heading(headings[i], i, vocabulary);
      if (!column || !is_read(column->id)) continue;
      const auto before = holder([&](const NamedColumn& other) { return other.id == column->id; });
      if (before == columns.end())
        columns.push_back(std::move(*column));
      else if (before >= columns.begin() + static_cast<std::ptrdiff_t>(own))
        throw InputError(path, headings[i].place,
                         "'" + before->heading.text + "' and '" + headings[i].text + "' may both be " +
                             std::string(to_string(column->id)) +
                             "; say which: " + mapping_flag(column->id, headings, before->index) + " or " +
                             mapping_flag(column->id, headings, i));
    }
    // "normal force_N" may be a symbol's index; beside headings that end with units it ends with one
    if (std::any_of(columns.begin(), columns.end(), [](const NamedColumn& column) { return column.heading.unit; }))
      for (NamedColumn& column : columns)
        if (!column.heading.unit && !rules.mapping.contains(std::string(to_string(column.id))))
          if (auto better = read_heading(headings[column.index], column.index, vocabulary, true);
              better && better->id == column.id)
            column = std::move(*better);
    if (!is_complete(columns, rules) && (!rules.log || has(ColumnId::P) || has(ColumnId::T)))
      refuse_unit(path, headings, columns, vocabulary, rules);
  }
  if (rules.vocabulary)
    for (std::size_t i = 0; i < headings.size(); ++i)
      if (const auto id = column_named(headings[i].name); id && is_read(*id) && !has(*id) && !taken(i))
        columns.push_back({*id, i, headings[i]});
  // an export may hold both; the radius is then what the area was made of, or the other way round
  const auto is_mapped = [&](ColumnId id) { return rules.mapping.contains(std::string(to_string(id))); };
  const auto drop = [&](ColumnId id) {
    if (!is_mapped(id)) std::erase_if(columns, [&](const NamedColumn& column) { return column.id == id; });
  };
  const auto unit_stated = [&](ColumnId id) {
    const auto found = holder([&](const NamedColumn& column) { return column.id == id; });
    return found != columns.end() && found->heading.unit;
  };
  if (has(ColumnId::A) && is_mapped(ColumnId::a))
    drop(ColumnId::A);
  else if (has(ColumnId::A) && std::none_of(headings.begin(), headings.end(), [](const Heading& heading) {
             return column_named(heading.name) == ColumnId::a;
           }))
    drop(ColumnId::a);
  // axes without a unit beside an area with one tell nothing that is needed
  for (const ColumnId axis : {ColumnId::a_par, ColumnId::a_perp, ColumnId::major, ColumnId::minor})
    if (unit_stated(ColumnId::A) && has(axis) && !unit_stated(axis)) {
      for (const ColumnId one : {ColumnId::a_par, ColumnId::a_perp, ColumnId::major, ColumnId::minor}) drop(one);
      break;
    }
  std::sort(columns.begin(), columns.end(), [](const auto& one, const auto& other) { return one.index < other.index; });
  return columns;
}

}  // namespace mixity
