#include "dataset/table/table.h"

#include <algorithm>

#include "base/text.h"
#include "dataset/table/decimal_sign.h"
#include "dataset/table/header_lines.h"
#include "dataset/table/number.h"

namespace mixity {
namespace {

using Lines = std::vector<CsvRow>;
using Indices = std::vector<std::size_t>;  // of columns

constexpr std::size_t kSearched = std::size_t{1} << 16;  // bytes at the start of the file

Indices indices_of_numbers(const std::string& path, const std::vector<Heading>& headings, const ColumnRules& rules) {
  Indices columns;
  for (const NamedColumn& column : number_columns(path, headings, rules)) columns.push_back(column.index);
  return columns;
}

/// Takes the units from a row between the headings and the numbers, or above the headings. Returns its line; 0 if none.
std::size_t take_row_of_units(const std::string& path, const Lines& lines, const HeadingLine& at,
                              const Indices& columns, const ColumnRules& rules, std::vector<Heading>& headings) {
  constexpr std::size_t kAbove = 12;  // lines
  const std::size_t heading = at.index.value_or(at.first_row);
  Indices order;
  for (std::size_t i = heading + 1; i < at.first_row; ++i) order.push_back(i);
  if (!columns.empty())
    for (std::size_t i = heading; i-- > heading - std::min(heading, kAbove);) order.push_back(i);
  for (const std::size_t i : order) {
    if (!is_row_of_units(lines[i], columns)) continue;
    take_units(path, lines[i], rules, headings);
    return lines[i].line();
  }
  return 0;
}

/// Whether a line is a setting of the channels that stands between headings and rows, "Length 39 39 39": its label is
/// none of a row.
bool is_setting(const CsvRow& line) {
  std::size_t i = 0;
  while (i < line.size() && line[i].empty()) ++i;
  const std::string label = i < line.size() ? folded(line[i]) : std::string();
  for (const std::string_view name :
       {"length",    "samples", "samplecount",     "numberofsamples", "datatype", "range",       "offset",
        "gain",      "factor",  "scale",           "coefficient",     "coeff",    "calibration", "sensitivity",
        "increment", "channel", "channelno",       "anzahl",          "bereich",  "messbereich", "faktor",
        "lange",     "laenge",  "kalibrierfaktor", "レンジ",          "校正係数", "オフセット",  "感度"})
    if (label == name) return true;
  return false;
}

/// Finds where the rows below the headings begin, and whether only such follow. Skips lines of words, as Origin writes
/// them, and of settings.
void set_first_row(std::string_view text, const Lines& lines, const NumberRows& rows, const HeadingLine& at,
                   Table& table) {
  std::size_t begin = at.index ? *at.index + 1 : at.first_row;
  for (; begin < at.first_row; ++begin) {
    const CsvRow& line = lines[begin];
    if (line.is_comment() || line.line() == table.units_line) continue;
    if (has_a_number(line) && !is_setting(line)) break;
    table.passed_over.push_back(line.line());
  }
  for (; begin >= at.first_row && begin + 1 < lines.size() && is_setting(lines[begin]); ++begin)
    table.passed_over.push_back(lines[begin].line());
  table.offset = static_cast<std::size_t>(lines[begin].raw().data() - text.data());
  table.line = lines[begin].line();
  table.only_rows = begin >= rows.only_from;
}

/// Where the headings are those of runs side by side, leaves those of the first. Not where blanks part the columns,
/// which may be empty, where a mapping counts them, or where the units differ.
void find_runs_beside(const Lines& lines, const HeadingLine& at, const ColumnRules& rules, Table& table) {
  const std::size_t width =
      !at.index || rules.log || table.format.delimiter == kBlanks ? 0 : width_of_runs(at.headings);
  if (width == 0 || counts_columns(rules)) return;
  constexpr std::size_t kAbove = 12;  // lines that may hold units
  for (std::size_t i = *at.index - std::min(*at.index, kAbove); i < at.first_row; ++i)
    for (std::size_t k = width; k < lines[i].size(); ++k)
      if (is_row_of_units(lines[i], {}) && lines[i][k] != lines[i][k - width]) return;
  const std::size_t count = (at.headings.size() + width - 1) / width;
  table.beside = {width, names_of_runs(lines, *at.index, width, count)};
  table.headings.resize(width);
}

/// Whether a word is the label of a row that summarises those above it.
bool names_a_summary(std::string_view text) {
  const std::string bare = folded(text);
  for (const std::string_view name :
       {"mean", "average", "median", "sd", "std", "stdev", "stddev", "min", "minimum", "max", "maximum", "sum",
        "mittelwert", "standardabweichung", "moyenne", "ecarttype", "media", "promedio", "desviacion"})
    if (bare == name) return true;
  return false;
}

/// The line of the first row of the summary at the end: rows with such a label, as ImageJ's "Mean" below its results,
/// or with words where all other rows have numbers that are not read. 0 if there are no such rows, or too many.
std::size_t find_summary(const Lines& lines, std::size_t first_row, const Indices& columns, const Table& table) {
  constexpr std::size_t kMostRows = 8, kLeastRows = 3;
  std::optional<std::size_t> runs;  // the column with names of runs, which may be any word
  for (std::size_t i = 0; i < table.headings.size(); ++i)
    if (column_named(table.headings[i].name) == ColumnId::curve) runs = i;
  const std::size_t n = lines.size();
  const auto numbers_above = [&](std::size_t k) {  // in all rows except those at the end
    for (std::size_t row = first_row; row + kMostRows < n || row < first_row + kLeastRows; ++row)
      if (k >= lines[row].size() || !is_number(lines[row][k])) return false;
    return true;
  };
  const auto is_summary = [&](const CsvRow& line) {
    for (std::size_t k = 0; k < line.size() && is_row_of_numbers(line); ++k) {
      const std::string_view text = line[k];
      if (k == runs || text.empty() || is_missing(text) || is_number(text)) continue;
      const bool is_read = std::count(columns.begin(), columns.end(), k) > 0;
      if (names_a_summary(text) || (!is_read && numbers_above(k))) return true;
    }
    return false;
  };
  std::size_t first = n;
  while (first > first_row + kLeastRows && n - first < kMostRows && is_summary(lines[first - 1])) --first;
  return first < n ? lines[first].line() : 0;
}

/// The table found with one separator.
struct Candidate {
  Table table;
  Indices columns;  // of numbers that are read; empty: the headings name no known quantity
  Reading reading;
};

/// Guesses what the lines are, in an order in which each step depends only on earlier results. The separator comes
/// first, since nothing can be recognised in a line that is not split. A wrong one misleads all other steps, so
/// find_table tries every separator and chooses the table that explains most.
///
/// 1. Rows of numbers, by the number of fields that most of them have: every table has these.
/// 2. Headings: the line above the rows that names most quantities. This decides which column is which (name_columns).
/// 3. The row of units: a word is a unit only if it fits the heading of its column.
/// 4. The columns again: with its unit a heading may mean another quantity; "T" in degrees is not a force.
/// 5. The first row: a line with numbers that is neither headings nor units is data, so that no data are lost.
/// 6. The summary at the end: it has labels, or words in columns of numbers that are not read, so these must be known.
/// 7. The decimal sign: only numbers that are read count, as dates or versions beside them would mislead.
///
/// Null if there are no rows or no headings.
std::optional<Candidate> guess(const std::string& path, std::string_view text, std::size_t first_line,
                               const CsvFormat& format, const ColumnRules& rules, char decimal) {
  const Lines lines = split_rows(text, first_line, format);
  const NumberRows rows(lines);
  if (rows.widths.empty()) return std::nullopt;
  const auto at = find_headings(path, lines, rows, rules);
  if (!at) return std::nullopt;
  Candidate made;
  Table& table = made.table;
  table.format = format;
  table.headings = at->headings;
  table.header_line = at->index ? lines[*at->index].line() : 0;
  find_runs_beside(lines, *at, rules, table);
  made.columns = indices_of_numbers(path, table.headings, rules);
  table.units_line = take_row_of_units(path, lines, *at, made.columns, rules, table.headings);
  if (table.units_line > 0) made.columns = indices_of_numbers(path, table.headings, rules);
  set_first_row(text, lines, rows, *at, table);
  table.summary_line = find_summary(lines, at->first_row, made.columns, table);
  if (made.columns.empty()) return made;
  // if commas separate columns, the decimal sign of a field without quotes is a point
  if (decimal == 0 && format.delimiter == ',' && text.find('"') == std::string_view::npos) decimal = '.';
  made.reading = decimal == 0 ? read_numbers(path, lines, at->first_row, made.columns)
                              : read_numbers(lines, at->first_row, made.columns, decimal);
  return made;
}

std::string name_of(char delimiter) {
  return delimiter == ';'    ? "semicolons"
         : delimiter == '|'  ? "bars"
         : delimiter == '\t' ? "tabs"
         : delimiter == ','  ? "commas"
                             : "blanks";
}

/// The decimal sign that a line above a table of LabVIEW states, "Decimal_Separator ,"; 0 if there is none.
char stated_sign(std::string_view start) {
  if (!start.starts_with("LabVIEW Measurement")) return 0;
  constexpr std::string_view kName = "Decimal_Separator";
  const std::size_t at = start.find(kName);
  if (at == std::string_view::npos) return 0;
  // behind the tab or comma that parts the columns
  const std::string_view value = start.substr(std::min(at + kName.size() + 1, start.size()));
  return value.starts_with(',') ? ',' : value.starts_with('.') ? '.' : 0;
}

}  // namespace

std::optional<Table> find_table(const std::string& path, std::string_view start, char line_end,
                                const ColumnRules& rules, char decimal) {
  if (decimal == 0) decimal = stated_sign(start);
  std::string delimiters = ";\t,| ";
  std::string_view text = start;
  std::size_t before = 0, first_line = 1;  // counts Excel's line "sep=;" above the table
  if (const std::string_view first = text.substr(0, text.find(line_end));
      first.starts_with("sep=") && first.size() > 4) {
    delimiters = first[4];
    before = std::min(first.size() + 1, text.size());
    first_line = 2;
    text.remove_prefix(before);
  }
  const bool cut = text.size() > kSearched;
  if (cut) text = text.substr(0, text.find_last_of("\r\n", kSearched) + 1);
  std::optional<Candidate> best;
  for (const char delimiter : delimiters) {
    const bool is_there = text.find(delimiter) != std::string_view::npos ||
                          (delimiter == kBlanks && text.find('\t') != std::string_view::npos);
    if (!is_there) continue;
    if (delimiter == kBlanks && best && !best->columns.empty()) continue;  // any other separator explains more
    CsvFormat format;
    format.delimiter = delimiter;
    format.line_end = line_end;
    auto made = guess(path, text, first_line, format, rules, decimal);
    const auto merit = [](const Candidate& one) { return std::pair(one.columns.size(), one.reading.valid_rows); };
    if (made && (!best || merit(*made) > merit(*best))) best = std::move(made);
  }
  if (!best) return std::nullopt;
  Table table = std::move(best->table);
  table.format.decimal = best->reading.decimal;
  table.format.grouped = best->reading.grouped || (decimal != 0 && best->reading.in_threes > 0);
  table.offset += before;
  if (cut) table.summary_line = 0;  // these rows may not be the last
  return table;
}

std::string describe(const Table& table) {
  std::string text = name_of(table.format.delimiter);
  if (table.beside.width > 0) text += ", " + std::to_string(table.beside.names.size()) + " runs side by side";
  if (table.format.decimal == ',') text += ", decimal commas";
  if (table.format.grouped) text += ", digits in groups of three";
  if (table.units_line > 0) text += ", units in line " + std::to_string(table.units_line);
  if (table.summary_line > 0) text += ", a summary from line " + std::to_string(table.summary_line) + " left out";
  for (const std::size_t line : table.passed_over) text += ", line " + std::to_string(line) + " passed over";
  if (table.header_line > 1) text += ", headings in line " + std::to_string(table.header_line);
  return text;
}

}  // namespace mixity
