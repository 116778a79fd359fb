#include "dataset/table/table.h"

#include <cmath>

#include "base/input_error.h"
#include "base/number_text.h"
#include "base/printable.h"
#include "base/trim.h"
#include "dataset/table/clock_time.h"
#include "dataset/table/csv_rows.h"
#include "dataset/table/number.h"
#include "dataset/table/partition.h"

namespace mixity {
namespace {

constexpr std::size_t kLooked = std::size_t{1} << 16;  // bytes of the start that are looked at

/// The numbers that a cut gives with one decimal sign.
struct Reading {
  char decimal = '.';
  std::size_t valid = 0;  // rows
  bool grouped = false;   // some numbers are, surely
  // Numbers with a point or comma, those of them that may be groups of three, and those without.
  std::size_t signs = 0, in_threes = 0, bare = 0;
  std::vector<double> values;                                 // of all rows, NaN where there is none
  std::vector<std::pair<std::size_t, std::size_t>> places{};  // of the values: line, field

  bool doubtful() const { return in_threes > 0; }
};

Reading read(const Partition& cut, char decimal) {
  Reading reading;
  reading.decimal = decimal;
  for (std::size_t i = cut.first; i < cut.lines.size(); ++i) {
    const Line& line = cut.lines[i];
    if (line.comment) continue;
    bool valid = true;
    for (const std::size_t k : cut.wanted) {
      double value = std::nan("");
      NumberStyle style;
      if (k >= line.fields.size() ||
          (!trim(line.fields[k]).empty() && !parse_number(line.fields[k], decimal, value, &style) &&
           !parse_clock(line.fields[k])))
        valid = false;
      reading.grouped |= style.grouped && !style.doubtful;
      reading.in_threes += style.doubtful;
      const bool has_sign = k < line.fields.size() && line.fields[k].find_first_of(".,") != std::string::npos;
      reading.signs += has_sign;
      reading.bare += !has_sign && value == value;
      reading.values.push_back(value);
      reading.places.emplace_back(i, k);
    }
    reading.valid += valid;
  }
  return reading;
}

std::string name_of(char delimiter) {
  return delimiter == ';'    ? "semicolons"
         : delimiter == '|'  ? "bars"
         : delimiter == '\t' ? "tabs"
         : delimiter == ','  ? "commas"
                             : "blanks";
}

/// Throws if both fit and differ.
const Reading& better(const std::string& path, const Partition& cut, const Reading& point, const Reading& comma) {
  if (point.valid != comma.valid) return point.valid > comma.valid ? point : comma;
  for (std::size_t i = 0; i < point.values.size(); ++i) {
    const double one = point.values[i], other = comma.values[i];
    if (one == other || (std::isnan(one) && std::isnan(other))) continue;
    // "1.234" without any comma has a decimal point; where semicolons part columns, "1,234" has a decimal comma: unless
    // all have three digits there, and others none, as integers in groups would
    const auto all_in_threes = [](const Reading& groups) {
      return groups.in_threes == groups.signs && groups.bare > 0;
    };
    if (comma.doubtful() && !comma.grouped && !all_in_threes(comma)) return point;
    if (point.doubtful() && !point.grouped && cut.table.format.delimiter == ';' && !all_in_threes(point)) return comma;
    const auto [line, field] = point.places[i];
    const Line& row = cut.lines[line];
    const std::string& text = row.fields[field];
    throw InputError(path, places_of(row, cut.table.format)[field],
                     "'" + printable(text, 40) + "' may be " + shortest(comma.values[i]) + " (decimal comma) or " +
                         shortest(point.values[i]) +
                         (text.find('.') == std::string::npos ? " (comma between thousands)" : " (decimal point)") +
                         "; say which: --decimal=\",\" or --decimal=\".\"");
  }
  return point;
}

}  // namespace

std::optional<Table> find_table(const std::string& path, std::string_view start, char line_end,
                                const ColumnRules& rules, char decimal) {
  std::string delimiters = ";\t,| ";
  std::string_view text = start;
  std::size_t before = 0, first_line = 1;  // Excel's "sep=;", which a table may begin with
  if (const std::string_view first = text.substr(0, text.find(line_end));
      first.starts_with("sep=") && first.size() > 4) {
    delimiters = first[4];
    before = std::min(first.size() + 1, text.size());
    first_line = 2;
    text.remove_prefix(before);
  }
  const bool cut = text.size() > kLooked;
  if (cut) text = text.substr(0, text.rfind(line_end, kLooked) + 1);
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
    // where commas part columns, the sign of a field without quotes is a point
    const bool commas = delimiter != ',' || text.find('"') != std::string_view::npos;
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
    table.format.grouped = best->grouped || (decimal != 0 && best->doubtful());
  }
  table.offset += before;
  if (cut) table.summary_line = 0;  // the end was not seen
  return std::move(table);
}

std::string describe(const Table& table) {
  std::string text = name_of(table.format.delimiter);
  if (table.format.decimal == ',') text += ", decimal commas";
  if (table.format.grouped) text += ", digits in groups of three";
  if (table.units_line > 0) text += ", units in line " + std::to_string(table.units_line);
  if (table.summary_line > 0) text += ", a summary from line " + std::to_string(table.summary_line) + " left out";
  for (const std::size_t line : table.passed_over) text += ", line " + std::to_string(line) + " passed over";
  if (table.header_line > 1) text += ", headings in line " + std::to_string(table.header_line);
  return text;
}

}  // namespace mixity
