#include "dataset/columns.h"

#include <algorithm>
#include <cctype>
#include <initializer_list>

#include "dataset/input_error.h"
#include "dataset/metadata.h"
#include "dataset/printable.h"
#include "dataset/table/number.h"
#include "dataset/table/vocabulary.h"

namespace mixity {
namespace {

/// In lower case, letters and digits only.
std::string bare_name(std::string_view name) {
  std::string bare;
  for (const char c : name)
    if (const auto byte = static_cast<unsigned char>(c); std::isalnum(byte))
      bare += static_cast<char>(std::tolower(byte));
  return bare;
}

const ColumnKind& kind_of(ColumnId id) { return kColumnKinds[static_cast<std::size_t>(id)]; }

bool is_pixels(const Dimension& found, const Dimension& wanted) {
  // a number of pixels is an area, and so are square pixels
  const bool area = wanted == dimension::area;
  return found == Dimension{0, 0, 0, 0, 1} ? area || wanted == dimension::length
                                           : area && found == Dimension{0, 0, 0, 0, 2};
}

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

/// Whether points can be made of these.
bool is_complete(const std::vector<NamedColumn>& columns, const ColumnRules& rules) {
  const auto has = [&](ColumnId id) {
    return std::any_of(columns.begin(), columns.end(), [&](const NamedColumn& column) { return column.id == id; });
  };
  using enum ColumnId;
  if (rules.log) return has(ColumnId::time) && ((has(P) && has(T)) || (has(A) && !has(T)));
  return (has(T) && (has(P) || rules.load_stated) &&
          (has(A) || has(ColumnId::a) || (has(a_par) && has(a_perp)) || (has(major) && has(minor)))) ||
         ((has(psi) || has(mode_ratio)) && (has(Gc) || has(Gc_over_GIc))) || (has(G_I) && has(G_II));
}

}  // namespace

ColumnRules rules_of(const Metadata& metadata) {
  return {metadata.columns, metadata.headings, metadata.load || !metadata.load_from.empty(), metadata.pixel};
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
  for (std::size_t i = 0; i < headings.size(); ++i) {
    const auto id = column_named(headings[i].name);
    if (!id || taken(i)) continue;
    const auto before = holder([&](const NamedColumn& column) { return column.id == *id; });
    if (before != columns.end() && before < columns.begin() + static_cast<std::ptrdiff_t>(mapped)) continue;
    if (before != columns.end())
      throw InputError(path, headings[i].place, "column '" + headings[i].name + "' stands twice");
    columns.push_back({*id, i, headings[i]});
  }
  if (rules.vocabulary && !is_complete(columns, rules)) {
    const std::size_t own = columns.size();
    const Vocabulary more = rules.headings.empty() ? Vocabulary{} : Vocabulary::with(rules.headings);
    const Vocabulary& vocabulary = rules.headings.empty() ? Vocabulary::shipped() : more;
    for (std::size_t i = 0; i < headings.size(); ++i) {
      if (taken(i)) continue;
      auto column = read_heading(headings[i], i, vocabulary);
      if (!column) continue;
      const auto before = holder([&](const NamedColumn& other) { return other.id == column->id; });
      if (before == columns.end())
        columns.push_back(std::move(*column));
      else if (before >= columns.begin() + static_cast<std::ptrdiff_t>(own))
        throw InputError(path, headings[i].place,
                         "'" + before->heading.text + "' and '" + headings[i].text + "' may both be " +
                             std::string(to_string(column->id)) + "; say which: --columns=\"" +
                             std::string(to_string(column->id)) + "=" + headings[i].text + "\"");
    }
    // "normal force_N" may be a symbol's index; beside headings that end with units it ends with one
    if (std::any_of(columns.begin(), columns.end(), [](const NamedColumn& column) { return column.heading.unit; }))
      for (NamedColumn& column : columns)
        if (!column.heading.unit && !rules.mapping.contains(std::string(to_string(column.id))))
          if (auto better = read_heading(headings[column.index], column.index, vocabulary, true);
              better && better->id == column.id)
            column = std::move(*better);
  }
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

Unit unit_of(const Heading& heading, const ColumnKind& kind, const std::string& path, bool alone,
             std::optional<double> pixel) {
  if (!heading.unit) return {};
  const auto fail = [&](const std::string& message) { throw InputError(path, heading.place, message); };
  const std::string_view text = heading.text;
  if (alone && text.find_first_of("])") < text.size() - 1)
    fail("'" + printable(text, 60) + "' is one column; separate columns by commas, semicolons or tabs");
  if (!heading.closed) {
    const bool goes_on = text.find(text[text.find_first_of("[(")] == '[' ? ']' : ')') != std::string_view::npos;
    fail((goes_on ? "something follows the unit of column '" : "the unit of column '") + heading.name +
         (goes_on ? "': '" : "' is not closed: '") + std::string(text) + "'");
  }
  const auto parsed = parse_unit(*heading.unit);
  const std::string wanted =
      kind.always_a_number ? "a plain number" : describe(kind.dimension) + ", or no unit if dimensionless";
  if (!parsed) fail("'" + *heading.unit + "' of column '" + heading.name + "' is no unit; wanted " + wanted);
  // "T [mN] (N)"
  for (std::size_t open = text.find_first_of("[("); open != std::string_view::npos;
       open = text.find_first_of("[(", open + 1)) {
    const std::size_t close = text.find(text[open] == '[' ? ']' : ')', open);
    if (close == std::string_view::npos) break;
    const auto other = parse_unit(text.substr(open + 1, close - open - 1));
    if (other && (other->factor != parsed->factor || other->dimension != parsed->dimension))
      fail("column '" + std::string(text) + "' states two units, " + other->text + " and " + parsed->text);
  }
  if (is_pixels(parsed->dimension, kind.dimension)) {
    if (!pixel)
      fail("column '" + heading.name + "' is in pixels; state the side of one: --pixel=\"1.7 um\", or the key pixel");
    const bool area = kind.dimension == dimension::area;
    return {area ? *pixel * *pixel : *pixel, kind.dimension, parsed->text};
  }
  const bool relative = parsed->text == "%" && kind.name.starts_with("sigma_");
  if (!relative && parsed->dimension != (kind.always_a_number ? dimension::none : kind.dimension))
    fail("unit '" + parsed->text + "' of column '" + heading.name + "' does not fit; wanted " + wanted);
  return *parsed;
}

void require_width(const std::string& path, const CsvRow& row, std::size_t count) {
  if (row.size() < count)
    throw InputError(path, row.place(row.size()),
                     "the row has " + std::to_string(row.size()) + " fields, the header " + std::to_string(count));
  for (std::size_t i = count; i < row.size(); ++i)
    if (!row[i].empty())
      throw InputError(path, row.place(i),
                       "the row has more fields than the header's " + std::to_string(count) +
                           (row.delimiter() == ',' && row.raw().find('.') == std::string_view::npos
                                ? " (commas that part columns and decimal commas cannot be told apart)"
                                : ""));
}

bool holds_a_number(const CsvRow& row) {
  double value = 0;
  for (std::size_t i = 0; i < row.size(); ++i)
    if (row.number(i, value)) return true;
  return false;
}

bool number_at(const std::string& path, const CsvRow& row, std::size_t i, std::string_view name, double& value) {
  if (row.number(i, value)) return true;
  const std::string_view text = trim_name(row[i]);
  if (text.empty() || is_missing(text)) return false;
  if (text.size() < row[i].size() && parse_number(text, value)) return true;
  throw InputError(path, row.place(i),
                   "column '" + std::string(name) + "': " + "'" + printable(text, 60) + "' is not a number" +
                       std::string(decimal_comma_hint(text)));
}

std::string_view decimal_comma_hint(std::string_view text) {
  return text.find(',') != std::string_view::npos ? " (write a decimal point, not a comma)" : "";
}

Columns::Columns(const std::string& path, const std::vector<Heading>& headings, const ColumnRules& rules) {
  const auto is_number = [](const Heading& heading) { return heading.text.empty() || parse_number(heading.text); };
  if (rules.mapping.empty() && std::all_of(headings.begin(), headings.end(), is_number))
    throw InputError(path, headings.at(0).place,
                     "the first row holds numbers where the columns' names are wanted, such as P, T, A (a line that "
                     "starts with '#' is a comment); say which is which: --columns=\"P=1 (mN),T=2 (mN),A=3 (mm^2)\"");
  std::vector<bool> used(headings.size());
  for (const NamedColumn& column : name_columns(path, headings, rules)) {
    if (column.id == ColumnId::time) continue;  // of logs
    const ColumnKind& kind = kind_of(column.id);
    columns_[static_cast<std::size_t>(column.id)] =
        Column{column.id, column.index, unit_of(column.heading, kind, path, headings.size() == 1, rules.pixel)};
    used[column.index] = true;
    count_ = std::max(count_, column.index + 1);
    if (column.heading.name != kind.name)
      taken_.push_back(std::string(kind.name) + " from '" + printable(headings[column.index].text, 60) + "'");
  }
  for (std::size_t i = 0; i < headings.size(); ++i) {
    if (!headings[i].text.empty()) count_ = std::max(count_, i + 1);
    if (!used[i] && !headings[i].name.empty())
      ignored_.push_back(printable(headings[i].closed ? headings[i].name : headings[i].text, std::string::npos));
  }
  require_a_complete_set(path, headings, rules);
  require_consistent_units(path, headings);
  for (const std::string& name : ignored_)
    for (const ColumnKind& kind : kColumnKinds)
      if (!has(kind.id) && kind.id != ColumnId::time && bare_name(name) == bare_name(kind.name))
        misspelt_.emplace_back(name, kind.name);
}

void Columns::require_a_complete_set(const std::string& path, const std::vector<Heading>& headings,
                                     const ColumnRules& rules) const {
  const bool sized = has(ColumnId::A) || has(ColumnId::a) || holds_axes();
  const bool loads = has(ColumnId::P) || has(ColumnId::T) || sized;
  const bool toughness =
      has(ColumnId::psi) || has(ColumnId::mode_ratio) || has(ColumnId::Gc) || has(ColumnId::Gc_over_GIc);
  const bool energies = has(ColumnId::G_I) || has(ColumnId::G_II);
  const auto fail = [&](const std::string& message, ColumnId missing = ColumnId::P) {
    std::string others;
    for (const std::string& name : rules.vocabulary ? ignored_ : std::vector<std::string>{})
      others += (others.empty() ? "'" : ", '") + printable(name, 40) + "'";
    const std::string unit = missing == ColumnId::A                             ? " (mm^2)"
                             : missing == ColumnId::P || missing == ColumnId::T ? " (mN)"
                                                                                : "";
    throw InputError(path, headings.at(0).place.line, 1,
                     message + (others.empty() ? ""
                                               : "; not understood: " + others + ". To say which column is " +
                                                     std::string(to_string(missing)) + ": --columns=\"" +
                                                     std::string(to_string(missing)) + "=" +
                                                     printable(ignored_.front(), 40) + unit + "\""));
  };
  const auto exactly_one = [&](ColumnId one, ColumnId other) {
    const std::string names = "'" + std::string(to_string(one)) + "' or '" + std::string(to_string(other)) + "'";
    if (!has(one) && !has(other)) fail("column " + names + " is missing", one);
    if (has(one) && has(other)) fail("columns " + names + ": one of them, not both");
  };
  const auto all_of = [&](std::initializer_list<ColumnId> ids) {
    for (const ColumnId id : ids)
      if (!has(id)) fail("column '" + std::string(to_string(id)) + "' is missing", id);
  };
  if (!loads && !toughness && !energies)
    fail(std::string("the header names no known quantity; wanted P, T and A (or a), or psi (or mode_ratio) and Gc (or "
                     "Gc_over_GIc), or G_I and G_II") +
         (headings.size() == 1 ? ", separated by commas, semicolons or tabs" : ""));
  if (loads + toughness + energies > 1) {
    std::string sets = loads ? "loads (P, T, A)" : "";
    if (toughness) sets += std::string(loads ? " with " : "") + "toughness (psi, Gc)";
    if (energies) sets += " with energies (G_I, G_II)";
    fail("the header mixes " + sets + "; give one set");
  }
  if (loads) {
    all_of({ColumnId::T});
    if (!rules.load_stated) all_of({ColumnId::P});
    if (!holds_axes()) exactly_one(ColumnId::A, ColumnId::a);
    if (has(ColumnId::a_par) || has(ColumnId::a_perp)) all_of({ColumnId::a_par, ColumnId::a_perp});
    if (has(ColumnId::major) || has(ColumnId::minor)) all_of({ColumnId::major, ColumnId::minor});
  } else if (energies) {
    all_of({ColumnId::G_I, ColumnId::G_II});
  } else {
    exactly_one(ColumnId::psi, ColumnId::mode_ratio);
    exactly_one(ColumnId::Gc, ColumnId::Gc_over_GIc);
  }
}

void Columns::require_consistent_units(const std::string& path, const std::vector<Heading>& headings) const {
  const auto require_like = [&](ColumnId id, const Column* reference, const std::string& rule) {
    const Column* column = find(id);
    if (!column || !reference || column->unit.text == "%") return;
    const bool bare = column->unit.dimension == dimension::none;
    if (bare == (reference->unit.dimension == dimension::none)) return;
    const std::string other(to_string(reference->id));
    throw InputError(
        path, headings[column->index].place,
        "column '" + std::string(to_string(id)) + "' " +
            (bare ? "has no unit while " + other + " has one" : "has a unit while " + other + " has none") + "; " +
            rule);
  };
  for (const ColumnId id :
       {ColumnId::T, ColumnId::A, ColumnId::a, ColumnId::a_par, ColumnId::a_perp, ColumnId::major, ColumnId::minor})
    require_like(id, find(ColumnId::P) ? find(ColumnId::P) : find(ColumnId::T),
                 "P, T and A are either all dimensionless or none is");
  require_like(ColumnId::G_II, find(ColumnId::G_I), "G_I and G_II either both have a unit or neither has");
  const std::string sigma_rule = "a standard error has the kind of unit of its quantity, or %";
  require_like(ColumnId::sigma_T, find(ColumnId::T), sigma_rule);
  require_like(ColumnId::sigma_A, find(ColumnId::T), sigma_rule);
  require_like(ColumnId::sigma_Gc, find(has(ColumnId::Gc) ? ColumnId::Gc : ColumnId::Gc_over_GIc), sigma_rule);
  require_like(ColumnId::sigma_GI, find(ColumnId::G_I), sigma_rule);
  require_like(ColumnId::sigma_GII, find(ColumnId::G_II), sigma_rule);
}

}  // namespace mixity
