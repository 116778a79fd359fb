#include "dataset/table/columns.h"

#include <algorithm>
#include <initializer_list>

#include "base/input_error.h"
#include "base/nearest_name.h"
#include "base/number_text.h"
#include "base/text.h"
#include "dataset/table/column_advice.h"
#include "dataset/table/mapped_columns.h"
#include "dataset/table/number.h"

namespace mixity {
namespace {

/// Words in a column without a heading, such as LabVIEW's comments on some rows.
bool is_remark(std::string_view text) {
  return text.find_first_of("+-.,0123456789") != 0 && !is_number(text) && !folded(text).empty();
}

}  // namespace

Unit unit_of(const Heading& heading, const ColumnKind& kind, const std::string& path, bool alone,
             std::optional<double> pixel) {
  if (!heading.unit) return {};
  const auto fail = [&](const Message& message) { throw InputError(path, heading.place, message); };
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
      describe(kind.dimension) + (kind.dimension == dimension::none ? "" : ", or no unit if dimensionless");
  if (!parsed && is_mass(*heading.unit) && kind.dimension == dimension::force)
    fail("'" + *heading.unit + "' of column '" + heading.name + "' is a mass; if a weight is meant: " +
         Remedy::set("columns", std::string(kind.name) + "=" + heading.name + " (" + *heading.unit + "f)"));
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
      fail("column '" + heading.name +
           "' is in pixels; state the side of one: " + Remedy::set_or_key("pixel", "1.7 um"));
    const bool area = kind.dimension == dimension::area;
    return {area ? *pixel * *pixel : *pixel, kind.dimension, parsed->text};
  }
  const bool relative = parsed->text == "%" && kind.name.starts_with("sigma_");
  if (!relative && parsed->dimension != kind.dimension)
    fail("unit '" + parsed->text + "' of column '" + heading.name + "' does not fit; wanted " + wanted);
  return *parsed;
}

void require_width(const std::string& path, const CsvRow& row, std::size_t count, std::size_t needed) {
  if (row.size() < count && (row.size() < needed || row.delimiter() == kBlanks))
    throw InputError(path, row.place(row.size()),
                     "the row has " + std::to_string(row.size()) + " fields, the header " + std::to_string(count));
  // beside a table of a sheet another may stand
  for (std::size_t i = count; i < row.size() && !row.is_of_cells(); ++i)
    if (!row[i].empty() && !is_remark(row[i]))
      throw InputError(path, row.place(i),
                       "the row has more fields than the header's " + std::to_string(count) +
                           (row.delimiter() != ',' ? ""
                            : row.raw().find('.') == std::string_view::npos
                                ? " (separating commas cannot be distinguished from decimal commas)"
                                : " (a text with a comma needs quotes around it)"));
}

bool holds_a_number(const CsvRow& row) {
  double value = 0;
  for (std::size_t i = 0; i < row.size(); ++i)
    if (row.number(i, value)) return true;
  return false;
}

bool number_at(const std::string& path, const CsvRow& row, std::size_t i, std::string_view name, double& value,
               double* error) {
  if (row.number(i, value)) return !is_placeholder(value);
  const std::string_view text = trim_name(row[i]);
  if (text.empty() || is_missing(text)) return false;
  if (text.size() < row[i].size() && parse_number(text, value)) return true;
  double stated = 0;
  if (parse_with_error(text, row.decimal(), value, stated)) {
    if (!error)
      throw InputError(path, row.place(i),
                       "column '" + std::string(name) + "': '" + printable(text, 60) +
                           "' states a standard error where none is read, or a column states it, too");
    *error = stated;
    return true;
  }
  const std::string problem = "column '" + std::string(name) + "': '" + printable(text, 60) + "' is not a number";
  NumberStyle style;
  if (parse_number(text, row.decimal(), value, &style) && style.doubtful)
    throw InputError(path, row.place(i),
                     problem + " but for " + shortest(value) + ", if digits stand in groups of three: " +
                         Remedy::set("decimal", std::string(1, row.decimal())) + " says so");
  throw InputError(path, row.place(i), problem + std::string(decimal_comma_hint(text)));
}

std::string_view decimal_comma_hint(std::string_view text) {
  return text.find(',') != std::string_view::npos ? " (write a decimal point, not a comma)" : "";
}

Columns::Columns(const std::string& path, const std::vector<Heading>& headings, const ColumnRules& rules) {
  const auto is_no_name = [](const Heading& heading) { return heading.text.empty() || parse_number(heading.text); };
  if (rules.mapping.empty() && std::all_of(headings.begin(), headings.end(), is_no_name))
    throw InputError(path, headings.at(0).place,
                     "the first row holds numbers where the columns' names are wanted, such as P, T, A (a line that "
                     "starts with '#' is a comment); say which is which: " +
                         Remedy::set("columns", "P=1 (mN),T=2 (mN),A=3 (mm^2)"));
  std::vector<bool> used(headings.size());
  for (const NamedColumn& column : name_columns(path, headings, rules)) {
    if (rules.log && column.id > ColumnId::angle && !is_clock(column.id)) continue;
    const ColumnKind& kind = kind_of(column.id);
    by_id[static_cast<std::size_t>(column.id)] =
        Column{column.id, column.index, unit_of(column.heading, kind, path, headings.size() == 1, rules.pixel)};
    Unit& unit = by_id[static_cast<std::size_t>(column.id)]->unit;
    if (const ErrorOfAxis* const error = error_of_axis(column.heading.name); error && unit.text != "%")
      unit.factor /= error->per_semi_axis;
    used[column.index] = true;
    mapped.emplace(kind.name, mapped_as(column, headings));
    needed = std::max(needed, column.index + 1);
    count = std::max(count, column.index + 1);
    if (column.heading.name != kind.name)
      taken.push_back(std::string(kind.name) + " from '" + printable(headings[column.index].text, 60) + "'");
  }
  for (std::size_t i = 0; i < headings.size(); ++i) {
    if (!headings[i].text.empty()) count = std::max(count, i + 1);
    if (!used[i] && !headings[i].name.empty())
      ignored.push_back(printable(headings[i].closed ? headings[i].name : headings[i].text, std::string::npos));
  }
  if (rules.log) return;
  find_runs_beside(headings, used);
  require_a_complete_set(path, headings, rules);
  require_consistent_units(path, headings, rules);
  if (rules.vocabulary) find_unused(headings, used, rules);
}

void Columns::find_unused(const std::vector<Heading>& headings, const std::vector<bool>& used,
                          const ColumnRules& rules) {
  std::size_t next = 0;  // index among the ignored columns
  for (std::size_t i = 0; i < headings.size(); ++i) {
    const Heading& heading = headings[i];
    if (used[i] || heading.name.empty()) continue;
    const std::string& name = ignored[next++];
    auto id = column_named(heading.name);
    if (const auto read = id ? std::nullopt : rules.known_names().read(heading, i)) id = read->id;
    if (!id) id = rules.known_names().find(heading.name);
    if (const auto meant = id ? std::nullopt : meant_column(heading)) {
      unused.emplace_back(name, "did you mean " + std::string(to_string(*meant)) + "?");
      continue;
    }
    if (!id && heading.name.starts_with("sigma"))
      unused.emplace_back(name, "it is the standard error of no column that is read");
    const bool of_approach = id && (*id == ColumnId::delta || *id == ColumnId::sigma_P);
    if (!id || is_clock(*id) || (of_approach && !rules.approach_held)) continue;
    // many a file has displacements that are none of a pull-off
    if (*id == ColumnId::u || *id == ColumnId::P_c || (has(*id) && !beside.empty())) continue;
    const std::string quantity(to_string(*id));
    if (const Column* const other = find(*id))
      unused.emplace_back(name, quantity + " is read from '" + printable(headings[other->index].text, 60) + "'");
    else if (!unit_fits(heading.unit, *id))
      unused.emplace_back(name, "its unit '" + printable(*heading.unit, 20) + "' does not fit " + quantity);
    else
      unused.emplace_back(name, "it may be " + quantity + ", which these columns do not need");
  }
}

std::optional<ColumnId> Columns::meant_column(const Heading& heading) const {
  const auto nearest = nearest_name(heading.name, column_names());
  const auto id = nearest ? column_named(*nearest) : std::nullopt;
  const bool optional = id && (*id >= ColumnId::sigma_T || id == ColumnId::angle) && !is_clock(*id);
  return optional && !has(*id) && unit_fits(heading.unit, *id) ? id : std::nullopt;
}

void Columns::find_runs_beside(const std::vector<Heading>& headings, const std::vector<bool>& used) {
  for (const std::optional<Column>& column : by_id) {
    if (!column || column->id > ColumnId::minor) continue;
    const std::string letters = letters_of(headings[column->index].name);
    const auto twin = std::find_if(headings.begin(), headings.end(), [&](const Heading& heading) {
      return !used[static_cast<std::size_t>(&heading - headings.data())] && letters_of(heading.name) == letters;
    });
    if (twin == headings.end() || letters.empty()) return beside.clear();
    beside += (beside.empty() ? "'" : ", '") + printable(twin->text, 40) + "'";
  }
}

std::vector<ColumnId> Columns::missing_loads(bool load_stated) const {
  using enum ColumnId;
  std::vector<ColumnId> missing;
  if (!has(P) && !load_stated && !has(delta)) missing.push_back(P);
  if (!has(T)) missing.push_back(T);
  if (!has(A) && !lengths()) missing.push_back(A);
  return missing;
}

Message Columns::advice(const std::vector<ColumnId>& missing, const std::vector<Heading>& headings) const {
  std::vector<bool> used(headings.size());
  for (const std::optional<Column>& column : by_id)
    if (column) used[column->index] = true;
  return advice_on_missing(missing, headings, used);
}

void Columns::require_a_complete_set(const std::string& path, const std::vector<Heading>& headings,
                                     const ColumnRules& rules) const {
  using enum ColumnId;
  const bool sized = has(A) || lengths();
  if (holds_pull_off()) {
    if (!has(T) && !has(ColumnId::u))
      throw MissingColumn(
          path, headings.at(0).place.line, 1,
          "column 'T' or 'u' is missing: a pull-off load P_c belongs to a tangential load or displacement");
    return;
  }
  const bool loads = has(P) || has(T) || sized;
  const bool toughness = has(psi) || has(mode_ratio) || has(Gc) || has(Gc_over_GIc);
  const bool energies = has(G_I) || has(G_II);
  const auto fail = [&](const std::string& message, std::optional<ColumnId> missing = {}, const Message& tail = {}) {
    const bool load = !missing || *missing == P || *missing == T || *missing == A;
    const Message text =
        rules.vocabulary
            ? message + advice(load ? missing_loads(rules.load_stated) : std::vector<ColumnId>{*missing}, headings)
            : Message(message);
    if (missing) throw MissingColumn(path, headings.at(0).place.line, 1, text + tail);
    throw InputError(path, headings.at(0).place.line, 1, text);
  };
  const auto exactly_one = [&](ColumnId one, ColumnId other) {
    const std::string names = "'" + std::string(to_string(one)) + "' or '" + std::string(to_string(other)) + "'";
    if (!has(one) && !has(other)) fail("column " + names + " is missing", one);
    if (has(one) && has(other))
      throw InputError(path, headings.at(0).place.line, 1,
                       "columns " + names + ": one of them, not both" +
                           (rules.vocabulary ? "; " + mapping(one, headings, find(one)->index) + " or " +
                                                   mapping(other, headings, find(other)->index) + " chooses"
                                             : Message()));
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
    all_of({T});
    if (rules.approach_held && !has(delta))
      fail("control = \"approach\" needs a column 'delta', the approach of the sphere", delta,
           rules.vocabulary ? "; say which it is: " + Remedy::set("columns", "delta=2 (um)") : Message());
    if (!rules.approach_held && !rules.load_stated && !has(P))
      fail("column 'P' is missing", P,
           !rules.vocabulary ? Message()
           : std::any_of(headings.begin(), headings.end(), [](const Heading& one) { return one.name == "delta"; })
               ? "; an approach, delta, that is held in place of a load is stated by " +
                     Remedy::set_or_key("control", "approach")
               : advice_on_load(path));
    if (!lengths() || lengths()->one == a) exactly_one(A, a);
    for (const ContactLengths& one : kContactLengths)
      if (has(one.one) || has(one.other)) all_of({one.one, one.other});
  } else if (energies) {
    all_of({G_I, G_II});
  } else {
    exactly_one(psi, mode_ratio);
    exactly_one(Gc, Gc_over_GIc);
  }
}

void Columns::require_consistent_units(const std::string& path, const std::vector<Heading>& headings,
                                       const ColumnRules& rules) const {
  using enum ColumnId;
  const auto require_like = [&](ColumnId id, const Column* reference, const std::string& rule) {
    const Column* column = find(id);
    if (!column || !reference || column->unit.text == "%") return;
    const bool bare = column->unit.dimension == dimension::none;
    if (bare == (reference->unit.dimension == dimension::none)) return;
    const std::string other(to_string(reference->id));
    const Dimension& wanted = kind_of(id).dimension;
    std::string unit =  // of a column of this kind
        rules.pixel && (wanted == dimension::area || wanted == dimension::length) ? "px" : "UNIT";
    for (const std::optional<Column>& like : by_id)
      if (like && like->unit.dimension == wanted) unit = like->unit.text;
    throw InputError(
        path, headings[column->index].place,
        "column '" + std::string(to_string(id)) + "' " +
            (bare ? "has no unit while " + other + " has one" : "has a unit while " + other + " has none") + "; " +
            rule +
            (bare && rules.vocabulary
                 ? "; say its unit: " + Remedy::set("columns", mapping_with(unit, id, headings, column->index))
                 : Message()));
  };
  const auto require_like_loads = [&](ColumnId id) {
    require_like(id, find(P) ? find(P) : find(T), "P, T and A are either all dimensionless or none is");
  };
  for (const ColumnId id : {T, A, delta}) require_like_loads(id);
  for (const ContactLengths& lengths : kContactLengths)
    if (lengths.round() || !has(A))  // beside an area, only the ratio of the axes counts
      for (const ColumnId id : {lengths.one, lengths.other}) require_like_loads(id);
  if (holds_pull_off())
    for (const ColumnId id : {T, ColumnId::u})
      require_like(id, find(P_c), "P_c and T or u are either all dimensionless or none is");
  require_like(sigma_u, find(ColumnId::u), "a standard error has the kind of unit of its quantity, or %");
  require_like(G_II, find(G_I), "G_I and G_II either both have a unit or neither has");
  const std::string sigma_rule = "a standard error has the kind of unit of its quantity, or %";
  require_like(sigma_P, find(holds_pull_off() ? P_c : P), sigma_rule);
  require_like(sigma_T, find(T), sigma_rule);
  require_like(sigma_A, find(T), sigma_rule);
  if (lengths())
    for (const ColumnId id : {sigma_a_par, sigma_a_perp}) require_like(id, find(lengths()->one), sigma_rule);
  require_like(sigma_Gc, find(has(Gc) ? Gc : Gc_over_GIc), sigma_rule);
  require_like(sigma_GI, find(G_I), sigma_rule);
  require_like(sigma_GII, find(G_II), sigma_rule);
}

}  // namespace mixity
