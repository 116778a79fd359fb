#include "dataset/table/header_lines.h"

#include <algorithm>
#include <map>
#include <utility>

#include "base/input_error.h"
#include "base/text.h"

namespace mixity {
namespace {

constexpr std::size_t kAbove = 5;   // lines above the first row of numbers, among which the headings are
constexpr std::size_t kBegins = 4;  // places that look like the first row of a table

/// The headings of a line, for each way to cut it.
std::vector<std::vector<Heading>> cut_headings(const Line& line, const CsvFormat& format) {
  std::vector<std::vector<Heading>> ways;
  const auto add = [&](const std::vector<std::pair<std::string, std::size_t>>& pieces) {  // text, column
    std::vector<Heading> headings;
    for (const auto& [text, column] : pieces) headings.push_back(split_heading(text, {line.number, column}));
    if (!headings.empty() && headings.front().text.find_first_of("#%") == 0)
      headings.front() = split_heading(headings.front().text.substr(1), headings.front().place);
    while (!headings.empty() && headings.back().text.empty()) headings.pop_back();
    if (!headings.empty()) ways.push_back(std::move(headings));
  };
  std::vector<std::pair<std::string, std::size_t>> pieces;
  if (format.delimiter != kBlanks) {
    const std::vector<FilePlace> places = places_of(line, format);
    for (std::size_t i = 0; i < line.fields.size(); ++i)
      pieces.emplace_back(line.fields[i], places[i].line == line.number ? places[i].column : 1);
    add(pieces);
    // a line without separators above several columns: the header line of NumPy has blanks whatever its rows have
    if (pieces.size() > 1 || line.text.find_first_of(" \t") == std::string::npos) return ways;
  }
  // cut at blanks: at a tab or two blanks, or at any blank outside brackets and quotes
  const std::string_view text = line.text;
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
      if (format.delimiter != ',' && piece.ends_with(',')) piece.remove_suffix(1);
      if (quotes && piece.size() > 1 && piece.front() == '"' && piece.back() == '"')
        piece = piece.substr(1, piece.size() - 2);
      pieces.emplace_back(piece, first + 1);
      at += blanks;
    }
    add(pieces);
  }
  return ways;
}

/// How many quantities the headings name; 0 if there are more headings than rows have fields, unless the rest name
/// nothing, as LabVIEW's "Comment", and are dropped. `blanks`: a heading may be several words, and none is dropped.
std::size_t count_named(const std::string& path, std::vector<Heading>& headings, std::size_t width,
                        const ColumnRules& rules, bool blanks) {
  try {
    if (headings.size() > width) {
      if (blanks) return 0;
      const std::size_t all = name_columns(path, headings, rules).size();
      headings.resize(width);
      if (name_columns(path, headings, rules).size() < all) return 0;
    }
    return name_columns(path, headings, rules).size();
  } catch (const InputError&) {
    return rules.mapping.empty() ? 1 : 0;  // a line that names one quantity twice is a heading
  }
}

/// Whether rows begin with names that have no heading, as written by write.table of R: a text in quotes, or a count
/// from 1.
bool begin_with_names(const std::vector<Line>& lines, std::size_t first, std::size_t width) {
  constexpr std::size_t kLeast = 3;
  std::size_t rows = 0;
  for (std::size_t i = first; i < lines.size(); ++i) {
    const Line& line = lines[i];
    if (line.comment || line.fields.size() != width) continue;
    ++rows;
    if (trim(line.fields.back()).empty() || (line.text[0] != '"' && line.fields[0] != std::to_string(rows)))
      return false;
  }
  return rows >= kLeast;
}

/// The first few indices at which rows of this width begin: "Samples 39 39 39" may be above the table.
std::vector<std::size_t> first_rows(const std::vector<Line>& lines, std::size_t width) {
  std::vector<std::size_t> begins;
  bool before = false;
  for (std::size_t i = 0; i < lines.size() && begins.size() < kBegins; ++i) {
    const bool is_row = lines[i].fields.size() == width && holds_numbers(lines[i]);
    if (is_row && !before) begins.push_back(i);
    before = is_row;
  }
  return begins;
}

/// The unit in a field of a row of units; empty if it has none.
std::string_view unit_in(const Line& line, std::size_t i) {
  if (!line.fields.empty() && line.fields[0] == "#") ++i;  // cut off where blanks part columns
  std::string_view text = i < line.fields.size() ? std::string_view(line.fields[i]) : std::string_view();
  if (i == 0 && text.starts_with('#')) text.remove_prefix(1);
  text = without_brackets(text);
  return text == "-" || text == "1" ? std::string_view() : text;
}

/// Whether the first field of a row of units is its name, as LabVIEW's "Y_Unit_Label".
bool names_units(std::string_view text) {
  const std::string bare = folded(text);
  for (const std::string_view name : {"unit", "einheit", "unidad"})
    if (bare.find(name) != std::string::npos) return true;
  return false;
}

}  // namespace

std::size_t usual_width(const std::vector<Line>& lines) {
  std::map<std::size_t, std::size_t> rows;  // by their width
  for (const Line& line : lines)
    if (holds_numbers(line)) ++rows[line.fields.size()];
  const auto most = std::max_element(rows.begin(), rows.end(),
                                     [](const auto& one, const auto& other) { return one.second < other.second; });
  return most == rows.end() ? 0 : most->first;
}

std::optional<HeadingLine> find_headings(const std::string& path, const std::vector<Line>& lines, std::size_t width,
                                         const CsvFormat& format, const ColumnRules& rules) {
  const std::vector<std::size_t> begins = first_rows(lines, width);
  HeadingLine found{{}, begins.front(), {}};
  std::size_t most = 0;
  for (const std::size_t first : begins) {
    const bool names = begin_with_names(lines, first, width);
    for (std::size_t i = first; i-- > first - std::min(first, kAbove);)
      for (std::vector<Heading>& headings : cut_headings(lines[i], format)) {
        if (names && headings.size() + 1 == width)
          headings.insert(headings.begin(), {"", "", {}, true, headings.front().place});
        const std::size_t named = count_named(path, headings, width, rules, format.delimiter == kBlanks);
        if (named <= most) continue;
        most = named;
        found = {std::move(headings), first, i};
      }
  }
  const std::size_t top = found.first_row - std::min(found.first_row, kAbove);
  for (std::size_t i = found.first_row; i-- > top && !found.index;)
    if (!is_row_of_units(lines[i], {}))
      for (std::vector<Heading>& headings : cut_headings(lines[i], format))
        if (!found.index && headings.size() >= 2 && headings.size() <= width)
          found = {std::move(headings), found.first_row, i};
  if (found.index) return found;
  if (rules.mapping.empty()) return std::nullopt;
  for (const FilePlace& place : places_of(lines[found.first_row], format))
    found.headings.push_back({"", "", {}, true, place});
  return count_named(path, found.headings, width, rules, false) > 0 ? std::optional(found) : std::nullopt;
}

bool is_row_of_units(const Line& line, const std::vector<std::size_t>& columns) {
  std::size_t filled = 0, units = 0, measured = 0;
  for (std::size_t i = 0; i < line.fields.size(); ++i) {
    const std::string_view text = unit_in(line, i);
    if (is_number(text)) return false;
    if (text.empty() || !(columns.empty() || std::count(columns.begin(), columns.end(), i) > 0)) continue;
    ++filled;
    const auto unit = parse_unit(text);
    units += unit.has_value();
    measured += unit && unit->dimension != dimension::none;
  }
  return measured > 0 && (!columns.empty() || 2 * units >= filled);
}

void take_units(const std::string& path, const Line& line, const CsvFormat& format, const ColumnRules& rules,
                std::vector<Heading>& headings) {
  std::vector<Heading> given = headings;
  for (std::size_t i = 0; i < headings.size(); ++i)
    if (const std::string_view text = unit_in(line, i);
        !headings[i].unit && !text.empty() && !(i == 0 && names_units(text)))
      given[i].unit = text;
  for (const NamedColumn& column : number_columns(path, given, rules)) {
    const std::string_view text = unit_in(line, column.index);
    if (text.empty()) continue;
    const Heading& heading = headings[column.index];
    const auto unit = parse_unit(text), own = column.heading.unit ? parse_unit(*column.heading.unit) : std::nullopt;
    const auto fail = [&](const Message& message) {
      throw InputError(
          path, places_of(line, format)[column.index],
          "the row of units has '" + printable(text, 40) + "' for column '" + heading.text + "', which " + message);
    };
    if (!unit && !own && given[column.index].unit)
      fail("is no unit that is known; if it is another way to write one: " + mapping(column.id, given, column.index));
    if (unit && own && (own->factor != unit->factor || own->dimension != unit->dimension))
      fail("itself says " + own->text);
  }
  for (std::size_t i = 0; i < headings.size(); ++i) headings[i].unit = given[i].unit;
}

}  // namespace mixity
