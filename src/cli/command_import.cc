// mixity import: converts the output of a plot digitiser to a data CSV.
#include <filesystem>

#include "base/toml_file.h"
#include "cli/commands.h"
#include "cli/flags.h"
#include "dataset/metadata.h"
#include "dataset/table/plot_import.h"

DEFINE_string(x, "", "header of the column on the x axis, with its unit: \"T [mN]\"");
DEFINE_string(y, "", "header of the column on the y axis, with its unit: \"A [mm^2]\"");
DEFINE_string(layout, "",
              "the columns of the export: pairs (x, y of each data set) or shared (one x, then each data set)");

namespace mixity::cli {
namespace {

PlotLayout layout() {
  if (FLAGS_layout.empty()) return PlotLayout::found;
  if (FLAGS_layout == "pairs") return PlotLayout::pairs;
  if (FLAGS_layout == "shared") return PlotLayout::shared;
  throw UsageError("flag '--layout' is '" + FLAGS_layout + "'; it must be pairs or shared");
}

}  // namespace

int run_import(const Arguments& arguments) {
  if (arguments.size() != 1) throw UsageError("import needs one exported CSV (see mixity help import)");
  if (FLAGS_x.empty() || FLAGS_y.empty()) throw UsageError("import needs the axes: --x=\"T [mN]\" --y=\"A [mm^2]\"");
  Metadata reading;
  apply_overrides(data_overrides(), reading);
  PlotImport options{FLAGS_x, FLAGS_y, {}, layout(), reading.decimal, reading.sheet};
  if (is_set("loads")) options.loads = quantities_from("loads");
  for (const Quantity& load : options.loads)
    if (load.unit.text != options.loads.front().unit.text ||
        (!load.unit.text.empty() && load.unit.dimension != dimension::force))
      throw refused("loads", "all loads must be forces in one unit");
  const std::string table = import_plot(arguments[0], options), stated = metadata_path(FLAGS_out);
  std::error_code unknown;
  if (!FLAGS_out.ends_with(".csv") || std::filesystem::exists(stated, unknown) || unknown)
    return print_or_write(table), kFine;
  // Constants are added to it by hand: a later import leaves it alone.
  write_outputs(
      {{FLAGS_out, table}, {stated, "provenance = \"digitised\"\nsource = " + toml_text(command_line()) + "\n"}});
  return kFine;
}

}  // namespace mixity::cli
