// From the files of a log to its loading runs.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "dataset/logs/loading_runs.h"
#include "dataset/metadata.h"

namespace mixity {

struct ReducedLog {
  Recording forces;      // without its values
  TimeBase areas_clock;  // of a second file
  std::string areas_path, force_unit, area_unit;
  double force_factor = 1, area_factor = 1;  // one unit in SI
  Metadata metadata;
  LoadingRuns runs;
  bool load_turned = false;  // compression is negative in the log
};

struct ReductionOptions {
  std::optional<double> lag{};  // s, of the clock of the areas; null: from events
  std::optional<bool> drift{};  // as in RunOptions
  std::string cuts_path{};      // of a TOML with stated cuts; empty: none
};

/// Reads a log with forces and areas, or one of forces and one of areas in any order, and finds its loading runs. There
/// may be none. `constants` override those beside the files. Throws InputError if forces or areas are missing, for
/// constants that contradict each other, and for cuts of a run that is not found.
ReducedLog reduce_log(const std::vector<std::string>& paths, const Overrides& constants,
                      const ReductionOptions& options);

/// Reads a TOML with tables [[cuts]], which have `run`, and shear = "2.1 s", onset = "4.31 s" or leave_out = true.
/// Throws InputError, with line and column, for anything else.
std::map<std::string, StatedCut> read_cuts(const std::string& path);

}  // namespace mixity
