// The output of `mixity runs`: points to fit, phases, peaks and cuts.
#pragma once

#include <string>
#include <vector>

#include "analysis/request.h"
#include "base/files.h"
#include "dataset/logs/reduced_log.h"

namespace mixity {

/// curve, time, P, T, A, sigma_T, sigma_A of the kept frames, in the units of the log.
std::string runs_csv(const ReducedLog& log);
/// The TOML beside the points: the constants of the log and its source.
std::string runs_toml(const ReducedLog& log);
/// JSON on how the log was read: the rows that share a time stamp, and the lag between two clocks with its standard
/// error and 95 % interval.
std::string log_json(const ReducedLog& log);
/// run, P, cycle, time, T_peak, T_min, sigma_T_peak, sigma_T_min: the maximum of T in each stick-slip cycle, the
/// minimum after it (slip_cycles), and their standard errors.
std::string peaks_csv(const ReducedLog& log);
/// phase, from, to, frames, kept, reason (why the frames are not kept).
std::string phases_csv(const ReducedLog& log);
/// The cuts that were made, with 95 % intervals, in the format of the option cuts.
std::string cuts_toml(const ReducedLog& log, Wording words = in_neutral_words);
struct RunsOutput {
  std::vector<OutputFile> files;
  std::string missing;  // what could not be drawn and why; empty if everything was
};

/// All files that `mixity runs` writes to a folder: points, peaks, phases, cuts, figures and a fit definition.
RunsOutput runs_output(const ReducedLog& log, const std::string& folder, const FigureFormats& formats,
                       Wording words = in_neutral_words, const Progress& progress = {});

/// Throws an InputError at this path: the log has no loading run.
[[noreturn]] void refuse_without_runs(const std::string& path);

/// For a terminal: how the log was read, each run with its cuts, and the frames that were not kept.
std::string runs_text(const ReducedLog& log, Wording words = in_neutral_words);

}  // namespace mixity
