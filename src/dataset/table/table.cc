#include "dataset/table/table.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "dataset/input_error.h"
#include "dataset/number_text.h"
#include "dataset/printable.h"
#include "dataset/table/csv_rows.h"
#include "dataset/table/number.h"
#include "dataset/trim.h"

namespace mixity {
namespace {

constexpr std::size_t kLooked = std::size_t{1} << 16;  // bytes of the start that are looked at
constexpr std::size_t kHeadingLines = 5;               // above the first row of numbers, among which the headings are

struct Line {
  std::size_t number, offset;
  std::vector<std::string> fields;
  std::string text;
  bool comment;
};

/// Of its fields. Found when they are asked for: of most lines nobody asks.
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

bool is_number(const std::string& field) {
  double value = 0;
  return !trim(field).empty() && (parse_number(field, '.', value) || parse_number(field, ',', value));
}

/// Two numbers at least, and no more else.
bool holds_numbers(const Line& line) {
  std::size_t filled = 0, numbers = 0;
  for (const std::string& field : line.fields) {
    filled += !trim(field).empty();
    numbers += is_number(field);
  }
  return !line.comment && numbers >= 2 && 2 * numbers >= filled;
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
    if (!headings.empty() && headings.front().text.starts_with('#'))
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
    return ways;
  }
  // where blanks part columns: a tab or two blanks between headings, or one outside brackets
  const std::string_view text = line.text;
  const std::size_t begin = text.find_first_not_of("# \t");
  for (const bool wide : {true, false}) {
    pieces.clear();
    int open = 0;
    for (std::size_t at = std::min(begin, text.size()); at < text.size();) {
      const std::size_t first = at;
      std::size_t blanks = 0;
      for (; at < text.size(); ++at) {
        open += text[at] == '[' || text[at] == '(';
        open -= text[at] == ']' || text[at] == ')';
        if (open > 0 || (text[at] != ' ' && text[at] != '\t')) continue;
        blanks = std::min(text.find_first_not_of(" \t", at), text.size()) - at;
        const bool tab = text.substr(at, blanks).find('\t') != std::string_view::npos;
        const char next = at + blanks < text.size() ? text[at + blanks] : ' ';
        if (wide ? tab || blanks > 1 : next != '[' && next != '(') break;
        at += blanks - 1;
      }
      pieces.emplace_back(text.substr(first, at - first), first + 1);
      at += blanks;
    }
    add(pieces);
  }
  return ways;
}

/// How many quantities they name; 0 if there are more of them than rows have fields, unless those behind name nothing,
/// as LabVIEW's "Comment", and are dropped.
std::size_t count_named(const std::string& path, std::vector<Heading>& headings, std::size_t width,
                        const ColumnRules& rules) {
  try {
    if (headings.size() > width) {
      const std::size_t all = name_columns(path, headings, rules).size();
      headings.resize(width);
      if (name_columns(path, headings, rules).size() < all) return 0;
    }
    return name_columns(path, headings, rules).size();
  } catch (const InputError&) {
    return rules.mapping.empty() ? 1 : 0;  // what names one quantity twice is a heading
  }
}

bool is_row_of_units(const Line& line) {
  bool any = false;
  for (const std::string& field : line.fields) {
    const std::string_view text = without_brackets(field);
    if (text.empty()) continue;
    if (!parse_unit(text)) return false;
    any |= text != "-" && text != "1";
  }
  return any;
}

/// A file cut by one separator.
struct Partition {
  std::vector<Line> lines;
  std::size_t first = 0;  // row of numbers
  Table table;
  std::vector<std::size_t> wanted;  // columns of numbers; empty: nothing that is known is named
};

/// Null if there is no table.
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
  while (!(holds_numbers(made.lines[made.first]) && made.lines[made.first].fields.size() == width)) ++made.first;
  Table& table = made.table;
  table.format = format;
  std::size_t most = 0, heading_line = made.first;
  const std::size_t top = made.first > kHeadingLines ? made.first - kHeadingLines : 0;
  for (std::size_t i = made.first; i-- > top;)
    for (std::vector<Heading>& headings : cut_headings(made.lines[i], format))
      if (const std::size_t named = count_named(path, headings, width, rules); named > most) {
        most = named;
        heading_line = i;
        table.headings = std::move(headings);
      }
  if (most == 0)  // a line of words at least
    for (std::size_t i = made.first; i-- > top && table.headings.empty();)
      for (std::vector<Heading>& headings : cut_headings(made.lines[i], format))
        if (headings.size() >= 2 && headings.size() <= width && !is_row_of_units(made.lines[i]) &&
            table.headings.empty()) {
          heading_line = i;
          table.headings = std::move(headings);
        }
  if (table.headings.empty()) {
    if (rules.mapping.empty()) return std::nullopt;
    for (const FilePlace& place : places_of(made.lines[made.first], format))
      table.headings.push_back({"", "", {}, true, place});
    if (count_named(path, table.headings, width, rules) == 0) return std::nullopt;
  } else {
    table.header_line = made.lines[heading_line].number;
  }
  for (std::size_t i = heading_line + 1; i < made.first && table.units_line == 0; ++i) {
    if (!is_row_of_units(made.lines[i])) continue;
    table.units_line = made.lines[i].number;
    for (std::size_t k = 0; k < std::min(table.headings.size(), made.lines[i].fields.size()); ++k) {
      const std::string_view unit = without_brackets(made.lines[i].fields[k]);
      if (!table.headings[k].unit && !unit.empty() && unit != "-" && unit != "1") table.headings[k].unit = unit;
    }
  }
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
  try {
    for (const NamedColumn& column : name_columns(path, table.headings, rules))
      if (column.id != ColumnId::curve) made.wanted.push_back(column.index);
  } catch (const InputError&) {  // to be thrown again by whoever reads the table
  }
  return made;
}

/// The numbers that a cut gives with one decimal sign.
struct Reading {
  char decimal = '.';
  std::size_t valid = 0;                                      // rows
  bool grouped = false, doubtful = false;                     // numbers in groups, surely; perhaps
  std::vector<double> values;                                 // of all rows, NaN where there is none
  std::vector<std::pair<std::size_t, std::size_t>> places{};  // of the values: line, field
};

Reading read(const Partition& cut, char decimal) {
  Reading reading{decimal, 0, false, false, {}, {}};
  for (std::size_t i = cut.first; i < cut.lines.size(); ++i) {
    const Line& line = cut.lines[i];
    if (line.comment) continue;
    bool valid = true;
    for (const std::size_t k : cut.wanted) {
      double value = std::nan("");
      NumberStyle style;
      if (k >= line.fields.size() ||
          (!trim(line.fields[k]).empty() && !parse_number(line.fields[k], decimal, value, &style)))
        valid = false;
      reading.grouped |= style.grouped && !style.doubtful;
      reading.doubtful |= style.doubtful;
      reading.values.push_back(value);
      reading.places.emplace_back(i, k);
    }
    reading.valid += valid;
  }
  return reading;
}

std::string name_of(char delimiter) {
  return delimiter == ';' ? "semicolons" : delimiter == '\t' ? "tabs" : delimiter == ',' ? "commas" : "blanks";
}

/// Throws if both fit and differ.
const Reading& better(const std::string& path, const Partition& cut, const Reading& point, const Reading& comma) {
  if (point.valid != comma.valid) return point.valid > comma.valid ? point : comma;
  for (std::size_t i = 0; i < point.values.size(); ++i) {
    const double one = point.values[i], other = comma.values[i];
    if (one == other || (std::isnan(one) && std::isnan(other))) continue;
    // "1.234" without any comma has a decimal point; where semicolons part columns, "1,234" has a decimal comma
    if (comma.doubtful && !comma.grouped) return point;
    if (point.doubtful && !point.grouped && cut.table.format.delimiter == ';') return comma;
    const auto [line, field] = point.places[i];
    const Line& row = cut.lines[line];
    throw InputError(path, places_of(row, cut.table.format)[field],
                     "'" + printable(row.fields[field], 40) + "' may be " + shortest(comma.values[i]) +
                         " (decimal comma) or " + shortest(point.values[i]) +
                         " (comma between thousands); say which: --decimal=\",\" or --decimal=\".\"");
  }
  return point;
}

}  // namespace

std::optional<Table> find_table(const std::string& path, std::string_view start, char line_end,
                                const ColumnRules& rules, char decimal) {
  std::string delimiters = ";\t, ";
  std::string_view text = start;
  std::size_t before = 0, first_line = 1;  // Excel's "sep=;", which a table may begin with
  if (const std::string_view first = text.substr(0, text.find(line_end));
      first.starts_with("sep=") && first.size() > 4) {
    delimiters = first[4];
    before = std::min(first.size() + 1, text.size());
    first_line = 2;
    text.remove_prefix(before);
  }
  if (text.size() > kLooked) text = text.substr(0, text.rfind(line_end, kLooked) + 1);
  std::optional<Reading> best;
  std::optional<Partition> best_cut, unknown;
  for (const char delimiter : delimiters) {
    if (text.find(delimiter) == std::string_view::npos &&
        !(delimiter == kBlanks && text.find('\t') != std::string_view::npos))
      continue;
    if (delimiter == kBlanks && best) continue;  // what any other separator explains
    CsvFormat format;
    format.delimiter = delimiter;
    format.line_end = line_end;
    const std::size_t end = end_of_rows(text, format);
    auto made = part_by(path, text.substr(0, std::max(end, text.ends_with(line_end) ? std::size_t{0} : text.size())),
                        first_line, format, rules);
    if (!made) continue;
    if (made->wanted.empty()) {
      if (!unknown) unknown = std::move(made);
      continue;
    }
    // without a comma in any field the decimal sign is a point
    const bool commas =
        delimiter == ',' ? text.find('"') != std::string_view::npos : text.find(',') != std::string_view::npos;
    Reading chosen;
    if (decimal != 0 || !commas) {
      chosen = read(*made, decimal == 0 ? '.' : decimal);
    } else {
      const Reading point = read(*made, '.'), comma = read(*made, ',');
      chosen = better(path, *made, point, comma);
    }
    const bool more = !best || made->wanted.size() > best_cut->wanted.size() ||
                      (made->wanted.size() == best_cut->wanted.size() && chosen.valid > best->valid);
    if (!more) continue;
    best = std::move(chosen);
    best_cut = std::move(made);
  }
  if (!best) best_cut = std::move(unknown);
  if (!best_cut) return std::nullopt;
  Table& table = best_cut->table;
  if (best) {
    table.format.decimal = best->decimal;
    table.format.grouped = best->grouped || (decimal != 0 && best->doubtful);
  }
  table.offset += before;
  return std::move(table);
}

std::string describe(const Table& table) {
  std::string text = name_of(table.format.delimiter);
  if (table.format.decimal == ',') text += ", decimal commas";
  if (table.format.grouped) text += ", digits in groups of three";
  if (table.units_line > 0) text += ", units in line " + std::to_string(table.units_line);
  for (const std::size_t line : table.passed_over) text += ", line " + std::to_string(line) + " passed over";
  if (table.header_line > 1) text += ", headings in line " + std::to_string(table.header_line);
  return text;
}

}  // namespace mixity
