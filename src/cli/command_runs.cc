// mixity runs: the loading runs of a log of forces and areas, as points for a fit.
#include <iostream>
#include <iterator>
#include <utility>

#include "base/files.h"
#include "base/input_error.h"
#include "cli/commands.h"
#include "cli/flag_words.h"
#include "cli/flags.h"
#include "cli/progress.h"
#include "cli/saved_definition.h"
#include "report/runs_files.h"

DEFINE_string(lag, "",
              "how far the clock of the areas is ahead of the clock of the forces, such as \"0.12 s\"; by default "
              "found from events that both show");
DEFINE_bool(zero_drift, false,
            "subtract from T a straight line through the zeros of all runs; by default only if the drift is certain");
DEFINE_string(cuts, "", "a TOML file of cuts, such as the cuts.toml that runs writes");

namespace mixity::cli {
namespace {

std::optional<double> seconds(const std::string& flag) {
  if (!is_set(flag)) return std::nullopt;
  const auto is_time = [](const Quantity& one) { return one.unit.dimension == dimension::time; };
  return quantity_from(flag, "be a time such as \"0.12 s\"", is_time).si();
}

}  // namespace

int run_runs(const Arguments& arguments) {
  if (arguments.empty()) throw UsageError("runs needs a log, or one of forces and one of areas (see mixity help runs)");
  const ReducedLogs logs =
      reduce_logs(arguments, data_overrides(),
                  {seconds("lag"), is_set("zero_drift") ? std::optional(FLAGS_zero_drift) : std::nullopt, FLAGS_cuts});
  std::vector<OutputFile> files = definition_to_save(understood(logs));
  if (has_no_run(logs)) {
    write_outputs(std::move(files));
    std::cout << runs_text(logs, in_flags) << saved_text() << std::flush;
    refuse_without_runs(arguments[0]);
  }
  RunsOutput output;
  if (!FLAGS_out.empty())
    output = runs_output(logs, FLAGS_out, figure_formats(), FLAGS_cuts, in_flags, progress_line("figures"));
  std::move(output.files.begin(), output.files.end(), std::back_inserter(files));
  write_outputs(std::move(files), {{}, false, {FLAGS_out + "/figures"}});
  if (!output.missing.empty()) warn(output.missing);
  std::cout << runs_text(logs, in_flags) << saved_text();
  if (!FLAGS_out.empty())
    std::cout << "Written to " << FLAGS_out << "; next: mixity report " << FLAGS_out << "/fit.toml --out=DIR\n";
  return kFine;
}

}  // namespace mixity::cli
