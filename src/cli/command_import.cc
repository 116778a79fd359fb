// mixity import: converts a WebPlotDigitizer export to a data CSV.
#include "cli/commands.h"
#include "cli/flags.h"
#include "dataset/table/plot_import.h"

DEFINE_string(x, "", "header of the column on the x axis, with its unit: \"T [mN]\"");
DEFINE_string(y, "", "header of the column on the y axis, with its unit: \"A [mm^2]\"");

namespace mixity::cli {

int run_import(const Arguments& arguments) {
  if (arguments.size() != 1) throw UsageError("import needs one WebPlotDigitizer CSV (see mixity help import)");
  if (FLAGS_x.empty() || FLAGS_y.empty()) throw UsageError("import needs the axes: --x=\"T [mN]\" --y=\"A [mm^2]\"");
  PlotImport options{FLAGS_x, FLAGS_y, {}};
  if (is_set("loads")) options.loads = quantities_from("loads");
  for (const Quantity& load : options.loads)
    if (load.unit.text != options.loads.front().unit.text ||
        (!load.unit.text.empty() && load.unit.dimension != dimension::force))
      throw refused("loads", "all loads must be forces in one unit");
  print_or_write(import_plot(arguments[0], options), arguments);
  return kFine;
}

}  // namespace mixity::cli
