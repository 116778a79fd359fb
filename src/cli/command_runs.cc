// mixity runs: the loading runs of a log of forces and areas, as points to be fitted.
#include <algorithm>
#include <iostream>

#include "base/files.h"
#include "base/input_error.h"
#include "cli/commands.h"
#include "cli/flag_words.h"
#include "cli/flags.h"
#include "cli/progress.h"
#include "dataset/logs/clocks.h"
#include "dataset/logs/compression.h"
#include "dataset/logs/cuts_file.h"
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

/// Reads one file with forces and areas, or two files; the first with forces gives the forces.
std::pair<Recording, std::optional<Recording>> read_logs(const Arguments& paths, const Overrides& overrides,
                                                         Metadata& metadata) {
  std::vector<Recording> read;
  for (const std::string& path : paths) {
    Metadata own = read_metadata(metadata_path(path));
    apply_overrides(overrides, own);
    read.push_back(read_recording(path, own));
    if (&path == &paths.front())
      metadata = own;
    else if (const std::string problem = add_constants(own, metadata); !problem.empty())
      throw InputError(metadata_path(path), problem);
  }
  if (read.size() == 1) {
    if (!read[0].holds_forces() || !read[0].holds_areas())
      throw InputError(paths[0], std::string("holds no ") + (read[0].holds_forces() ? "areas" : "forces") +
                                     "; name the file that does, too: mixity runs FORCES.csv AREAS.csv");
    return {std::move(read[0]), std::nullopt};
  }
  if (!read[0].holds_forces()) std::swap(read[0], read[1]);
  if (!read[0].holds_forces()) throw InputError(paths[0], "holds no forces, and neither does " + paths[1]);
  if (!read[1].holds_areas()) throw InputError(read[1].path, "holds no areas");
  return {std::move(read[0]), std::move(read[1])};
}

}  // namespace

int run_runs(const Arguments& arguments) {
  if (arguments.empty() || arguments.size() > 2)
    throw UsageError("runs needs a log, or one of forces and one of areas (see mixity help runs)");
  FrameOptions frame_options;
  frame_options.lag = seconds("lag");
  RunOptions options;
  if (is_set("drift")) options.drift = FLAGS_drift;
  if (!FLAGS_cuts.empty()) options.cuts = read_cuts(FLAGS_cuts);
  ReducedLog log;
  auto [forces, areas] = read_logs(arguments, data_overrides(), log.metadata);
  const Recording& pictures = areas ? *areas : forces;
  log.areas_path = pictures.path;
  log.force_unit = forces.force_unit;
  log.force_factor = forces.force_factor;
  log.area_unit = pictures.area_unit;
  log.area_factor = pictures.area_factor;
  log.load_turned = compression_is_negative(forces, pictures, frame_options.lag.value_or(0));
  if (log.load_turned) {
    for (double& P : forces.P) P = 0 - P;
    if (log.metadata.load_offset) *log.metadata.load_offset = 0 - *log.metadata.load_offset;
  }
  log.runs =
      find_loading_runs(on_one_clock(forces, pictures, frame_options), log.force_unit, log.force_factor, options);
  for (const auto& [name, cut] : options.cuts)
    if (!cut.leave_out && std::none_of(log.runs.runs.begin(), log.runs.runs.end(),
                                       [&](const LoadingRun& run) { return run.name == name; }))
      throw InputError(FLAGS_cuts, "states cuts of a run '" + name + "', which the log does not have");
  forces.time = forces.P = forces.T = forces.A = {};
  log.forces = std::move(forces);
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
