#include "dataset/columns.h"

#include <cctype>
#include <initializer_list>

#include "dataset/input_error.h"
#include "dataset/printable.h"

namespace mixity {
namespace {

struct Kind {
  ColumnId id;
  std::string_view name;
  Dimension dimension;   // when it has a unit
  bool always_a_number;  // never carries a unit of its own
};

constexpr std::array<Kind, kColumnCount> kKinds{{
    {ColumnId::P, "P", dimension::force, false},
    {ColumnId::T, "T", dimension::force, false},
    {ColumnId::A, "A", dimension::area, false},
    {ColumnId::a, "a", dimension::length, false},
    {ColumnId::psi, "psi", dimension::angle, false},
    {ColumnId::mode_ratio, "mode_ratio", dimension::none, true},
    {ColumnId::Gc, "Gc", dimension::energy_per_area, false},
    {ColumnId::Gc_over_GIc, "Gc_over_GIc", dimension::none, true},
    {ColumnId::G_I, "G_I", dimension::energy_per_area, false},
    {ColumnId::G_II, "G_II", dimension::energy_per_area, false},
    {ColumnId::sigma_T, "sigma_T", dimension::force, false},
    {ColumnId::sigma_A, "sigma_A", dimension::area, false},
    {ColumnId::sigma_Gc, "sigma_Gc", dimension::energy_per_area, false},
    {ColumnId::sigma_GI, "sigma_GI", dimension::energy_per_area, false},
    {ColumnId::sigma_GII, "sigma_GII", dimension::energy_per_area, false},
    {ColumnId::curve, "curve", dimension::none, true},
    {ColumnId::include, "include", dimension::none, true},
}};

/// In lower case, letters and digits only.
std::string bare_name(std::string_view name) {
  std::string bare;
  for (const char c : name)
    if (const auto byte = static_cast<unsigned char>(c); std::isalnum(byte))
      bare += static_cast<char>(std::tolower(byte));
  return bare;
}

/// As trim, also of what spreadsheets and web pages leave behind: no-break and zero-width spaces, byte order marks.
std::string_view trim_name(std::string_view text) {
  constexpr std::string_view kUnseen[] = {"\xC2\xA0", "\xE2\x80\xAF", "\xE2\x80\x8B", "\xEF\xBB\xBF"};
  for (bool more = true; more;) {
    more = false;
    text = trim(text);
    for (const std::string_view unseen : kUnseen) {
      const bool before = text.starts_with(unseen), behind = !before && text.ends_with(unseen);
      if (before) text.remove_prefix(unseen.size());
      if (behind) text.remove_suffix(unseen.size());
      more |= before || behind;
    }
  }
  return text;
}

}  // namespace

Heading heading_at(const CsvRow& header, std::size_t i) {
  const std::string_view text = trim_name(header[i]);
  const std::size_t open = text.find_first_of("[(");
  if (open == std::string_view::npos) return {std::string(text), {}};
  const std::string name(trim_name(text.substr(0, open)));
  // "P (load) [mN]": the last bracket holds the unit
  const std::size_t last = text.back() == ']'   ? text.rfind('[')
                           : text.back() == ')' ? text.rfind('(')
                                                : std::string_view::npos;
  const bool closed = last != std::string_view::npos;
  const std::size_t unit = (closed ? last : open) + 1;
  return {name, std::string(trim_name(text.substr(unit, text.size() - unit - (closed ? 1 : 0)))), closed};
}

Unit unit_of(const Heading& heading, const Dimension& wanted, bool always_a_number, const std::string& path,
             const CsvRow& header, std::size_t i) {
  if (!heading.unit) return {};
  const auto fail = [&](const std::string& message) { throw InputError(path, header.place(i), message); };
  const std::string_view text = header[i];
  if (header.size() == 1 && text.find_first_of("])") < text.size() - 1)
    fail("'" + printable(text, 60) + "' is one column; separate columns by commas, semicolons or tabs");
  if (!heading.closed) {
    const bool goes_on = text.find(text[text.find_first_of("[(")] == '[' ? ']' : ')') != std::string_view::npos;
    fail((goes_on ? "something follows the unit of column '" : "the unit of column '") + heading.name +
         (goes_on ? "': '" : "' is not closed: '") + std::string(text) + "'");
  }
  const auto parsed = parse_unit(*heading.unit);
  const std::string kind = always_a_number ? "a plain number" : describe(wanted) + ", or no unit if dimensionless";
  if (!parsed) fail("'" + *heading.unit + "' of column '" + heading.name + "' is no unit; wanted " + kind);
  const bool relative = parsed->text == "%" && heading.name.starts_with("sigma_");
  if (!relative && parsed->dimension != (always_a_number ? dimension::none : wanted))
    fail("unit '" + parsed->text + "' of column '" + heading.name + "' does not fit; wanted " + kind);
  return *parsed;
}

void require_width(const std::string& path, const CsvRow& row, std::size_t count) {
  if (row.size() < count)
    throw InputError(path, row.place(row.size()),
                     "the row has " + std::to_string(row.size()) + " fields, the header " + std::to_string(count));
  for (std::size_t i = count; i < row.size(); ++i)
    if (!row[i].empty())
      throw InputError(path, row.place(i), "the row has more fields than the header's " + std::to_string(count));
}

bool holds_a_number(const CsvRow& row) {
  for (std::size_t i = 0; i < row.size(); ++i)
    if (parse_number(row[i])) return true;
  return false;
}

bool number_at(const std::string& path, const CsvRow& row, std::size_t i, std::string_view name, double& value) {
  if (parse_number(row[i], value)) return true;
  const std::string_view text = trim_name(row[i]);
  if (text.empty()) return false;
  if (text.size() < row[i].size() && parse_number(text, value)) return true;
  throw InputError(path, row.place(i),
                   "column '" + std::string(name) + "': " + "'" + printable(text, 60) + "' is not a number" +
                       std::string(decimal_comma_hint(text)));
}

std::string_view decimal_comma_hint(std::string_view text) {
  return text.find(',') != std::string_view::npos ? " (write a decimal point, not a comma)" : "";
}

std::string_view to_string(ColumnId id) { return kKinds[static_cast<std::size_t>(id)].name; }

Columns::Columns(const std::string& path, const CsvRow& header) {
  for (std::size_t i = 0; i < header.size(); ++i) {
    const auto fail = [&](const std::string& message) { throw InputError(path, header.place(i), message); };
    const Heading heading = heading_at(header, i);
    const std::string& name = heading.name;
    if (!header[i].empty()) count_ = i + 1;
    const Kind* kind = nullptr;
    for (const Kind& candidate : kKinds)
      if (candidate.name == heading.name) kind = &candidate;
    if (!kind) {
      if (!name.empty()) ignored_.push_back(printable(heading.closed ? name : header[i], std::string::npos));
      continue;
    }
    const Unit unit = unit_of(heading, kind->dimension, kind->always_a_number, path, header, i);
    auto& slot = columns_[static_cast<std::size_t>(kind->id)];
    if (slot) fail("column '" + name + "' stands twice");
    slot = Column{kind->id, i, unit};
  }
  const auto number_or_empty = [&](std::size_t i) { return header[i].empty() || parse_number(header[i]); };
  std::size_t numbers = 0;
  while (numbers < header.size() && number_or_empty(numbers)) ++numbers;
  if (numbers == header.size())
    throw InputError(path, header.place(0),
                     "the first row holds numbers where the columns' names are wanted, such as P, T, A (a line that "
                     "starts with '#' is a comment)");
  require_a_complete_set(path, header);
  require_consistent_units(path, header);
  for (const std::string& name : ignored_)
    for (const Kind& kind : kKinds)
      if (!has(kind.id) && bare_name(name) == bare_name(kind.name)) misspelt_.emplace_back(name, kind.name);
}

void Columns::require_a_complete_set(const std::string& path, const CsvRow& header) const {
  const bool loads = has(ColumnId::P) || has(ColumnId::T) || has(ColumnId::A) || has(ColumnId::a);
  const bool toughness =
      has(ColumnId::psi) || has(ColumnId::mode_ratio) || has(ColumnId::Gc) || has(ColumnId::Gc_over_GIc);
  const bool energies = has(ColumnId::G_I) || has(ColumnId::G_II);
  const auto fail = [&](const std::string& message) { throw InputError(path, header.line(), 1, message); };
  const auto exactly_one = [&](ColumnId one, ColumnId other) {
    const std::string names = "'" + std::string(to_string(one)) + "' or '" + std::string(to_string(other)) + "'";
    if (!has(one) && !has(other)) fail("column " + names + " is missing");
    if (has(one) && has(other)) fail("columns " + names + ": one of them, not both");
  };
  const auto all_of = [&](std::initializer_list<ColumnId> ids) {
    for (const ColumnId id : ids)
      if (!has(id)) fail("column '" + std::string(to_string(id)) + "' is missing");
  };
  if (!loads && !toughness && !energies)
    fail(std::string("the header names no known quantity; wanted P, T and A (or a), or psi (or mode_ratio) and Gc (or "
                     "Gc_over_GIc), or G_I and G_II") +
         (header.size() == 1 ? ", separated by commas, semicolons or tabs" : ""));
  if (loads + toughness + energies > 1) {
    std::string sets = loads ? "loads (P, T, A)" : "";
    if (toughness) sets += std::string(loads ? " with " : "") + "toughness (psi, Gc)";
    if (energies) sets += " with energies (G_I, G_II)";
    fail("the header mixes " + sets + "; give one set");
  }
  if (loads) {
    all_of({ColumnId::P, ColumnId::T});
    exactly_one(ColumnId::A, ColumnId::a);
  } else if (energies) {
    all_of({ColumnId::G_I, ColumnId::G_II});
  } else {
    exactly_one(ColumnId::psi, ColumnId::mode_ratio);
    exactly_one(ColumnId::Gc, ColumnId::Gc_over_GIc);
  }
}

void Columns::require_consistent_units(const std::string& path, const CsvRow& header) const {
  const auto require_like = [&](ColumnId id, const Column* reference, const std::string& rule) {
    const Column* column = find(id);
    if (!column || !reference || column->unit.text == "%") return;
    const bool bare = column->unit.dimension == dimension::none;
    if (bare == (reference->unit.dimension == dimension::none)) return;
    const std::string other(to_string(reference->id));
    throw InputError(
        path, header.place(column->index),
        "column '" + std::string(to_string(id)) + "' " +
            (bare ? "has no unit while " + other + " has one" : "has a unit while " + other + " has none") + "; " +
            rule);
  };
  for (const ColumnId id : {ColumnId::T, ColumnId::A, ColumnId::a})
    require_like(id, find(ColumnId::P), "P, T and A are either all dimensionless or none is");
  require_like(ColumnId::G_II, find(ColumnId::G_I), "G_I and G_II either both have a unit or neither has");
  const std::string sigma_rule = "a standard error has the kind of unit of its quantity, or %";
  require_like(ColumnId::sigma_T, find(ColumnId::T), sigma_rule);
  require_like(ColumnId::sigma_A, find(ColumnId::P), sigma_rule);
  require_like(ColumnId::sigma_Gc, find(has(ColumnId::Gc) ? ColumnId::Gc : ColumnId::Gc_over_GIc), sigma_rule);
  require_like(ColumnId::sigma_GI, find(ColumnId::G_I), sigma_rule);
  require_like(ColumnId::sigma_GII, find(ColumnId::G_II), sigma_rule);
}

}  // namespace mixity
