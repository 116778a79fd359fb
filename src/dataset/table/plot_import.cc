#include "dataset/table/plot_import.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/files.h"
#include "base/input_error.h"
#include "base/number_text.h"
#include "base/text.h"
#include "dataset/table/columns.h"
#include "dataset/table/csv_file.h"

namespace mixity {
namespace {

struct Series {
  std::string name;
  std::vector<std::pair<std::string, std::string>> points;  // as written, so that no digit changes
};

/// A number as written; empty if the field is empty or missing. Throws for anything else.
std::string number_field(const std::string& path, const CsvRow& row, std::size_t i) {
  const std::string text(i < row.size() ? row[i] : std::string_view());
  if (!text.empty() && !std::isfinite(parse_number(text).value_or(std::nan(""))))
    throw InputError(path, row.place(i),
                     "'" + text + "' is not a finite number" + std::string(decimal_comma_hint(text)));
  return text;
}

std::vector<Series> read_series(const std::string& path) {
  std::vector<Series> series;
  std::size_t rows = 0;
  read_csv_text(read_file(path), path, false, [&](const CsvRow& row) {
    if (++rows == 1) {
      for (std::size_t i = 0; i < row.size(); i += 2) {
        const std::string name(row[i]);
        if (name.empty() && i + 1 >= row.size()) break;
        if (i + 1 < row.size() && parse_number(row[i]) && parse_number(row[i + 1]))
          throw InputError(path, row.place(i), "the first row holds a point where the data sets' names are wanted");
        series.push_back({name.empty() ? "data set " + std::to_string(i / 2 + 1) : name, {}});
        const auto same = [&](const Series& other) { return other.name == series.back().name; };
        if (std::any_of(series.begin(), series.end() - 1, same))
          throw InputError(path, row.place(i),
                           "a second data set is named '" + printable(series.back().name, 60) + "'");
      }
      return;
    }
    if (rows == 2 && !row[0].empty() && !holds_a_number(row)) return;  // the labels X,Y
    for (std::size_t i = 2 * series.size(); i < row.size(); ++i)
      if (!row[i].empty()) throw InputError(path, row.place(i), "a value stands beyond the last named data set");
    for (std::size_t k = 0; k < series.size(); ++k) {
      const std::string x = number_field(path, row, 2 * k), y = number_field(path, row, 2 * k + 1);
      if (x.empty() && y.empty()) continue;
      if (x.empty() || y.empty())
        throw InputError(path, row.place(2 * k + (x.empty() ? 0 : 1)),
                         "data set '" + series[k].name + "' has one coordinate of a point without the other");
      series[k].points.emplace_back(x, y);
    }
  });
  if (rows == 0) throw InputError(path, 1, 1, "is empty: a row with the data sets' names is missing");
  return series;
}

}  // namespace

std::string import_plot(const std::string& path, const PlotImport& options) {
  const std::vector<Series> series = read_series(path);
  const bool with_loads = !options.loads.empty();
  if (with_loads && options.loads.size() != series.size())
    throw InputError(path, 1, 1,
                     "holds " + std::to_string(series.size()) + " data sets, but " +
                         std::to_string(options.loads.size()) +
                         (options.loads.size() == 1 ? " load was given" : " loads were given"));
  std::string text = "curve,";
  if (with_loads) {
    const Unit& unit = options.loads.front().unit;
    text += unit.text.empty() ? "P," : "P [" + unit.text + "],";
  }
  text += options.x_column + "," + options.y_column + "\n";
  // the header must be readable as two axes with units that fit
  const std::string name = path + ": the header '" + text.substr(0, text.size() - 1) + "'";
  read_csv_text(text, name, true, [&](const CsvRow& header) {
    const std::vector<Heading> headings = headings_of(header);
    for (const Heading& heading : headings)
      if (const std::string& axis = heading.name; !with_loads && (axis == "T" || axis == "A" || axis == "a"))
        throw InputError(path, "needs the normal load of each data set beside the axis " + axis + " (" +
                                   Remedy::fill_in("loads") + ")");
    ColumnRules own_names;
    own_names.vocabulary = false;
    const Columns columns(name, headings, own_names);
    if (header.size() != (with_loads ? 4u : 3u) || !columns.ignored.empty() || columns.holds_loads() != with_loads)
      throw InputError(name, "does not name two axes of one kind: T and A (or a) with loads, or psi and Gc without");
  });
  if (std::all_of(series.begin(), series.end(), [](const Series& one) { return one.points.empty(); }))
    throw InputError(path, 2, 1, "holds no points");
  for (std::size_t k = 0; k < series.size(); ++k)
    for (const auto& [x, y] : series[k].points) {
      text += csv_field(series[k].name) + ",";
      if (with_loads) text += shortest(options.loads[k].value) + ",";
      text += x + "," + y + "\n";
    }
  return text;
}

}  // namespace mixity
