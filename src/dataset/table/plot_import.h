// Converts a WebPlotDigitizer export of several data sets to a mixity CSV.
#pragma once

#include <string>
#include <vector>

#include "base/units.h"

namespace mixity {

struct PlotImport {
  std::string x_column, y_column;  // headers with units: "T [mN]", "A [mm^2]"
  std::vector<Quantity> loads;     // one per data set of the export, all in the same unit; empty for psi against Gc
};

/// The CSV text. The export holds the data sets' names in its first row, each over an X,Y pair of columns, then a row
/// of X,Y labels, then the points, shorter data sets padded with empty fields. Throws InputError with file, line and
/// column for anything else, for a number of loads that differs from the number of data sets, and for headers that
/// mixity would not read back.
std::string import_plot(const std::string& path, const PlotImport& options);

}  // namespace mixity
