#include "dataset/table/plot_layout.h"

#include <algorithm>
#include <optional>
#include <set>

#include "base/input_error.h"
#include "base/text.h"
#include "dataset/table/number.h"
#include "dataset/table/vocabulary.h"

namespace mixity {
namespace {

/// Whether the cells of a row are alike from pair to pair: "X,Y,X,Y", "dry,dry,wet,wet", "dry x,dry y,wet x,wet y". In
/// each pair, the rest after the common beginning, or before the common end, is the same.
bool repeats_in_pairs(const PlotRows& plot, std::size_t row) {
  if (plot.width < 4 || plot.width % 2 != 0) return false;
  for (const bool reversed : {false, true}) {
    std::optional<std::pair<std::string, std::string>> rests;
    bool alike = true, has_stems = true;
    for (std::size_t i = 0; i < plot.width && alike; i += 2) {
      std::string x = plot.text(row, i), y = plot.text(row, i + 1);
      if (x.empty() || y.empty()) return false;
      if (reversed) {
        std::reverse(x.begin(), x.end());
        std::reverse(y.begin(), y.end());
      }
      std::size_t stem = 0;
      while (stem < std::min(x.size(), y.size()) && x[stem] == y[stem]) ++stem;
      has_stems &= stem > 0;
      const std::pair both(x.substr(stem), y.substr(stem));
      alike = !rests || *rests == both;
      rests = both;
    }
    if (alike && (has_stems || rests->first != rests->second)) return true;
  }
  return false;
}

/// Whether every other name, and only these, is the same except for a number: "x,dry,x,wet", "x1,dry,x2,wet".
bool repeats_x(const PlotRows& plot) {
  std::set<std::string> names[2];
  for (std::size_t i = 0; i < plot.width; ++i) {
    std::string letters = folded(plot.text(0, i));
    std::erase_if(letters, is_digit);
    names[i % 2].insert(letters);
  }
  return plot.width > 2 && names[0].size() == 1 && !names[1].contains(*names[0].begin());
}

/// Whether every row has both numbers of each pair, or neither.
bool is_complete_in_pairs(const PlotRows& plot) {
  for (std::size_t row = plot.first; row < plot.rows.size(); ++row)
    for (std::size_t i = 0; i < plot.width; i += 2)
      if (plot.text(row, i).empty() != plot.text(row, i + 1).empty()) return false;
  return true;
}

bool has_x_in_each_row(const PlotRows& plot) {
  for (std::size_t row = plot.first; row < plot.rows.size(); ++row)
    for (std::size_t i = 1; i < plot.width && plot.text(row, 0).empty(); ++i)
      if (!plot.text(row, i).empty()) return false;
  return true;
}

/// The quantity that a heading names; null if it names none.
std::optional<ColumnId> quantity_of(const Heading& heading) {
  if (const auto own = column_named(heading.name)) return own;
  const auto read = Vocabulary::shipped().read(heading, 0);
  return read ? std::optional(read->id) : std::nullopt;
}

/// Whether the first column has the name of the axis.
bool names_the_axis(const PlotRows& plot, const std::string& x_column) {
  const Heading heading = split_heading(plot.text(0, 0), {}), axis = split_heading(x_column, {});
  const std::string name = folded(heading.name);
  const auto quantity = quantity_of(heading);
  return name.empty() || name == "x" || name == folded(axis.name) || (quantity && quantity == quantity_of(axis));
}

std::string quoted(const std::string& name) { return "'" + printable(name, 40) + "'"; }

[[noreturn]] void refuse(const std::string& path, const PlotRows& plot) {
  std::string shared, pairs;
  for (std::size_t i = 1; i < plot.width; ++i) shared += (i == 1 ? "" : ", ") + quoted(plot.text(0, i));
  for (std::size_t i = 0; i < plot.width; i += 2) pairs += (i == 0 ? "" : ", ") + quoted(plot.text(0, i));
  throw InputError(path, plot.rows[0].place(0),
                   "the columns may be one x, " + quoted(plot.text(0, 0)) + ", with the data sets " + shared +
                       ", or pairs x, y of the data sets " + pairs + "; say which: " + Remedy::set("layout", "shared") +
                       " or " + Remedy::set("layout", "pairs"));
}

}  // namespace

PlotLayout layout_of(const std::string& path, const PlotRows& plot, const std::string& x_column) {
  bool over_x = false, over_y = false, all = plot.width > 1;  // where names are placed
  for (std::size_t i = 0; i < plot.width; ++i) {
    const bool named = !plot.text(0, i).empty();
    (i % 2 == 0 ? over_x : over_y) |= named;
    if (i > 0) all &= named;
  }
  if (!all && !(over_x && over_y)) return PlotLayout::pairs;
  if (!all) refuse(path, plot);
  if (repeats_x(plot) || repeats_in_pairs(plot, 0) || (plot.first == 2 && repeats_in_pairs(plot, 1)))
    return PlotLayout::pairs;
  if (plot.width == 2 || !is_complete_in_pairs(plot)) return PlotLayout::shared;  // two columns are the same points
  if (!has_x_in_each_row(plot)) return PlotLayout::pairs;
  if (!names_the_axis(plot, x_column)) refuse(path, plot);
  return PlotLayout::shared;
}

}  // namespace mixity
