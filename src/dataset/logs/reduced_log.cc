#include "dataset/logs/reduced_log.h"

#include <algorithm>

#include "base/input_error.h"
#include "dataset/logs/clocks.h"
#include "dataset/logs/compression.h"
#include "dataset/logs/cuts_file.h"

namespace mixity {
namespace {

/// One file with forces and areas, or two files: the first with forces gives the forces.
std::vector<Recording> read_logs(const std::vector<std::string>& paths, const Overrides& constants,
                                 Metadata& metadata) {
  std::vector<Recording> logs;
  for (const std::string& path : paths) {
    Metadata own = read_metadata(metadata_path(path));
    apply_overrides(constants, own);
    logs.push_back(read_recording(path, own));
    if (logs.size() == 1)
      metadata = own;
    else if (const std::string problem = add_constants(own, metadata); !problem.empty())
      throw InputError(metadata_path(path), problem);
  }
  Recording& first = logs.front();
  if (logs.size() == 1) {
    if (!first.holds_forces() || !first.holds_areas())
      throw InputError(paths[0], std::string("holds no ") + (first.holds_forces() ? "areas" : "forces") +
                                     "; name the file that does, too: mixity runs FORCES.csv AREAS.csv");
    return logs;
  }
  if (!first.holds_forces()) std::swap(first, logs[1]);
  if (!first.holds_forces()) throw InputError(paths[0], "holds no forces, and neither does " + paths[1]);
  if (!logs[1].holds_areas()) throw InputError(logs[1].path, "holds no areas");
  return logs;
}

}  // namespace

ReducedLog reduce_log(const std::vector<std::string>& paths, const Overrides& constants,
                      const ReductionOptions& options) {
  RunOptions run_options;
  run_options.drift = options.drift;
  if (!options.cuts_path.empty()) run_options.cuts = read_cuts(options.cuts_path);
  ReducedLog log;
  std::vector<Recording> logs = read_logs(paths, constants, log.metadata);
  Recording& forces = logs.front();
  const Recording& areas = logs.back();
  log.areas_path = areas.path;
  log.force_unit = forces.force_unit;
  log.force_factor = forces.force_factor;
  log.area_unit = areas.area_unit;
  log.area_factor = areas.area_factor;
  log.load_turned = compression_is_negative(forces, areas, options.lag.value_or(0));
  if (log.load_turned) {
    for (double& P : forces.P) P = 0 - P;
    if (log.metadata.load_offset) *log.metadata.load_offset = 0 - *log.metadata.load_offset;
  }
  log.runs =
      find_loading_runs(on_one_clock(forces, areas, {options.lag}), log.force_unit, log.force_factor, run_options);
  for (const auto& [name, cut] : run_options.cuts)
    if (!cut.leave_out && std::none_of(log.runs.runs.begin(), log.runs.runs.end(),
                                       [&, &name = name](const LoadingRun& run) { return run.name == name; }))
      throw InputError(options.cuts_path, "states cuts of a run '" + name + "', which the log does not have");
  forces.time = forces.P = forces.T = forces.A = {};
  log.forces = std::move(forces);
  return log;
}

}  // namespace mixity
