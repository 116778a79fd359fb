#include "dataset/table/plot_series.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>

#include "base/input_error.h"
#include "base/number_text.h"
#include "base/text.h"
#include "dataset/table/columns.h"
#include "dataset/table/csv_file.h"
#include "dataset/table/decimal_sign.h"
#include "dataset/table/header_lines.h"
#include "dataset/table/number.h"
#include "dataset/table/plot_layout.h"

namespace mixity {
namespace {

/// The separator with which most rows contain only numbers; that of the first row if there are no such rows.
char delimiter_of(std::string_view text, std::size_t line, const CsvFormat& first) {
  CsvFormat format = first;
  char best = first.delimiter;
  std::size_t most = 0;
  for (const char delimiter : {first.delimiter, ';', '\t', ','}) {
    format.delimiter = delimiter;
    std::size_t rows = 0;
    for (const CsvRow& row : split_rows(text, line, format)) {
      std::size_t numbers = 0, empty = 0;
      for (std::size_t i = 0; i < row.size(); ++i) {
        numbers += is_number(row[i]);
        empty += row[i].empty();
      }
      rows += numbers > 0 && row.size() > 1 && numbers + empty == row.size();
    }
    if (rows <= most) continue;
    most = rows;
    best = delimiter;
  }
  return best;
}

std::vector<CsvRow> rows_of(std::string_view text, const std::string& path, const CsvFormat& format, std::size_t line) {
  CsvSplitter splitter(path, format, line);
  std::vector<CsvRow> rows;
  for (CsvRow row; splitter.next(text, true, row);) rows.push_back(std::move(row));
  return rows;
}

/// Whether a row has the headings of further data sets, "x,Curve2": its first cell is that of the first headings, or it
/// has only words, which are several or below a blank line.
bool begins_a_block(const std::vector<CsvRow>& rows, std::size_t i, bool below_numbers) {
  const CsvRow& row = rows[i];
  if (row.blank() || !begins_with_words(row)) return false;
  const std::string name = folded(row[0]);
  if (count_filled(row) >= 2 && !name.empty() && name == folded(rows[0][0])) return true;
  return below_numbers && !has_a_number(row) &&
         (count_filled(row) >= 2 || (count_filled(row) == 1 && row.line() > rows[i - 1].line() + 1));
}

/// The blocks of rows below one another, each with names of its own.
std::vector<PlotRows> blocks_of(std::vector<CsvRow> rows) {
  std::vector<std::size_t> begins{0};
  bool numbers = false;  // in the block so far
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const bool begins_one = begins_a_block(rows, i, numbers);
    if (begins_one) begins.push_back(i);
    numbers = !begins_one && (numbers || has_a_number(rows[i]));
  }
  begins.push_back(rows.size());
  std::vector<PlotRows> blocks(begins.size() - 1);
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    PlotRows& block = blocks[k];
    const auto row = [&](std::size_t i) {
      return std::make_move_iterator(rows.begin() + static_cast<std::ptrdiff_t>(i));
    };
    block.rows.assign(row(begins[k]), row(begins[k + 1]));
    const bool labelled = block.rows.size() > 1 && !block.rows[1][0].empty() && !has_a_number(block.rows[1]);
    block.first = labelled ? 2 : 1;
    for (const CsvRow& one : block.rows)
      for (std::size_t i = block.width; i < one.size(); ++i)
        if (!one[i].empty()) block.width = i + 1;
  }
  return blocks;
}

/// Splits the text, and finds the decimal sign as find_table does.
std::vector<PlotRows> split_plot(std::string_view text, const std::string& path, char decimal) {
  CsvFormat format;
  format.comments = false;  // "#1" is a name
  if (text.find('\n') == std::string_view::npos) format.line_end = '\r';
  std::size_t line = 1;
  if (!find_first_row(text, line, format))
    throw InputError(path, 1, 1, "is empty: a row with the data sets' names is missing");
  format.delimiter = delimiter_of(text, line, format);
  const std::vector<CsvRow> rows = rows_of(text, path, format, line);
  std::size_t width = 0;
  for (const CsvRow& row : rows) width = std::max(width, row.size());
  std::vector<std::size_t> columns(width);
  std::iota(columns.begin(), columns.end(), 0);
  if (decimal == 0 && format.delimiter == ',' && text.find('"') == std::string_view::npos) decimal = '.';
  const Reading reading = decimal == 0 ? read_numbers(path, rows, 1, columns) : read_numbers(rows, 1, columns, decimal);
  format.decimal = reading.decimal;
  format.grouped = reading.grouped || (decimal != 0 && reading.in_threes > 0);
  return blocks_of(rows_of(text, path, format, line));
}

/// A number with its digits unchanged; empty if there is none. Throws for anything else.
std::string number_field(const std::string& path, const CsvRow& row, std::size_t i) {
  std::string text(i < row.size() ? row[i] : std::string_view());
  if (text.empty() || is_missing(text)) return {};
  double value = 0;
  if (!row.number(i, value) || !std::isfinite(value))
    throw InputError(path, row.place(i),
                     "'" + text + "' is not a finite number" +
                         std::string(row.decimal() == '.' ? decimal_comma_hint(text) : std::string_view()));
  double plain = 0;  // with a decimal point, as in the written file
  if (parse_number(text, plain)) return text;
  if (row.decimal() == ',') std::replace(text.begin(), text.end(), ',', '.');
  return parse_number(text, plain) && plain == value ? text : shortest(value);
}

/// Whether all pairs have the same text over their columns that are `offset` from their first.
bool is_label(const PlotRows& plot, std::size_t offset) {
  for (std::size_t i = offset; i < plot.width; i += 2)
    if (plot.text(0, i).empty() || plot.text(0, i) != plot.text(0, offset)) return false;
  return true;
}

/// The column of each pair with the names above: usually x; null if there are only labels.
std::optional<std::size_t> column_of_name(const PlotRows& plot, std::size_t x) {
  bool all_y = plot.width > 2;
  for (std::size_t i = 1; i < plot.width; i += 2) all_y &= !plot.text(0, i).empty();
  if (all_y && is_label(plot, 0)) return is_label(plot, 1) ? std::nullopt : std::optional(x + 1);
  return plot.text(0, x).empty() && !plot.text(0, x + 1).empty() ? x + 1 : x;
}

/// The name of the next data set.
std::string name_over(const std::string& path, const PlotRows& plot, std::optional<std::size_t> column,
                      const std::vector<PlotSeries>& before) {
  std::string name = column ? plot.text(0, *column) : std::string();
  if (name.empty()) name = "data set " + std::to_string(before.size() + 1);
  if (std::any_of(before.begin(), before.end(), [&](const PlotSeries& other) { return other.name == name; }))
    throw InputError(path, plot.rows[0].place(column.value_or(0)),
                     "a second data set is named '" + printable(name, 60) + "'");
  return name;
}

/// Adds the columns x and y of each data set to those of the blocks above.
void add_columns(const std::string& path, const PlotRows& plot,
                 const std::vector<std::pair<std::size_t, std::size_t>>& columns, bool shared,
                 std::vector<PlotSeries>& series) {
  const std::size_t before = series.size();
  for (const auto& [x, y] : columns)
    series.push_back({name_over(path, plot, shared ? y : column_of_name(plot, x), series), {}});
  for (std::size_t i = plot.first; i < plot.rows.size(); ++i) {
    const CsvRow& row = plot.rows[i];
    for (std::size_t k = columns.back().second + 1; k < row.size(); ++k)
      if (!row[k].empty()) throw InputError(path, row.place(k), "a value stands beyond the last named data set");
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const auto [at_x, at_y] = columns[k];
      PlotSeries& one = series[before + k];
      const std::string x = number_field(path, row, at_x), y = number_field(path, row, at_y);
      if (y.empty() && (x.empty() || shared)) continue;
      if (x.empty() || y.empty())
        throw InputError(path, row.place(x.empty() ? at_x : at_y),
                         "data set '" + one.name + "' has one coordinate of a point without the other");
      one.points.emplace_back(x, y);
    }
  }
}

}  // namespace

std::vector<PlotSeries> read_plot(const std::string& path, PlotLayout layout, const std::string& x_column,
                                  const SheetChoice& choice) {
  const std::string text = read_text(path, choice);
  std::vector<PlotSeries> series;
  for (const PlotRows& plot : split_plot(text, path, choice.decimal)) {
    const CsvRow& names = plot.rows[0];
    bool is_point = names.size() > 1;
    for (std::size_t i = 0; i < names.size(); ++i) is_point &= is_number(names[i]);
    if (is_point)
      throw InputError(path, names.place(0), "the first row holds a point where the data sets' names are wanted");
    const bool shared = (layout == PlotLayout::found ? layout_of(path, plot, x_column) : layout) == PlotLayout::shared;
    std::vector<std::pair<std::size_t, std::size_t>> columns;
    if (shared)
      for (std::size_t y = 1; y < plot.width; ++y) columns.emplace_back(0, y);
    else
      for (std::size_t x = 0; x < std::min(plot.width, names.size()); x += 2) {
        if (plot.text(0, x).empty() && x + 1 >= names.size()) break;  // no comma after the last name
        columns.emplace_back(x, x + 1);
      }
    if (columns.empty()) throw InputError(path, names.place(0), "holds no points");
    add_columns(path, plot, columns, shared, series);
  }
  return series;
}

}  // namespace mixity
