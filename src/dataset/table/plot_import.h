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

/// The CSV text. The first row of the export has the names of the data sets, each over an X,Y pair of columns; then
/// come a row of X,Y labels and the points, shorter data sets padded with empty fields. Throws InputError with file,
/// line and column for anything else, for a number of loads that is not that of the data sets, and for headers that
/// mixity would not read back.
std::string import_plot(const std::string& path, const PlotImport& options);

}  // namespace mixity
