#include "dataset/table/header_lines.h"

#include <algorithm>
#include <map>
#include <utility>

#include "base/input_error.h"
#include "base/text.h"
#include "dataset/table/column_advice.h"
#include "dataset/table/number.h"
#include "dataset/table/runs_beside.h"

namespace mixity {
namespace {

constexpr std::size_t kAbove = 5;   // lines above the first row of numbers that are searched for headings
constexpr std::size_t kBegins = 4;  // places that look like the first row of a table

/// The headings of a line, for each way to split it.
std::vector<std::vector<Heading>> split_headings(const CsvRow& line) {
  std::vector<std::vector<Heading>> ways;
  const auto add = [&](const std::vector<std::pair<std::string, std::size_t>>& pieces) {  // text, column
    std::vector<Heading> headings;
    for (const auto& [text, column] : pieces) headings.push_back(split_heading(text, {line.line(), column}));
    if (!headings.empty() && headings.front().text.find_first_of("#%") == 0)
      headings.front() = split_heading(headings.front().text.substr(1), headings.front().place);
    while (!headings.empty() && headings.back().text.empty()) headings.pop_back();
    if (!headings.empty()) ways.push_back(std::move(headings));
  };
  std::vector<std::pair<std::string, std::size_t>> pieces;
  if (line.delimiter() != kBlanks) {
    const std::vector<FilePlace> places = line.places();
    for (std::size_t i = 0; i < line.size(); ++i) {
      const FilePlace& place = places[i];
      pieces.emplace_back(line[i], place.line == line.line() ? place.column : 1);
    }
    add(pieces);
    // NumPy separates headings by blanks, whatever separates the fields of its rows.
    if (pieces.size() > 1 || line.raw().find_first_of(" \t") == std::string_view::npos) return ways;
  }
  // splits at tabs or double blanks, or at any blank outside brackets and quotes
  const std::string_view text = line.raw();
  const bool quotes = std::count(text.begin(), text.end(), '"') % 2 == 0;
  const std::size_t begin = text.find_first_not_of("#% \t");
  for (const bool wide : {true, false}) {
    pieces.clear();
    int open = 0;
    bool quoted = false;
    for (std::size_t at = std::min(begin, text.size()); at < text.size();) {
      const std::size_t first = at;
      std::size_t blanks = 0;
      for (; at < text.size(); ++at) {
        open += text[at] == '[' || text[at] == '(';
        open -= text[at] == ']' || text[at] == ')';
        quoted ^= quotes && text[at] == '"';
        if (open > 0 || quoted || (text[at] != ' ' && text[at] != '\t')) continue;
        blanks = std::min(text.find_first_not_of(" \t", at), text.size()) - at;
        const bool tab = text.substr(at, blanks).find('\t') != std::string_view::npos;
        const char next = at + blanks < text.size() ? text[at + blanks] : ' ';
        if (wide ? tab || blanks > 1 : next != '[' && next != '(') break;
        at += blanks - 1;
      }
      std::string_view piece = text.substr(first, at - first);
      if (line.delimiter() != ',' && piece.ends_with(',')) piece.remove_suffix(1);
      if (quotes && piece.size() > 1 && piece.front() == '"' && piece.back() == '"')
        piece = piece.substr(1, piece.size() - 2);
      pieces.emplace_back(piece, first + 1);
      at += blanks;
    }
    add(pieces);
  }
  return ways;
}

/// The number of quantities that the headings name. Removes headings beyond the width of the rows that name nothing,
/// such as LabVIEW's "Comment". If one of these names a quantity, or if blanks separate the fields, so that a heading
/// may have several words, returns 0.
std::size_t count_named(const std::string& path, std::vector<Heading>& headings, std::size_t width,
                        const ColumnRules& rules, bool blanks) {
  try {
    if (const std::size_t run = rules.log ? 0 : width_of_runs(headings); run > 0 && headings.size() <= width)
      return name_columns(path,
                          std::vector<Heading>(headings.begin(), headings.begin() + static_cast<std::ptrdiff_t>(run)),
                          rules)
          .size();
    if (headings.size() > width) {
      if (blanks) return 0;
      const std::size_t all = name_columns(path, headings, rules).size();
      headings.resize(width);
      if (name_columns(path, headings, rules).size() < all) return 0;
    }
    return name_columns(path, headings, rules).size();
  } catch (const InputError&) {
    return rules.mapping.empty() ? 1 : 0;  // a line that names one quantity twice is a line of headings
  }
}

/// Whether rows begin with names without a heading, as from R's write.table: a quoted text, or a count from 1.
bool begin_with_names(const std::vector<CsvRow>& lines, std::size_t first, std::size_t width) {
  constexpr std::size_t kLeast = 3;
  std::size_t rows = 0;
  for (std::size_t i = first; i < lines.size(); ++i) {
    const CsvRow& line = lines[i];
    if (line.is_comment() || line.size() != width) continue;
    ++rows;
    if (line[width - 1].empty() || (line.raw()[0] != '"' && line[0] != std::to_string(rows))) return false;
  }
  return rows >= kLeast;
}

/// The first few indices at which rows of this width begin: lines such as "Samples 39 39 39" may precede the table.
std::vector<std::size_t> first_rows(const std::vector<CsvRow>& lines, const NumberRows& rows, std::size_t width) {
  std::vector<std::size_t> begins;
  bool before = false;
  for (std::size_t i = 0; i < lines.size() && begins.size() < kBegins; ++i) {
    const bool is_row = lines[i].size() == width && rows.are[i];
    if (is_row && !before) begins.push_back(i);
    before = is_row;
  }
  return begins;
}

/// The unit in a field of a row of units; empty if it has none.
std::string_view unit_in(const CsvRow& row, std::size_t i) {
  if (row.size() > 0 && row[0] == "#") ++i;  // "#" is a separate field if blanks separate columns
  std::string_view text = i < row.size() ? row[i] : std::string_view();
  if (i == 0 && text.starts_with('#')) text.remove_prefix(1);
  text = without_brackets(text);
  return text == "-" || text == "1" ? std::string_view() : text;
}

/// Counts fields of a row, in these columns or, if none are given, in all.
struct UnitCount {
  std::size_t filled = 0, units = 0, measured = 0;  // measured: units that are not just numbers; 0 if a field is one
};
UnitCount count_units(const CsvRow& row, const std::vector<std::size_t>& columns) {
  UnitCount count;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const std::string_view text = unit_in(row, i);
    if (is_number(text)) return {};
    if (text.empty() || !(columns.empty() || std::count(columns.begin(), columns.end(), i) > 0)) continue;
    ++count.filled;
    const auto unit = parse_unit(text);
    count.units += unit.has_value();
    count.measured += unit && unit->dimension != dimension::none;
  }
  return count;
}

/// Whether a line has only units, as headings never have: "s,N,N,mm^2".
bool holds_only_units(const CsvRow& row) {
  const UnitCount count = count_units(row, {});
  return count.measured > 0 && count.units == count.filled;
}

/// A mapping by number counts the columns of the table that is there without it: any line would have such columns.
ColumnRules without_numbers(ColumnRules rules) {
  std::erase_if(rules.mapping, [](const auto& one) { return parse_number(split_heading(one.second, {}).name); });
  return rules;
}

/// Whether the first field of a row of units is a label, as LabVIEW's "Y_Unit_Label".
bool is_label_of_units(std::string_view text) {
  const std::string bare = folded(text);
  for (const std::string_view name : {"unit", "einheit", "unidad"})
    if (bare.find(name) != std::string::npos) return true;
  return false;
}

/// The same for rows of one width.
std::optional<HeadingLine> headings_of_width(const std::string& path, const std::vector<CsvRow>& lines,
                                             const NumberRows& rows, std::size_t width, const ColumnRules& rules) {
  const std::vector<std::size_t> begins = first_rows(lines, rows, width);
  const ColumnRules by_name = without_numbers(rules);
  HeadingLine found{{}, begins.front(), {}};
  std::size_t most = 0;
  for (const std::size_t first : begins) {
    const bool names = begin_with_names(lines, first, width);
    for (std::size_t i = first; i-- > first - std::min(first, kAbove);) {
      if (holds_only_units(lines[i])) continue;
      for (std::vector<Heading>& headings : split_headings(lines[i])) {
        if (headings.size() <= most) continue;  // which cannot name more
        if (names && headings.size() + 1 == width)
          headings.insert(headings.begin(), {"", "", {}, true, headings.front().place});
        const std::size_t named = count_named(path, headings, width, by_name, lines[i].delimiter() == kBlanks);
        if (named <= most) continue;
        most = named;
        found = {std::move(headings), first, i, named};
      }
    }
  }
  const std::size_t top = found.first_row - std::min(found.first_row, kAbove);
  for (std::size_t i = found.first_row; i-- > top && !found.index;)
    if (!is_row_of_units(lines[i], {}))
      for (std::vector<Heading>& headings : split_headings(lines[i]))
        if (!found.index && headings.size() >= 2 && headings.size() <= width)
          found = {std::move(headings), found.first_row, i};
  if (found.index) return found;
  if (rules.mapping.empty()) return std::nullopt;
  const CsvRow& first = lines[found.first_row];
  for (std::size_t i = 0; i < first.size(); ++i) found.headings.push_back({"", "", {}, true, first.place(i)});
  return count_named(path, found.headings, width, rules, false) > 0 ? std::optional(found) : std::nullopt;
}

}  // namespace

bool counts_columns(const ColumnRules& rules) { return without_numbers(rules).mapping.size() < rules.mapping.size(); }

std::size_t count_filled(const CsvRow& row) {
  std::size_t filled = 0;
  for (std::size_t i = 0; i < row.size(); ++i) filled += !row[i].empty();
  return filled;
}

bool has_a_number(const CsvRow& row) {
  for (std::size_t i = 0; i < row.size(); ++i)
    if (is_number(row[i])) return true;
  return false;
}

bool is_row_of_numbers(const CsvRow& row) {
  std::size_t numbers = 0;
  for (std::size_t i = 0; i < row.size() && !row.is_comment() && numbers < 2; ++i) numbers += is_number(row[i]);
  return numbers == 2;
}

bool begins_with_words(const CsvRow& row) {
  std::size_t i = 0;
  while (i < row.size() && row[i].empty()) ++i;
  return i < row.size() && row[i].find_first_of("+-.,0123456789") != 0 && !is_missing(row[i]) && !is_number(row[i]);
}

NumberRows::NumberRows(const std::vector<CsvRow>& lines) {
  std::map<std::size_t, std::size_t> rows, with_words;  // by their width
  std::size_t count = 0, count_with_words = 0;
  for (const CsvRow& line : lines) {
    are.push_back(is_row_of_numbers(line));
    const bool words = begins_with_words(line);
    if (!are.back() || words) only_from = are.size();
    if (!are.back()) continue;
    ++(words ? with_words : rows)[line.size()];
    ++(words ? count_with_words : count);
  }
  if (2 * count < count_with_words)
    for (const auto& [fields, n] : with_words) rows[fields] += n;
  std::vector<std::pair<std::size_t, std::size_t>> order;  // rows, width: the wider first, as heads have fewer fields
  for (const auto& [fields, n] : rows) order.emplace_back(n, fields);
  std::sort(order.rbegin(), order.rend());
  for (const auto& [n, fields] : order) widths.push_back(fields);
}

std::optional<HeadingLine> find_headings(const std::string& path, const std::vector<CsvRow>& lines,
                                         const NumberRows& rows, const ColumnRules& rules) {
  constexpr std::size_t kTried = 3, kSure = 2;  // widths, quantities
  std::optional<HeadingLine> usual;
  for (std::size_t k = 0; k < std::min(rows.widths.size(), kTried); ++k) {
    auto found = headings_of_width(path, lines, rows, rows.widths[k], rules);
    if (found && found->named >= (k == 0 ? 1 : kSure)) return found;
    if (k == 0) usual = std::move(found);
  }
  return usual;
}

bool is_row_of_units(const CsvRow& row, const std::vector<std::size_t>& columns) {
  const UnitCount count = count_units(row, columns);
  return count.measured > 0 && (!columns.empty() || 2 * count.units >= count.filled);
}

void take_units(const std::string& path, const CsvRow& row, const ColumnRules& rules, std::vector<Heading>& headings) {
  std::vector<Heading> given = headings;
  for (std::size_t i = 0; i < headings.size(); ++i)
    if (const std::string_view text = unit_in(row, i);
        !headings[i].unit && !text.empty() && !(i == 0 && is_label_of_units(text)))
      given[i].unit = text;
  for (const NamedColumn& column : number_columns(path, given, rules)) {
    const std::string_view text = unit_in(row, column.index);
    if (text.empty()) continue;
    const Heading& heading = headings[column.index];
    const auto unit = parse_unit(text), own = column.heading.unit ? parse_unit(*column.heading.unit) : std::nullopt;
    const auto fail = [&](const Message& message) {
      throw InputError(
          path, row.place(column.index),
          "the row of units has '" + printable(text, 40) + "' for column '" + heading.text + "', which " + message);
    };
    if (!unit && !own && is_mass(text) && kind_of(column.id).dimension == dimension::force)
      fail("is a mass; if a weight is meant: " +
           Message(Remedy::set("columns", mapping_with(std::string(text) + "f", column.id, given, column.index))));
    if (!unit && !own && given[column.index].unit)
      fail("is no unit that is known; if it is another way to write one: " + mapping(column.id, given, column.index));
    if (unit && own && (own->factor != unit->factor || own->dimension != unit->dimension))
      fail("itself says " + own->text);
  }
  headings = std::move(given);
}

}  // namespace mixity
