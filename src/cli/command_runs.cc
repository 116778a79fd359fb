// mixity runs: the loading runs of a log of forces and areas, as points to be fitted.
#include <iostream>

#include "base/files.h"
#include "base/input_error.h"
#include "cli/commands.h"
#include "cli/flag_words.h"
#include "cli/flags.h"
#include "cli/progress.h"
#include "report/figures/drawn_figures.h"
#include "report/figures/log_figures.h"
#include "report/runs_files.h"

DEFINE_string(
    lag, "", "what the clock of the areas is ahead of that of the forces: \"0.12 s\"; else from events that both show");
DEFINE_bool(drift, false, "take a line through the zeros of T of all runs off T; left out, where it is sure");
DEFINE_string(cuts, "", "a TOML that states cuts of runs (cuts.toml, which runs writes)");

namespace mixity::cli {
namespace {

std::optional<double> seconds(const std::string& flag) {
  if (!is_set(flag)) return std::nullopt;
  const auto quantity = parse_quantity(value_of(flag));
  if (!quantity || quantity->unit.dimension != dimension::time) throw must(flag, "be a time such as \"0.12 s\"");
  return quantity->si();
}

}  // namespace

int run_runs(const Arguments& arguments) {
  if (arguments.empty() || arguments.size() > 2)
    throw UsageError("runs needs a log, or one of forces and one of areas (see mixity help runs)");
  const ReducedLog log =
      reduce_log(arguments, data_overrides(),
                 {seconds("lag"), is_set("drift") ? std::optional(FLAGS_drift) : std::nullopt, FLAGS_cuts});
  if (log.runs.runs.empty()) {
    std::cout << runs_text(log, in_flags);
    throw InputError(arguments[0], "holds no loading run: no contact under one load in which T rises");
  }
  if (!FLAGS_out.empty()) {
    const std::string folder = FLAGS_out + "/";
    const std::vector<Figure> figures = log_figures(log);
    const DrawnFigures drawn =
        draw_figures(figures, FLAGS_out + "/figures", figure_formats(), progress_line("figures"));
    std::vector<OutputFile> files = drawn.files;
    files.push_back({folder + "runs.csv", runs_csv(log)});
    files.push_back({folder + "runs.toml", runs_toml(log)});
    files.push_back({folder + "peaks.csv", peaks_csv(log)});
    files.push_back({folder + "peaks.toml", runs_toml(log)});
    files.push_back({folder + "phases.csv", phases_csv(log)});
    files.push_back({folder + "cuts.toml", cuts_toml(log, in_flags)});
    files.push_back({folder + "fit.toml", runs_definition(figures)});
    std::vector<std::string> inputs(arguments.begin(), arguments.end());
    for (const std::string& path : arguments) inputs.push_back(metadata_path(path));
    for (const std::string& kept : keep_former(files))
      std::cerr << "mixity: what was there is kept as " << kept << '\n';
    write_files(files, inputs);
    if (!drawn.missing.empty()) std::cerr << "mixity: " << drawn.missing << '\n';
  }
  std::cout << runs_text(log, in_flags);
  if (!FLAGS_out.empty())
    std::cout << "Written to " << FLAGS_out << "; next: mixity report " << FLAGS_out << "/fit.toml --out=DIR\n";
  return kFine;
}

}  // namespace mixity::cli
