// Reduces logs to their loading runs.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "dataset/definition.h"
#include "dataset/logs/loading_runs.h"
#include "dataset/metadata.h"

namespace mixity {

struct ReducedLog {
  Recording forces;      // without the recorded values
  TimeBase areas_clock;  // of the second file
  std::string areas_path, force_unit, area_unit;
  double force_factor = 1, area_factor = 1;  // one unit in SI
  Metadata metadata;
  /// The column of each quantity, as the key columns of its metadata; one that two files find in columns of
  /// different names only as it is stated.
  std::map<std::string, std::string> mapping;
  LoadingRuns runs;
  std::vector<InputFile> inputs{};  // what was read for all logs, without contents; of the first log only
  bool load_turned = false;  // compression is negative in the log, so loads were reversed
};

struct ReductionOptions {
  std::optional<double> lag{};  // s, of the areas' clock; null: from events
  std::optional<bool> drift{};  // as in RunOptions
  std::string cuts_path{};      // a TOML with stated cuts; empty: none
  Inputs inputs{};              // may have logs that were read before
};

/// Reads logs of forces and areas, or files in pairs, one of forces and one of areas in any order, and finds the
/// loading runs of each, possibly none. Each log has a clock and zeros of its own; runs of all have different names.
/// `constants` override those beside the files. Throws InputError if forces or areas are missing, for contradictory
/// constants, and for cuts of an unknown run.
using ReducedLogs = std::vector<ReducedLog>;
ReducedLogs reduce_logs(const std::vector<std::string>& paths, const Overrides& constants,
                        const ReductionOptions& options);

/// What was understood of the files of each log.
std::vector<UnderstoodFile> understood(const ReducedLogs& logs);

/// Reads a TOML with tables [[cuts]], which have `run`, and shear = "2.1 s", onset = "4.31 s" or leave_out = true.
/// Throws InputError, with line and column, for anything else.
std::map<std::string, StatedCut> read_cuts(const std::string& path, Inputs& inputs);

}  // namespace mixity
