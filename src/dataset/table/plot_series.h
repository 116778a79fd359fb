// The data sets of a plot, as plot digitisers export them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "dataset/table/spreadsheet.h"

namespace mixity {

enum class PlotLayout {
  found,   // as inferred from the file
  pairs,   // columns x, y for each data set, as WebPlotDigitizer writes them
  shared,  // one column x, and one column y for each data set, as Engauge writes them
};

struct PlotSeries {
  std::string name;
  std::vector<std::pair<std::string, std::string>> points;  // digits as written, with a decimal point
};

/// Reads an exported plot. The first row has the names of the data sets; a row of words may follow, then the numbers in
/// the formats of find_table. Other names with numbers may stand below them. A data set may lack points. Throws
/// InputError with file, line and column for anything else, for repeated names, and for a file that fits both layouts.
std::vector<PlotSeries> read_plot(const std::string& path, PlotLayout layout, const std::string& x_column,
                                  const SheetChoice& choice = {});

}  // namespace mixity
