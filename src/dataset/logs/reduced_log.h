// Reduces the files of a log to its loading runs.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "dataset/logs/loading_runs.h"
#include "dataset/metadata.h"

namespace mixity {

struct ReducedLog {
  Recording forces;      // without the recorded values
  TimeBase areas_clock;  // of the second file
  std::string areas_path, force_unit, area_unit;
  double force_factor = 1, area_factor = 1;  // one unit in SI
  Metadata metadata;
  LoadingRuns runs;
  bool load_turned = false;  // compression is negative in the log, so loads were reversed
};

struct ReductionOptions {
  std::optional<double> lag{};  // s, of the areas' clock; null: from events
  std::optional<bool> drift{};  // as in RunOptions
  std::string cuts_path{};      // a TOML with stated cuts; empty: none
};

/// Reads a log with forces and areas, or one with forces and one with areas in any order, and finds its loading runs,
/// possibly none. `constants` override those beside the files. Throws InputError if forces or areas are missing, for
/// contradictory constants, and for cuts of an unknown run.
ReducedLog reduce_log(const std::vector<std::string>& paths, const Overrides& constants,
                      const ReductionOptions& options);

/// Reads a TOML with tables [[cuts]], which have `run`, and shear = "2.1 s", onset = "4.31 s" or leave_out = true.
/// Throws InputError, with line and column, for anything else.
std::map<std::string, StatedCut> read_cuts(const std::string& path);

}  // namespace mixity
