#include "dataset/table/partition.h"

#include <algorithm>
#include <map>

#include "base/input_error.h"
#include "base/printable.h"
#include "base/trim.h"
#include "dataset/table/csv_rows.h"
#include "dataset/table/number.h"

namespace mixity {
namespace {

constexpr std::size_t kHeadingLines = 5;  // above the first row of numbers, among which the headings are
constexpr std::size_t kUnitLines = 12;    // above the headings, among which a row of units may be
constexpr std::size_t kBegins = 4;        // places that look like the first row of a table

bool is_number(const std::string& field) {
  double value = 0;
  return !trim(field).empty() && (parse_number(field, '.', value) || parse_number(field, ',', value));
}

/// Two numbers at least.
bool holds_numbers(const Line& line) {
  const auto numbers = std::count_if(line.fields.begin(), line.fields.end(), is_number);
  return !line.comment && numbers >= 2;
}

/// Empty if the text's quotes forbid it.
std::vector<Line> split(std::string_view text, std::size_t first_line, const CsvFormat& format) {
  std::vector<Line> lines;
  const auto add = [&](const CsvRow& row, bool comment) {
    Line line{
        row.line(), static_cast<std::size_t>(row.raw().data() - text.data()), {}, std::string(row.raw()), comment};
    for (std::size_t i = 0; i < row.size(); ++i) line.fields.emplace_back(row[i]);
    lines.push_back(std::move(line));
  };
  try {
    read_rows(
        text, first_line, format, {}, [&](const CsvRow& row) { add(row, false); },
        [&](const CsvRow& row) { add(row, true); });
  } catch (const InputError&) {
    return {};
  }
  return lines;
}

/// The headings of a line, in each way that it may be cut.
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
    // one piece above several columns: NumPy's header line has blanks whatever its rows have
    if (pieces.size() > 1 || line.text.find_first_of(" \t") == std::string::npos) return ways;
  }
  // where blanks part columns: a tab or two blanks between headings, or one outside brackets and quotes
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

/// How many quantities they name; 0 if there are more of them than rows have fields, unless those behind name nothing,
/// as LabVIEW's "Comment", and are dropped. What blanks part may be one heading of several words.
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
    return rules.mapping.empty() ? 1 : 0;  // what names one quantity twice is a heading
  }
}

/// The columns whose fields have to be numbers.
std::vector<NamedColumn> wanted_columns(const std::string& path, const std::vector<Heading>& headings,
                                        const ColumnRules& rules) {
  try {
    std::vector<NamedColumn> columns = name_columns(path, headings, rules);
    std::erase_if(columns, [](const NamedColumn& column) { return column.id == ColumnId::curve; });
    return columns;
  } catch (const InputError&) {  // to be thrown again by whoever reads the table
    return {};
  }
}

/// Whether rows begin with names that the headings leave out, as R's write.table has them: a text in quotes, or a count
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

bool among(const std::vector<std::size_t>& places, std::size_t i) {
  return std::find(places.begin(), places.end(), i) != places.end();
}

/// Of a row of units, what stands in a field; empty where that says nothing.
std::string_view unit_in(const Line& line, std::size_t i) {
  if (!line.fields.empty() && line.fields[0] == "#") ++i;  // cut off where blanks part columns
  std::string_view text = i < line.fields.size() ? std::string_view(line.fields[i]) : std::string_view();
  if (i == 0 && text.starts_with('#')) text.remove_prefix(1);
  text = without_brackets(text);
  return text == "-" || text == "1" ? std::string_view() : text;
}

/// No field is a number, and one of the columns at these places at least has a unit of something measured; of all
/// columns, if no place is given, half.
bool is_row_of_units(const Line& line, const std::vector<std::size_t>& wanted) {
  std::size_t filled = 0, units = 0, measured = 0;
  for (std::size_t i = 0; i < line.fields.size(); ++i) {
    const std::string_view text = unit_in(line, i);
    if (is_number(std::string(text))) return false;
    if (text.empty() || !(wanted.empty() || among(wanted, i))) continue;
    ++filled;
    const auto unit = parse_unit(text);
    units += unit.has_value();
    measured += unit && unit->dimension != dimension::none;
  }
  return measured > 0 && (!wanted.empty() || 2 * units >= filled);
}

/// What a row of units may be called in its first field, as LabVIEW's "Y_Unit_Label".
bool names_units(std::string_view text) {
  const std::string bare = folded(text);
  for (const std::string_view name : {"unit", "einheit", "unidad"})
    if (bare.find(name) != std::string::npos) return true;
  return false;
}

/// Gives the headings the units of that row. Throws InputError for what is no unit there, and for one that is not the
/// heading's own or its mapping's.
void take_units(const std::string& path, const Line& line, const CsvFormat& format, const ColumnRules& rules,
                std::vector<Heading>& headings) {
  std::vector<Heading> given = headings;
  for (std::size_t i = 0; i < headings.size(); ++i)
    if (const std::string_view text = unit_in(line, i);
        !headings[i].unit && !text.empty() && !(i == 0 && names_units(text)))
      given[i].unit = text;
  for (const NamedColumn& column : wanted_columns(path, given, rules)) {
    const std::string_view text = unit_in(line, column.index);
    if (text.empty()) continue;
    const Heading& heading = headings[column.index];
    const auto unit = parse_unit(text), own = column.heading.unit ? parse_unit(*column.heading.unit) : std::nullopt;
    const auto fail = [&](const std::string& message) {
      throw InputError(
          path, places_of(line, format)[column.index],
          "the row of units has '" + printable(text, 40) + "' for column '" + heading.text + "', which " + message);
    };
    if (!unit && !own && given[column.index].unit)
      fail("is no unit that is known; if it is another way to write one: " +
           mapping_flag(column.id, given, column.index));
    if (unit && own && (own->factor != unit->factor || own->dimension != unit->dimension))
      fail("itself says " + own->text);
  }
  for (std::size_t i = 0; i < headings.size(); ++i) headings[i].unit = given[i].unit;
}

/// What a row is called that says something of all above it.
bool names_a_summary(std::string_view text) {
  const std::string bare = folded(text);
  for (const std::string_view name :
       {"mean", "average", "median", "sd", "std", "stdev", "stddev", "min", "minimum", "max", "maximum", "sum",
        "mittelwert", "standardabweichung", "moyenne", "ecarttype", "media", "promedio", "desviacion"})
    if (bare == name) return true;
  return false;
}

/// The first of the rows at the end that have words where all others have numbers, or are called so, as ImageJ's "Mean"
/// below its results; 0 if there are none, or more than a few.
std::size_t find_summary(const Partition& cut) {
  constexpr std::size_t kMostRows = 8, kLeastRows = 3;
  const std::size_t n = cut.lines.size();
  const auto numbers_above = [&](std::size_t k) {  // in all rows but those at the end
    for (std::size_t row = cut.first; row + kMostRows < n || row < cut.first + kLeastRows; ++row)
      if (k >= cut.lines[row].fields.size() || !is_number(cut.lines[row].fields[k])) return false;
    return true;
  };
  const auto is_summary = [&](const Line& line) {
    for (std::size_t k = 0; k < line.fields.size() && holds_numbers(line); ++k) {
      const std::string_view text = trim(line.fields[k]);
      if (k == cut.runs || among(cut.wanted, k) || text.empty() || is_missing(text) || is_number(line.fields[k]))
        continue;
      if (names_a_summary(text) || numbers_above(k)) return true;
    }
    return false;
  };
  std::size_t first = n;
  while (first > cut.first + kLeastRows && n - first < kMostRows && is_summary(cut.lines[first - 1])) --first;
  return first < n ? cut.lines[first].number : 0;
}

}  // namespace

std::vector<FilePlace> places_of(const Line& line, const CsvFormat& format) {
  std::vector<FilePlace> places;
  CsvFormat plain = format;
  plain.comments = false;
  try {
    read_rows(line.text, line.number, plain, {}, [&](const CsvRow& row) {
      for (std::size_t i = 0; i < row.size(); ++i) places.push_back(row.place(i));
    });
  } catch (const InputError&) {  // quotes in a comment
  }
  places.resize(line.fields.size(), {line.number, 1});
  return places;
}

std::optional<Partition> part_by(const std::string& path, std::string_view text, std::size_t first_line,
                                 const CsvFormat& format, const ColumnRules& rules) {
  Partition made;
  made.lines = split(text, first_line, format);
  std::map<std::size_t, std::size_t> widths;  // and how many rows have them
  for (const Line& line : made.lines)
    if (holds_numbers(line)) ++widths[line.fields.size()];
  if (widths.empty()) return std::nullopt;
  const std::size_t width = std::max_element(widths.begin(), widths.end(), [](const auto& one, const auto& other) {
                              return one.second < other.second;
                            })->first;
  Table& table = made.table;
  table.format = format;
  const auto is_row = [&](std::size_t i) {
    return holds_numbers(made.lines[i]) && made.lines[i].fields.size() == width;
  };
  const auto above = [](std::size_t first, std::size_t lines) { return first > lines ? first - lines : 0; };
  // of the first few places where rows begin ("Samples 39 39 39" stands above the table) that with the best headings
  std::vector<std::size_t> begins;
  for (std::size_t i = 0; i < made.lines.size() && begins.size() < kBegins; ++i)
    if (is_row(i) && (i == 0 || !is_row(i - 1))) begins.push_back(i);
  made.first = begins.front();
  std::size_t most = 0, heading_line = made.first;
  for (const std::size_t first : begins) {
    const bool names = begin_with_names(made.lines, first, width);
    for (std::size_t i = first; i-- > above(first, kHeadingLines);)
      for (std::vector<Heading>& headings : cut_headings(made.lines[i], format)) {
        if (names && headings.size() + 1 == width)
          headings.insert(headings.begin(), {"", "", {}, true, headings.front().place});
        if (const std::size_t named = count_named(path, headings, width, rules, format.delimiter == kBlanks);
            named > most) {
          most = named;
          heading_line = i;
          made.first = first;
          table.headings = std::move(headings);
        }
      }
  }
  const std::size_t top = above(made.first, kHeadingLines);
  if (most == 0)  // a line of words at least
    for (std::size_t i = made.first; i-- > top && table.headings.empty();)
      for (std::vector<Heading>& headings : cut_headings(made.lines[i], format))
        if (headings.size() >= 2 && headings.size() <= width && !is_row_of_units(made.lines[i], {}) &&
            table.headings.empty()) {
          heading_line = i;
          table.headings = std::move(headings);
        }
  if (table.headings.empty()) {
    if (rules.mapping.empty()) return std::nullopt;
    for (const FilePlace& place : places_of(made.lines[made.first], format))
      table.headings.push_back({"", "", {}, true, place});
    if (count_named(path, table.headings, width, rules, false) == 0) return std::nullopt;
  } else {
    table.header_line = made.lines[heading_line].number;
  }
  const auto find_wanted = [&] {
    made.wanted.clear();
    for (const NamedColumn& column : wanted_columns(path, table.headings, rules)) made.wanted.push_back(column.index);
  };
  find_wanted();
  const auto units_from = [&](std::size_t i) {
    if (table.units_line > 0 || !is_row_of_units(made.lines[i], made.wanted)) return;
    table.units_line = made.lines[i].number;
    take_units(path, made.lines[i], format, rules, table.headings);
  };
  for (std::size_t i = heading_line + 1; i < made.first; ++i) units_from(i);
  for (std::size_t i = heading_line; i-- > above(heading_line, kUnitLines) && !made.wanted.empty();) units_from(i);
  // Below them words alone are comments, as Origin has them; any number begins the rows, so that none is passed over.
  std::size_t begin = table.header_line == 0 ? made.first : heading_line + 1;
  for (; begin < made.first; ++begin) {
    const Line& line = made.lines[begin];
    if (line.comment || line.number == table.units_line) continue;
    if (std::any_of(line.fields.begin(), line.fields.end(), is_number)) break;
    table.passed_over.push_back(line.number);
  }
  table.offset = made.lines[begin].offset;
  table.line = made.lines[begin].number;
  find_wanted();
  for (std::size_t i = 0; i < table.headings.size(); ++i)
    if (column_named(table.headings[i].name) == ColumnId::curve) made.runs = i;
  table.summary_line = find_summary(made);
  return made;
}

}  // namespace mixity
