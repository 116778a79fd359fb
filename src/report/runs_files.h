// The output of `mixity runs`: points to fit, phases, peaks and cuts.
#pragma once

#include <string>
#include <vector>

#include "analysis/request.h"
#include "base/files.h"
#include "dataset/logs/reduced_log.h"

namespace mixity {

/// Several logs have the units of the first; times are those of each log's own clock.
///
/// curve, time, P, T, A, sigma_T, sigma_A of the kept frames, in the units of the log.
std::string runs_csv(const ReducedLogs& logs);
/// The TOML beside the points: the constants of the log and its source.
std::string runs_toml(const ReducedLogs& logs);
/// JSON on how the log was read: the files with their hashes, the rows that share a time stamp, and the lag between two clocks with its standard
/// error and 95 % interval.
std::string log_json(const ReducedLogs& logs);
/// run, P, cycle, time, T_peak, T_min, sigma_T_peak, sigma_T_min: the maximum of T in each stick-slip cycle, the
/// minimum after it (slip_cycles), and their standard errors.
std::string peaks_csv(const ReducedLogs& logs);
/// phase, from, to, frames, kept, reason (why the frames are not kept), and log if there are several.
std::string phases_csv(const ReducedLogs& logs);
/// The cuts that were made, with 95 % intervals, in the format of the option cuts.
std::string cuts_toml(const ReducedLogs& logs, Wording words = in_neutral_words);
struct RunsOutput {
  std::vector<OutputFile> files;
  std::string missing;  // what could not be drawn and why; empty if everything was
};

/// All files that `mixity runs` writes to a folder: points, peaks, phases, cuts, figures and a fit definition. If the
/// cuts were read from the file of cuts there (`cuts_path`), it stays as it is and is left out.
RunsOutput runs_output(const ReducedLogs& logs, const std::string& folder, const FigureFormats& formats,
                       const std::string& cuts_path = {}, Wording words = in_neutral_words,
                       const Progress& progress = {});

bool has_no_run(const ReducedLogs& logs);
/// Throws an InputError at this path: the log has no loading run.
[[noreturn]] void refuse_without_runs(const std::string& path);

/// For a terminal: how the log was read, each run with its cuts, and the frames that were not kept.
std::string runs_text(const ReducedLogs& logs, Wording words = in_neutral_words);

}  // namespace mixity
