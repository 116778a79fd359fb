// The output of `mixity runs`: points to be fitted, phases, peaks and cuts.
#pragma once

#include <string>
#include <vector>

#include "analysis/request.h"
#include "base/files.h"
#include "dataset/logs/reduced_log.h"

namespace mixity {

/// curve, time, P, T, A, sigma_T, sigma_A of the frames that are kept, in the units of the log.
std::string runs_csv(const ReducedLog& log);
/// The TOML beside the points: the constants of the log and the source.
std::string runs_toml(const ReducedLog& log);
/// How the log was read, in JSON: the rows that share a stamp of the clock, and the lag between two clocks with its
/// standard error and 95 % interval.
std::string log_json(const ReducedLog& log);
/// run, P, cycle, time, T_peak, T_min, sigma_T_peak, sigma_T_min: the maximum of T in each cycle of stick and slip, the
/// minimum after it (slip_cycles), and their standard errors.
std::string peaks_csv(const ReducedLog& log);
/// phase, from, to, frames, whether they are kept, and the reason if not.
std::string phases_csv(const ReducedLog& log);
/// The cuts as they were made, with their 95 % intervals, in the form that the option cuts reads.
std::string cuts_toml(const ReducedLog& log, Wording words = in_neutral_words);
struct RunsOutput {
  std::vector<OutputFile> files;
  std::string missing;  // what could not be drawn, and why; empty if nothing
};

/// All that `mixity runs` writes into a folder: points, peaks, phases, cuts, figures and the definition of a fit.
RunsOutput runs_output(const ReducedLog& log, const std::string& folder, const FigureFormats& formats,
                       Wording words = in_neutral_words, const Progress& progress = {});

/// Throws an InputError at this path: the log holds no loading run.
[[noreturn]] void refuse_without_runs(const std::string& path);

/// For a terminal: how the log was read, each run with its cuts, and the frames that are not kept.
std::string runs_text(const ReducedLog& log, Wording words = in_neutral_words);

}  // namespace mixity
