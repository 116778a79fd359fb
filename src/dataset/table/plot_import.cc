#include "dataset/table/plot_import.h"

#include <algorithm>

#include "base/input_error.h"
#include "base/number_text.h"
#include "base/text.h"
#include "dataset/table/columns.h"
#include "dataset/table/csv_file.h"

namespace mixity {
std::string import_plot(const std::string& path, const PlotImport& options) {
  const std::vector<PlotSeries> series =
      read_plot(path, options.layout, options.x_column, {options.sheet, options.decimal});
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
  // the header must be readable as two axes with fitting units
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
  if (std::all_of(series.begin(), series.end(), [](const PlotSeries& one) { return one.points.empty(); }))
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
