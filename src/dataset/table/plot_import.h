// Converts the output of a plot digitiser, such as WebPlotDigitizer or Engauge, to a mixity CSV.
#pragma once

#include <string>
#include <vector>

#include "base/units.h"
#include "dataset/table/plot_series.h"

namespace mixity {

struct PlotImport {
  std::string x_column, y_column;  // headers with units: "T [mN]", "A [mm^2]"
  std::vector<Quantity> loads;     // one per data set of the file, all in the same unit; empty for psi against Gc
  PlotLayout layout = PlotLayout::found;
  char decimal = 0;     // '.' or ','; 0: inferred from the numbers
  std::string sheet{};  // of a workbook: name or number; empty: inferred from the headings
};

/// The CSV text of the data sets found by read_plot. Throws InputError as read_plot does, if the number of loads is not
/// that of the data sets, and for headers that mixity would not read back.
std::string import_plot(const std::string& path, const PlotImport& options);

}  // namespace mixity
