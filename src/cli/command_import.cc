// mixity import: a WebPlotDigitizer export becomes a data CSV.
#include <iostream>

#include "base/output_file.h"
#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/flags.h"
#include "cli/quantity_list.h"
#include "cli/usage_error.h"
#include "dataset/table/plot_import.h"

namespace mixity::cli {

int run_import(const Arguments& arguments) {
  if (arguments.size() != 1) throw UsageError("import needs one WebPlotDigitizer CSV (see mixity help import)");
  if (FLAGS_x.empty() || FLAGS_y.empty()) throw UsageError("import needs the axes: --x=\"T [mN]\" --y=\"A [mm^2]\"");
  PlotImport options{FLAGS_x, FLAGS_y, {}};
  if (is_set("loads")) options.loads = quantity_list("loads", FLAGS_loads);
  for (const Quantity& load : options.loads)
    if (load.unit.text != options.loads.front().unit.text ||
        (!load.unit.text.empty() && load.unit.dimension != dimension::force))
      throw UsageError("flag '--loads': all loads must be forces in one unit");
  const std::string text = import_plot(arguments[0], options);
  if (FLAGS_out.empty()) {
    std::cout << text;
    return kFine;
  }
  write_files({{FLAGS_out, text}}, arguments);
  return kFine;
}

}  // namespace mixity::cli
