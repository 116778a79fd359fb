// Finds which columns of an exported plot belong together.
#pragma once

#include <string>
#include <vector>

#include "dataset/table/csv.h"
#include "dataset/table/plot_series.h"

namespace mixity {

/// Rows of an exported plot with one row of names: the first has names, the second may have labels or units.
struct PlotRows {
  std::vector<CsvRow> rows;
  std::size_t first = 0;  // the first row of numbers
  std::size_t width = 0;  // number of columns, up to the last that is not empty

  std::string text(std::size_t row, std::size_t column) const {
    return std::string(column < rows[row].size() ? rows[row][column] : std::string_view());
  }
};

/// Decides between pairs and shared by the names, then by the gaps: a shared x has none, and a pair lacks both numbers
/// or neither. `x_column`: the heading of the axis. Throws InputError, showing both readings, if these do not decide.
PlotLayout layout_of(const std::string& path, const PlotRows& plot, const std::string& x_column);

}  // namespace mixity
